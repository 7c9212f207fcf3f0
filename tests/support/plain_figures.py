# SPDX-License-Identifier: MIT
"""Figures that documents name, worked out from nothing but the scene's numbers and the files' texels: no shader, no sample, no truth of ours."""
import itertools
import math


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


def ball_of_triangles(rings, segments, size, distance=2.5, field_of_view=60):
    """How far a ray is off that is reflected at a unit ball of triangles, by the normal between those at their corners, made unit: mean and largest
    in degrees, over the middles of pixels that see both. Each ray from the eye is cut with each triangle's plane."""

    def at(row, column):
        height, around = math.pi * (row / rings - 0.5), 2 * math.pi * column / segments
        return math.cos(height) * math.sin(around), math.sin(height), math.cos(height) * math.cos(around)

    def dot(a, b):
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]

    def cross(a, b):
        return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]

    def reflected(ray, n):
        twice = 2 * dot(ray, n) / dot(n, n)
        return tuple(r - twice * k for r, k in zip(ray, n))

    reach, eye, errors = math.tan(math.radians(field_of_view) / 2), (0, 0, distance), []
    pixels = [((2 * i + 1) / size - 1) * reach for i in range(size)]
    for row, column in itertools.product(range(rings), range(segments)):
        low, high = at(row, column), at(row + 1, column + 1)
        for corners in ((low, at(row, column + 1), high), (low, high, at(row + 1, column))):
            to = [(x, y, z - distance) for x, y, z in corners]
            plane = [cross(to[i - 2], to[i - 1]) for i in range(3)]  # through the eye and the side opposite corner i
            if dot(to[0], plane[0]) >= -1e-12:  # seen from behind, or a pole's without area
                continue
            first, last = ([round((limit(p[axis] / -p[2] for p in to) / reach + 1) / 2 * size) for axis in (0, 1)] for limit in (min, max))
            for y, x in itertools.product(pixels[max(first[1], 0):last[1] + 1], pixels[max(first[0], 0):last[0] + 1]):
                ray = (x, y, -1.0)
                shares = [dot(ray, side) for side in plane]
                length, toward = dot(ray, ray), distance  # of the ray; how far along it the middle lies
                beyond = toward * toward - length * (distance * distance - 1)
                if max(shares) > 0 or beyond < 0:
                    continue
                normal = [sum(share * corner[k] for share, corner in zip(shares, corners)) / sum(shares) for k in range(3)]
                exact = [e + r * (toward - math.sqrt(beyond)) / length for e, r in zip(eye, ray)]
                a, b = reflected(ray, normal), reflected(ray, exact)
                errors.append(math.degrees(math.atan2(math.hypot(*cross(a, b)), dot(a, b))))
    return sum(errors) / len(errors), max(errors)


def without_worst(errors, count):
    """Rms and largest of errors without the worst `count`."""
    rest = sorted(errors)[:-count]
    return math.sqrt(sum(error * error for error in rest) / len(rest)), rest[-1]
