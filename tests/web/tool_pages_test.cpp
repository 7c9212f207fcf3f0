// SPDX-License-Identifier: MIT
// The gallery and the bench's page in a real browser.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "../support/browser.hpp"
#include "../support/picture_files.hpp"
#include "../support/places.hpp"
#include "../support/process.hpp"

namespace texel::tools {
namespace {

/// One browser, and the pages of lab 4, which draws quickly.
class ToolPages : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new test::TemporaryFolder("tool_pages");
    const std::string texel = fmt::format("{}/texel ", test::kBin);
    gallery_ = test::shell(fmt::format("{}gallery --lab 4 --out {}", texel, (*folder_ / "gallery").string()));
    bench_ = test::shell(fmt::format("{}bench 4 --from {}/docs/accuracy.json --out {}", texel, test::kSource,
                                     (*folder_ / "bench").string()));
    shared_browser_ = new test::Browser(TEXEL_CHROMIUM, *folder_ / "profile");
  }
  static void TearDownTestSuite() {
    delete shared_browser_;
    delete folder_;
  }
  ToolPages() {
    browser_.forget();
    browser_.prefer("light");
    browser_.resize(1300, 1000);
  }
  void open(const std::string& page) { browser_.open(*folder_ / page); }

  static inline test::TemporaryFolder* folder_ = nullptr;
  static inline test::Result gallery_, bench_;
  static inline test::Browser* shared_browser_ = nullptr;
  test::Browser& browser_ = *shared_browser_;
};

TEST_F(ToolPages, are_made) {
  EXPECT_EQ(gallery_.exit_code, 0) << gallery_.errors;
  EXPECT_EQ(bench_.exit_code, 0) << bench_.errors;
}

TEST_F(ToolPages, fit_a_phone_and_a_desk_in_light_and_dark) {
  for (const std::string page : {"gallery/index.html", "bench/index.html"})
    for (const int width : {375, 1300})
      for (const std::string scheme : {"light", "dark"}) {
        browser_.prefer(scheme);
        browser_.resize(width, 900);
        open(page);
        EXPECT_EQ(browser_.evaluate("document.querySelectorAll('main > section').length"), 1) << page;
        EXPECT_LE(int(browser_.evaluate("document.documentElement.scrollWidth")), width)
            << page << " " << scheme;
        EXPECT_GE(std::stod(std::string(browser_.evaluate(
                      "String(Math.min(...[...document.querySelectorAll('main svg')].map(s => 11 * "
                      "s.getBoundingClientRect().width / s.viewBox.baseVal.width), 99))"))),
                  10)  // pixels: the plots' letters, which are 11 units high
            << page << " " << width;
      }
  EXPECT_TRUE(browser_.complaints().empty()) << browser_.complaints().front();
}

TEST_F(ToolPages, a_method_s_dot_shows_its_pictures_and_figures) {
  open("bench/index.html");
  browser_.evaluate("document.querySelector('.dot').focus(); 0");
  browser_.wait_for(
      "[...document.querySelectorAll('.tip img')].filter(i => i.naturalWidth > 0).length === 2");
  const std::string tip = browser_.evaluate("document.querySelector('.tip').textContent");
  const std::string name = browser_.evaluate("document.querySelector('.dot text').textContent");
  EXPECT_TRUE(tip.starts_with(name)) << tip;
  browser_.evaluate("document.activeElement.blur(); 0");
  EXPECT_TRUE(browser_.evaluate("document.querySelector('.tip').hidden"));
}

TEST_F(ToolPages, the_gallery_shows_what_fits_the_choices) {
  open("gallery/index.html");
  const auto shown = [&](const std::string& that) {
    return int(browser_.evaluate("document.querySelectorAll('figure:not([hidden])" + that + "').length"));
  };
  const int all = shown("");
  const auto choose = [&](const std::string& id, const std::string& value) {
    browser_.evaluate(
        fmt::format("{{ const s = document.getElementById('{}'); s.value = '{}'; "
                    "s.dispatchEvent(new Event('change', {{bubbles: true}})); }} 0",
                    id, value));
  };
  choose("view", "texcoord");
  const int texcoords = shown("");
  EXPECT_GT(texcoords, 0);
  EXPECT_LT(texcoords, all);
  EXPECT_EQ(texcoords, shown("[data-view=texcoord]"));
  choose("view", "");
  choose("method", "before");
  EXPECT_GT(shown(""), 0);
  EXPECT_EQ(shown(""), shown("[data-methods~=before]"));
  EXPECT_EQ(browser_.evaluate("document.querySelector('.filters output').value"),
            fmt::format("{} of {} pictures", shown(""), all));
}

TEST_F(ToolPages, the_gallery_compares_two_pictures_with_a_slider) {
  open("gallery/index.html");
  browser_.evaluate("document.querySelector('.compare').click(); 0");
  browser_.wait_for("document.querySelector('.stage .over').naturalWidth > 0");
  const auto cut = [&] {
    return std::string(browser_.evaluate("document.querySelector('.stage .over').style.clipPath"));
  };
  EXPECT_NE(browser_.evaluate("document.querySelector('.stage img').src"),
            browser_.evaluate("document.querySelector('.stage .over').src"));
  EXPECT_EQ(cut(), "inset(0px 0px 0px 50%)");
  browser_.evaluate("document.querySelector('.split input').focus(); 0");
  browser_.press("Home");
  EXPECT_EQ(cut(), "inset(0px 0px 0px 0%)");
  EXPECT_EQ(browser_.evaluate("String(document.querySelector('.bar b').hidden)"), "true");  // said above it
  EXPECT_NE(
      std::string(browser_.evaluate("document.querySelector('.bar span').textContent")).find(", picture "),
      std::string::npos);
}

}  // namespace
}  // namespace texel::tools
