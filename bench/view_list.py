#!/usr/bin/env python3
"""Writes a list of the benchmark's near-isometric pairs as single depth images show them: of three
pairs a family, spread evenly, the mesh beside one view, one view beside the mesh, and one view each,
from directions drawn by the pair's name and a seed, the two no more than 30 degrees apart. A view is an organised PCD file in the frame
of the mesh, with about 15,000 points, noise along the rays and without grazing returns.

Its missing pixels stand for the vertices it does not show: what is mapped though its true place was
not seen counts by how far off it is on the whole target.

    bench/view_list.py BENCHMARK_FOLDER OUT_FOLDER [SEED]
    posture benchmark OUT_FOLDER/views.csv -o RESULTS
"""
import csv
import math
import os
import random
import sys

from benchmark_files import dot, minus, read_mesh, read_truth, spread_pairs
from depth_image import View, direction, direction_near

EACH, POINTS = 3, 15000
APART = 30      # degrees between the directions of the two cameras


def write(view, path, vertices):
    """The image, and where on the mesh each pixel lies. Returns the pixel of each vertex: the
    nearest that shows it, or else one without a return, and the number of vertices shown."""
    count = view.size * view.size
    own, free, on_mesh = {}, [], []
    with open(path + ".pcd", "w") as out:
        out.write("VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"
                  "WIDTH %d\nHEIGHT %d\nVIEWPOINT %.9g %.9g %.9g 1 0 0 0\nPOINTS %d\n"
                  "DATA ascii\n" % (view.size, view.size, *view.eye, count))
        for pixel in range(count):
            found = view.pixels.get((pixel % view.size, pixel // view.size))
            if found is None:
                out.write("nan nan nan\n")
                free.append(pixel)
                continue
            place, vertex = found
            out.write("%.7g %.7g %.7g\n" % place)
            off = minus(place, vertices[vertex])
            own.setdefault(vertex, []).append((dot(off, off), pixel))
            on_mesh.append((pixel, vertex))
    shown = {v: min(pixels)[1] for v, pixels in own.items()}
    hidden = [v for v in range(len(vertices)) if v not in shown]
    if len(hidden) > len(free):
        sys.exit("%s: fewer missing pixels than vertices that are hidden" % path)
    on_mesh += [(pixel, v) for pixel, v in zip(free, hidden)]
    with open(path + ".txt", "w") as out:
        out.writelines("%d %d\n" % row for row in on_mesh)
    return {**shown, **dict(zip(hidden, free))}, set(shown), dict(on_mesh)


def main(benchmark, out, seed):
    os.makedirs(out, exist_ok=True)
    with open(os.path.join(out, "views.csv"), "w", newline="") as listed:
        columns = ["id", "family", "kind", "source", "target", "truth", "target_surface",
                   "target_surface_vertices", "note"]
        table = csv.DictWriter(listed, columns)
        table.writeheader()
        for row in spread_pairs(benchmark, EACH):
            draw = random.Random(row["id"] + seed)
            axis = direction(draw)
            axes = {"source": axis, "target": direction_near(axis, APART, draw)}
            mesh, view, paths = {}, {}, {}
            for side in ("source", "target"):
                vertices, faces = read_mesh(os.path.join(benchmark, row[side]))
                mesh[side] = vertices
                paths[side] = os.path.abspath(os.path.join(out, row["id"] + "-" + side))
                view[side] = write(View(vertices, faces, axes[side], POINTS, draw),
                                   paths[side], vertices)
            truth = read_truth(benchmark, row["truth"], len(mesh["source"]))
            shown = {side: view[side][1] for side in view}
            both = sum(v in shown["source"] and w in shown["target"] for v, w in truth)
            target_mesh = os.path.abspath(os.path.join(benchmark, row["target"]))
            by_source = {}
            for v, w in truth:
                by_source.setdefault(v, w)

            def add(kind, source, target, pairs, note):
                path = os.path.join(out, "%s-%s.txt" % (row["id"], kind))
                with open(path, "w") as lines:
                    lines.writelines("%d %d\n" % pair for pair in pairs)
                new = {"id": row["id"] + "-" + kind, "family": row["family"], "kind": kind,
                       "source": source, "target": target, "truth": os.path.abspath(path),
                       "note": note}
                if target != target_mesh:
                    new["target_surface"] = target_mesh
                    new["target_surface_vertices"] = paths["target"] + ".txt"
                table.writerow(new)

            in_target = view["target"][0]
            of_source = [(pixel, by_source[v]) for pixel, v in view["source"][2].items()
                         if v in shown["source"] and v in by_source]
            seen = {side: sum((v, w)[side == "target"] in shown[side] for v, w in truth)
                    for side in shown}
            add("mesh-view", os.path.abspath(os.path.join(benchmark, row["source"])),
                paths["target"] + ".pcd", [(v, in_target[w]) for v, w in truth],
                "the view shows %.0f %% of the vertices" % (100 * seen["target"] / len(truth)))
            add("view-mesh", paths["source"] + ".pcd", target_mesh, of_source, "")
            add("view-view", paths["source"] + ".pcd", paths["target"] + ".pcd",
                [(pixel, in_target[w]) for pixel, w in of_source],
                "%.0f %% of the vertices that the first view shows are in the second too"
                % (100 * both / max(1, seen["source"])))


if __name__ == "__main__":
    if not 3 <= len(sys.argv) <= 4:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2], sys.argv[3] if len(sys.argv) == 4 else "")
