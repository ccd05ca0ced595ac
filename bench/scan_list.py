#!/usr/bin/env python3
"""Writes a list of the benchmark's near-isometric pairs as raw scans of six and of three views show
them: of three pairs a family, spread evenly, both sides as one cloud of about 25,000 points without
faces or normals. The cameras are drawn by the pair's name and a seed, no two of a scan less than
60 degrees (six views) or 80 degrees (three) apart; noise lies along their rays, grazing returns are
missing, and one point in 500 is anywhere in the box around. The source has a frame and a unit of its
own.

Counted is what both scans show, on the mesh behind the target.

    bench/scan_list.py BENCHMARK_FOLDER OUT_FOLDER [SEED]
    posture benchmark OUT_FOLDER/scans.csv -o RESULTS
"""
import functools
import math
import sys

from benchmark_files import dot
from depth_image import View, direction
from scan_pairs import write_list

EACH, POINTS = 3, 25000
APART = {6: 60, 3: 80}  # degrees between cameras, by their number
OUTLIERS = 1 / 500


def directions(count, draw):
    least = math.cos(math.radians(APART[count]))
    while True:
        chosen = []
        for _ in range(200):
            new = direction(draw)
            if all(dot(new, old) < least for old in chosen):
                chosen.append(new)
            if len(chosen) == count:
                return chosen


def scan(count, vertices, faces, draw):
    """Points, and of each the vertex it is nearest to, or none."""
    points = []
    for axis in directions(count, draw):
        view = View(vertices, faces, axis, POINTS // count, draw)
        points += [view.pixels[pixel] for pixel in sorted(view.pixels)]
    low, high = ([f(v[i] for v in vertices) for i in range(3)] for f in (min, max))
    for _ in range(round(OUTLIERS * len(points))):
        points.append((tuple(draw.uniform(a, b) for a, b in zip(low, high)), None))
    return points


def main(benchmark, out, seed):
    scans = {"%d-views" % count: functools.partial(scan, count) for count in APART}
    write_list(benchmark, out, "scans.csv", EACH, scans, seed)


if __name__ == "__main__":
    if not 3 <= len(sys.argv) <= 4:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2], sys.argv[3] if len(sys.argv) == 4 else "")
