# SPDX-License-Identifier: MIT
"""Small plots side by side, drawn as SVG. All have two logarithmic axes, and a name beside each dot."""
import dataclasses
import html
import math

WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 340, 286, 52, 328, 48, 246  # of a panel, and of its axes
COLUMNS = 3
DOT = 5.5  # its radius
CHARACTER, BOLD = 6.3, 7.1  # width of a label's character, at 11 units
ASCENT, DESCENT = 9, 3  # of a label
# Apart also for those who do not see red from green (M. Okabe and K. Ito, "Color Universal Design", 2008).
COLORS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#7f6a00", "#777777")
# The page's custom properties, with light defaults.
INK, QUIET, LINE, CARD = "var(--ink, #1d1f23)", "var(--quiet, #5f646d)", "var(--line, #dedbd3)", "var(--card, #fff)"
# Where a label may stand: right of its dot, left, on the four diagonals, above, below.
DIRECTIONS = ((1, 0), (-1, 0), (0.7, -0.7), (0.7, 0.7), (-0.7, -0.7), (-0.7, 0.7), (0, -1), (0, 1))
DISTANCES = (9, 16, 26, 38, 52, 68, 86, 106, 128)


@dataclasses.dataclass
class Point:
    x: float  # positive
    y: float  # 0 lies on the lower edge
    color: int
    filled: bool  # on the front
    label: str
    title: str  # what hovering shows, lines
    pictures: list = dataclasses.field(default_factory=list)  # files that the page shows beside the title
    up: tuple = None  # the interval of y, low and high, or None
    across: tuple = None  # that of x


@dataclasses.dataclass
class Panel:
    name: str
    points: list = dataclasses.field(default_factory=list)
    lines: list = dataclasses.field(default_factory=list)  # (numbers of points, a color or None for grey)
    is_hard: bool = False


@dataclasses.dataclass
class Plot:
    x_label: str
    y_label: str
    panels: list = dataclasses.field(default_factory=list)


def escaped(text):
    return html.escape(text).replace("&#x27;", "&#39;")


def color(number):
    return COLORS[number % len(COLORS)]


class Axis:
    """A logarithmic axis over whole powers of ten, or over 1-2-5 steps where it is short."""

    def __init__(self, values, begin, end):
        least, most = (min(values), max(values)) if values else (1, 1)
        room = 0.08 * (math.log10(most / least) + 0.6)
        self.begin, self.end = begin, end
        self.least, self.most = math.log10(least) - room, math.log10(most) + room

    def place(self, value):
        return self.begin + (self.end - self.begin) * (math.log10(value) - self.least) / (self.most - self.least)

    def ticks(self):
        decades = self.most - self.least
        digits = (1, 1.5, 2, 3, 4, 5, 6, 8) if decades < 0.7 else (1, 2, 5) if decades < 2.2 else (1,)
        step = max(1, math.ceil(decades / 6))
        values = [digit * 10.0**power for power in range(math.floor(self.least), math.floor(self.most) + 1) if power % step == 0
                  for digit in digits]
        return [value for value in values if self.least <= math.log10(value) <= self.most]


def label_width(point):
    return (BOLD if point.filled else CHARACTER) * len(point.label)


def along(a, b):
    """Small boxes along a line from one place to another."""
    count = max(1, math.ceil(math.dist(a, b) / 4))
    places = ((a[0] + (b[0] - a[0]) * i / count, a[1] + (b[1] - a[1]) * i / count) for i in range(count + 1))
    return [(x - 1, y - 1, x + 1, y + 1) for x, y in places]


def place_labels(points, dots, lines):
    """(x, y, distance from the dot) of each label: as near as there is room, not on a dot, not on another label, and where it can be not on
    a line. The front comes first. A label without room has None: hovering shows it. `lines` is a list of pairs of places."""
    crossed = [box for line in lines for box in along(*line)]
    taken = [(x - DOT, y - DOT, x + DOT, y + DOT) for x, y in dots]  # left, top, right, bottom

    def is_free(box, others):
        inside = box[0] > LEFT + 2 and box[2] < WIDTH - 6 and box[1] > TOP - 8 and box[3] < BOTTOM
        return inside and not any(box[0] < other[2] and other[0] < box[2] and box[1] < other[3] and other[1] < box[3] for other in others)

    def find(point, dot, others):
        width = label_width(point)
        for away in DISTANCES:
            for u, v in DIRECTIONS:
                x = dot[0] + u * away - (width if u < 0 else width / 2 if u == 0 else 0)
                y = dot[1] + v * (away + 3) + (ASCENT - DESCENT) / 2
                if is_free(box := (x, y - ASCENT, x + width, y + DESCENT), others):
                    taken.append(box)
                    return x, y, away
        return None

    labels = [None] * len(points)
    for filled in (True, False):
        for i, point in enumerate(points):
            if point.filled == filled and point.label:
                labels[i] = find(point, dots[i], taken + crossed) or find(point, dots[i], taken)
    return labels


def text(x, y, content, attributes):
    return f'<text x="{x:.1f}" y="{y:.1f}" {attributes}>{escaped(content)}</text>\n'


def grid(across, up):
    out = ""
    for tick in across.ticks():
        out += f'<path d="M{across.place(tick):.1f} {TOP}V{BOTTOM}" stroke="{LINE}"/>\n'
        out += text(across.place(tick), BOTTOM + 15, f"{tick:g}", f'text-anchor="middle" fill="{QUIET}"')
    for tick in up.ticks():
        out += f'<path d="M{LEFT} {up.place(tick):.1f}H{RIGHT}" stroke="{LINE}"/>\n'
        out += text(LEFT - 6, up.place(tick) + 4, f"{tick:g}", f'text-anchor="end" fill="{QUIET}"')
    return out


def whiskers(point, dot, across, up):
    """The intervals of a point as lines through its dot, each from place to place; what is 0 lies on the lower edge."""
    lines = []
    if point.up:
        low, high = (min(max(up.place(value), TOP), BOTTOM) if value > 0 else BOTTOM for value in point.up)
        lines.append(((dot[0], low), (dot[0], high)))
    if point.across:
        lines.append(tuple((across.place(value), dot[1]) for value in point.across))
    return lines


def drawn(point, dot, label):
    out = ""
    if label:
        x, y, distance = label
        if distance > 16:
            end = min(max(dot[0], x), x + label_width(point))
            out += (f'<path d="M{dot[0]:.1f} {dot[1]:.1f}L{end:.1f} {y - (ASCENT - DESCENT) / 2:.1f}" stroke="{color(point.color)}" '
                    'opacity="0.6"/>')
        weight = ' font-weight="600"' if point.filled else ""
        out += text(x, y, point.label, f'fill="{INK}" stroke="{CARD}" stroke-width="3" paint-order="stroke"{weight}')
    pictures = f' data-pictures="{" ".join(point.pictures)}"' if point.pictures else ""
    return (f'<g class="dot" tabindex="0"{pictures}><title>{escaped(point.title)}</title>{out}<circle cx="{dot[0]:.1f}" cy="{dot[1]:.1f}" '
            f'r="{DOT}" fill="{color(point.color) if point.filled else CARD}" stroke="{color(point.color)}" stroke-width="1.6"/></g>\n')


def content(plot, panel):
    """What stands in the panel's <svg>. Errors are compared from panel to panel, and have the same axis in all; costs are not."""
    across = Axis([x for point in panel.points for x in (point.x, *(point.across or ()))], LEFT, RIGHT)
    errors = [y for each in plot.panels for point in each.points for y in (point.y, (point.up or (0, 0))[1]) if y > 0]
    up = Axis(errors, BOTTOM, TOP)
    out = text(8, 18, panel.name, f'font-size="12" font-weight="600" fill="{INK}"')
    out += text(8, 34, plot.y_label + (", a hard case" if panel.is_hard else ""), f'fill="{QUIET}"')
    out += grid(across, up)
    out += text(RIGHT, BOTTOM + 32, plot.x_label, f'text-anchor="end" fill="{QUIET}"')
    dots = [(across.place(point.x), up.place(point.y) if point.y > 0 else BOTTOM) for point in panel.points]
    lines = []
    for points, number in panel.lines:
        if len(points) > 1:
            path = "L".join(f"{dots[i][0]:.1f} {dots[i][1]:.1f}" for i in points)
            stroke = QUIET if number is None else color(number)
            out += f'<path d="M{path}" fill="none" stroke="{stroke}" stroke-width="1.6" opacity="0.55"/>\n'
            lines += [(dots[a], dots[b]) for a, b in zip(points, points[1:])]
    for point, dot in zip(panel.points, dots):
        for begin, end in whiskers(point, dot, across, up):
            out += (f'<path d="M{begin[0]:.1f} {begin[1]:.1f}L{end[0]:.1f} {end[1]:.1f}" stroke="{color(point.color)}" stroke-width="1.2" '
                    'opacity="0.7"/>\n')
            lines.append((begin, end))
    labels = place_labels(panel.points, dots, lines)
    for filled in (False, True):  # the front in front
        out += "".join(drawn(*one) for one in zip(panel.points, dots, labels) if one[0].filled == filled)
    return out


def element(width, height, label, inside, scale=1):
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width * scale:g}" height="{height * scale:g}" role="group" '
            f'aria-label="{escaped(label)}" font-family="system-ui, \'Segoe UI\', Roboto, \'DejaVu Sans\', sans-serif" font-size="11">\n'
            f'<rect width="{width}" height="{height}" fill="{CARD}"/>\n{inside}</svg>\n')


def panel_svgs(plot):
    """Each panel as an <svg> element of its own."""
    return [element(WIDTH, HEIGHT, f"{panel.name}: {plot.y_label} against {plot.x_label}", content(plot, panel)) for panel in plot.panels]


def svg(plot, scale=1):
    """All panels in one <svg> element, three in a row: a picture for a document, so many times as large."""
    count = len(plot.panels)
    inside = "".join(f'<g transform="translate({WIDTH * (i % COLUMNS)} {HEIGHT * (i // COLUMNS)})">\n{content(plot, panel)}</g>\n'
                     for i, panel in enumerate(plot.panels))
    return element(WIDTH * min(count, COLUMNS), HEIGHT * -(-count // COLUMNS), f"{plot.y_label} against {plot.x_label}", inside, scale)
