"""What the lists of simulated scans in this folder share: the source's frame, and how a pair of
clouds is written, with the truth on the mesh behind the target."""
import csv
import math
import os

from benchmark_files import cross, dot, read_truth
from depth_image import direction


def scan_table(listed):
    table = csv.DictWriter(listed, ["id", "family", "kind", "source", "target", "truth",
                                    "target_surface", "target_surface_vertices", "note"])
    table.writeheader()
    return table


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
