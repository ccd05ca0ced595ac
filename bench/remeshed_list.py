#!/usr/bin/env python3
"""Writes lists of the benchmark's near-isometric pairs with their sources meshed otherwise, and
truths to match: with three times the vertices (a point put into each face, then the old edges
turned), with a third of them (vertices pulled into a neighbour, along short edges first), and with
the same vertices and nearly a third of the edges turned, which tells what a pair owes to meshes
that share their faces. The vertices that stay are where they were, and only they have a truth.

    bench/remeshed_list.py BENCHMARK_FOLDER OUT_FOLDER
    posture benchmark OUT_FOLDER/thrice.csv -o RESULTS
    posture benchmark OUT_FOLDER/third.csv -o RESULTS
    posture benchmark OUT_FOLDER/turned.csv -o RESULTS
"""
import csv
import heapq
import os
import sys

from benchmark_files import FAMILIES, dot, minus, read_mesh, read_truth, write_mesh


def normal(vertices, face):
    a, b, c = (vertices[v] for v in face)
    u, w = minus(b, a), minus(c, a)
    return (u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0])


def alike(vertices, face, other, least):
    """Whether the cosine between the normals is more than `least`."""
    n, m = normal(vertices, face), normal(vertices, other)
    return dot(n, m) > least * (dot(n, n) * dot(m, m)) ** 0.5


def oriented(faces):
    """All faces the same way round as their neighbours; some of the benchmark's are not."""
    beside = {}
    for f, face in enumerate(faces):
        for k in range(3):
            beside.setdefault(frozenset((face[k], face[(k + 1) % 3])), []).append(f)
    turned = list(faces)
    seen = [False] * len(faces)
    for start in range(len(faces)):
        stack = [] if seen[start] else [start]
        seen[start] = True
        while stack:
            face = turned[stack.pop()]
            for k in range(3):
                a, b = face[k], face[(k + 1) % 3]
                for g in beside[frozenset((a, b))]:
                    if seen[g]:
                        continue
                    seen[g] = True
                    other = turned[g]
                    if any((other[j], other[(j + 1) % 3]) == (a, b) for j in range(3)):
                        turned[g] = other[::-1]
                    stack.append(g)
    return turned


def thrice(vertices, faces):
    """Mesh, and the old vertices' numbers in it."""
    n = len(vertices)
    finer = list(vertices) + [
        tuple(sum(vertices[v][i] for v in face) / 3 for i in range(3)) for face in faces]
    opposite = {}
    for f, face in enumerate(faces):
        for k in range(3):
            opposite[face[k], face[(k + 1) % 3]] = n + f
    made = []
    for (a, b), left in opposite.items():
        right = opposite.get((b, a))
        if right is None:
            made.append((a, b, left))
        elif a < b:
            turned = [(left, a, right), (right, b, left)]
            old = [(a, b, left), (b, a, right)]
            smooth = dot(normal(finer, turned[0]), normal(finer, turned[1])) > 0 and all(
                dot(normal(finer, t), normal(finer, o)) > 0 for t in turned for o in old)
            made += turned if smooth else old
    return finer, made, list(range(n))


def third(vertices, faces):
    """Mesh, and the old vertices' numbers in it, -1 for those left out."""
    faces = dict(enumerate(faces))
    around = [set() for _ in vertices]
    for f, face in faces.items():
        for v in face:
            around[v].add(f)

    def ring(v):
        return {w for f in around[v] for w in faces[f]} - {v}

    def length(a, b):
        d = minus(vertices[a], vertices[b])
        return dot(d, d)

    def is_inner(v):
        return len(ring(v)) == len(around[v])

    def may_go(gone, kept):
        if not is_inner(gone) or len(ring(gone) & ring(kept)) != 2 or len(ring(kept)) < 4:
            return False
        if any(len(ring(v)) < 4 for v in ring(gone) & ring(kept)):
            return False
        for f in around[gone] - around[kept]:
            now = tuple(kept if v == gone else v for v in faces[f])
            if not alike(vertices, faces[f], now, 0.5):
                return False
        return True

    left = len(vertices)
    queue = [(length(v, w), v, w) for v in range(left) for w in ring(v)]
    heapq.heapify(queue)
    alive = [True] * left
    aim = len(vertices) // 3
    while queue and left > aim:
        _, gone, kept = heapq.heappop(queue)
        if not (alive[gone] and alive[kept] and kept in ring(gone) and may_go(gone, kept)):
            continue
        old_ring = ring(gone)
        for f in list(around[gone]):
            if kept in faces[f]:
                for v in faces[f]:
                    around[v].discard(f)
                del faces[f]
            else:
                faces[f] = tuple(kept if v == gone else v for v in faces[f])
                around[kept].add(f)
        around[gone] = set()
        alive[gone] = False
        left -= 1
        for v in sorted(old_ring):
            for w in sorted(ring(v)):
                heapq.heappush(queue, (length(v, w), v, w))
                heapq.heappush(queue, (length(v, w), w, v))
    number, kept = [-1] * len(vertices), [v for v in range(len(vertices)) if alive[v]]
    for i, v in enumerate(kept):
        number[v] = i
    return ([vertices[v] for v in kept],
            [tuple(number[v] for v in faces[f]) for f in sorted(faces)], number)


def turned(vertices, faces):
    """Mesh, and the old vertices' numbers in it."""
    faces = list(faces)
    edges = {(a, b) for face in faces for a, b in zip(face, face[1:] + face[:1])}
    beside = {}
    used = set()
    for f, face in enumerate(faces):
        for k in range(3):
            a, b, c = face[k], face[(k + 1) % 3], face[(k + 2) % 3]
            if (b, a) not in beside:
                beside[a, b] = f, c
                continue
            g, d = beside[b, a]
            if f in used or g in used or (c, d) in edges or (d, c) in edges:
                continue
            new = (c, d, b), (d, c, a)
            if all(alike(vertices, n, o, 0.95) for n in new for o in (face, faces[g])):
                faces[f], faces[g] = new
                edges |= {(c, d), (d, c)}
                used |= {f, g}
                break
    return vertices, faces, list(range(len(vertices)))


def main(benchmark, out):
    os.makedirs(out, exist_ok=True)
    with open(os.path.join(benchmark, "pairs.csv")) as listed:
        rows = [row for row in csv.DictReader(listed) if row["family"] in FAMILIES]
    for name, remesh in (("thrice", thrice), ("third", third), ("turned", turned)):
        made = {}
        with open(os.path.join(out, name + ".csv"), "w", newline="") as listed:
            table = csv.DictWriter(listed, list(rows[0].keys()))
            table.writeheader()
            for row in rows:
                source = os.path.join(benchmark, row["source"])
                stem = os.path.splitext(os.path.basename(source))[0]
                path = os.path.abspath(os.path.join(out, "%s-%s.off" % (stem, name)))
                if source not in made:
                    vertices, faces = read_mesh(source)
                    vertices, faces, number = remesh(vertices, oriented(faces))
                    write_mesh(path, vertices, faces)
                    made[source] = number
                truth = os.path.abspath(os.path.join(out, "%s-%s.txt" % (row["id"], name)))
                with open(truth, "w") as rows_of:
                    pairs = read_truth(benchmark, row["truth"], len(made[source]))
                    rows_of.writelines("%d %d\n" % (made[source][a], b)
                                       for a, b in pairs if made[source][a] >= 0)
                table.writerow(dict(row, source=path, truth=truth, mirror_truth="",
                                    target=os.path.abspath(os.path.join(benchmark, row["target"]))))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
