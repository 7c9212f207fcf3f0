#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The report's pages in a real browser, used by hand: keys, wheel and sliders. report_pages_test.py CHROMIUM PROGRAM, which writes the
demo class (tests/support/demo_class.hpp)."""
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from browser import Browser

CHROMIUM, PROGRAM = sys.argv[1:3]
YOURS, EXPECTED = "[data-pane=yours] canvas", "[data-pane=expected] canvas"
SIZE = 64  # pixels of a picture's side

# A page, an element, and how its text goes, without blanks: between elements none is heard or seen.
SAID = [
    ("ada-half.html", ".masthead", "Ada Half 10232 6 of 12 points Correct this first: step 5.2: Build the tangent frame"),
    ("ada-half.html", "#step-5\\.2 .cause", "This looks like: Green is inverted: in these maps green points up (+Y)."),
    ("ada-half.html", "#step-5\\.2 .cause b", "Green is inverted"),
    ("ada-half.html", ".place code", "shaders/05_normal_map/tangent_frame.glsl:42"),
    ("ada-half.html", ".hint", "Hint T, B and N are the columns of a matrix."),
    ("ada-half.html", "#step-5\\.2 .others", "✓ Passed: flat_normal"),
    ("ada-half.html", "#facts", "The command below a picture draws it again in your own tree."),
    ("ben-nothing.html", ".hint code", "v/vt/vn"),
    ("index.student.html", ".start", "Every step passed."),
    ("dora-incident.html", ".masthead", "Not graded The grader could not finish."),
    ("emil-bomb.html", ".start", "The submission the archive unpacks to more than 512 MiB"),
    ("cleo-broken.html", ".start", "Correct the compiler's errors, then step 5.1"),
    ("cleo-broken.html", "#step-9\\.1", "– 9.1 Take the slope of the height not begun 0.75 / 3"),
    ("cleo-broken.html", "#ignored", "2 files of the submission not used build/CMakeCache.txt no file of the labs"),
    ("wolfeschlegelsteinhausenbergerdorff.html", "#step-5\\.2",
     "✓ 5.2 Build the tangent frame passed 3 / 4 The teacher set these points: right idea, shown in the lab session"),
    ("index.html", ".masthead", "Class report 8 students. Mean 4.8 of 12 points, median 4.5. 1 not graded."),
    # Those who tried count, and first comes the step that most fail.
    ("index.html", "#steps", "Steps that are not right yet 6 5.3 Light the normal 86 % of 7 students who began it 5 5.2 Build the tangent "
     "frame 71 % of 7 students who began it 5 9.1 Take the slope of the height 83 % of 6 students who began it 4 5.1 "),
    # Ada, Cleo and the hostile student count once, though each shows it in several steps.
    ("index.html", "#mistakes li", "3 </script>"),
    ("index.html", "#mistakes li:nth-child(2)", "1 T must be made perpendicular to N again steps 5.3, 9.1"),
    ("index.html", ".pick code", "N"),
    ("index.html", "#mistakes > p", "10 failed steps look like no known mistake: 3.1 (2), 5.1 (2), 5.2 (2), 5.3 (2), 9.1 (2)."),
    ("index.html", "#incidents dl", "Dora Incident lab 5: the sandbox could not start: no space left on the disk"),
    ("index.html", "#changes tbody", "Ada Half 5.1 25 % 100 % ▲ Ben Nothing 5.2 50 % 25 % ▼"),
    ("index.html", "[data-state=incident] td.step", "· 3.1 not judged"),
    ("index.html", "tfoot", "Passed by 4 3 2 1 1"),
    ("index.html", "#facts code", "texel grade class --out out/grade --labs 3,5,9"),
]

# WCAG 2.2, 1.4.3: the least contrast between a text and what is behind it.
CONTRAST = r"""(() => {
  const luminance = (color) => color.match(/[\d.]+/g).slice(0, 3).map(Number).map(c => c / 255)
      .map(c => c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4)
      .reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i], 0);
  let least = 100;
  for (const e of document.querySelectorAll('p, td, th, a, button, h1, h2, h3, h4, code, summary, figcaption, li span')) {
    if (!e.textContent.trim() || !e.offsetParent) continue;
    let back = e;
    while (back && getComputedStyle(back).backgroundColor.endsWith(', 0)')) back = back.parentElement;
    const a = luminance(getComputedStyle(e).color);
    const b = luminance(getComputedStyle(back || document.body).backgroundColor);
    least = Math.min(least, (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05));
  }
  return least; })()"""


def ball(x, y, flipped):
    """The normal of the demo's ball at a pixel, (0, 0, 0) beside it; `flipped` as a student sees it who turns green round."""
    nx, ny = (((2 * value + 1) / SIZE - 1) / 0.8 for value in (x, y))
    rest = 1 - nx * nx - ny * ny
    return (nx, -ny if flipped else ny, math.sqrt(rest)) if rest > 0 else (0, 0, 0)


def lit(x, y, flipped):
    """The color of the demo's lit ball at a pixel of it."""
    normal = ball(x, y, flipped)
    return round(40 + 200 * max(0, -0.5 * normal[0] + 0.6 * normal[1] + 0.62 * normal[2]))


def degrees_between(x, y):
    return math.degrees(math.acos(max(-1, min(1, sum(a * b for a, b in zip(ball(x, y, False), ball(x, y, True)))))))


def shown(x, y, flipped):
    """A normal as the data view shows it."""
    return [math.floor(255 * (0.5 + 0.5 * value) + 0.5) for value in ball(x, y, flipped)]


class ReportPages(unittest.TestCase):
    """One browser and one class for all tests; none changes what another sees."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        cls.addClassCleanup(folder.cleanup)
        subprocess.run([PROGRAM, f"{folder.name}/out"], check=True)
        cls.report = pathlib.Path(folder.name, "out/report")
        cls.pages = sorted(file.name for file in cls.report.iterdir())
        cls.browser = Browser(CHROMIUM, f"{folder.name}/profile")
        cls.addClassCleanup(cls.browser.close)

    def setUp(self):
        self.ask, self.act, self.press = self.browser.ask, self.browser.act, self.browser.press
        self.browser.requests.clear()
        self.browser.complaints.clear()
        self.browser.prefer("light")
        self.browser.resize(1280, 1000)

    def open(self, page):
        self.browser.open(self.report / page)

    def open_case(self, view):
        """Opens Ada's page and makes the comparison of one of her cases; "normal" for a data view, else "color"."""
        self.open("ada-half.html")
        self.act(f"""window.v = [...document.querySelectorAll('.viewer')].find(v => v.dataset.view === '{view}' &&
            v.querySelector('[data-pane=expected]')); v.scrollIntoView({{behavior: 'instant'}});""")
        self.browser.wait_for("v.classList.contains('ready')")
        self.act("v.querySelector('.panes').focus({preventScroll: true});")

    def text(self, selector):
        return self.ask(f"v.querySelector('{selector}').textContent")

    def pixel(self):
        return self.text(".readout caption")

    def is_zoomed(self):
        return self.ask("v.classList.contains('zoomed')")

    def numbers(self, row):
        """A row of the pixel's numbers: "Yours", "Expected" or "Difference"."""
        return self.ask(f"""[...[...v.querySelectorAll('.readout tr')].find(r => r.cells[0].textContent === '{row}').cells].slice(1)
            .map(c => c.textContent)""")

    def number_above(self):
        return self.ask(r"Number([...v.querySelectorAll('output')].at(-1).value.match(/: (\d+) pixels/)[1])")

    def go_to(self, x, y):
        """Moves the choice to a pixel counted from the lower left, by keys alone."""
        self.press("Shift+ArrowLeft", 8)
        self.press("Shift+ArrowDown", 8)
        self.press("ArrowRight", x)
        self.press("ArrowUp", y)

    def color(self, pane, x, y):
        """The color in the middle of a picture's pixel as it stands in a pane, while all of it is shown."""
        return self.ask(f"""(() => {{ const c = v.querySelector('{pane}'), s = c.width / {SIZE}; return [...c.getContext('2d').getImageData(
            Math.floor(s * ({x} + 0.5)), Math.floor(s * ({SIZE - 1} - {y} + 0.5)), 1, 1).data.slice(0, 3)]; }})()""")

    def place_in(self, pane, part):
        """Where a pane's picture is in the window, at a part of its width and height."""
        return self.ask(f"(b => [b.left + b.width * {part}, b.top + b.height * {part}])(v.querySelector('{pane}').getBoundingClientRect())")

    def test_vertex_streams_show_where_they_differ(self):
        self.open("ben-nothing.html")
        shown = "#step-3\\\\.1 .case:nth-of-type(1) [data-pane={}] img"
        for pane in ("yours", "expected"):
            reds = self.ask(f"""(async () => {{ const image = document.querySelector('{shown.format(pane)}');
                await image.decode();
                const canvas = Object.assign(document.createElement('canvas'), {{width: image.naturalWidth, height: image.naturalHeight}});
                const context = canvas.getContext('2d');
                context.drawImage(image, 0, 0);
                const {{data}} = context.getImageData(0, 0, canvas.width, canvas.height), reds = [0, 0];
                for (let i = 0; i < data.length; i += 4)
                  if (data[i] > 200 && data[i + 1] < 100) ++reds[(i / 4) % canvas.width < canvas.width / 2 ? 0 : 1];
                return reds; }})()""")
            self.assertEqual(reds, [50, 0], pane)  # a dot of 5x5 pixels at both vertices on the left

    def test_say_what_the_grader_found(self):
        for page, selector, says in SAID:
            with self.subTest(page, selector=selector):
                self.open(page)
                text = self.ask(f"document.querySelector(String.raw`{selector}`).textContent")
                self.assertIn(re.sub(r"\s", "", says), re.sub(r"\s", "", text))

    def test_link_students_and_their_steps(self):
        self.open("index.html")
        for links, expected in (("#changes a", ["ada-half.html#step-5.1", "ben-nothing.html#step-5.2"]), ("#incidents a", ["dora-incident.html"]),
                                ("tbody .name a", ["index.student.html", "ada-half.html", "ben-nothing.html", "cleo-broken.html"])):
            found = self.ask(f"[...document.querySelectorAll('{links}')].map(a => a.getAttribute('href'))")
            self.assertEqual(found[:len(expected)], expected)
        self.open("ada-half.html")
        self.assertEqual(self.ask("[...document.querySelectorAll('nav a, .start a')].map(a => a.getAttribute('href'))"),
                         ["#step-5.2", "#lab3", "#lab5", "#lab9"])

    def test_show_the_real_numbers_of_a_pixel_that_keys_choose(self):
        self.open_case("normal")
        for x, y in ((20, 45), (33, 12)):
            self.go_to(x, y)
            self.assertEqual(self.pixel(), f"Pixel {x}, {y} from the lower left")
            for row, flipped in (("Yours", True), ("Expected", False)):
                for value, expected in zip(self.numbers(row), ball(x, y, flipped), strict=True):
                    self.assertAlmostEqual(float(value), expected, delta=1e-4)  # four decimals are shown
            number, _, unit = self.numbers("Difference")[0].partition(" ")
            self.assertAlmostEqual(float(number), degrees_between(x, y), delta=0.5)  # three digits are shown
            self.assertEqual(unit, "degrees")

    def test_show_the_steps_of_a_color_picture(self):
        self.open_case("color")
        self.go_to(20, 45)
        right, wrong = lit(20, 45, False), lit(20, 45, True)
        self.assertEqual([self.numbers(row) for row in ("Yours", "Expected")], [[str(wrong)] * 3, [str(right)] * 3])
        self.assertEqual(self.numbers("Difference"), [f"{abs(right - wrong)} 8-bit steps"])

    def test_begin_at_the_worst_pixel_and_mark_those_above_the_tolerance(self):
        self.open_case("normal")
        off = [degrees_between(x, y) for x in range(SIZE) for y in range(SIZE) if ball(x, y, False) != (0, 0, 0)]
        self.assertAlmostEqual(float(self.numbers("Difference")[0].split()[0]), max(off), delta=0.5)
        worst = self.pixel()
        self.press("ArrowLeft")
        self.assertNotEqual(self.pixel(), worst)
        self.press("w")
        self.assertEqual(self.pixel(), worst)

        self.assertEqual(self.number_above(), sum(value > 0.2 for value in off))  # the case's limit
        self.act("v.querySelectorAll('input')[1].focus();")
        self.press("End")
        self.assertEqual(self.number_above(), 0)
        self.press("Home")
        everywhere = self.number_above()
        self.assertEqual(everywhere, len(off))
        self.press("ArrowRight", 50)
        self.assertTrue(0 < self.number_above() < everywhere)
        # Grey within the tolerance, in colors above it.
        far, near = 32 + 20, 33
        self.assertGreater(degrees_between(32, far), 60)
        self.assertLess(degrees_between(32, near), 10)
        is_grey = [red == green for red, green, _ in (self.color(".difference canvas", 32, y) for y in (far, near))]
        self.assertEqual(is_grey, [False, True])

    def test_split_the_first_picture_between_yours_and_expected(self):
        self.open_case("normal")
        self.assertEqual(self.color(YOURS, 44, 44), shown(44, 44, True))
        self.assertEqual(self.color(EXPECTED, 44, 44), shown(44, 44, False))
        self.press("s")
        self.assertEqual(self.color(YOURS, 20, 44), shown(20, 44, True))  # left half
        self.assertEqual(self.color(YOURS, 44, 44), shown(44, 44, False))  # right half
        self.assertEqual(self.text("[data-pane=yours] figcaption"), "Yours | Expected")
        self.act("v.querySelectorAll('input')[0].focus();")
        self.press("Home")
        self.assertEqual(self.color(YOURS, 20, 44), shown(20, 44, False))
        self.press("End")
        self.assertEqual(self.color(YOURS, 44, 44), shown(44, 44, True))

    def test_zoom_by_keys_buttons_and_wheel(self):
        self.open_case("normal")
        # With all shown a background pixel is in the corner; zoomed to the ball's middle there is none.
        background = self.color(EXPECTED, 1, 62)
        self.go_to(32, 32)
        self.assertFalse(self.is_zoomed())
        self.press("+", 2)
        self.assertTrue(self.is_zoomed())
        self.assertNotEqual(self.color(EXPECTED, 1, 62), background)
        self.press("-")
        self.assertTrue(self.is_zoomed())
        self.press("0")
        self.assertFalse(self.is_zoomed())
        self.assertEqual(self.color(EXPECTED, 1, 62), background)

        self.act("""v.querySelector('button[aria-label="Zoom in"]').focus();""")
        self.press("Enter")
        self.assertTrue(self.is_zoomed())
        self.press("Tab")
        self.press("Enter")  # Fit
        self.assertFalse(self.is_zoomed())

        x, y = self.place_in(EXPECTED, 0.25)
        # The wheel belongs to the page until a picture was clicked.
        self.act("document.activeElement.blur();")
        self.browser.mouse("mousePressed", x, y)
        self.browser.mouse("mouseReleased", x, y)
        self.assertEqual(self.pixel(), "Pixel 16, 47 from the lower left")
        self.browser.mouse("mouseWheel", x, y, -100)
        self.browser.wait_for("v.classList.contains('zoomed')")
        self.assertEqual(self.pixel(), "Pixel 16, 47 from the lower left")  # which stays below the pointer
        self.browser.mouse("mouseWheel", x, y, 100)
        self.browser.wait_for("!v.classList.contains('zoomed')")

    def test_move_a_zoomed_picture_under_the_pointer(self):
        self.open_case("normal")
        self.go_to(32, 32)
        self.press("+", 2)
        before = self.color(EXPECTED, 20, 20)
        x, y = self.place_in(YOURS, 0.5)
        self.browser.mouse("mousePressed", x, y)
        self.browser.mouse("mouseMoved", x + 40, y + 30)
        self.browser.mouse("mouseReleased", x + 40, y + 30)
        self.assertNotEqual(self.color(EXPECTED, 20, 20), before)

    def test_are_used_by_keys_alone(self):
        self.open("ada-half.html")
        self.browser.wait_for("document.querySelector('.viewer.ready')")
        reached = set()
        for _ in range(60):
            self.press("Tab")
            reached.add(self.ask("(e => [e.tagName, e.type, e.className].filter(Boolean).join(' '))(document.activeElement)"))
        self.assertLessEqual({"A", "SUMMARY", "DIV panes", "BUTTON button", "INPUT range", "BUTTON button copy"}, reached)
        self.act("document.querySelector('.hint summary').focus();")
        self.assertFalse(self.ask("document.querySelector('.hint').open"))
        self.press("Enter")
        self.assertTrue(self.ask("document.querySelector('.hint').open"))

    def test_need_no_network_and_complain_of_nothing(self):
        for page in self.pages:
            self.open(page)
            self.act("document.querySelectorAll('details').forEach(d => { d.open = true; });")
            self.act("document.querySelectorAll('.viewer').forEach(v => near.observe(v));")
            for i in range(self.ask("document.querySelectorAll('.viewer').length")):
                self.act(f"window.v = document.querySelectorAll('.viewer')[{i}]; v.scrollIntoView({{behavior: 'instant'}});")
                self.browser.wait_for("v.matches('.ready')")
        for address in self.browser.requests:
            self.assertRegex(address, "^(file://|data:)")
        self.assertTrue(self.browser.requests)
        self.assertEqual(self.browser.complaints, [])

    def test_run_nothing_of_a_hostile_student(self):
        for page in ("script-1a2b3c4d.html", "index.html"):
            self.open(page)
            self.assertNotEqual(self.ask("document.title"), "harmed")
            self.assertEqual(self.ask("document.scripts.length"), 2)  # the data and the page's own
            self.assertEqual(self.ask("""document.querySelectorAll('img:not([src^="data:image/png"])').length"""), 0)
            self.assertTrue(self.ask("document.body.innerText.includes('<img src=x onerror=')"))
            for address in self.ask("[...document.links].map(a => a.getAttribute('href'))"):
                self.assertRegex(address, r"^(#|[^/:]+\.html)")
            # And if some text had slipped through, it would not run.
            self.act("""const s = document.createElement('script'); s.textContent = 'document.title = "harmed"'; document.body.append(s);
                document.body.insertAdjacentHTML('beforeend', '<img src=x onerror="document.title=`harmed`">');""")
            self.ask("new Promise(done => setTimeout(done, 100))")
            self.assertNotEqual(self.ask("document.title"), "harmed")
        self.assertEqual([address for address in self.browser.requests if address.startswith("http")], [])

    def test_fit_on_a_phone(self):
        self.browser.resize(390, 844, True)
        for page in self.pages:
            self.open(page)
            self.act("document.querySelectorAll('details').forEach(d => { d.open = true; });")
            self.ask("new Promise(done => setTimeout(done, 200))")
            # With its sliders and readout a viewer is the widest part.
            if self.ask("document.querySelector('.viewer img') !== null"):
                self.act("document.querySelector('.viewer:has(img)').scrollIntoView();")
                self.browser.wait_for("document.querySelector('.viewer.ready')")
            wide = self.ask("""[...document.querySelectorAll('body *')].filter(e => e.getBoundingClientRect().right > 391)
                .map(e => e.outerHTML.slice(0, 90))""")
            self.assertLessEqual(self.ask("document.documentElement.scrollWidth"), 390, f"{page}: {wide}")

    def test_a_wide_window_shows_the_labs_that_a_narrow_one_scrolls_to(self):
        for width, fits in (1280, False), (1920, True):
            self.browser.resize(width, 1000)
            self.open("index.html")
            self.act("document.querySelector('.class td.step').style.minWidth = '900px';")  # as wide as a whole course's
            table = "document.querySelector('#students .scroll')"
            self.assertEqual(self.ask(f"{table}.scrollWidth <= {table}.clientWidth"), fits)
            self.assertLessEqual(self.ask("document.documentElement.scrollWidth"), width)

    def test_are_readable_in_light_and_dark(self):
        papers = set()
        for scheme in ("light", "dark"):
            for page in ("index.html", "ada-half.html", "dora-incident.html", "cleo-broken.html"):
                self.browser.prefer(scheme)
                self.open(page)
                papers.add(self.ask("getComputedStyle(document.body).backgroundColor"))
                self.assertGreaterEqual(self.ask(CONTRAST), 4.5, f"{page} in {scheme}")
        self.assertEqual(len(papers), 2)

    def test_sort_and_filter_the_class(self):
        self.open("index.html")

        def names():
            return self.ask("""[...document.querySelector('table.class').tBodies[0].rows].filter(r => !r.hidden)
                .map(r => r.querySelector('a').textContent.slice(0, 11))""")

        self.assertEqual(len(names()), 8)
        self.act("document.querySelectorAll('.class thead button')[1].focus();")
        self.press("Enter")
        self.assertEqual((names()[0], names()[-1]), ("Index Page", "Dora Incide"))  # the most points, and none at all
        self.press("Enter")
        self.assertEqual(names()[-1], "Index Page")
        self.assertEqual(self.ask("document.querySelectorAll('[aria-sort=ascending]').length"), 1)

        self.act("document.getElementById('find').focus();")
        self.browser.type("1023")
        self.assertEqual(len(names()), 7)  # the hostile student has another number
        self.browser.type("4")
        self.assertEqual(names(), ["Cleo Broken"])
        self.act("""document.getElementById('find').value = ''; document.getElementById('show').value = 'incident';
            document.getElementById('show').dispatchEvent(new Event('change'));""")
        self.assertEqual(names(), ["Dora Incide"])
        self.act("document.getElementById('show').value = ''; document.querySelector('.pick').focus();")
        self.press("Enter")
        self.assertEqual(len(names()), 3)  # who turned green round
        self.press("Enter")
        self.assertEqual(len(names()), 8)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
