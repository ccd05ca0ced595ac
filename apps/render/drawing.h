// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/io/mesh_io.h>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include "image.h"
#include "views.h"

namespace posture::render {

/// What is drawn of a shape.
struct Style {
  bool faces = true;      ///< false: the vertices only, as for a cloud
  bool boundary = false;  ///< dark lines along edges with one face
  double point_size = 0;  ///< of a cloud's points, in pixels; 0: so that they cover the surface
};

/// The part of the picture plane that a tile shows.
struct Window {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< along the view's right and up
  double half_width = 1, half_height = 1;
};

/// The vertices that are seen: all of a cloud, those in faces of a mesh.
Points visiblePoints(const MeshFile& shape, const Style& style);

/// Tightly round the points as they are seen.
Window windowAround(const Points& points, const View& view);

/// A shape made ready for drawing from several sides.
class Drawing {
 public:
  Drawing(const MeshFile& shape, const Style& style);

  /// Adds the shape, as it is to be seen from there, to an empty scene.
  /// \param pixels_per_unit  of the picture.
  void addTo(vtkRenderer& scene, const View& view, double pixels_per_unit);

 private:
  void makeSurface(const MeshFile& shape, bool boundary);
  void makeCloud(const MeshFile& shape);
  void turnNormals(const Eigen::Vector3d& toward_viewer);

  Style style_;
  double spacing_ = 0;  ///< of a cloud's points
  vtkSmartPointer<vtkPolyData> cloud_;
  std::vector<vtkSmartPointer<vtkActor>> actors_;
};

/// An off-screen window that draws one tile after the other.
class Canvas {
 public:
  Canvas(int width, int height);

  Image draw(Drawing& drawing, const View& view, const Window& window);

 private:
  vtkNew<vtkRenderWindow> window_;
  vtkNew<vtkRenderer> scene_;
};

}  // namespace posture::render
