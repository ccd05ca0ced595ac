#!/usr/bin/env python3
"""Writes a list of the benchmark's near-isometric pairs as scanners that fuse depth images into
voxels give them: of three pairs a family, spread evenly, the mesh beside its target filled into
voxels, blurred and meshed anew, and both sides so. Parts less than two voxels apart have become
one, fingers and ears have lost their ends, limbs thinner than three voxels are gone, so that what
lies beyond is a piece of its own, and nothing has a hole. The seed moves the voxels against the
bodies.

Errors are those on the mesh behind the target; what the voxels swallowed has no truth. Where parts
have become one, the truth may be the other one's nearest place.

    bench/fused_list.py BENCHMARK_FOLDER OUT_FOLDER [SEED]
    posture benchmark OUT_FOLDER/fused.csv -o RESULTS
"""
import csv
import math
import os
import random
import sys

from benchmark_files import cross, dot, minus, read_mesh, read_truth, spread_pairs, write_mesh

EACH = 3
VOXELS = 85      # along the square root of the area: 16 mm of a person
SWALLOWED = 1.5  # voxels from the new surface
REACH = 10       # voxels from a new vertex to the nearest old one, at most


def area(vertices, faces):
    normals = (cross(minus(vertices[b], vertices[a]), minus(vertices[c], vertices[a]))
               for a, b, c in faces)
    return sum(math.sqrt(dot(n, n)) for n in normals) / 2


class Grid:
    """Of each voxel whether its centre is inside a mesh, by two of the rays along the three axes."""

    def __init__(self, vertices, faces, draw):
        low, high = ([f(v[i] for v in vertices) for i in range(3)] for f in (min, max))
        self.voxel = math.sqrt(area(vertices, faces)) / VOXELS
        self.origin = [a - (3 + draw.random()) * self.voxel for a in low]
        self.size = [math.ceil((b - o) / self.voxel) + 4 for b, o in zip(high, self.origin)]
        places = [tuple((x - o) / self.voxel for x, o in zip(v, self.origin)) for v in vertices]
        votes = [0] * (self.size[0] * self.size[1] * self.size[2])
        for axis in range(3):
            self.count(places, faces, axis, votes)
        self.values = [float(vote > 1) for vote in votes]

    def step(self, axis):
        return (1, self.size[0], self.size[0] * self.size[1])[axis]

    def count(self, places, faces, axis, votes):
        u, w = (axis + 1) % 3, (axis + 2) % 3
        crossings = {}
        for face in faces:
            a, b, c = (places[v] for v in face)
            doubled = (b[u] - a[u]) * (c[w] - a[w]) - (b[w] - a[w]) * (c[u] - a[u])
            if doubled == 0:
                continue
            us, ws = [p[u] for p in (a, b, c)], [p[w] for p in (a, b, c)]
            for i in range(math.ceil(min(us)), math.floor(max(us)) + 1):
                for j in range(math.ceil(min(ws)), math.floor(max(ws)) + 1):
                    s = ((i - a[u]) * (c[w] - a[w]) - (j - a[w]) * (c[u] - a[u])) / doubled
                    t = ((b[u] - a[u]) * (j - a[w]) - (b[w] - a[w]) * (i - a[u])) / doubled
                    if s >= 0 and t >= 0 and s + t <= 1:
                        depth = a[axis] + s * (b[axis] - a[axis]) + t * (c[axis] - a[axis])
                        crossings.setdefault((i, j), []).append((depth, 1 if doubled > 0 else -1))
        for (i, j), hits in crossings.items():
            hits.sort()
            start, winding = i * self.step(u) + j * self.step(w), 0
            for (depth, turn), (following, _) in zip(hits, hits[1:]):
                winding += turn
                if winding != 0:
                    for k in range(math.ceil(depth), math.floor(following) + 1):
                        votes[start + k * self.step(axis)] += 1

    def blur(self):
        for axis in range(3):
            step, old = self.step(axis), self.values
            # All around is outside, so that rows may run into each other.
            self.values = ([0.0] * step +
                           [0.25 * (a + c) + 0.5 * b
                            for a, b, c in zip(old, old[step:], old[2 * step:])] + [0.0] * step)

    def place(self, i):
        return (i % self.size[0], i // self.size[0] % self.size[1],
                i // self.size[0] // self.size[1])


# The six tetrahedra of a cube around its diagonal, by corners (bits: x, y, z), all turned alike.
TETRAHEDRA = ((0, 1, 3, 7), (0, 3, 2, 7), (0, 2, 6, 7), (0, 6, 4, 7), (0, 4, 5, 7), (0, 5, 1, 7))


def isosurface(grid, level):
    """Marching tetrahedra; the outside is where values are less."""
    steps = [(k & 1) * grid.step(0) + (k >> 1 & 1) * grid.step(1) + (k >> 2) * grid.step(2)
             for k in range(8)]
    inside = [value > level for value in grid.values]
    number, vertices, faces = {}, [], []

    def between(i, o):
        key = (i, o)
        if key not in number:
            number[key] = len(vertices)
            t = (level - grid.values[i]) / (grid.values[o] - grid.values[i])
            vertices.append(tuple(origin + grid.voxel * (a + t * (b - a)) for origin, a, b in
                                  zip(grid.origin, grid.place(i), grid.place(o))))
        return number[key]

    for base in range(len(inside) - steps[7]):
        corners = [base + step for step in steps]
        some = sum(inside[i] for i in corners)
        if some in (0, 8):
            continue
        for tetrahedron in TETRAHEDRA:
            at = [corners[k] for k in tetrahedron]
            within = [k for k in range(4) if inside[at[k]]]
            without = [k for k in range(4) if not inside[at[k]]]
            if len(within) in (0, 4):
                continue
            if len(within) == 2:
                ring = [between(at[i], at[o]) for i, o in
                        ((within[0], without[0]), (within[0], without[1]),
                         (within[1], without[1]), (within[1], without[0]))]
            else:
                alone, others = ((within, without) if len(within) == 1 else (without, within))
                ring = [between(*((at[alone[0]], at[k]) if len(within) == 1 else
                                  (at[k], at[alone[0]]))) for k in others]
            # An even order of the corners, those inside first, sees the ring turned one way.
            order = within + without
            if sum(order[x] > order[y] for x in range(4) for y in range(x + 1, 4)) % 2 == 1:
                ring.reverse()
            faces.append((ring[0], ring[1], ring[2]))
            if len(ring) == 4:
                faces.append((ring[0], ring[2], ring[3]))
    return vertices, faces


class Nearest:
    def __init__(self, points, cell):
        self.points, self.cell, self.cells = points, cell, {}
        for i, p in enumerate(points):
            self.cells.setdefault(self.at(p), []).append(i)

    def at(self, p):
        return tuple(math.floor(x / self.cell) for x in p)

    def __call__(self, p, reach):
        """The nearest point no farther than `reach` <= the cell; or none."""
        best, least = None, reach
        x, y, z = self.at(p)
        for a in (x - 1, x, x + 1):
            for b in (y - 1, y, y + 1):
                for c in (z - 1, z, z + 1):
                    for i in self.cells.get((a, b, c), ()):
                        distance = math.dist(p, self.points[i])
                        if distance < least:
                            best, least = i, distance
        return best


def fused(vertices, faces, draw):
    """Vertices and faces; of each old vertex the new one nearest to it, or none, and of each new
    vertex the nearest old one, if any is near."""
    grid = Grid(vertices, faces, draw)
    grid.blur()
    grid.blur()
    new, new_faces = isosurface(grid, 0.5)
    to_new, reach = Nearest(new, 2 * grid.voxel), SWALLOWED * grid.voxel
    to_old = Nearest(vertices, REACH * grid.voxel)
    return (new, new_faces, [to_new(v, reach) for v in vertices],
            [to_old(v, REACH * grid.voxel) for v in new])


def main(benchmark, out, seed):
    os.makedirs(out, exist_ok=True)
    with open(os.path.join(out, "fused.csv"), "w", newline="") as listed:
        table = csv.DictWriter(listed, ["id", "family", "kind", "source", "target", "truth",
                                        "target_surface", "target_surface_vertices", "note"])
        table.writeheader()
        for row in spread_pairs(benchmark, EACH):
            path = os.path.abspath(os.path.join(out, row["id"]))
            old = {side: read_mesh(os.path.join(benchmark, row[side]))
                   for side in ("source", "target")}
            made = {}
            for side in old:
                made[side] = fused(*old[side], random.Random(row["id"] + side + seed))
                write_mesh("%s-%s.off" % (path, side), *made[side][:2])
            truth = read_truth(benchmark, row["truth"], len(old["source"][0]))
            on_source, on_target = made["source"][2], made["target"][2]
            with open(path + "-vertices.txt", "w") as lines:
                lines.writelines("%d %d\n" % (i, w) for i, w in enumerate(made["target"][3])
                                 if w is not None)
            for kind, source in (("mesh-fused", None), ("fused-fused", on_source)):
                with open("%s-%s.txt" % (path, kind), "w") as lines:
                    known = set()
                    for v, w in truth:
                        start = v if source is None else source[v]
                        if start is None or on_target[w] is None or start in known:
                            continue
                        known.add(start)
                        lines.write("%d %d\n" % (start, on_target[w]))
                table.writerow({
                    "id": "%s-%s" % (row["id"], kind), "family": row["family"], "kind": kind,
                    "source": os.path.abspath(os.path.join(benchmark, row["source"]))
                              if source is None else path + "-source.off",
                    "target": path + "-target.off",
                    "truth": "%s-%s.txt" % (path, kind),
                    "target_surface": os.path.abspath(os.path.join(benchmark, row["target"])),
                    "target_surface_vertices": path + "-vertices.txt",
                    "note": "%d and %d vertices" % (
                        len((old if source is None else made)["source"][0]),
                        len(made["target"][0]))})


if __name__ == "__main__":
    if not 3 <= len(sys.argv) <= 4:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2], sys.argv[3] if len(sys.argv) == 4 else "")
