"""What the lists of scans in this folder are made with: simulated depth images of a mesh."""
import math

from benchmark_files import cross, dot, minus

NOISE = 0.0008  # of the diagonal
GRAZING = 0.15  # cosine
AWAY = 2.5      # of the camera, in diagonals


def unit(a):
    length = math.sqrt(dot(a, a))
    return tuple(x / length for x in a)


def direction(draw):
    return unit([draw.gauss(0, 1) for _ in range(3)])


def direction_near(axis, degrees, draw):
    other = direction(draw)
    while dot(axis, other) < math.cos(math.radians(degrees)):
        other = direction(draw)
    return other


class View:
    """What a camera sees of a mesh from a direction, in about so many pixels: for each of these the
    place, with noise along the ray, and the vertex it is nearest to. No grazing returns."""

    def __init__(self, vertices, faces, axis, points, draw):
        low, high = ([f(v[i] for v in vertices) for i in range(3)] for f in (min, max))
        middle = tuple((a + b) / 2 for a, b in zip(low, high))
        self.diagonal = math.sqrt(dot(minus(high, low), minus(high, low)))
        self.axis = axis
        self.eye = tuple(m - AWAY * self.diagonal * x for m, x in zip(middle, self.axis))
        least = min(range(3), key=lambda i: abs(self.axis[i]))
        self.right = unit(cross(self.axis, tuple(float(i == least) for i in range(3))))
        self.down = cross(self.axis, self.right)
        self.size = 240
        hits = self.rendered(vertices, faces)
        self.size = round(self.size * math.sqrt(points / len(hits)))
        self.pixels = {}
        for pixel, (depth, face, weights) in self.rendered(vertices, faces).items():
            a, b, c = (vertices[v] for v in faces[face])
            place = tuple(sum(w * x[i] for w, x in zip(weights, (a, b, c))) for i in range(3))
            ray, normal = unit(minus(place, self.eye)), cross(minus(b, a), minus(c, a))
            if not abs(dot(ray, normal)) > GRAZING * math.sqrt(dot(normal, normal)):
                continue
            off = draw.gauss(0, NOISE * self.diagonal)
            self.pixels[pixel] = (tuple(x + off * r for x, r in zip(place, ray)),
                                  faces[face][weights.index(max(weights))])

    def rendered(self, vertices, faces):
        scale = self.size * AWAY  # the diagonal spans the image
        seen, at = {}, []
        for v in vertices:
            d = minus(v, self.eye)
            depth = dot(d, self.axis)
            at.append((scale * dot(d, self.right) / depth + self.size / 2,
                       scale * dot(d, self.down) / depth + self.size / 2, depth))
        for number, (i, j, k) in enumerate(faces):
            a, b, c = at[i], at[j], at[k]
            whole = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
            if whole == 0:
                continue
            for y in range(math.ceil(min(a[1], b[1], c[1])), math.floor(max(a[1], b[1], c[1])) + 1):
                for x in range(math.ceil(min(a[0], b[0], c[0])),
                               math.floor(max(a[0], b[0], c[0])) + 1):
                    u = ((b[0] - x) * (c[1] - y) - (b[1] - y) * (c[0] - x)) / whole
                    v = ((c[0] - x) * (a[1] - y) - (c[1] - y) * (a[0] - x)) / whole
                    if u < 0 or v < 0 or u + v > 1:
                        continue
                    # Inverse depths are linear in the image.
                    weights = (u / a[2], v / b[2], (1 - u - v) / c[2])
                    depth = 1 / sum(weights)
                    if (x, y) not in seen or depth < seen[x, y][0]:
                        seen[x, y] = (depth, number, tuple(w * depth for w in weights))
        return seen
