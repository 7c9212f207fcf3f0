// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "material/mutant_file.hpp"
#include "page.hpp"
#include "reports/reports.hpp"
#include "wording.hpp"

namespace texel::reports {
namespace {

std::string callout(const std::string& mistake, const std::string& says) {
  if (mistake.empty()) return "";
  const std::string title = material::title_of(says);
  return fmt::format("<p class=\"cause\">This looks like: <b>{}</b>{}</p>\n", with_code(title),
                     with_code(says.substr(title.size())));
}

/// One of the two pictures. The script makes a canvas of it; without a script it is a picture all the same.
std::string pane(const char* name, const char* label, const Picture& picture) {
  if (!picture.problem.empty())
    return fmt::format(
        "<figure class=\"pane\"><p class=\"problem\">{}</p><figcaption>{}</figcaption></figure>\n",
        escaped(picture.problem), label);
  const std::string values = picture.values.empty() ? ""
                                                    : fmt::format(" data-values=\"{}\" data-channels=\"{}\"",
                                                                  picture.values, picture.channels);
  return fmt::format(
      "<figure class=\"pane\" data-pane=\"{}\"><img src=\"{}\" width=\"{}\" height=\"{}\" alt=\"{}\"{}>"
      "<figcaption>{}</figcaption></figure>\n",
      name, picture.url, picture.width, picture.height, label, values, label);
}

/// How the pictures of a step's first wrong case are shown, and those of its others.
struct Detail {
  Shown first, others;
};

/// From all that there is to the least. A page takes the first with which it is small enough.
constexpr Detail kDetails[] = {{Shown::with_numbers, Shown::with_numbers},
                               {Shown::with_numbers, Shown::plain},
                               {Shown::with_numbers, Shown::small},
                               {Shown::plain, Shown::small},
                               {Shown::small, Shown::small},
                               {Shown::small, Shown::not_at_all}};
constexpr std::size_t kLargestPage = 1'500'000;

std::string viewer(const judge::CaseResult& result, Pictures& pictures, Shown shown) {
  if (result.is_mesh() || shown == Shown::not_at_all) return "";
  if (result.picture.empty() && result.reference.empty()) return "";
  std::string panes;
  if (!result.picture.empty())
    panes += pane("yours", "Yours", pictures.read(result.picture, name_of(result.view), shown));
  if (!result.reference.empty())
    panes += pane("expected", "Expected", pictures.reference(result.reference, name_of(result.view), shown));
  if (shown != Shown::with_numbers) return "<div class=\"panes\">\n" + panes + "</div>\n";
  return fmt::format(
      "<div class=\"viewer\" data-view=\"{}\" data-unit=\"{}\" data-limit=\"{}\">\n<div class=\"panes\">\n{}"
      "</div>\n</div>\n",
      escaped(name_of(result.view)), escaped(name_of(result.unit())), number(result.limit, 9), panes);
}

/// A case whose picture is wrong; it is right itself where only other steps spoil the picture.
std::string wrong_case(const judge::CaseResult& result, const judge::StepResult& step, Pictures& pictures,
                       Shown shown) {
  std::string html =
      fmt::format("<article class=\"case\">\n<h4>{}{}{}{}</h4>\n", escaped(result.name),
                  result.hidden ? " <span class=\"tag\">hidden case</span>" : "",
                  result.view == course::View::color
                      ? ""
                      : fmt::format(" <span class=\"tag\">{} view</span>", escaped(name_of(result.view))),
                  result.passed() ? " <span class=\"tag\">right, only other steps spoil it</span>" : "");
  if (!result.message.empty()) html += fmt::format("<p>{}</p>\n", with_code(result.message));
  // The message of a picture that was not judged alone has its distance.
  std::string figures = result.is_alone() && !result.passed() ? distance(result) : "";
  if (result.score > 0 && !result.passed())
    figures +=
        fmt::format("{}{} % of the case's marks", figures.empty() ? "" : "; ", number(100 * result.score, 0));
  if (!figures.empty()) html += fmt::format("<p class=\"quiet\">{}.</p>\n", escaped(figures));
  if (result.mistake != step.mistake) html += callout(result.mistake, result.mistake_says);
  html += viewer(result, pictures, shown);
  if (const std::string typed = command(result); !typed.empty()) html += command_line(typed);
  return html + "</article>\n";
}

/// A line of the names of cases of which there is no more to say, or "".
std::string other_cases(const std::vector<const judge::CaseResult*>& cases, const char* style,
                        const char* symbol, const char* says) {
  std::string names;
  for (const judge::CaseResult* result : cases)
    names += fmt::format("{}{}{}", names.empty() ? "" : ", ", escaped(result->name),
                         result->hidden ? " (hidden)" : "");
  if (names.empty()) return "";
  return fmt::format("<p class=\"others\"><span class=\"{}\" aria-hidden=\"true\">{}</span> {}: {}</p>\n",
                     style, symbol, says, names);
}

std::string details(const judge::StepResult& step, Pictures& pictures, const Detail& detail) {
  std::string html;
  const bool said_below =  // the message is the first failed case's, which has it again with its picture
      std::any_of(step.cases.begin(), step.cases.end(),
                  [](const judge::CaseResult& c) { return !c.passed(); });
  if (!step.message.empty() && !said_below) html += fmt::format("<p>{}</p>\n", with_code(step.message));
  html += callout(step.mistake, step.mistake_says);
  if (const std::string file = place(step); !file.empty())
    html += fmt::format("<p class=\"place\">Written in <code>{}</code></p>\n", escaped(file));
  if (!step.hints.empty())
    html += fmt::format("<details class=\"hint\"><summary>Hint</summary><p>{}</p></details>\n",
                        with_code(step.hints.front()));
  if (step.is_untouched()) return html;  // its pictures say nothing of the student
  Shown shown = detail.first;
  const judge::CaseResult* nothing = nullptr;  // the first of which nothing can be compared
  std::vector<const judge::CaseResult*> same, passed;
  for (const judge::CaseResult& result : step.cases) {
    if (result.passed()) {
      if (!result.is_alone()) passed.push_back(&result);
      continue;
    }
    // A file that does not compile fails all its cases with one sentence: once is enough.
    const bool has_nothing = std::isnan(result.error) && !result.message.empty();
    if (has_nothing && nothing != nullptr && result.message == nothing->message &&
        result.mistake == nothing->mistake) {
      same.push_back(&result);
      continue;
    }
    if (has_nothing && nothing == nullptr) nothing = &result;
    html += wrong_case(result, step, pictures, shown);
    shown = detail.others;
  }
  return html + other_cases(same, "failed", "✗", "The same is true of") +
         other_cases(passed, "passed", "✓", "Passed");
}

/// The cases that are right, but whose pictures other steps spoil.
std::string spoilt_cases(const judge::StepResult& step, Pictures& pictures, const Detail& detail) {
  std::string cases;
  std::size_t count = 0;
  for (const judge::CaseResult& result : step.cases)
    if (result.passed() && result.is_alone()) {
      cases += wrong_case(result, step, pictures, detail.others);
      ++count;
    }
  if (count == 0) return "";
  return fmt::format("<details><summary>{} that other steps spoil</summary>\n{}</details>\n",
                     counted(count, "picture"), cases);
}

/// Of a submission with a `fault` no step has more to say.
std::string step_section(const judge::StepResult& step, Pictures& pictures, const Detail& detail,
                         const std::string& fault) {
  const Standing stands = standing(step);
  std::string html = fmt::format(
      "<section class=\"step {0}\" id=\"step-{1}\">\n<h3><span class=\"symbol\" "
      "aria-hidden=\"true\">{2}</span>"
      "<span>{1} {3}</span><span class=\"spoken\">{4}</span><span class=\"points\">{5} / {6}</span></h3>\n",
      stands.style, escaped(step.id), stands.symbol, escaped(step.title), stands.word,
      number(step.points * step.score), number(step.points));
  if (!step.overridden.empty())
    html +=
        fmt::format("<p class=\"cause\">The teacher set these points: {}</p>\n", escaped(step.overridden));
  if (const std::string told = judging(step); !told.empty())
    html += fmt::format("<p>{}</p>\n", escaped(told));
  if (step.status != judge::Status::passed && (fault.empty() || step.message != fault))
    html += details(step, pictures, detail);
  return html + spoilt_cases(step, pictures, detail) + "</section>\n";
}

std::string lab_section(const judge::LabResult& lab, Pictures& pictures, const Detail& detail,
                        const std::string& fault) {
  std::string html = fmt::format(
      "<section class=\"lab\" id=\"lab{0}\" aria-labelledby=\"title{0}\">\n<header>\n"
      "<p class=\"number\" aria-hidden=\"true\">{0}</p>\n<div><h2 id=\"title{0}\">{1}</h2>\n<p>{2} of {3} "
      "points</p></div>\n</header>\n",
      lab.lab.number, escaped(lab.lab.title), number(lab.points()), number(lab.max_points()));
  for (const std::string& note : lab.notes) html += fmt::format("<p class=\"cause\">{}</p>\n", escaped(note));
  for (const bool begun : {true, false})  // what is not begun comes last
    for (const judge::StepResult& step : lab.steps)
      if (step.is_untouched() != begun) html += step_section(step, pictures, detail, fault);
  return html + "</section>\n";
}

std::string logs_section(const store::StudentResult& student) {
  if (student.logs.empty()) return "";
  std::string html = "<section id=\"compiler\" class=\"logs\">\n<h2>Compiler errors</h2>\n";
  for (const store::CompilerLog& log : student.logs)
    html += fmt::format(
        "<details open><summary><code>{}</code></summary>\n<pre tabindex=\"0\">{}</pre></details>\n",
        escaped(log.file), escaped(log.text));
  return html + "</section>\n";
}

std::string ignored_section(const store::StudentResult& student) {
  if (student.ignored.empty()) return "";
  std::string items;
  for (const store::Ignored& ignored : student.ignored)
    items += fmt::format("<li><code>{}</code> {}</li>\n", escaped(ignored.path), escaped(ignored.reason));
  constexpr std::size_t few = 10;
  return fmt::format(
      "<section id=\"ignored\">\n<details{}><summary>{} of the submission not used</summary>\n<ul>\n{}</ul>\n"
      "</details>\n</section>\n",
      student.ignored.size() <= few ? " open" : "", counted(student.ignored.size(), "file"), items);
}

/// A line with a link to the files that were not used, or "".
std::string ignored_link(const store::StudentResult& student) {
  const std::size_t count = student.ignored.size();
  if (count == 0) return "";
  return fmt::format("<p><a href=\"#ignored\">{} of the submission</a> {} not used.</p>\n",
                     counted(count, "file"), count == 1 ? "is" : "are");
}

/// What to do first: the submission's or the grader's fault, or the first failing step.
std::string first_thing(const store::StudentResult& student) {
  if (!student.incident.empty())
    return fmt::format(
        "<div class=\"start incident\"><p>{}</p>\n<details><summary>What "
        "happened</summary><p>{}</p></details>"
        "</div>\n",
        kIncident, escaped(student.incident));
  if (student.is_unfinished())
    return fmt::format("<div class=\"start incident\"><p>Not graded yet: {}.</p></div>\n",
                       escaped(student.unmarked()));
  if (!student.fault.empty())
    return fmt::format("<div class=\"start failed\"><p>The submission {}</p></div>\n",
                       escaped(student.fault));
  if (const judge::StepResult* step = first_failing(student))
    return fmt::format("<div class=\"start {}\"><p>{} <a href=\"#step-{}\">step {}: {}</a></p>\n{}</div>\n",
                       step->is_untouched() ? "skipped" : "failed",
                       !student.logs.empty() ? "Correct the <a href=\"#compiler\">compiler's errors</a>, then"
                       : step->is_untouched() ? "All that you began is right. Next is"
                                              : "Correct this first:",
                       escaped(step->id), escaped(step->id), escaped(step->title), ignored_link(student));
  if (student.labs.empty()) return "";
  return "<div class=\"start passed\"><p>Every step passed.</p>\n" + ignored_link(student) + "</div>\n";
}

std::string page_with(const store::StudentResult& student, const std::map<std::string, std::string>& facts,
                      Pictures& pictures, const Detail& detail) {
  std::string contents, labs;
  for (const judge::LabResult& lab : student.labs) {
    contents +=
        fmt::format("<li><a href=\"#lab{0}\"><b>{0}</b> {1} <span>{2}/{3}</span></a></li>\n", lab.lab.number,
                    escaped(lab.lab.title), number(lab.points()), number(lab.max_points()));
    labs += lab_section(lab, pictures, detail, student.fault);
  }
  if (!contents.empty()) contents = "<nav aria-label=\"Labs\"><ol>\n" + contents + "</ol></nav>\n";
  std::string mark = "Not graded";
  if (student.unmarked().empty())
    mark = student.labs.empty() ? "0 <small>points</small>"
                                : fmt::format("{} <small>of {} points</small>", number(student.points()),
                                              number(student.max_points()));
  const bool has_pictures = labs.find("<div class=\"panes\">") != labs.npos;
  std::string repeat;
  if (has_pictures && labs.find("<div class=\"command\">") != labs.npos)
    repeat = "<p class=\"quiet\">The command below a picture draws it again in your own tree.</p>\n";
  if (has_pictures && detail.others != Shown::with_numbers)
    repeat +=
        "<p class=\"quiet\">To keep this page small, some pictures are small or have no difference.</p>\n";
  return page(
      student.name,
      fmt::format("<header class=\"masthead student\">\n<div><h1><bdi>{}</bdi></h1>\n<p>{}</p></div>\n"
                  "<p class=\"mark\">{}</p>\n{}</header>\n{}<main>\n{}{}{}<section id=\"facts\">\n"
                  "<h2>Facts</h2>\n{}{}</section>\n</main>\n",
                  escaped(student.name), escaped(student.number), mark, first_thing(student), contents,
                  logs_section(student), labs, ignored_section(student), facts_list(facts, false), repeat),
      kStudentScript);
}

}  // namespace

std::string student_page(const store::StudentResult& student, const std::map<std::string, std::string>& facts,
                         Pictures& pictures) {
  std::string html;
  for (const Detail& detail : kDetails) {
    html = page_with(student, facts, pictures, detail);
    if (html.size() <= kLargestPage) break;
  }
  return html;
}

}  // namespace texel::reports
