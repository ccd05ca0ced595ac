#!/usr/bin/env python3
"""Writes a list of the benchmark's near-isometric pairs with parts cut out of them: of each pair
one side or both lose all faces within two to four balls, 0.08 or 0.12 square roots of the area in
radius, around vertices drawn by the pair's name and a seed. A target keeps its vertices, so that
the truth stays as it is, and what is mapped though its true place is gone counts by how far off it
is on the whole target.

    bench/cut_list.py BENCHMARK_FOLDER OUT_FOLDER [SEED]
    posture benchmark OUT_FOLDER/cut.csv -o RESULTS
"""
import csv
import os
import random
import sys

from benchmark_files import FAMILIES, compact, dot, minus, read_mesh, read_truth, write_mesh

SIDES = (("source",), ("target",), ("source", "target"))


def area(vertices, faces):
    total = 0
    for a, b, c in faces:
        u, w = minus(vertices[b], vertices[a]), minus(vertices[c], vertices[a])
        total += 0.5 * max(0, dot(u, u) * dot(w, w) - dot(u, w) ** 2) ** 0.5
    return total


def without_balls(vertices, faces, draw):
    """The faces that have no corner in any of the balls."""
    size = area(vertices, faces) ** 0.5
    gone = set()
    for _ in range(draw.randint(2, 4)):
        center, radius = draw.choice(vertices), draw.choice((0.08, 0.12)) * size
        gone.update(v for v, at in enumerate(vertices)
                    if dot(minus(at, center), minus(at, center)) < radius ** 2)
    return [face for face in faces if not gone.intersection(face)]


def main(benchmark, out, seed):
    os.makedirs(out, exist_ok=True)
    with open(os.path.join(benchmark, "pairs.csv")) as pairs:
        rows = [row for row in csv.DictReader(pairs) if row["family"] in FAMILIES]
    with open(os.path.join(out, "cut.csv"), "w", newline="") as listed:
        columns = ["id", "family", "kind", "source", "target", "truth", "target_surface"]
        table = csv.DictWriter(listed, columns)
        table.writeheader()
        for row in rows:
            draw = random.Random(row["id"] + seed)
            sides = draw.choice(SIDES)
            place = {side: os.path.abspath(os.path.join(benchmark, row[side]))
                     for side in ("source", "target")}
            vertices, faces = read_mesh(place["source"])
            truth = read_truth(benchmark, row["truth"], len(vertices))
            new = {"id": row["id"] + "-cut" + seed, "family": row["family"],
                   "kind": "cut-" + "-".join(sides), **place,
                   "truth": os.path.abspath(os.path.join(out, row["id"] + ".txt"))}
            if "source" in sides:
                vertices, faces, kept = compact(vertices, without_balls(vertices, faces, draw))
                number = {v: i for i, v in enumerate(kept)}
                truth = [(number[v], w) for v, w in truth if v in number]
                new["source"] = os.path.abspath(os.path.join(out, row["id"] + "-source.off"))
                write_mesh(new["source"], vertices, faces)
            if "target" in sides:
                vertices, faces = read_mesh(place["target"])
                new["target_surface"] = place["target"]
                new["target"] = os.path.abspath(os.path.join(out, row["id"] + "-target.off"))
                write_mesh(new["target"], vertices, without_balls(vertices, faces, draw))
            with open(new["truth"], "w") as lines:
                lines.writelines("%d %d\n" % pair for pair in truth)
            table.writerow(new)


if __name__ == "__main__":
    if not 3 <= len(sys.argv) <= 4:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2], sys.argv[3] if len(sys.argv) == 4 else "")
