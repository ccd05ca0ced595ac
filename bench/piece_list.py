#!/usr/bin/env python3
"""Writes a list of pieces of the benchmark's bodies beside other poses of the whole: of two pairs a
family the faces around a tip, by distance along the edges, until they have 15, 30 or 50 % of the
area. The tip is drawn by the pair's name and a seed from the six that are farthest from each other.

    bench/piece_list.py BENCHMARK_FOLDER OUT_FOLDER [SEED]
    posture benchmark OUT_FOLDER/pieces.csv -o RESULTS
"""
import csv
import heapq
import math
import os
import random
import sys

from benchmark_files import (compact, cross, dot, minus, read_mesh, read_truth,
                             spread_pairs, write_mesh)

EACH, TIPS, SHARES = 2, 6, (0.15, 0.3, 0.5)


def distances(edges, starts):
    found, queue = {}, [(0, v) for v in starts]
    while queue:
        d, v = heapq.heappop(queue)
        if v in found:
            continue
        found[v] = d
        for w, length in edges[v]:
            if w not in found:
                heapq.heappush(queue, (d + length, w))
    return found


def main(benchmark, out, seed):
    os.makedirs(out, exist_ok=True)
    with open(os.path.join(out, "pieces.csv"), "w", newline="") as listed:
        table = csv.DictWriter(listed, ["id", "family", "kind", "source", "target", "truth"])
        table.writeheader()
        for row in spread_pairs(benchmark, EACH):
            vertices, faces = read_mesh(os.path.join(benchmark, row["source"]))
            truth = read_truth(benchmark, row["truth"], len(vertices))
            edges = [set() for _ in vertices]
            for face in faces:
                for a, b in zip(face, face[1:] + face[:1]):
                    d = minus(vertices[a], vertices[b])
                    length = math.sqrt(dot(d, d))
                    edges[a].add((b, length))
                    edges[b].add((a, length))
            used = min(v for face in faces for v in face)
            around = distances(edges, [used])
            tips = [max(sorted(around), key=around.get)]
            while len(tips) < TIPS:
                around = distances(edges, tips)
                tips.append(max(sorted(around), key=around.get))
            around = distances(edges, [random.Random(row["id"] + seed).choice(tips)])
            area = []
            for a, b, c in faces:
                n = cross(minus(vertices[b], vertices[a]), minus(vertices[c], vertices[a]))
                area.append(math.sqrt(dot(n, n)))
            order = sorted((max(around.get(v, math.inf) for v in face), number)
                           for number, face in enumerate(faces))
            for share in SHARES:
                sum_, taken = 0, []
                for _, number in order:
                    if sum_ > share * sum(area):
                        break
                    sum_ += area[number]
                    taken.append(faces[number])
                piece, piece_faces, kept = compact(vertices, taken)
                number = {v: i for i, v in enumerate(kept)}
                name = "%s-%d" % (row["id"], round(100 * share))
                paths = {what: os.path.abspath(os.path.join(out, name + end))
                         for what, end in (("mesh", ".off"), ("truth", ".txt"))}
                write_mesh(paths["mesh"], piece, piece_faces)
                with open(paths["truth"], "w") as lines:
                    lines.writelines("%d %d\n" % (number[v], w) for v, w in truth
                                     if v in number)
                table.writerow({"id": name, "family": row["family"],
                                "kind": "piece-%d" % round(100 * share),
                                "source": paths["mesh"], "truth": paths["truth"],
                                "target": os.path.abspath(
                                    os.path.join(benchmark, row["target"]))})


if __name__ == "__main__":
    if not 3 <= len(sys.argv) <= 4:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2], sys.argv[3] if len(sys.argv) == 4 else "")
