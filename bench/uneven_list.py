#!/usr/bin/env python3
"""Writes a list of the benchmark's near-isometric pairs as scans that are 25 times as dense at one
end as at the other: of two pairs a family, spread evenly, 15,000 points a side without faces or
normals. The density falls by the same factor over equal lengths, along a direction drawn by the
pair's name and a seed; noise is a tenth of the spacing there. The source has a frame and a unit of
its own.

    bench/uneven_list.py BENCHMARK_FOLDER OUT_FOLDER [SEED]
    posture benchmark OUT_FOLDER/uneven.csv -o RESULTS
"""
import bisect
import math
import sys

from benchmark_files import cross, dot, minus
from depth_image import direction
from scan_pairs import write_list

EACH, POINTS, RATIO = 2, 15000, 25
NOISE = 0.1  # of the spacing


def scan(vertices, faces, draw):
    """Points, and of each the vertex it is nearest to."""
    axis = direction(draw)
    along = [dot(axis, v) for v in vertices]
    low, length = min(along), max(along) - min(along)
    density, normals, sums, total = [], [], [], 0
    for face in faces:
        a, b, c = (vertices[v] for v in face)
        normal = cross(minus(b, a), minus(c, a))
        twice = math.sqrt(dot(normal, normal))
        normals.append(tuple(x / twice if twice > 0 else 0 for x in normal))
        density.append(RATIO ** -((sum(along[v] for v in face) / 3 - low) / length))
        total += twice / 2 * density[-1]
        sums.append(total)
    points = []
    for _ in range(POINTS):
        f = min(bisect.bisect(sums, draw.random() * total), len(faces) - 1)
        root, part = math.sqrt(draw.random()), draw.random()
        weights = (1 - root, root * (1 - part), root * part)
        noise = draw.gauss(0, NOISE * math.sqrt(total / POINTS / density[f]))
        place = tuple(sum(w * vertices[v][k] for w, v in zip(weights, faces[f])) +
                      noise * normals[f][k] for k in range(3))
        points.append((place, faces[f][weights.index(max(weights))]))
    return points


def main(benchmark, out, seed):
    write_list(benchmark, out, "uneven.csv", EACH, {"uneven": scan}, seed)


if __name__ == "__main__":
    if not 3 <= len(sys.argv) <= 4:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2], sys.argv[3] if len(sys.argv) == 4 else "")
