# SPDX-License-Identifier: MIT
"""unseen_model.py KIND SEED…: prints an OBJ file that nobody has seen; of several, a line # is between two. See unseen_model.hpp.

Sums, products and square roots only: they are the same on every machine, and sines are not.
"""
import itertools
import math
import sys

SIXTY_FOUR = (1 << 64) - 1


def mix(x):
    """Moves every bit by every other: as mesh::mix."""
    x = x + 0x9E3779B97F4A7C15 & SIXTY_FOUR
    x = (x ^ x >> 30) * 0xBF58476D1CE4E5B9 & SIXTY_FOUR
    x = (x ^ x >> 27) * 0x94D049BB133111EB & SIXTY_FOUR
    return x ^ x >> 31


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def plus(a, b):
    return tuple(x + y for x, y in zip(a, b))


def times(factor, a):
    return tuple(factor * x for x in a)


def cross(a, b):
    return a[1] * b[2] - b[1] * a[2], a[2] * b[0] - b[2] * a[0], a[0] * b[1] - b[0] * a[1]


def unit(a):
    return times(1 / math.sqrt(dot(a, a)), a)


class Random:
    """Numbers that look like chance and follow from the seed."""

    def __init__(self, seed):
        self.states = itertools.count(mix(seed))

    def bits(self):
        return mix(next(self.states) & SIXTY_FOUR)

    def between(self, least, most):
        return least + (most - least) * ((self.bits() >> 11) * 2.0**-53)

    def index(self, least, most):
        """least to most, both of them too."""
        return least + self.bits() % (most - least + 1)

    def coin(self):
        return self.bits() % 2 == 0

    def shuffle(self, values):
        for i in range(len(values), 1, -1):
            other = self.bits() % i
            values[i - 1], values[other] = values[other], values[i - 1]

    def vector(self, least, most, size=3):
        return tuple(self.between(least, most) for _ in range(size))

    def direction(self):
        while True:
            vector = self.vector(-1, 1)
            length = math.sqrt(dot(vector, vector))
            if 0.1 < length < 1:
                return tuple(x / length for x in vector)


def decimals(numbers):
    return " ".join(f"{number:.6f}" for number in numbers)


class ObjText:
    """The file as it is written. Corners are {"v": …, "vt": …, "vn": …}, indices from 1; one without vt has none."""

    def __init__(self):
        self.lines = []
        self.counts = {"v": 0, "vt": 0, "vn": 0}

    def add(self, keyword, numbers):
        """An entry of a list; returns its index."""
        self.lines.append(f"{keyword} {decimals(numbers)}")
        self.counts[keyword] += 1
        return self.counts[keyword]

    def face(self, corners, both_ways=None):
        """With the Random `both_ways` each second index, by chance, is counted backwards from the list's latest entry."""
        def written(corner, keyword):
            if keyword not in corner:
                return ""
            return str(corner[keyword] - self.counts[keyword] - 1 if both_ways and both_ways.coin() else corner[keyword])
        self.lines.append("f " + " ".join("/".join(written(corner, keyword) for keyword in self.counts) for corner in corners))

    def add_shuffled(self, random, corners, keyword, numbers_of, points):
        """Adds an entry for the corner of each point, in an order of its own."""
        points = list(points)
        random.shuffle(points)
        for point in points:
            corners[point][keyword] = self.add(keyword, numbers_of(point))


class Relief:
    """Points in columns and rows, uneven, facing +z."""

    def __init__(self, random, least=5, most=10):
        self.columns, self.rows = random.index(least, most), random.index(least, most)
        height = 0.3 / most  # below half a cell: no triangle is steep
        self.points, self.texcoords, self.normals = [], [], []  # t is 0 in the first row
        for j in range(self.rows):
            for i in range(self.columns):
                x = (i + random.between(0.35, 0.65)) / self.columns
                y = (j + random.between(0.35, 0.65)) / self.rows
                self.points.append((x, y, random.between(0.5 - height, 0.5 + height)))
                self.texcoords.append((x, 0 if j == 0 else y))
                self.normals.append(unit((*random.vector(-0.2, 0.2, 2), 1)))

    def triangles(self, row):
        """The column and the points of the two triangles of each cell of a row; counter-clockwise."""
        for i in range(self.columns - 1):
            a = row * self.columns + i
            b, c, d = a + 1, a + 1 + self.columns, a + self.columns
            yield i, (a, b, c)
            yield i, (a, c, d)


def numbers(random):
    relief, text = Relief(random), ObjText()
    corners = [{} for _ in relief.points]

    def position(point):
        weight = (random.between(0.5, 2),) if random.coin() else ()
        color = random.vector(0, 1) if random.coin() else ()
        return relief.points[point] + weight + color

    def texcoord(point):
        s, t = relief.texcoords[point]
        s, t = 3 * s - 1, 2 * t  # the picture repeats
        return (s,) if t == 0 else (s, t) + ((random.between(0, 1),) if random.coin() else ())

    for keyword, numbers_of in ("v", position), ("vt", texcoord), ("vn", relief.normals.__getitem__):
        text.add_shuffled(random, corners, keyword, numbers_of, range(len(corners)))
    for j in range(relief.rows - 1):
        for _, points in relief.triangles(j):
            text.face([corners[point] for point in points])
    return text


def negative(random):
    relief, text = Relief(random), ObjText()
    corners = [{} for _ in relief.points]
    for j in range(relief.rows):
        row = range(j * relief.columns, (j + 1) * relief.columns)
        for keyword, values in ("v", relief.points), ("vt", relief.texcoords), ("vn", relief.normals):
            text.add_shuffled(random, corners, keyword, values.__getitem__, row)
        if j > 0:
            for _, points in relief.triangles(j - 1):
                text.face([corners[point] for point in points], both_ways=random)
    return text


def faces(random):
    return shared(random, 5, 10)  # so few that each of them counts


def shared(random, least=24, most=32):  # as many vertices as nobody finds who looks at the latest alone
    relief, text = Relief(random, least, most), ObjText()
    # Two cuts make four patches, each with entries of its own along the cuts. The two pairs of cuts differ, so that there are
    # corners with another vt, another vn, and both.
    half_columns, half_rows = relief.columns // 2, relief.rows // 2
    by_texcoord = random.index(1, half_columns - 1), random.index(1, half_rows - 1)
    by_normal = random.index(half_columns, relief.columns - 2), random.index(half_rows, relief.rows - 2)
    places = [{} for _ in relief.points]
    text.add_shuffled(random, places, "v", relief.points.__getitem__, range(len(places)))
    offsets = [random.vector(0, 0.4, 2) for _ in range(4)]
    tilts = [(*random.vector(-0.3, 0.3, 2), 0) for _ in range(4)]
    known = {}

    def index(keyword, patch, point, numbers_of):
        if (keyword, patch, point) not in known:
            known[keyword, patch, point] = text.add(keyword, numbers_of())
        return known[keyword, patch, point]

    def corner(point, texture, side):
        vt = index("vt", texture, point, lambda: plus(times(0.6, relief.points[point][:2]), offsets[texture]))
        vn = index("vn", side, point, lambda: unit(plus(relief.normals[point], tilts[side])))
        return places[point] | {"vt": vt, "vn": vn}

    faces = []
    for j in range(relief.rows - 1):
        for i, points in relief.triangles(j):
            texture, side = ((i >= column) + 2 * (j >= row) for column, row in (by_texcoord, by_normal))
            faces.append([corner(point, texture, side) for point in points])
    # One triangle once more, above: only v tells its corners from the first one's.
    above = [plus(relief.points[point], (0, 0, 0.3)) for point in (0, 1, relief.columns + 1)]
    faces.append([corner | {"v": text.add("v", place)} for corner, place in zip(faces[0], above)])
    # One that is very small, and one without area: its corners lie on a line along x.
    x, y, z = random.vector(0.4, 0.6)
    faces.append([corner | {"v": text.add("v", plus((x, y, z), place))} for corner, place in
                  zip(faces[2], ((0, 0, 0.2), (0.0003, 0, 0.2), (0, 0.0003, 0.2)))])
    faces.append([corner | {"v": text.add("v", (x, y, z))} for corner, x in zip(faces[1], (0.2, 0.3, 0.4))])
    random.shuffle(faces)  # equal corners lie far apart
    for corners in faces:
        text.face(corners)
    return text


# An outline is a polygon in the plane, counter-clockwise: complex numbers.


def area(a, b, c):
    """Twice the signed area of a triangle."""
    return ((b - a).conjugate() * (c - a)).imag


def length(p):
    return math.sqrt(p.real * p.real + p.imag * p.imag)


def distance_to_edge(p, a, b):
    edge, way = b - a, p - a
    along = (way.real * edge.real + way.imag * edge.imag) / (edge.real * edge.real + edge.imag * edge.imag)
    return length(a + min(max(along, 0.0), 1.0) * edge - p)


def untangled(outline):
    """Turns pieces of the outline round until no two edges cross; each time it becomes shorter, so this ends."""
    n, again = len(outline), True
    while again:
        again = False
        for i, j in itertools.combinations(range(n), 2):
            if j == i + 1 or (i == 0 and j == n - 1):
                continue  # neighbours
            a, b, c, d = outline[i], outline[i + 1], outline[j], outline[(j + 1) % n]
            if area(a, b, c) * area(a, b, d) < 0 and area(c, d, a) * area(c, d, b) < 0:
                outline[i + 1:j + 1] = reversed(outline[i + 1:j + 1])
                again = True
    return outline if sum(area(outline[0], *edge) for edge in itertools.pairwise(outline[1:])) >= 0 else outline[::-1]


def is_sturdy(outline):
    """Whether rounding to 6 decimals cannot make it touch itself or straighten a corner."""
    n = len(outline)
    for i, tip in enumerate(outline):
        before, after = outline[i - 1], outline[(i + 1) % n]
        if abs(area(before, tip, after) / (length(tip - before) * length(after - tip))) < 0.2:
            return False
        if any(distance_to_edge(tip, outline[j], outline[(j + 1) % n]) < 0.1 for j in range(n) if i not in (j, (j + 1) % n)):
            return False
    return True


def filling_disc(outline):
    """Moved and widened until it fills the unit disc."""
    x, y = [p.real for p in outline], [p.imag for p in outline]
    middle = complex(0.5 * (min(x) + max(x)), 0.5 * (min(y) + max(y)))
    radius = max(length(p - middle) for p in outline)
    return [complex((p - middle).real / radius, (p - middle).imag / radius) for p in outline]


def any_outline(random, corners):
    """A simple polygon that fills the unit disc, which a fan gets wrong from the fourth corner on."""
    while True:
        outline = []
        while len(outline) < corners:
            p = complex(*random.vector(-1, 1, 2))
            if length(p) < 1:
                outline.append(p)
        outline = filling_disc(untangled(outline))
        is_right_as_a_fan = all(area(outline[0], *edge) > 0 for edge in itertools.pairwise(outline[1:]))
        if is_sturdy(outline) and (corners == 3 or not is_right_as_a_fan):
            return outline


def comb(random):
    """A comb of four teeth that begins at any corner: of its 11 corners many are no ear for long."""
    tips = [complex(1 - tooth / 2, random.between(0.4, 0.6)) for tooth in range(5)]
    notches = [complex(0.75 - tooth / 2, random.between(-0.4, -0.2)) for tooth in range(4)]
    outline = [-1 - 0.6j, 1 - 0.6j] + [p for both in zip(tips, notches) for p in both] + [tips[-1]]
    first = random.index(0, len(outline) - 1)
    return filling_disc(outline[first:] + outline[:first])


def polygons(random):
    text = ObjText()
    side = 4  # cells along each edge of the cube, a polygon in each
    radius = 0.49 / side
    cells = list(range(side**3))
    random.shuffle(cells)
    for cell in cells[:random.index(40, side**3)]:
        center = tuple((place + 0.5) / side for place in (cell % side, cell // side % side, cell // side // side))
        normal = random.direction()
        x = unit(cross(normal, random.direction()))
        y = cross(normal, x)
        vn = text.add("vn", normal)
        outline = comb(random) if random.index(1, 5) == 1 else any_outline(random, random.index(3, 9))
        corners = [{"v": text.add("v", plus(center, times(radius, plus(times(p.real, x), times(p.imag, y))))), "vn": vn}
                   for p in outline]
        text.add_shuffled(random, corners, "vt", lambda i: (0.5 + 0.45 * outline[i].real, 0.5 + 0.45 * outline[i].imag),
                          range(len(corners)))
        text.face(corners)
    return text


def no_vt(random):
    """A ball out of an octahedron whose edges are cut into so many pieces."""
    pieces = random.index(3, 5)
    x = random.direction()
    y = unit(cross(x, random.direction()))
    z = cross(x, y)
    dents = random.vector(0.1, 0.3)
    text, known, faces = ObjText(), {}, []

    def corner(place):
        if place not in known:
            p = unit(place)
            out = plus(plus(times(p[0], x), times(p[1], y)), times(p[2], z))
            dent = dot(dents, [part * part for part in out])
            known[place] = {"v": text.add("v", [part + 0.5 for part in times(0.48 * (1 - dent), out)]), "vn": text.add("vn", out)}
        return known[place]

    for octant in range(8):
        sign = [-1 if octant & bit else 1 for bit in (1, 2, 4)]
        for i in range(pieces):
            for j in range(pieces - i):
                upward, downward = [(i, j), (i + 1, j), (i, j + 1)], [(i + 1, j), (i + 1, j + 1), (i, j + 1)]
                for cell in [upward] if i + j + 1 == pieces else [upward, downward]:
                    corners = [corner((sign[0] * (pieces - i - j), sign[1] * i, sign[2] * j)) for i, j in cell]
                    faces.append(corners if math.prod(sign) > 0 else [corners[0], corners[2], corners[1]])
    random.shuffle(faces)
    for corners in faces:
        text.face(corners)
    return text


if __name__ == "__main__":
    make = {"numbers": numbers, "negative": negative, "polygons": polygons, "shared": shared, "faces": faces, "no_vt": no_vt}[sys.argv[1]]
    print("\n#\n".join("\n".join(make(Random(int(seed))).lines) for seed in sys.argv[2:]))
