#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""drawings.py FOLDER: writes the handouts' drawings as SVG, for light and dark pages. Every point is computed: T and B by the formulas
of step 5.2, ears by those of 3.3, rays by those of 8.1 and 8.3. Exit codes: 0 written, 2 no folder."""
import html
import math
import pathlib
import re
import sys

# In light and in dark. T, B and N are red, green and blue in all drawings, as in the views.
COLORS = {"paper": ("#faf9f6", "#1a1c20"), "ink": ("#1d1f23", "#e8e6e1"), "quiet": ("#666b74", "#9da2ab"), "line": ("#cfcbc2", "#454a53"),
          "wash": ("#ece9e1", "#2a2d33"), "red": ("#c0361d", "#ff8a70"), "green": ("#2b7a2f", "#7fd184"), "blue": ("#1f5fae", "#82b7ff"),
          "gold": ("#a06a00", "#f0c050")}


def add(a, b, factor=1.0):
    return tuple(x + factor * y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def unit(a):
    return tuple(x / math.sqrt(dot(a, a)) for x in a)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


class Drawing:
    """An SVG. Points have y upwards; `frame` says where they lie: the origin in pixels from the upper left, and the pixels of a unit."""

    def __init__(self, width, height, title):
        self.size, self.title, self.parts = (width, height), title, []
        self.frame((0, height), 1)

    def frame(self, origin, scale):
        self.origin, self.scale = origin, scale

    def place(self, point):
        return self.origin[0] + self.scale * point[0], self.origin[1] - self.scale * point[1]

    def polygon(self, points, fill="wash", stroke="ink", width=1.2):
        at = " ".join("%.1f,%.1f" % self.place(point) for point in points)
        self.parts.append(f'<polygon points="{at}" fill="{f"var(--{fill})" if fill else "none"}" stroke="var(--{stroke})" stroke-width="{width}"/>')

    def line(self, a, b, color="line", width=1.0, dashes=""):
        (x, y), (u, v) = self.place(a), self.place(b)
        dashed = f' stroke-dasharray="{dashes}"' if dashes else ""
        self.parts.append(f'<line x1="{x:.1f}" y1="{y:.1f}" x2="{u:.1f}" y2="{v:.1f}" stroke="var(--{color})" stroke-width="{width}"{dashed}/>')

    def arrow(self, a, b, color="ink", width=2.2):
        (x, y), (u, v) = self.place(a), self.place(b)
        length = math.hypot(u - x, v - y)
        dx, dy = (u - x) / length, (v - y) / length
        back = (u - 9 * dx, v - 9 * dy)
        self.parts.append(f'<line x1="{x:.1f}" y1="{y:.1f}" x2="{back[0]:.1f}" y2="{back[1]:.1f}" stroke="var(--{color})" stroke-width="{width}"/>')
        tips = ((u, v), (back[0] - 4.2 * dy, back[1] + 4.2 * dx), (back[0] + 4.2 * dy, back[1] - 4.2 * dx))
        self.parts.append(f'<polygon points="{" ".join("%.1f,%.1f" % tip for tip in tips)}" fill="var(--{color})"/>')

    def dot(self, point, color="ink", radius=3.5):
        x, y = self.place(point)
        self.parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius}" fill="var(--{color})"/>')

    def arc(self, center, radius, begin, end, color="quiet"):
        """Of a circle, between two angles in radians."""
        steps = [begin + (end - begin) * i / 24 for i in range(25)]
        at = " ".join("%.1f,%.1f" % self.place(add(center, (math.cos(a), math.sin(a)), radius)) for a in steps)
        self.parts.append(f'<polyline points="{at}" fill="none" stroke="var(--{color})" stroke-width="1.2"/>')

    def text(self, point, words, color="ink", shift=(0, 0), anchor="middle", bold=False, size=14):
        """`shift` in pixels, downwards. `n_x` has its x lowered."""
        x, y = self.place(point)
        weight = ' font-weight="600"' if bold else ""
        words = re.sub(r"_(.)$", r'<tspan dy="4" font-size="10">\1</tspan>', html.escape(words))
        self.parts.append(f'<text x="{x + shift[0]:.1f}" y="{y + shift[1] + 0.35 * size:.1f}" fill="var(--{color})" text-anchor="{anchor}" '
                          f'font-size="{size}"{weight}>{words}</text>')

    def svg(self):
        width, height = self.size
        light, dark = ("".join(f"--{name}:{pair[i]};" for name, pair in COLORS.items()) for i in (0, 1))
        return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" role="img" '
                f'aria-labelledby="t">\n<title id="t">{html.escape(self.title)}</title>\n'
                f"<style>:root{{{light}}} @media (prefers-color-scheme: dark){{:root{{{dark}}}}} "
                f'text{{font-family:system-ui,"Segoe UI","DejaVu Sans",sans-serif}}</style>\n'
                f'<rect width="{width}" height="{height}" rx="8" fill="var(--paper)"/>\n' + "\n".join(self.parts) + "\n</svg>\n")


def clipped(points, value, level):
    """The two points of a triangle's edges at which a linear value of its corners is `level`; or none."""
    found = []
    for i in range(3):
        a, b = value[i], value[(i + 1) % 3]
        if (a - level) * (b - level) < 0:
            found.append(add(points[i], add(points[(i + 1) % 3], points[i], -1), (level - a) / (b - a)))
    return found


def tangents():
    texcoords = ((0.15, 0.15), (0.9, 0.35), (0.35, 0.9))
    positions = ((0.0, 0.2), (2.2, 0.0), (1.3, 2.0))
    e1, e2 = add(positions[1], positions[0], -1), add(positions[2], positions[1], -1)
    (s1, t1), (s2, t2) = add(texcoords[1], texcoords[0], -1), add(texcoords[2], texcoords[1], -1)
    determinant = s1 * t2 - s2 * t1
    tangent = tuple((t2 * a - t1 * b) / determinant for a, b in zip(e1, e2))
    bitangent = tuple((s1 * b - s2 * a) / determinant for a, b in zip(e1, e2))
    d = Drawing(560, 256, "A triangle in the picture and on the surface: along E1 and E2 both position and texture coordinate change; T is where s grows, B where t grows")
    d.frame((40, 205), 165)
    for i in range(6):
        d.line((i / 5, 0), (i / 5, 1)), d.line((0, i / 5), (1, i / 5))
    d.polygon(texcoords)
    d.arrow((0, 0), (1.06, 0), "red"), d.arrow((0, 0), (0, 1.06), "green")
    d.text((1.06, 0), "s", "red", (10, 0), bold=True), d.text((0, 1.06), "t", "green", (-12, 4), bold=True)
    for i, shift in enumerate(((-11, 9), (14, 2), (-4, -12))):
        d.dot(texcoords[i]), d.text(texcoords[i], f"P{'₁₂₃'[i]}", shift=shift)
    d.text((0.5, 0), "in the picture", "quiet", (0, 22))
    d.frame((290, 205), 88)
    d.polygon(positions)
    for values, axis in ((0, "red"), (1, "green")):
        for i in range(1, 5):
            line = clipped(positions, [one[values] for one in texcoords], i / 5)
            if line:
                d.line(*line, color="line")
    d.arrow(positions[0], positions[1]), d.arrow(positions[1], positions[2])
    d.text(add(positions[0], e1, 0.4), "E₁", shift=(0, 17)), d.text(add(positions[1], e2, 0.5), "E₂", shift=(18, 0))
    for i, shift in enumerate(((-14, 6), (8, 16), (0, -13))):
        d.text(positions[i], f"P{'₁₂₃'[i]}", shift=shift)
    middle = (1.05, 0.62)
    d.arrow(middle, add(middle, tangent, 0.42), "red"), d.arrow(middle, add(middle, bitangent, 0.42), "green")
    d.text(add(middle, tangent, 0.42), "T", "red", (10, -6), bold=True), d.text(add(middle, bitangent, 0.42), "B", "green", (11, 2), bold=True)
    d.dot(middle)
    d.text((1.1, 0), "on the surface", "quiet", (10, 34))
    return d


def mipmaps():
    center, dx, dy = (0.54, 0.5), (0.42, 0.12), (-0.03, 0.11)  # of a picture of 16 x 16 texels
    corners = [add(add(center, dx, u), dy, v) for u, v in ((-.5, -.5), (.5, -.5), (.5, .5), (-.5, .5))]
    longest = max(math.hypot(*dx), math.hypot(*dy)) * 16
    level = math.log2(longest)
    d = Drawing(560, 212, f"One pixel's footprint on four mipmap levels: {longest:.1f} texels long on level 0, half as many on each further one; lambda is {level:.1f}")
    for i in range(4):
        d.frame((20 + 133 * i, 143), 122)
        count = 16 >> i
        d.polygon(((0, 0), (1, 0), (1, 1), (0, 1)), "wash", "line")
        for j in range(1, count):
            d.line((j / count, 0), (j / count, 1)), d.line((0, j / count), (1, j / count))
        d.polygon(corners, None, "gold", 2.5)
        if i == 0:
            d.arrow(add(corners[0], (0, -0.06)), add(corners[1], (0, -0.06)), "red"), d.text(add(center, (0.04, -0.3)), "dx", "red", bold=True)
            d.arrow(add(corners[0], (-0.06, 0)), add(corners[3], (-0.06, 0)), "green"), d.text(add(corners[0], (-0.19, 0.08)), "dy", "green", bold=True)
        d.text((0.5, 0), f"level {i}", shift=(0, 15)), d.text((0.5, 0), f"ρ = {longest / 2 ** i:.1f} texels", "quiet", (0, 32), size=13)
    d.frame((0, 212), 1)
    d.text((280, 16), f"λ = log₂ {longest:.1f} = {level:.1f}: between level {math.floor(level)} and level {math.ceil(level)}", bold=True)
    return d


def rays():
    eta, angle = 1 / 1.5, math.radians(50)
    normal, incident = (0.0, 1.0), (math.sin(angle), -math.cos(angle))
    cos_i = -dot(normal, incident)
    cos_t = math.sqrt(1 - eta * eta * (1 - cos_i * cos_i))
    reflected = add(incident, normal, -2 * dot(normal, incident))
    refracted = add(tuple(eta * x for x in incident), normal, eta * cos_i - cos_t)
    d = Drawing(480, 290, "The incident ray i, the normal n, the reflected ray r above the surface and the refracted ray t below it; glass, seen from air at 50 degrees")
    d.frame((240, 150), 118)
    d.polygon(((-1.9, 0), (1.9, 0), (1.9, -1.1), (-1.9, -1.1)), "wash", "wash")
    d.line((-1.9, 0), (1.9, 0), "ink", 1.5)
    d.line((0, 0), (0, -1), "quiet", 1, "4 4")
    d.arrow(add((0, 0), incident, -1), (0, 0), "ink"), d.arrow((0, 0), normal, "blue"), d.arrow((0, 0), reflected, "red"), d.arrow((0, 0), refracted, "green")
    d.text(add((0, 0), incident, -1), "i", shift=(-10, 0), bold=True), d.text(normal, "n", "blue", (14, 2), bold=True)
    d.text(reflected, "r", "red", (12, 0), bold=True), d.text(refracted, "t", "green", (12, 4), bold=True)
    up, down = math.pi / 2, -math.pi / 2
    d.arc((0, 0), 0.45, up, up + angle), d.arc((0, 0), 0.5, up, up - angle), d.arc((0, 0), 0.5, down, down + math.acos(cos_t))
    d.text((-0.26, 0.52), "θᵢ", "quiet"), d.text((0.28, 0.58), "θᵢ", "quiet"), d.text((0.17, -0.62), "θₜ", "quiet")
    d.text((-1.85, 0), "air, n₁ = 1", "quiet", (0, -13), "start", size=13), d.text((-1.85, 0), "glass, n₂ = 1.5", "quiet", (0, 15), "start", size=13)
    return d


def cube_faces():
    # OpenGL 3.3, table 3.17: of each face the axis, and where s grows and t, which runs downwards; where it lies in the net.
    faces = (("+X", "RIGHT", "−z", "−y", 2, 1), ("−X", "LEFT", "+z", "−y", 0, 1), ("+Y", "UP", "+x", "+z", 1, 2), ("−Y", "DOWN", "+x", "−z", 1, 0),
             ("+Z", "BACK", "+x", "−y", 1, 1), ("−Z", "FRONT", "−x", "−y", 3, 1))
    d = Drawing(520, 400, "The unfolded cube map seen from outside: +Z in the middle, −X left and +X right of it, −Z at the far right, +Y above and −Y below; on each face s to the right and t downwards")
    side = 122
    d.frame((16, 388), side)
    for axis, name, s, t, column, row in faces:
        x, y = column, row
        d.polygon(((x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)), "wash", "ink", 1.5)
        d.text((x + 0.55, y + 0.5), axis, shift=(0, -8), bold=True, size=20), d.text((x + 0.55, y + 0.5), name, "quiet", (0, 13), size=12)
        corner = (x + 0.1, y + 0.9)
        d.arrow(corner, add(corner, (0.42, 0)), "red", 1.8), d.arrow(corner, add(corner, (0, -0.42)), "green", 1.8)
        d.text(add(corner, (0.42, 0)), f"s {s}", "red", (19, 0), size=12), d.text(add(corner, (0, -0.42)), f"t {t}", "green", (9, 11), size=12)
    return d


def spaces():
    d = Drawing(600, 200, "The chain of spaces: object, world, view, clip, picture; each arrow is a matrix, but the last divides by w")
    names = ("object", "world", "view", "clip", "picture")
    notes = ("one model's", "the scene's", "from the eye", "x, y, z, w", "−1 to 1, pixels")
    forward = ("world_from_object", "view_from_world", "clip_from_view", "divide by w")
    back = ("", "R⁻¹: 7.2", "P⁻¹: 7.3", "")
    for i, name in enumerate(names):
        x = 62 + 119 * i
        d.polygon(((x - 47, 74), (x + 47, 74), (x + 47, 124), (x - 47, 124)), "wash", "ink", 1.4)
        d.text((x, 106), name, bold=True), d.text((x, 87), notes[i], "quiet", size=11)
        if i < 4:
            d.arrow((x + 47, 99), (x + 72, 99))
            d.text((x + 59.5, 142 if i % 2 == 0 else 158), forward[i], size=12.5)
            d.line((x + 59.5, 134 if i % 2 == 0 else 150), (x + 59.5, 106), "line")
        if i < 4 and back[i]:
            d.arrow((x + 107, 66), (x + 12, 66), "red", 1.8), d.text((x + 59.5, 50), back[i], "red", size=12.5)
    d.text((300, 183), "clip = P · V · M · object: the matrix that comes first stands on the right", size=13)
    d.text((300, 22), "The environment goes back: direction = R⁻¹ P⁻¹ clip", "red", size=13)
    return d


def ears():
    polygon = ((0, 0), (3.2, 0), (3.2, 0.8), (1.1, 0.8), (1.1, 1.7), (3.2, 1.7), (3.2, 2.5), (0, 2.5))  # the letter C

    def area(a, b, c):
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])

    def state(i):
        a, b, c = polygon[i - 1], polygon[i], polygon[(i + 1) % len(polygon)]
        if area(a, b, c) <= 0:
            return "turns right: no ear"
        others = [p for p in polygon if p not in (a, b, c)]
        inside = any(min(area(a, b, p), area(b, c, p), area(c, a, p)) >= 0 for p in others)
        return "holds a corner: no ear" if inside else "an ear"

    d = Drawing(560, 190, "The letter C three times: a corner that is an ear, one that turns right, and one whose triangle holds another corner")
    for panel, (i, expected) in enumerate(((2, "an ear"), (3, "turns right: no ear"), (0, "holds a corner: no ear"))):
        assert state(i) == expected
        d.frame((22 + 184 * panel, 148), 46)
        a, b, c = polygon[i - 1], polygon[i], polygon[(i + 1) % len(polygon)]
        color = "green" if state(i) == "an ear" else "red"
        d.polygon(polygon, "wash", "ink", 1.6)
        d.line(a, c, color, 2, "5 4")
        for point in polygon:
            d.dot(point, "quiet", 2.8)
        middle = tuple(sum(p[k] for p in polygon) / len(polygon) for k in (0, 1))
        for name, point in zip("abc", (a, b, c)):
            d.dot(point, color), d.text(point, name, color, (9 if point[0] > 2 else -9 if point[0] < 1 else 9, -10 if point[1] > middle[1] or name == "b" and i == 3 else 12), bold=True)
        d.text((1.6, 0), state(i), color, (0, 28))
    return d


class View:
    """A camera far away, for drawings in space: x to the right and nearer, y upwards, z to the left and nearer."""

    def __init__(self, yaw, pitch):
        yaw, pitch = math.radians(yaw), math.radians(pitch)
        self.right = (math.cos(yaw), 0, -math.sin(yaw))
        self.up = (-math.sin(yaw) * math.sin(pitch), math.cos(pitch), -math.cos(yaw) * math.sin(pitch))

    def __call__(self, point):
        return dot(point, self.right), dot(point, self.up)


def frame():
    see = View(28, 24)
    lean = unit((0.5, 0.35, 1.0))  # in the tangent frame: along T, B and N
    tangent, bitangent, normal = (1, 0, 0), (0, 0, -1), (0, 1, 0)  # the patch lies level, T × B = N
    assert cross(tangent, bitangent) == normal
    bent = add(add(tuple(lean[0] * x for x in tangent), bitangent, lean[1]), normal, lean[2])
    d = Drawing(480, 230, "A patch of the surface with T, B and N; the bent normal n' is n_x T + n_y B + n_z N")
    d.frame((215, 155), 125)
    d.polygon([see(p) for p in ((-1.1, 0, 0.8), (1.1, 0, 0.8), (1.1, 0, -0.8), (-1.1, 0, -0.8))], "wash", "line")
    for i in range(-2, 3):
        d.line(see((-1.1, 0, 0.4 * i)), see((1.1, 0, 0.4 * i)))
        d.line(see((0.55 * i, 0, 0.8)), see((0.55 * i, 0, -0.8)))
    foot = add(tuple(lean[0] * x for x in tangent), bitangent, lean[1])
    d.line(see((0, 0, 0)), see(tuple(lean[0] * x for x in tangent)), "red", 4), d.line(see(tuple(lean[0] * x for x in tangent)), see(foot), "green", 4)
    d.line(see(foot), see(bent), "blue", 2, "5 4")
    for name, axis, color, shift in (("T", tangent, "red", (12, 6)), ("B", bitangent, "green", (12, 0)), ("N", normal, "blue", (-14, 4))):
        d.arrow(see((0, 0, 0)), see(axis), color), d.text(see(axis), name, color, shift, bold=True)
    d.arrow(see((0, 0, 0)), see(bent), "gold", 3), d.text(see(bent), "n′", "gold", (14, -2), bold=True)
    d.text(see(tuple(0.5 * lean[0] * x for x in tangent)), "n_x", "red", (-4, 16)), d.text(see(add(foot, bitangent, -0.5 * lean[1])), "n_y", "green", (16, 10))
    d.text(see(add(foot, normal, 0.5)), "n_z", "blue", (17, 4))
    return d


def corners():
    see = View(24, 20)
    faces = (((1, 0, 0), "red", ((0, -1, 0), (0, 0, -1))), ((0, 1, 0), "green", ((-1, 0, 0), (0, 0, -1))), ((0, 0, 1), "blue", ((-1, 0, 0), (0, -1, 0))))
    d = Drawing(560, 262, "A cube's corner: one shared vertex has one texture coordinate and one normal that leans between the faces; split, each of the three faces has its own")
    for origin, gap in (((160, 115), 0.0), ((430, 121), 0.2)):
        d.frame(origin, 92)
        for normal, color, (u, v) in faces:
            corner = tuple(gap * x for x in normal)
            ring = (corner, add(corner, u, 0.9), add(add(corner, u, 0.9), v, 0.9), add(corner, v, 0.9))
            d.polygon([see(p) for p in ring], "wash", "ink", 1.3)
        for normal, color, _ in faces if gap else ():
            corner = tuple(gap * x for x in normal)
            d.arrow(see(corner), see(add(corner, normal, 0.62)), color), d.dot(see(corner), color, 5)
        if not gap:
            mean = unit((1, 1, 1))
            d.arrow(see((0, 0, 0)), see(tuple(0.9 * x for x in mean)), "gold", 3), d.dot(see((0, 0, 0)), "gold", 6)
    d.frame((0, 262), 1)
    d.text((150, 26), "one vertex: one (s, t), one normal,"), d.text((150, 10), "54.7° off for each of the faces", "quiet", size=13)
    d.text((420, 26), "three vertices at one place:"), d.text((420, 10), "each face has its own (s, t) and normal", "quiet", size=13)
    return d


DRAWINGS = {"tangents": tangents, "mipmaps": mipmaps, "rays": rays, "cube_faces": cube_faces, "spaces": spaces, "ears": ears, "frame": frame, "corners": corners}


def main(folder):
    for name, draw in DRAWINGS.items():
        (pathlib.Path(folder) / f"{name}.svg").write_text(draw().svg(), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]) if len(sys.argv) == 2 else __doc__ and 2)
