#!/usr/bin/env python3
"""Writes the list that bench/RESULTS.md is made of: the benchmark's pairs, scans to be measured on
the clean shapes behind them; cats, horses and centaurs as points, their faces taken away; and pairs
of shapes that have nothing to do with each other, among them a sphere, an ellipsoid, a blob and
noise.

    bench/result_list.py BENCHMARK_FOLDER OUT_FOLDER
    posture benchmark OUT_FOLDER/pairs.csv -o RESULTS
"""
import csv
import glob
import math
import os
import random
import sys


def sphere(subdivisions):
    vertices = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    faces = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
    for _ in range(subdivisions):
        middles, finer = {}, []

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                p = [(vertices[a][i] + vertices[b][i]) / 2 for i in range(3)]
                norm = math.sqrt(sum(x * x for x in p))
                vertices.append(tuple(x / norm for x in p))
                middles[key] = len(vertices) - 1
            return middles[key]

        for a, b, c in faces:
            x, y, z = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, x, z), (x, b, y), (z, y, c), (x, y, z)]
        faces = finer
    return vertices, faces


def write(path, radius):
    vertices, faces = sphere(5)
    with open(path, "w") as out:
        out.write("OFF\n%d %d 0\n" % (len(vertices), len(faces)))
        for v in vertices:
            r = radius(v)
            out.write("%g %g %g\n" % tuple(x * r for x in v))
        for face in faces:
            out.write("3 %d %d %d\n" % face)


def vertices_of(path):
    with open(path) as lines:
        if path.endswith(".obj"):
            return [line.split()[1:4] for line in lines if line.startswith("v ")]
        words = lines.read().split()
        return [words[4 + 3 * i:7 + 3 * i] for i in range(int(words[1]))]


def as_points(path, out):
    """The vertices of an OBJ or OFF file alone."""
    name = os.path.splitext(os.path.basename(path))[0] + ".xyz"
    with open(os.path.join(out, name), "w") as points:
        for vertex in vertices_of(path):
            points.write(" ".join(vertex) + "\n")
    return os.path.abspath(os.path.join(out, name))


def main(benchmark, out):
    random.seed(5)
    os.makedirs(out, exist_ok=True)
    made = {name: os.path.abspath(os.path.join(out, name + ".off"))
            for name in ("sphere", "ellipsoid", "noise", "blob")}
    waves = [([random.uniform(-6, 6) for _ in range(3)], random.uniform(0, 6)) for _ in range(12)]
    write(made["sphere"], lambda v: 1)
    write(made["ellipsoid"], lambda v: 1 / math.sqrt(v[0] ** 2 / 4 + v[1] ** 2 + v[2] ** 2 / 2))
    write(made["noise"], lambda v: 1 + random.uniform(-0.25, 0.25))
    write(made["blob"], lambda v: 1 + 0.12 * sum(
        math.sin(sum(a * b for a, b in zip(k, v)) + p) for k, p in waves))

    def of(family, number):
        return sorted(glob.glob(os.path.join(benchmark, "meshes", family, "*")))[number]

    unrelated = [
        (of("cat", 1), of("michael", 0)), (of("michael", 1), of("cat", 2)),
        (of("cat", 3), of("horse", 3)), (of("horse", 2), of("cat", 4)),
        (of("horse", 1), of("faust", 3)), (of("faust", 5), of("horse", 5)),
        (of("centaur", 0), of("gorilla", 1)), (of("gorilla", 0), of("centaur", 2)),
        (of("centaur", 1), of("michael", 2)), (of("victoria", 1), of("centaur", 3)),
        (of("cat", 2), of("gorilla", 2)), (made["sphere"], of("horse", 1)),
        (of("cat", 1), made["sphere"]), (made["noise"], of("faust", 1)),
        (of("horse", 4), made["noise"]), (made["blob"], of("cat", 5)),
        (of("michael", 2), made["blob"]), (made["ellipsoid"], of("victoria", 2)),
        (made["sphere"], made["noise"]), (of("teddy", 0), of("horse", 6)),
        (of("armadillo", 0), of("cat", 1)), (of("teddy", 1), of("michael", 1)),
        (of("faust", 7), of("centaur", 4)), (of("gorilla", 1), of("horse", 0))]

    with open(os.path.join(benchmark, "pairs.csv")) as listed:
        rows = list(csv.DictReader(listed))
    with open(os.path.join(out, "pairs.csv"), "w", newline="") as listed:
        table = csv.DictWriter(listed, list(rows[0].keys()) + ["target_surface"])
        table.writeheader()
        for row in rows:
            for key in ("source", "target", "truth", "mirror_truth"):
                if row[key] not in ("", "identity"):
                    row[key] = os.path.abspath(os.path.join(benchmark, row[key]))
            if row["family"] == "scans":
                # scan-<source>-<target>, in the frame of the clean shape <target>
                row["target_surface"] = os.path.abspath(os.path.join(
                    benchmark, "meshes", "large", row["id"].split("-")[2] + ".ply"))
            table.writerow(row)
        for row in rows:
            if row["family"] in ("cat", "horse", "centaur"):
                table.writerow(dict(row, id="points-" + row["id"], family="points-" + row["family"],
                                    kind="points", source=as_points(row["source"], out),
                                    target=as_points(row["target"], out),
                                    target_surface=row["target"], note="vertices alone"))
        for number, (source, target) in enumerate(unrelated):
            table.writerow({"id": "unrelated-%02d" % number, "family": "unrelated",
                            "kind": "unrelated", "source": source, "target": target})


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
