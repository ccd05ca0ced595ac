#!/usr/bin/env python3
"""How well parts found by `posture segment` agree with the bones of synthetic bodies, and their
motions with those of the bones: people and quadrupeds, the rest pose to each other pose, which is
meshed anew. Prints for each pair the adjusted Rand index, over vertices that one bone moves alone,
and for each part that one bone moves by how many degrees its rotation and its long axis are off.

    bench/segmentation_table.py POSTURE OUT_FOLDER [FIRST_POSE LAST_POSE]
"""
import csv
import json
import math
import os
import struct
import subprocess
import sys

RIGID = 0.999  # weight of the bone of a vertex that no other bone moves


def transposed(m):
    return [list(row) for row in zip(*m)]


def product(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def degrees(rotation):
    """Accurate for small angles: from what a rotation differs from its transpose by."""
    r = rotation
    sine = math.dist((r[2][1], r[0][2], r[1][0]), (r[1][2], r[2][0], r[0][1])) / 2
    return math.degrees(math.atan2(sine, (r[0][0] + r[1][1] + r[2][2] - 1) / 2))


def axis_degrees(rotation, axis):
    turned = [sum(rotation[i][j] * axis[j] for j in range(3)) for i in range(3)]
    return 2 * math.degrees(math.asin(min(1, math.dist(turned, axis) / 2)))


def long_axis(places):
    """The direction of most spread, by powers of the covariance."""
    n = len(places)
    middle = [sum(p[i] for p in places) / n for i in range(3)]
    m = [[sum((p[i] - middle[i]) * (p[j] - middle[j]) for p in places) for j in range(3)]
         for i in range(3)]
    for _ in range(20):
        trace = sum(m[i][i] for i in range(3))
        m = product(m, m) if trace == 0 else [[x / trace for x in row] for row in m]
        m = product(m, m)
    column = max(transposed(m), key=lambda c: sum(x * x for x in c))
    length = math.sqrt(sum(x * x for x in column))
    return [x / length for x in column]


def adjusted_rand_index(a, b):
    def pairs(n):
        return n * (n - 1) / 2

    both, of_a, of_b = {}, {}, {}
    for x, y in zip(a, b):
        both[x, y] = both.get((x, y), 0) + 1
        of_a[x] = of_a.get(x, 0) + 1
        of_b[y] = of_b.get(y, 0) + 1
    together, in_a, in_b = (sum(map(pairs, c.values())) for c in (both, of_a, of_b))
    expected = in_a * in_b / pairs(len(a))
    most = (in_a + in_b) / 2
    return 1.0 if most == expected else (together - expected) / (most - expected)


def vertices_of(ply):
    """Of a binary PLY as synthesize writes it: x, y, z first, doubles or floats."""
    with open(ply, "rb") as file:
        count, properties, element = 0, [], ""
        for line in iter(file.readline, b"end_header\n"):
            word = line.decode().split()
            if word[0] == "element":
                element = word[1]
                count = int(word[2]) if element == "vertex" else count
            elif word[0] == "property" and element == "vertex":
                properties.append({"float": "f", "double": "d", "uchar": "B"}[word[1]])
        row = struct.Struct("<" + "".join(properties))
        return [row.unpack(file.read(row.size))[:3] for _ in range(count)]


def faces_of(ply):
    """Of the same: triangles, the last of the file."""
    with open(ply, "rb") as file:
        data = file.read()
    header = data.index(b"end_header\n") + len(b"end_header\n")
    lines = data[:header].decode().splitlines()
    count = next(int(x.split()[2]) for x in lines if x.startswith("element face"))
    faces = data[len(data) - 13 * count:]
    return [struct.unpack_from("<3i", faces, 13 * i + 1) for i in range(count)]


def joined(bones, motion, faces_touch, least):
    """Bones that touch and turn by less than what separates parts are one: nothing tells them
    apart."""
    group = {bone: bone for bone in bones}

    def find(bone):
        return bone if group[bone] == bone else find(group[bone])

    for a, b in faces_touch:
        if degrees(product(transposed(motion[a]), motion[b])) < least:
            group[find(a)] = find(b)
    return {bone: find(bone) for bone in bones}


def measure(folder, name, reference):
    with open(os.path.join(folder, "bones.json")) as file:
        bones = json.load(file)
    rest = {b["bone"]: b["rotation"] for b in bones[reference + ".ply"]}
    pose = {b["bone"]: b["rotation"] for b in bones[name + ".ply"]}
    motion = {b: product(pose[b], transposed(rest[b])) for b in rest}
    with open(os.path.join(folder, reference + "-bones.csv")) as file:
        rows = list(csv.DictReader(file))
    bone = [row["bone"] for row in rows]
    rigid = [float(row["weight"]) >= RIGID for row in rows]
    with open(os.path.join(folder, name + "-segments", "segments.csv")) as file:
        part = [int(row["part"]) for row in csv.DictReader(file)]
    with open(os.path.join(folder, name + "-segments", "segments.json")) as file:
        found = json.load(file)
    ply = os.path.join(folder, reference + ".ply")
    places = vertices_of(ply)
    touch = {(bone[a], bone[b]) for f in faces_of(ply)
             for a, b in ((f[0], f[1]), (f[1], f[2]), (f[2], f[0])) if bone[a] != bone[b]}
    least = found["least_turn_degrees"]
    group = joined(rest, motion, sorted(touch), least)
    judged = [v for v in range(len(bone)) if rigid[v]]
    index = adjusted_rand_index([group[bone[v]] for v in judged], [part[v] for v in judged])
    rows = []
    for p, moved in enumerate(found["poses"][0]["motions"]):
        of_part = [v for v in range(len(bone)) if part[v] == p]
        whole = [v for v in of_part if rigid[v]]
        names = {bone[v] for v in whole}
        if len(names) != 1 or 2 * len(whole) < len(of_part):
            continue  # no one bone moves it
        name_of_bone = names.pop()
        off = product(moved["rotation"], transposed(motion[name_of_bone]))
        axis = long_axis([places[v] for v in of_part])
        turned = [sum(motion[name_of_bone][i][j] * axis[j] for j in range(3)) for i in range(3)]
        rows.append((name_of_bone, len(of_part), degrees(off), axis_degrees(off, turned)))
    return index, least, found["count"], rows


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    posture, out = sys.argv[1:3]
    first, last = (int(x) for x in sys.argv[3:5]) if len(sys.argv) > 4 else (1, 16)
    everything, undecided = [], 0
    for kind in ("human", "quadruped"):
        for pose in range(first, last + 1):
            folder = os.path.join(out, f"{kind}-{pose}")
            reference, name = f"{kind}-pose0", f"{kind}-pose{pose}"
            segments = os.path.join(folder, name + "-segments")
            if not os.path.exists(os.path.join(segments, "segments.json")):
                subprocess.run([posture, "synthesize", "-q", "--kind", kind, "--pose", "0",
                                str(pose), "--remesh", "-o", folder], check=True)
                run = subprocess.run([posture, "segment", "-q",
                                      os.path.join(folder, reference + ".ply"),
                                      os.path.join(folder, name + ".ply"), "-o", segments])
                if run.returncode == 1:
                    print(f"{kind}-{pose}: undecided")
                    undecided += 1
                    continue
                run.check_returncode()
            index, least, count, rows = measure(folder, name, reference)
            everything.append((index, least, count, rows))
            print(f"{kind}-{pose}: index {index:.3f}, threshold {least:.1f}, {count} parts; "
                  + ", ".join(f"{b} {w:.1f}/{a:.1f}" for b, n, w, a in rows))
    print(f"{undecided} undecided, which the figures below leave out")
    if not everything:
        return
    rows = [row for _, _, _, each in everything for row in each]
    indices = [index for index, _, _, _ in everything]
    turns = sorted(row[2] for row in rows)
    within = [100 * sum(row[k] <= 2 for row in rows) / len(rows) for k in (2, 3)]
    print(f"index {min(indices):.3f} to {max(indices):.3f}, mean {sum(indices) / len(indices):.3f}, "
          f"below 0.85: {sum(i < 0.85 for i in indices)} of {len(indices)}; rotations within 2 "
          f"degrees {within[0]:.0f} %, median {turns[len(turns) // 2]:.1f}; long axes within 2 "
          f"degrees {within[1]:.0f} %")


if __name__ == "__main__":
    main()
