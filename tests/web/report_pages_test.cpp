// SPDX-License-Identifier: MIT
// The report's pages in a real browser, used by hand: keys, wheel and sliders.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <sstream>

#include "../support/browser.hpp"
#include "../support/demo_class.hpp"
#include "../support/picture_files.hpp"
#include "reports/reports.hpp"

namespace texel::reports {
namespace {

namespace fs = std::filesystem;

/// One browser and one class for all tests; none changes what another sees.
class ReportPages : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new test::TemporaryFolder("report_pages");
    results_ = new store::ClassResult(test::demo_class(*folder_ / "out"));
    write_html(*results_, *folder_ / "out");
    shared_browser_ = new test::Browser(TEXEL_CHROMIUM, *folder_ / "profile");
  }
  static void TearDownTestSuite() {
    delete shared_browser_;
    delete results_;
    delete folder_;
  }
  ReportPages() {
    browser_.forget();
    browser_.prefer("light");
    browser_.resize(1280, 1000);
  }

  void open(const std::string& page) { browser_.open(*folder_ / ("out/report/" + page)); }

  /// Opens Ada's page and makes the comparison of one of her cases; "normal" for a data view, else "color".
  void open_case(const std::string& view) {
    open("ada-half.html");
    browser_.evaluate(
        "window.v = [...document.querySelectorAll('.viewer')].find(v => v.dataset.view === '" + view +
        "' && v.querySelector('[data-pane=expected]')); v.scrollIntoView({behavior: 'instant'}); 0");
    browser_.wait_for("v.classList.contains('ready')");
    browser_.evaluate("v.querySelector('.panes').focus({preventScroll: true}); 0");
  }

  std::string text(const std::string& selector) {
    return browser_.evaluate("v.querySelector('" + selector + "').textContent");
  }
  /// A row of the pixel's numbers: "Yours", "Expected" or "Difference".
  std::string numbers(const std::string& row) {
    return browser_.evaluate(
        "[...[...v.querySelectorAll('.readout tr')].find(r => r.cells[0].textContent === '" + row +
        "').cells].slice(1).map(c => c.textContent).join(' ')");
  }
  int number_above() {
    return std::stoi(std::string(
        browser_.evaluate("[...v.querySelectorAll('output')].at(-1).value.match(/: (\\d+) pixels/)[1]")));
  }
  /// Moves the choice to a pixel counted from the lower left, by keys alone.
  void go_to(int x, int y) {
    for (int i = 0; i < 8; ++i) browser_.press("Shift+ArrowLeft");
    for (int i = 0; i < 8; ++i) browser_.press("Shift+ArrowDown");
    for (int i = 0; i < x; ++i) browser_.press("ArrowRight");
    for (int i = 0; i < y; ++i) browser_.press("ArrowUp");
  }
  /// The colour in the middle of a picture's pixel as it stands in a pane, "r g b", while all of it is shown.
  std::string color(const std::string& pane, int x, int y) {
    return browser_.evaluate(fmt::format(
        "(() => {{ const c = v.querySelector('{}'), s = c.width / 64; return "
        "[...c.getContext('2d').getImageData(Math.floor(s * ({} + 0.5)), Math.floor(s * (63 - {} + 0.5)), 1, "
        "1).data.slice(0, 3)].join(' '); }})()",
        pane, x, y));
  }
  static std::string color_of(const image::Image8& picture, int x, int y) {
    return fmt::format("{} {} {}", picture.at(x, y, 0), picture.at(x, y, 1), picture.at(x, y, 2));
  }

  static inline test::TemporaryFolder* folder_ = nullptr;
  static inline store::ClassResult* results_ = nullptr;
  static inline test::Browser* shared_browser_ = nullptr;
  test::Browser& browser_ = *shared_browser_;
  const image::ImageF right_ = test::ball(64, false), wrong_ = test::ball(64, true);
};

constexpr const char* kYours = "[data-pane=yours] canvas";
constexpr const char* kExpected = "[data-pane=expected] canvas";

double degrees_between(const image::ImageF& a, const image::ImageF& b, int x, int y) {
  const auto vector = [&](const image::ImageF& picture) {
    return std::array<double, 3>{picture.at(x, y, 0), picture.at(x, y, 1), picture.at(x, y, 2)};
  };
  const auto u = vector(a), v = vector(b);
  const double cross =
      std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
  return std::atan2(cross, u[0] * v[0] + u[1] * v[1] + u[2] * v[2]) * 180 / std::numbers::pi;
}

TEST_F(ReportPages, shows_the_real_numbers_of_a_pixel_that_keys_choose) {
  open_case("normal");
  for (const auto& [x, y] : {std::pair(20, 45), std::pair(33, 12)}) {
    go_to(x, y);
    EXPECT_EQ(text(".readout caption"), fmt::format("Pixel {}, {} from the lower left", x, y));
    for (const auto& [row, normals] : {std::pair("Yours", &wrong_), std::pair("Expected", &right_)}) {
      std::istringstream shown(numbers(row));
      for (int c = 0; c < 3; ++c) {
        double value = 0;
        shown >> value;
        EXPECT_NEAR(value, normals->at(x, y, c), 1e-4) << row;  // four decimals are shown
      }
    }
    // Three digits are shown.
    EXPECT_NEAR(std::stod(numbers("Difference")), degrees_between(right_, wrong_, x, y), 0.5);
    EXPECT_TRUE(numbers("Difference").ends_with(" degrees"));
  }
}

TEST_F(ReportPages, shows_the_steps_of_a_color_picture) {
  open_case("color");
  go_to(20, 45);
  const image::Image8 right = test::lit(right_), wrong = test::lit(wrong_);
  EXPECT_EQ(numbers("Yours"), color_of(wrong, 20, 45));
  EXPECT_EQ(numbers("Expected"), color_of(right, 20, 45));
  EXPECT_EQ(numbers("Difference"),
            fmt::format("{} 8-bit steps", std::abs(right.at(20, 45) - wrong.at(20, 45))));
}

TEST_F(ReportPages, begins_at_the_worst_pixel_and_comes_back_to_it) {
  open_case("normal");
  double worst = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      if (right_.at(x, y, 2) > 0) worst = std::max(worst, degrees_between(right_, wrong_, x, y));
  EXPECT_NEAR(std::stod(numbers("Difference")), worst, 0.5);
  const std::string place = text(".readout caption");
  browser_.press("ArrowLeft");
  EXPECT_NE(text(".readout caption"), place);
  browser_.press("w");
  EXPECT_EQ(text(".readout caption"), place);
}

TEST_F(ReportPages, marks_the_pixels_above_the_tolerance) {
  open_case("normal");
  const auto above = [&](double limit) {
    int count = 0;
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x)
        count += right_.at(x, y, 2) > 0 && degrees_between(right_, wrong_, x, y) > limit ? 1 : 0;
    return count;
  };
  EXPECT_EQ(number_above(), above(0.2));  // the case's limit
  browser_.evaluate("v.querySelectorAll('input')[1].focus(); 0");
  browser_.press("End");
  EXPECT_EQ(number_above(), 0);
  browser_.press("Home");
  EXPECT_EQ(number_above(), above(0));
  for (int i = 0; i < 50; ++i) browser_.press("ArrowRight");
  EXPECT_GT(number_above(), 0);
  EXPECT_LT(number_above(), above(0));

  // Grey within the tolerance, in colours above it.
  const int y_far = 32 + 20, y_near = 33;
  ASSERT_GT(degrees_between(right_, wrong_, 32, y_far), 60);
  ASSERT_LT(degrees_between(right_, wrong_, 32, y_near), 10);
  const auto is_grey = [](const std::string& rgb) {
    return rgb.substr(0, rgb.find(' ')) == rgb.substr(rgb.find(' ') + 1, rgb.rfind(' ') - rgb.find(' ') - 1);
  };
  EXPECT_FALSE(is_grey(color(".difference canvas", 32, y_far)));
  EXPECT_TRUE(is_grey(color(".difference canvas", 32, y_near)));
}

TEST_F(ReportPages, splits_the_first_picture_between_yours_and_expected) {
  open_case("normal");
  const auto shown = [&](const image::ImageF& normals, int x, int y) {
    const auto byte = [&](int c) { return std::lround(255 * (0.5F + 0.5F * normals.at(x, y, c))); };
    return fmt::format("{} {} {}", byte(0), byte(1), byte(2));
  };
  EXPECT_EQ(color(kYours, 44, 44), shown(wrong_, 44, 44));
  EXPECT_EQ(color(kExpected, 44, 44), shown(right_, 44, 44));
  browser_.press("s");
  EXPECT_EQ(color(kYours, 20, 44), shown(wrong_, 20, 44));  // left half
  EXPECT_EQ(color(kYours, 44, 44), shown(right_, 44, 44));  // right half
  EXPECT_EQ(text("[data-pane=yours] figcaption"), "Yours | Expected");
  browser_.evaluate("v.querySelectorAll('input')[0].focus(); 0");
  browser_.press("Home");
  EXPECT_EQ(color(kYours, 20, 44), shown(right_, 20, 44));
  browser_.press("End");
  EXPECT_EQ(color(kYours, 44, 44), shown(wrong_, 44, 44));
}

TEST_F(ReportPages, zooms_by_keys_buttons_and_wheel) {
  open_case("normal");
  const auto zoomed = [&] { return bool(browser_.evaluate("v.classList.contains('zoomed')")); };
  // With all shown a background pixel is in the corner; zoomed to the ball's middle there is none.
  const std::string background = color(kExpected, 1, 62);
  go_to(32, 32);
  EXPECT_FALSE(zoomed());
  browser_.press("+");
  browser_.press("+");
  EXPECT_TRUE(zoomed());
  EXPECT_NE(color(kExpected, 1, 62), background);
  browser_.press("-");
  EXPECT_TRUE(zoomed());
  browser_.press("0");
  EXPECT_FALSE(zoomed());
  EXPECT_EQ(color(kExpected, 1, 62), background);

  browser_.evaluate("v.querySelector('button[aria-label=\"Zoom in\"]').focus(); 0");
  browser_.press("Enter");
  EXPECT_TRUE(zoomed());
  browser_.press("Tab");
  browser_.press("Enter");  // Fit
  EXPECT_FALSE(zoomed());

  const auto box = browser_.evaluate(
      "(b => [b.left + b.width / 4, b.top + b.height / 4])(v.querySelector('[data-pane=expected] "
      "canvas').getBoundingClientRect())");
  // The wheel belongs to the page until a picture was clicked.
  browser_.evaluate("document.activeElement.blur(); 0");
  browser_.mouse("mousePressed", box[0], box[1]);
  browser_.mouse("mouseReleased", box[0], box[1]);
  EXPECT_EQ(text(".readout caption"), "Pixel 16, 47 from the lower left");
  browser_.mouse("mouseWheel", box[0], box[1], -100);
  browser_.wait_for("v.classList.contains('zoomed')");
  EXPECT_EQ(text(".readout caption"), "Pixel 16, 47 from the lower left");  // which stays below the pointer
  browser_.mouse("mouseWheel", box[0], box[1], 100);
  browser_.wait_for("!v.classList.contains('zoomed')");
}

TEST_F(ReportPages, moves_a_zoomed_picture_under_the_pointer) {
  open_case("normal");
  go_to(32, 32);
  browser_.press("+");
  browser_.press("+");
  const std::string before = color(kExpected, 20, 20);
  const auto box = browser_.evaluate(
      "(b => [b.left + b.width / 2, b.top + b.height / 2])(v.querySelector('[data-pane=yours] "
      "canvas').getBoundingClientRect())");
  browser_.mouse("mousePressed", box[0], box[1]);
  browser_.mouse("mouseMoved", double(box[0]) + 40, double(box[1]) + 30);
  browser_.mouse("mouseReleased", double(box[0]) + 40, double(box[1]) + 30);
  EXPECT_NE(color(kExpected, 20, 20), before);
}

TEST_F(ReportPages, are_used_by_keys_alone) {
  open("ada-half.html");
  browser_.wait_for("document.querySelector('.viewer.ready')");
  std::set<std::string> reached;
  for (int i = 0; i < 60; ++i) {
    browser_.press("Tab");
    reached.insert(
        browser_.evaluate("(e => e.tagName + (e.type ? ' ' + e.type : '') + (e.className ? ' ' + e.className "
                          ": ''))(document.activeElement)"));
  }
  for (const char* wanted :
       {"A", "SUMMARY", "DIV panes", "BUTTON button", "INPUT range", "BUTTON button copy"})
    EXPECT_TRUE(reached.contains(wanted)) << wanted;
  browser_.evaluate("document.querySelector('.hint summary').focus(); 0");
  EXPECT_FALSE(bool(browser_.evaluate("document.querySelector('.hint').open")));
  browser_.press("Enter");
  EXPECT_TRUE(bool(browser_.evaluate("document.querySelector('.hint').open")));
}

TEST_F(ReportPages, need_no_network_and_complain_of_nothing) {
  for (const store::StudentResult& student : results_->students) {
    open(page_name(student));
    browser_.evaluate("document.querySelectorAll('details').forEach(d => { d.open = true; }); 0");
    browser_.evaluate("document.querySelectorAll('.viewer').forEach(v => near.observe(v)); 0");
    for (int i = 0; i < int(browser_.evaluate("document.querySelectorAll('.viewer').length")); ++i) {
      browser_.evaluate(fmt::format(
          "document.querySelectorAll('.viewer')[{}].scrollIntoView({{behavior: 'instant'}}); 0", i));
      browser_.wait_for(fmt::format("document.querySelectorAll('.viewer')[{}].matches('.ready')", i));
    }
  }
  open("index.html");
  for (const std::string& address : browser_.requests())
    EXPECT_TRUE(address.starts_with("file://") || address.starts_with("data:")) << address;
  EXPECT_EQ(browser_.complaints(), std::vector<std::string>{});
}

TEST_F(ReportPages, run_nothing_of_a_hostile_student) {
  for (const std::string page : {"script-1a2b3c4d.html", "index.html"}) {
    open(page);
    EXPECT_NE(browser_.evaluate("document.title"), "harmed") << page;
    EXPECT_EQ(browser_.evaluate("document.scripts.length"), 1) << page;
    EXPECT_EQ(browser_.evaluate("document.querySelectorAll('img:not([src^=\"data:image/png\"])').length"), 0);
    EXPECT_TRUE(bool(browser_.evaluate("document.body.textContent.includes('<img src=x onerror=')"))) << page;
    // And if some text had slipped through, it would not run.
    browser_.evaluate(
        "{ const s = document.createElement('script'); s.textContent = 'document.title = \"harmed\"'; "
        "document.body.append(s); document.body.insertAdjacentHTML('beforeend', '<img src=x "
        "onerror=\"document.title=`harmed`\">'); } 0");
    browser_.evaluate("new Promise(done => setTimeout(done, 100))");
    EXPECT_NE(browser_.evaluate("document.title"), "harmed") << page;
  }
  for (const std::string& address : browser_.requests()) EXPECT_FALSE(address.starts_with("http")) << address;
}

TEST_F(ReportPages, fit_on_a_phone) {
  browser_.resize(390, 844, true);
  std::vector<std::string> pages = {"index.html"};
  for (const store::StudentResult& student : results_->students) pages.push_back(page_name(student));
  for (const std::string& page : pages) {
    open(page);
    browser_.evaluate("document.querySelectorAll('details').forEach(d => { d.open = true; }); 0");
    browser_.evaluate("new Promise(done => setTimeout(done, 200))");
    // With its sliders and readout a viewer is the widest part.
    if (browser_.evaluate("document.querySelector('.viewer img') !== null")) {
      browser_.evaluate("document.querySelector('.viewer:has(img)').scrollIntoView(); 0");
      browser_.wait_for("document.querySelector('.viewer.ready')");
    }
    EXPECT_LE(int(browser_.evaluate("document.documentElement.scrollWidth")), 390)
        << page << ": "
        << browser_.evaluate(
               "[...document.querySelectorAll('body *')].filter(e => e.getBoundingClientRect().right > 391)"
               ".map(e => e.outerHTML.slice(0, 90)).join('\\n')");
  }
}

TEST_F(ReportPages, are_readable_in_light_and_dark) {
  // WCAG 2.2, 1.4.3: 4.5 to 1 between the text and what is behind it.
  const char* contrast = R"((() => {
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
    return least; })())";
  std::set<std::string> papers;
  for (const std::string scheme : {"light", "dark"})
    for (const std::string page : {"index.html", "ada-half.html", "dora-incident.html", "cleo-broken.html"}) {
      browser_.prefer(scheme);
      open(page);
      papers.insert(browser_.evaluate("getComputedStyle(document.body).backgroundColor"));
      EXPECT_GE(double(browser_.evaluate(contrast)), 4.5) << page << " in " << scheme;
    }
  EXPECT_EQ(papers.size(), 2U);
}

TEST_F(ReportPages, sort_and_filter_the_class) {
  open("index.html");
  const auto names = [&] {
    return std::vector<std::string>(browser_.evaluate(
        "[...document.querySelector('table.class').tBodies[0].rows].filter(r => !r.hidden).map(r => "
        "r.querySelector('a').textContent.slice(0, 11))"));
  };
  ASSERT_EQ(names().size(), 8U);
  browser_.evaluate("document.querySelectorAll('.class thead button')[1].focus(); 0");
  browser_.press("Enter");
  EXPECT_EQ(names().front(), "Index Page");  // the most points
  EXPECT_EQ(names().back(), "Dora Incide");  // none at all
  browser_.press("Enter");
  EXPECT_EQ(names().back(), "Index Page");
  EXPECT_EQ(browser_.evaluate("document.querySelectorAll('[aria-sort=ascending]').length"), 1);

  browser_.evaluate("document.getElementById('find').focus(); 0");
  browser_.type("1023");
  EXPECT_EQ(names().size(), 7U);  // the hostile student has another number
  browser_.type("4");
  EXPECT_EQ(names(), std::vector<std::string>{"Cleo Broken"});
  browser_.evaluate(
      "document.getElementById('find').value = ''; document.getElementById('show').value = 'incident'; "
      "document.getElementById('show').dispatchEvent(new Event('change')); 0");
  EXPECT_EQ(names(), std::vector<std::string>{"Dora Incide"});
  browser_.evaluate("document.getElementById('show').value = ''; document.querySelector('.pick').focus(); 0");
  browser_.press("Enter");
  EXPECT_EQ(names().size(), 3U);  // who turned green round
  browser_.press("Enter");
  EXPECT_EQ(names().size(), 8U);
}

}  // namespace
}  // namespace texel::reports
