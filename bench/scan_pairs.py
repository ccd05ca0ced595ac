"""What the lists of simulated scans in this folder share: the source's frame, and how pairs of
clouds are written, with the truth on the mesh behind the target."""
import csv
import math
import os
import random

from benchmark_files import cross, dot, read_mesh, read_truth, spread_pairs
from depth_image import direction


def elsewhere(points, draw):
    """In another frame, a hundred times as large."""
    x = direction(draw)
    y = cross(x, direction(draw))
    length = math.sqrt(dot(y, y))
    y = tuple(c / length for c in y)
    axes = (x, y, cross(x, y))
    return [tuple(100 * dot(axis, p) + 1000 for axis in axes) for p in points]


def write_points(path, points):
    with open(path, "w") as out:
        out.writelines("%.7g %.7g %.7g\n" % p for p in points)


def write_scans(benchmark, out, row, new, count, source, target, draw):
    """Writes two scans of a pair's meshes, the source elsewhere; the list's line for them. A scan is
    points, and of each the vertex it is nearest to, or none. `count`: of the source's vertices."""
    path = os.path.abspath(os.path.join(out, new))
    write_points(path + "-source.xyz", elsewhere([p for p, _ in source], draw))
    write_points(path + "-target.xyz", [p for p, _ in target])
    truth = dict(reversed(read_truth(benchmark, row["truth"], count)))
    shown = {}
    for i, (_, w) in enumerate(target):
        if w is not None:
            shown.setdefault(w, i)
    with open(path + ".txt", "w") as lines:
        lines.writelines("%d %d\n" % (i, shown[truth[v]])
                         for i, (_, v) in enumerate(source) if truth.get(v) in shown)
    with open(path + "-vertices.txt", "w") as lines:
        lines.writelines("%d %d\n" % (i, w) for i, (_, w) in enumerate(target) if w is not None)
    return {"id": new, "family": row["family"], "kind": "scans", "source": path + "-source.xyz",
            "target": path + "-target.xyz", "truth": path + ".txt",
            "target_surface": os.path.abspath(os.path.join(benchmark, row["target"])),
            "target_surface_vertices": path + "-vertices.txt",
            "note": "%d and %d points" % (len(source), len(target))}


def write_list(benchmark, out, name, each, scans, seed):
    """Writes a list of so many pairs a family, each once for every way to scan both meshes.
    `scans`: what a way adds to a pair's name, and what makes a scan of vertices and faces."""
    os.makedirs(out, exist_ok=True)
    with open(os.path.join(out, name), "w", newline="") as listed:
        table = csv.DictWriter(listed, ["id", "family", "kind", "source", "target", "truth",
                                        "target_surface", "target_surface_vertices", "note"])
        table.writeheader()
        for row in spread_pairs(benchmark, each):
            mesh = {side: read_mesh(os.path.join(benchmark, row[side]))
                    for side in ("source", "target")}
            for way, scan in scans.items():
                new = "%s-%s" % (row["id"], way)
                draw = random.Random(new + seed)
                source, target = (scan(*mesh[side], draw) for side in ("source", "target"))
                table.writerow(write_scans(benchmark, out, row, new, len(mesh["source"][0]), source,
                                           target, draw))
