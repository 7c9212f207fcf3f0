#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The gallery and the bench's page in a real browser, of lab 4, which draws quickly. tool_pages_test.py CHROMIUM BUILD, in the tree's root"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

from browser import Browser

CHROMIUM, TEXEL = sys.argv[1], pathlib.Path(sys.argv[2], "bin/texel")


class ToolPages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        for page, arguments in (("gallery", ["gallery", "--lab", "4"]), ("bench", ["bench", "4", "--from", "docs/accuracy.json"])):
            subprocess.run([TEXEL, *arguments, "--out", cls.folder / page], check=True, stdout=subprocess.DEVNULL)
        cls.browser = Browser(CHROMIUM, cls.folder / "profile")
        cls.addClassCleanup(cls.browser.close)

    def setUp(self):
        self.ask, self.act = self.browser.ask, self.browser.act
        self.browser.complaints.clear()
        self.browser.prefer("light")
        self.browser.resize(1300, 1000)

    def open(self, page):
        self.browser.open(self.folder / page / "index.html")

    def test_fit_a_phone_and_a_desk_in_light_and_dark(self):
        for page in ("gallery", "bench"):
            for width in (375, 1300):
                for scheme in ("light", "dark"):
                    with self.subTest(page, width=width, scheme=scheme):
                        self.browser.prefer(scheme)
                        self.browser.resize(width, 900)
                        self.open(page)
                        self.assertEqual(self.ask("document.querySelectorAll('main > section').length"), 1)
                        self.assertLessEqual(self.ask("document.documentElement.scrollWidth"), width)
                        letters = self.ask("""[...document.querySelectorAll('main svg')].map(s => 11 * s.getBoundingClientRect().width /
                            s.viewBox.baseVal.width)""")
                        self.assertGreaterEqual(min(letters, default=99), 10)  # pixels: the plots' letters, which are 11 units high
        self.assertEqual(self.browser.complaints, [])

    def test_a_method_s_dot_shows_its_pictures_and_figures(self):
        self.open("bench")
        self.act("document.querySelector('.dot').focus();")
        self.browser.wait_for("[...document.querySelectorAll('.tip img')].filter(i => i.naturalWidth > 0).length === 2")
        self.assertTrue(self.ask("document.querySelector('.tip').textContent.startsWith(document.querySelector('.dot text').textContent)"))
        self.act("document.activeElement.blur();")
        self.assertTrue(self.ask("document.querySelector('.tip').hidden"))

    def test_the_gallery_shows_what_fits_the_choices(self):
        self.open("gallery")
        self.assertEqual(self.ask("document.querySelectorAll('.view-legend').length"),
                         self.ask("document.querySelectorAll('figure[data-view]:not([data-view=color])').length"))

        def count(that=""):
            return self.ask(f"document.querySelectorAll('figure:not([hidden]){that}').length")

        def choose(name, value):
            self.act(f"""const s = document.getElementById('{name}'); s.value = '{value}';
                s.dispatchEvent(new Event('change', {{bubbles: true}}));""")

        everything = count()
        choose("view", "texcoord")
        self.assertTrue(0 < count() < everything)
        self.assertEqual(count(), count("[data-view=texcoord]"))
        choose("view", "")
        choose("method", "before")
        self.assertGreater(count(), 0)
        self.assertEqual(count(), count("[data-methods~=before]"))
        self.assertEqual(self.ask("document.querySelector('.filters output').value"), f"{count()} of {everything} pictures")

    def test_the_gallery_compares_two_pictures_with_a_slider(self):
        self.open("gallery")
        self.act("document.querySelector('.compare').click();")
        self.browser.wait_for("document.querySelector('.stage .over').naturalWidth > 0")
        self.assertTrue(self.ask("document.querySelector('.stage img').src !== document.querySelector('.stage .over').src"))
        cut = "document.querySelector('.stage .over').style.clipPath"
        self.assertEqual(self.ask(cut), "inset(0px 0px 0px 50%)")
        self.act("document.querySelector('.split input').focus();")
        self.browser.press("Home")
        self.assertEqual(self.ask(cut), "inset(0px 0px 0px 0%)")
        self.assertTrue(self.ask("document.querySelector('.bar b').hidden"))  # said above it
        self.assertIn(", picture ", self.ask("document.querySelector('.bar span').textContent"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
