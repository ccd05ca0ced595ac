// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "drawing.h"

#include <posture/core/error.h>

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCleanPolyData.h>
#include <vtkFeatureEdges.h>
#include <vtkFloatArray.h>
#include <vtkLight.h>
#include <vtkPCANormalEstimation.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

namespace posture::render {
namespace {

constexpr int OVERSAMPLING = 2;  // pixels drawn along the side of one pixel of the picture
constexpr int NEIGHBOURS = 16;   // that tell how a cloud lies at a point
constexpr double GREY = 0.74;

vtkSmartPointer<vtkPolyData> toVtk(const MeshFile& shape, bool faces) {
  const Eigen::Index n = shape.mesh.vertices.rows();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(n);
  for (Eigen::Index i = 0; i < n; ++i) points->SetPoint(i, shape.mesh.vertices.row(i).data());
  vtkNew<vtkCellArray> cells;
  for (Eigen::Index f = 0; faces && f < shape.mesh.faces.rows(); ++f)
    cells->InsertNextCell({shape.mesh.faces(f, 0), shape.mesh.faces(f, 1), shape.mesh.faces(f, 2)});
  for (Eigen::Index i = 0; !faces && i < n; ++i) cells->InsertNextCell({i});

  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  faces ? data->SetPolys(cells) : data->SetVerts(cells);
  if (shape.colors.rows() == n && n > 0) {
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetNumberOfComponents(3);
    colors->SetNumberOfTuples(n);
    std::copy_n(shape.colors.data(), 3 * n, colors->GetPointer(0));
    data->GetPointData()->SetScalars(colors);
  }
  return data;
}

/// Distance between the points of a cloud, taken as a sample of a surface: the cells of a grid that
/// it touches tell the surface's area.
double spacingOf(const Points& points) {
  if (points.rows() == 0) return 0;
  const Eigen::RowVector3d low = points.colwise().minCoeff();
  const double size = (points.colwise().maxCoeff() - low).maxCoeff();
  if (size <= 0) return 0;
  const double resolution = std::clamp(std::sqrt(double(points.rows()) / 4), 2.0, 100.0);
  const double cell = size / resolution;
  std::vector<std::array<int, 3>> touched(points.rows());
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    for (int c = 0; c < 3; ++c) touched[i][c] = static_cast<int>((points(i, c) - low(c)) / cell);
  std::sort(touched.begin(), touched.end());
  const auto count = std::unique(touched.begin(), touched.end()) - touched.begin();
  return cell * std::sqrt(double(count) / double(points.rows()));
}

vtkSmartPointer<vtkActor> actorFor(vtkPolyData* data) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(GREY, GREY, GREY);
  actor->GetProperty()->SetInterpolationToPhong();
  actor->GetProperty()->SetAmbient(0.08);
  actor->GetProperty()->SetSpecular(0.06);
  actor->GetProperty()->SetSpecularPower(15);
  return actor;
}

void addLight(vtkRenderer& scene, double x, double y, double z, double intensity) {
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(x, y, z);
  light->SetFocalPoint(0, 0, 0);
  light->SetIntensity(intensity);
  scene.AddLight(light);
}

}  // namespace

Points visiblePoints(const MeshFile& shape, const Style& style) {
  const TriangleMesh& mesh = shape.mesh;
  if (mesh.faces.rows() == 0 || !style.faces) return mesh.vertices;
  std::vector<bool> used(mesh.vertices.rows());
  for (Eigen::Index i = 0; i < mesh.faces.size(); ++i) used[mesh.faces.data()[i]] = true;
  Points visible(std::count(used.begin(), used.end(), true), 3);
  for (Eigen::Index i = 0, k = 0; i < mesh.vertices.rows(); ++i)
    if (used[i]) visible.row(k++) = mesh.vertices.row(i);
  return visible;
}

Window windowAround(const Points& points, const View& view) {
  if (points.rows() == 0) return {};
  const Vector x = points * view.right;
  const Vector y = points * view.up;
  return {{(x.minCoeff() + x.maxCoeff()) / 2, (y.minCoeff() + y.maxCoeff()) / 2},
          (x.maxCoeff() - x.minCoeff()) / 2,
          (y.maxCoeff() - y.minCoeff()) / 2};
}

Drawing::Drawing(const MeshFile& shape, const Style& style) : style_(style) {
  if (shape.mesh.faces.rows() > 0 && style.faces)
    makeSurface(shape, style.boundary);
  else
    makeCloud(shape);
}

void Drawing::makeSurface(const MeshFile& shape, bool boundary) {
  // Corners at the same place become one, so that an STL file is smooth and has no seams.
  vtkNew<vtkCleanPolyData> weld;
  weld->SetInputData(toVtk(shape, true));
  weld->ConvertPolysToLinesOff();
  weld->ConvertLinesToPointsOff();
  weld->ToleranceIsAbsoluteOn();
  weld->SetAbsoluteTolerance(0);
  vtkNew<vtkPolyDataNormals> smooth;
  smooth->SetInputConnection(weld->GetOutputPort());
  smooth->SplittingOff();
  smooth->ConsistencyOn();
  smooth->Update();
  actors_.push_back(actorFor(smooth->GetOutput()));
  if (!boundary) return;

  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputConnection(weld->GetOutputPort());
  edges->BoundaryEdgesOn();
  edges->FeatureEdgesOff();
  edges->NonManifoldEdgesOff();
  edges->ManifoldEdgesOff();
  edges->ColoringOff();
  edges->Update();
  edges->GetOutput()->GetPointData()->Initialize();
  const auto lines = actorFor(edges->GetOutput());
  lines->GetProperty()->SetColor(0.1, 0.1, 0.1);
  lines->GetProperty()->LightingOff();
  lines->GetProperty()->SetLineWidth(1.25f * OVERSAMPLING);
  lines->GetMapper()->SetResolveCoincidentTopologyToPolygonOffset();
  lines->GetMapper()->SetRelativeCoincidentTopologyLineOffsetParameters(-2, -4);
  actors_.push_back(lines);
}

void Drawing::makeCloud(const MeshFile& shape) {
  const Points& points = shape.mesh.vertices;
  cloud_ = toVtk(shape, false);
  spacing_ = spacingOf(points);
  if (shape.normals.rows() == points.rows()) {
    vtkNew<vtkFloatArray> normals;
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(points.rows());
    for (Eigen::Index i = 0; i < points.rows(); ++i)
      normals->SetTuple(i, shape.normals.row(i).data());
    cloud_->GetPointData()->SetNormals(normals);
  } else if (points.rows() > NEIGHBOURS) {
    vtkNew<vtkPCANormalEstimation> estimate;
    estimate->SetInputData(cloud_);
    estimate->SetSampleSize(NEIGHBOURS);
    estimate->SetNormalOrientationToAsComputed();
    estimate->Update();
    cloud_->GetPointData()->SetNormals(estimate->GetOutput()->GetPointData()->GetNormals());
  }
  const auto actor = actorFor(cloud_);
  // Discs instead of squares.
  actor->GetShaderProperty()->AddFragmentShaderReplacement(
      "//VTK::Color::Impl",
      true,
      "if (length(gl_PointCoord - vec2(0.5)) > 0.5) discard;\n//VTK::Color::Impl\n",
      false);
  actors_.push_back(actor);
}

void Drawing::turnNormals(const Eigen::Vector3d& toward_viewer) {
  vtkDataArray* normals = cloud_->GetPointData()->GetNormals();
  if (normals == nullptr) return;
  for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i) {
    Eigen::Vector3d normal;
    normals->GetTuple(i, normal.data());
    if (normal.dot(toward_viewer) >= 0) continue;
    normal = -normal;
    normals->SetTuple(i, normal.data());
  }
  normals->Modified();
  cloud_->Modified();
}

void Drawing::addTo(vtkRenderer& scene, const View& view, double pixels_per_unit) {
  if (cloud_ != nullptr) {
    turnNormals(view.toward_viewer);
    constexpr double LEAST = 1.5, LARGEST = 12;
    const double automatic =  // a single place is a dot
        spacing_ > 0 ? std::clamp(1.6 * spacing_ * pixels_per_unit, LEAST, LARGEST) : LARGEST;
    const double size = style_.point_size > 0 ? style_.point_size : automatic;
    actors_.front()->GetProperty()->SetPointSize(static_cast<float>(size * OVERSAMPLING));
  }
  for (const auto& actor : actors_) scene.AddActor(actor);
}

Canvas::Canvas(int width, int height) {
  window_->OffScreenRenderingOn();
  window_->SetMultiSamples(0);
  window_->SetSize(width * OVERSAMPLING, height * OVERSAMPLING);
  window_->AddRenderer(scene_);
  scene_->SetBackground(1, 1, 1);
  scene_->AutomaticLightCreationOff();
  addLight(*scene_, -0.5, 0.8, 1.0, 0.62);
  addLight(*scene_, 0.9, 0.1, 0.6, 0.22);
  addLight(*scene_, 0.0, 0.0, 1.0, 0.26);
}

Image Canvas::draw(Drawing& drawing, const View& view, const Window& window) {
  const int* size = window_->GetSize();
  vtkCamera* camera = scene_->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetViewUp(view.up.data());
  camera->SetParallelScale(window.half_height);
  scene_->RemoveAllViewProps();
  drawing.addTo(*scene_, view, size[1] / (2 * window.half_height * OVERSAMPLING));
  std::array<double, 6> bounds{};
  scene_->ComputeVisiblePropBounds(bounds.data());
  const Eigen::Vector3d low(bounds[0], bounds[2], bounds[4]);
  const Eigen::Vector3d high(bounds[1], bounds[3], bounds[5]);
  const double across = (high - low).norm(), distance = across > 0 ? across : 1;
  const Eigen::Vector3d target = window.centre.x() * view.right + window.centre.y() * view.up +
                                 (low + high).dot(view.toward_viewer) / 2 * view.toward_viewer;
  const Eigen::Vector3d eye = target + distance * view.toward_viewer;
  camera->SetFocalPoint(target.data());
  camera->SetPosition(eye.data());
  scene_->ResetCameraClippingRange();
  window_->Render();
  Image image(size[0], size[1]);
  vtkNew<vtkUnsignedCharArray> pixels;
  window_->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
  if (pixels->GetNumberOfValues() != static_cast<vtkIdType>(image.pixels.size()))
    throw InputError("the X display cannot draw a tile of this size");
  std::copy_n(pixels->GetPointer(0), image.pixels.size(), image.pixels.begin());
  scene_->RemoveAllViewProps();
  return shrink(image, OVERSAMPLING);
}

}  // namespace posture::render
