"""What the lists in this folder are made with: the benchmark's files, and vectors."""
import csv
import os

FAMILIES = ("cat", "horse", "gorilla", "centaur", "michael", "victoria", "faust")


def spread_pairs(benchmark, each):
    """So many pairs a family, spread evenly over those the benchmark has."""
    with open(os.path.join(benchmark, "pairs.csv")) as pairs:
        rows = list(csv.DictReader(pairs))
    for family in FAMILIES:
        own = [row for row in rows if row["family"] == family]
        yield from (own[i * len(own) // each] for i in range(each))


def read_mesh(path):
    with open(path) as lines:
        if path.endswith(".obj"):
            rows = [line.split() for line in lines]
            return ([tuple(map(float, row[1:4])) for row in rows if row[:1] == ["v"]],
                    [tuple(int(word.split("/")[0]) - 1 for word in row[1:4])
                     for row in rows if row[:1] == ["f"]])
        words = lines.read().split()
    n, m = int(words[1]), int(words[2])
    faces = words[4 + 3 * n:]
    return ([tuple(map(float, words[4 + 3 * i:7 + 3 * i])) for i in range(n)],
            [tuple(map(int, faces[4 * i + 1:4 * i + 4])) for i in range(m)])


def write_mesh(path, vertices, faces):
    with open(path, "w") as out:
        out.write("OFF\n%d %d 0\n" % (len(vertices), len(faces)))
        out.writelines("%.10g %.10g %.10g\n" % v for v in vertices)
        out.writelines("3 %d %d %d\n" % f for f in faces)


def read_truth(benchmark, truth, count=None):
    """Pairs of a vertex of the source and one of the target; a source vertex may have several.
    `count`: of the source's vertices, for truths that are the identity."""
    if truth == "identity":
        return [(v, v) for v in range(count)]
    with open(os.path.join(benchmark, truth)) as lines:
        rows = (line.split() for line in lines if line.strip() and not line.startswith("#"))
        return [(int(row[0]), int(row[1])) for row in rows]


def compact(vertices, faces):
    """Without vertices that no face has; and the number each had."""
    kept = sorted({v for face in faces for v in face})
    number = {v: i for i, v in enumerate(kept)}
    return [vertices[v] for v in kept], [tuple(number[v] for v in face) for face in faces], kept


def minus(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
