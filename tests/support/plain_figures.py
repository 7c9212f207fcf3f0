# SPDX-License-Identifier: MIT
"""Figures that documents name, worked out from nothing but the scene's numbers and the files' texels: no shader, no sample, no truth of ours."""
import itertools
import math
import struct


def linear(value):
    return value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4


def steps(light):
    return 255 * (12.92 * light if light <= 0.0031308 else 1.055 * light ** (1 / 2.4) - 0.055)


def mean_sign(begin, end):
    """Of a wave that is +1 in each even field, -1 in each odd one: its integral is a wave of triangles."""

    def integral(t):
        return min(t % 2, 2 - t % 2)

    return (integral(end) - integral(begin)) / (end - begin)


def sides(size, half=0.7, distance=10, field_of_view=23.4, repeats=100):
    """Where the pixels of a row begin and end, in pictures, on a square that faces the eye: of those whose middle lies on it."""
    reach = distance * math.tan(math.radians(field_of_view) / 2)
    for i in range(size):
        if abs((2 * i + 1) / size - 1) * reach < half:
            yield tuple((max(-half, min(half, (2 * at / size - 1) * reach)) / half + 1) / 2 * repeats for at in (i, i + 1))


def far_checkers(size, shown, fields=8):
    """How far `shown`, one colour of 8 bits for all, is from the mean of a far checker's light: mean and rms over the pixels. A pixel is a rectangle
    of fields, and the mean of a product of signs is the product of both means."""
    means = [mean_sign(fields * begin, fields * end) for begin, end in sides(size)]
    errors = [abs(shown - steps(0.5 + 0.5 * a * b)) for a in means for b in means]
    return sum(errors) / len(errors), math.sqrt(sum(error * error for error in errors) / len(errors))


class Tiled:
    """The integral of a picture that repeats, from its lower left corner to any place, by the sums of its texels."""

    def __init__(self, size, light):
        self.size, self.sums = size, [[0.0] * (size + 1)]
        for row in range(size):
            line = [0.0, *itertools.accumulate(light[row * size:(row + 1) * size])]
            self.sums.append([above + here for above, here in zip(self.sums[-1], line)])

    def within(self, u, v):
        """To a place inside of the picture, in texels."""
        x, y = min(int(u), self.size - 1), min(int(v), self.size - 1)
        a, b, low, high = u - x, v - y, self.sums[y], self.sums[y + 1]
        return (1 - b) * ((1 - a) * low[x] + a * low[x + 1]) + b * ((1 - a) * high[x] + a * high[x + 1])

    def to(self, u, v):
        """To any place, in pictures."""
        (p, u), (q, v), n = divmod(u, 1), divmod(v, 1), self.size
        return p * q * self.sums[n][n] + p * self.within(n, v * n) + q * self.within(u * n, n) + self.within(u * n, v * n)

    def mean(self, across, up):
        (a, b), (c, d) = across, up
        return (self.to(b, d) - self.to(a, d) - self.to(b, c) + self.to(a, c)) / ((b - a) * (d - c) * self.size**2)


def badges(size, wall, badge):
    """Badges smaller than a pixel on a wall: how far one colour is from the mean of the light over each pixel, in levels, the largest of three
    channels, in the mean over the pixels: with straight alpha, whose mean colour counts also what no one sees, and premultiplied. Both pictures
    are squares of equally many texels."""
    texels = list(zip(wall.pixels(), badge.pixels(), strict=True))
    alphas, rows, errors, count = [top[3] / 255 for _, top in texels], list(sides(size)), ([], []), len(texels)
    alpha = sum(alphas) / count
    for c in range(3):
        behind, top = [linear(low[c] / 255) for low, _ in texels], [linear(high[c] / 255) for _, high in texels]
        light = Tiled(math.isqrt(count), [(1 - a) * b + a * t for a, b, t in zip(alphas, behind, top)])
        seen = sum(a * t for a, t in zip(alphas, top)) / count
        right = [steps(light.mean(across, up)) for up in rows for across in rows]
        for mean, all_errors in zip((alpha * sum(top) / count, seen), errors):
            shown = steps((1 - alpha) * sum(behind) / count + mean)
            all_errors.append([abs(shown - value) for value in right])
    return [sum(map(max, zip(*channels))) / len(rows) ** 2 for channels in errors]


def schlick(index, count=100_000):
    """How far Schlick's share of reflected light is from Fresnel's at most."""

    def fresnel(cosine):
        within = math.sqrt(1 - (1 - cosine * cosine) / index**2)
        return sum(((a - b) / (a + b)) ** 2 for a, b in ((cosine, index * within), (index * cosine, within))) / 2

    straight = ((index - 1) / (index + 1)) ** 2
    return max(abs(straight + (1 - straight) * (1 - i / count) ** 5 - fresnel(i / count)) for i in range(1, count + 1))


def one_ray(distance, count=100_000):
    """How far the ray -eye is from the rays to a unit ball's points, in degrees: mean over the pixels, mean over the visible surface, at the rim.
    The reflected ray is as far off as the one that arrives. A pixel's place is tan(angle) from the middle; even in the disc's area."""
    rim = math.asin(1 / distance)
    over_pixels = sum(math.degrees(math.atan(math.tan(rim) * math.sqrt((i + 0.5) / count))) for i in range(count)) / count
    visible = [(1 / distance + (1 - 1 / distance) * (i + 0.5) / count) for i in range(count)]  # cosines at the ball's middle, even in area
    over_surface = sum(math.degrees(math.atan2(math.sqrt(1 - c * c), distance - c)) for c in visible) / count
    return over_pixels, over_surface, math.degrees(rim)


def dot(a, b):
    return sum(i * j for i, j in zip(a, b))


def cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def pixels_of_triangles(rings, segments, size, distance, field_of_view, turned=lambda point: point):
    """A unit ball of triangles, turned, before an eye on the z axis: each pixel whose middle sees one as (column, row, place). place(column, row) is
    where a pixel's ray meets this triangle's plane, in the ball's own space. Each ray is cut with each triangle's plane."""

    def at(row, column):
        height, around = math.pi * (row / rings - 0.5), 2 * math.pi * column / segments
        return math.cos(height) * math.sin(around), math.sin(height), math.cos(height) * math.cos(around)

    reach = math.tan(math.radians(field_of_view) / 2)
    middles = [((2 * i + 1) / size - 1) * reach for i in range(size)]
    for row, column in itertools.product(range(rings), range(segments)):
        low, high = at(row, column), at(row + 1, column + 1)
        for corners in ((low, at(row, column + 1), high), (low, high, at(row + 1, column))):
            to = [(x, y, z - distance) for x, y, z in map(turned, corners)]
            planes = [cross(to[i - 2], to[i - 1]) for i in range(3)]  # through the eye and the side opposite corner i
            if dot(to[0], planes[0]) >= -1e-12:  # seen from behind, or a pole's without area
                continue

            def shares(i, j):
                return [dot((middles[i], middles[j], -1), plane) for plane in planes]

            def place(i, j):
                of = shares(i, j)
                return [dot(of, axis) / sum(of) for axis in zip(*corners)]

            first, last = ([round((limit(p[axis] / -p[2] for p in to) / reach + 1) / 2 * size) for axis in (0, 1)] for limit in (min, max))
            for j, i in itertools.product(range(max(first[1], 0), min(last[1] + 1, size)), range(max(first[0], 0), min(last[0] + 1, size))):
                if max(shares(i, j)) <= 0:
                    yield i, j, place


def on_ball(size, distance, field_of_view, x, y):
    """Where the ray through a place of the picture, in pixels, meets the unit ball, and the ray; None beside it."""
    reach = math.tan(math.radians(field_of_view) / 2)
    ray = ((2 * x / size - 1) * reach, (2 * y / size - 1) * reach, -1)
    length = dot(ray, ray)
    beyond = distance * distance - length * (distance * distance - 1)
    along = (distance - math.sqrt(max(beyond, 0))) / length
    return (None if beyond < 0 else (ray[0] * along, ray[1] * along, distance - along)), ray


def ball_of_triangles(rings, segments, size, distance=2.5, field_of_view=60):
    """How far a ray is off that is reflected at a unit ball of triangles, by the normal between those at their corners, made unit: mean and largest
    in degrees, over the middles of pixels that see both."""

    def reflected(ray, n):
        twice = 2 * dot(ray, n) / dot(n, n)
        return tuple(r - twice * k for r, k in zip(ray, n))

    errors = []
    for i, j, place in pixels_of_triangles(rings, segments, size, distance, field_of_view):
        exact, ray = on_ball(size, distance, field_of_view, i + 0.5, j + 0.5)
        if exact is None:
            continue
        a, b = reflected(ray, place(i, j)), reflected(ray, exact)
        errors.append(math.degrees(math.atan2(math.hypot(*cross(a, b)), dot(a, b))))
    return sum(errors) / len(errors), max(errors)


def levels_at_a_seam(tilt, turn, yaw, size=256, texels=512, rings=32, segments=64, distance=3, field_of_view=45, rim=0.1):
    """A picture on a ball by longitude and latitude: how far the level of detail is from the exact one, by differences of the coordinates between a
    pixel and its neighbours ("naive"), by the same the short way round ("wrapped"), and by the derivative of the formula ("analytic"): mean and
    largest, but for the pixels that see the ball within `rim` (a cosine) of its side. Neighbours go by two; what a pixel reads of them lies on its
    own triangle's plane."""
    rotations = [(1, 2, math.radians(tilt)), (2, 0, math.radians(turn))]  # about x, then about y; the camera's yaw turns the ball the other way

    def rotated(point, axes, sign):
        point = list(point)
        for a, b, angle in axes:
            c, s = math.cos(sign * angle), math.sin(sign * angle)
            point[a], point[b] = c * point[a] - s * point[b], s * point[a] + c * point[b]
        return point

    forward = [rotations[1], rotations[0], (2, 0, -math.radians(yaw))]

    def texcoord(n):
        return math.atan2(n[0], n[2]) / (-2 * math.pi), math.atan2(math.hypot(n[0], n[2]), n[1]) / math.pi

    def change(a, b, short=True):
        du = texcoord(b)[0] - texcoord(a)[0]
        return du - round(du) * short, texcoord(b)[1] - texcoord(a)[1]

    def derivative(n, dn):
        """Of the two angles where n moves by dn, as a limit."""
        tiny = 1e-6
        du, dv = change(n, [a + tiny * b for a, b in zip(n, dn)])
        return du / tiny, dv / tiny

    def level(changes):
        return math.log2(texels * max(math.hypot(*one) for one in changes))

    errors = {"naive": [], "wrapped": [], "analytic": []}
    for i, j, place in pixels_of_triangles(rings, segments, size, distance, field_of_view, lambda point: rotated(point, forward, 1)):
        hit, ray = on_ball(size, distance, field_of_view, i + 0.5, j + 0.5)
        if hit is None or -dot(ray, hit) < rim * math.hypot(*ray):
            continue
        tiny, exact = 1e-4, []
        for x, y in ((tiny, 0), (0, tiny)):
            ends = [on_ball(size, distance, field_of_view, i + 0.5 + s * x, j + 0.5 + s * y)[0] for s in (-1, 1)]
            du, dv = change(*(rotated(end, reversed(forward), -1) for end in ends))
            exact.append((du / (2 * tiny), dv / (2 * tiny)))

        def unit(x, y):
            n = place(x, y)
            return [k / math.hypot(*n) for k in n]

        # The two neighbours of its group of four, and itself among them.
        pairs = [(unit(i & ~1, j), unit(i | 1, j)), (unit(i, j & ~1), unit(i, j | 1))]
        here = unit(i, j)
        for name, found in (("naive", [change(a, b, False) for a, b in pairs]), ("wrapped", [change(a, b) for a, b in pairs]),
                            ("analytic", [derivative(here, [q - p for p, q in zip(a, b)]) for a, b in pairs])):
            errors[name].append(abs(level(found) - level(exact)))
    return {name: (sum(all_errors) / len(all_errors), max(all_errors)) for name, all_errors in errors.items()}


def single(value):
    """The nearest number of 32 bits."""
    return struct.unpack("f", struct.pack("f", value))[0]


def inverse(matrix):
    """By Gauss and Jordan, with the largest pivot."""
    rows, count = [[*row, *(float(i == j) for j in range(len(matrix)))] for i, row in enumerate(matrix)], len(matrix)
    for c in range(count):
        best = max(range(c, count), key=lambda r: abs(rows[r][c]))
        rows[c], rows[best] = rows[best], rows[c]
        rows[c] = [value / rows[c][c] for value in rows[c]]
        for r in {*range(count)} - {c}:
            rows[r] = [a - rows[r][c] * b for a, b in zip(rows[r], rows[c])]
    return [row[count:] for row in rows]


def unprojected(near, yaw, pitch=20, far=100, distance=2.5, plane=-1, size=256, every=8):
    """How far the directions are off, in degrees, that a camera of 90 degrees finds by points of a plane in clip space minus the eye: mean and largest.
    Camera and shader count in 32 bits: eye, axes, the entries of the inverse matrix, the four corners' points. All else is double."""

    def direction(rounded):
        a, b = (rounded(angle * rounded(math.pi / 180)) for angle in (yaw, pitch))
        return [rounded(rounded(math.sin(a)) * rounded(math.cos(b))), rounded(math.sin(b)), rounded(rounded(math.cos(a)) * rounded(math.cos(b)))]

    def unit(v):
        return [single(k * single(1 / single(math.hypot(*v)))) for k in v]

    def axes(back, rounded, made_unit):
        across = made_unit([rounded(k) for k in cross((0, 1, 0), back)])
        return across, [rounded(k) for k in cross(back, across)]

    eye = [single(distance * k) for k in direction(single)]
    back = unit(eye)
    right, up = axes(back, single, unit)
    view = [[*axis, -single(dot(axis, eye))] for axis in (right, up, back)] + [[0, 0, 0, 1]]
    near, far = single(near), single(far)
    clip_from_view = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, -(far + near) / (far - near), -2 * far * near / (far - near)], [0, 0, -1, 0]]
    world_from_clip = [[single(value) for value in row] for row in inverse([[dot(row, column) for column in zip(*view)] for row in clip_from_view])]
    corners = {}
    for x, y in itertools.product((-1, 1), repeat=2):
        point = [single(single(single(a * x + b * y) + c * plane) + d) for a, b, c, d in world_from_clip]
        corners[x, y] = [single(single(k / point[3]) - e) for k, e in zip(point, eye)]

    behind = direction(float)
    across, above = axes(behind, float, lambda v: [k / math.hypot(*v) for k in v])
    errors = []
    for x, y in itertools.product([(2 * i + 1) / size - 1 for i in range(0, size, every)], repeat=2):
        side = -1 if x + y < 0 else 1  # of the two triangles, whose corners are joined in a straight line
        found = [a + (1 - side * x) / 2 * (b - a) + (1 - side * y) / 2 * (c - a)
                 for a, b, c in zip(corners[side, side], corners[-side, side], corners[side, -side])]
        exact = [x * a + y * b - c for a, b, c in zip(across, above, behind)]
        errors.append(math.degrees(math.atan2(math.hypot(*cross(found, exact)), dot(found, exact))))
    return sum(errors) / len(errors), max(errors)


def without_worst(errors, count):
    """Rms and largest of errors without the worst `count`."""
    rest = sorted(errors)[:-count]
    return math.sqrt(sum(error * error for error in rest) / len(rest)), rest[-1]
