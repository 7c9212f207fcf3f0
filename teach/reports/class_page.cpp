// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "material/mutant_file.hpp"
#include "page.hpp"
#include "reports/reports.hpp"
#include "wording.hpp"

namespace texel::reports {
namespace {

/// A mistake that somebody made.
struct Mistake {
  std::string name, says;
  std::set<std::string> steps;
  std::size_t students = 0;
};

/// How a step went in the class.
struct Tried {
  const judge::StepResult* step = nullptr;  ///< of anybody
  std::size_t begun = 0, failed = 0;        ///< students
};

/// The steps that anybody began, those first that fail most often.
std::vector<Tried> tried_steps(const store::ClassResult& results) {
  std::map<std::string, Tried> by_step;
  for (const store::StudentResult& student : results.students)
    for (const judge::LabResult& lab : student.labs)
      for (const judge::StepResult& step : lab.steps) {
        if (!student.fault.empty() || step.cases.empty() || step.is_untouched()) continue;
        Tried& tried = by_step[step.id];
        tried.step = &step, ++tried.begun;
        if (step.status != judge::Status::passed) ++tried.failed;
      }
  std::vector<Tried> all;
  for (const auto& [id, tried] : by_step) all.push_back(tried);
  std::stable_sort(all.begin(), all.end(),
                   [](const Tried& a, const Tried& b) { return a.failed > b.failed; });
  return all;
}

/// "3 of 40 who began it": how many a number of students is among those who began a step.
std::string share(std::size_t students, const std::vector<Tried>& all, const std::string& step) {
  for (const Tried& tried : all)
    if (tried.step->id == step)
      return fmt::format("{} of {} who began {}", students, counted(tried.begun, "student"), step);
  return counted(students, "student");
}

/// A line of a histogram: a number and its bar, at most `most` long.
std::string histogram_line(std::size_t count, std::size_t most, const std::string& text) {
  return fmt::format(
      "<li><span class=\"count\">{0}</span><svg class=\"bar\" viewBox=\"0 0 {1} 1\" "
      "preserveAspectRatio=\"none\" aria-hidden=\"true\"><rect width=\"{0}\" height=\"1\"/></svg>"
      "<div>{2}</div></li>\n",
      count, most, text);
}

/// By how many students made them, then by name.
std::vector<Mistake> histogram(const store::ClassResult& results) {
  std::map<std::string, Mistake> by_name;
  for (const store::StudentResult& student : results.students) {
    std::set<std::string> made;
    for (const judge::LabResult& lab : student.labs)
      for (const judge::StepResult& step : lab.steps) {
        if (step.status != judge::Status::failed || step.mistake.empty()) continue;
        Mistake& mistake = by_name[step.mistake];
        mistake.name = step.mistake;
        mistake.says = step.mistake_says;
        mistake.steps.insert(step.id);
        made.insert(step.mistake);
      }
    for (const std::string& name : made) ++by_name[name].students;
  }
  std::vector<Mistake> mistakes;
  for (const auto& [name, mistake] : by_name) mistakes.push_back(mistake);
  std::stable_sort(mistakes.begin(), mistakes.end(),
                   [](const Mistake& a, const Mistake& b) { return a.students > b.students; });
  return mistakes;
}

/// The labs of the class with their steps: students whose submission could not be read may have none.
std::vector<judge::LabResult> all_labs(const store::ClassResult& results) {
  std::map<int, judge::LabResult> labs;
  for (const store::StudentResult& student : results.students)
    for (const judge::LabResult& lab : student.labs) {
      const auto [place, is_new] = labs.try_emplace(lab.lab.number, lab);
      if (!is_new && lab.steps.size() > place->second.steps.size()) place->second = lab;
    }
  std::vector<judge::LabResult> result;
  for (auto& [lab_number, lab] : labs) result.push_back(std::move(lab));
  return result;
}

const judge::StepResult* find_step(const store::StudentResult& student, const std::string& id) {
  for (const judge::LabResult& lab : student.labs)
    for (const judge::StepResult& step : lab.steps)
      if (step.id == id) return &step;
  return nullptr;
}

std::string column(const std::string& label, const char* style, const std::string& title) {
  return fmt::format(
      "<th scope=\"col\" class=\"{}\" aria-sort=\"none\"><button type=\"button\" title=\"{}\">{}"
      "</button></th>",
      style, escaped(title), escaped(label));
}

std::string head(const std::vector<judge::LabResult>& labs) {
  std::string groups = "<td colspan=\"2\"></td>", columns;
  columns = column("Student", "name", "Sort by name") + column("Points", "number", "Sort by points");
  for (const judge::LabResult& lab : labs) {
    groups += fmt::format("<th scope=\"colgroup\" colspan=\"{}\" title=\"{}\">Lab {}</th>", lab.steps.size(),
                          escaped(lab.lab.title), lab.lab.number);
    for (const judge::StepResult& step : lab.steps)
      columns +=
          column(step.id, &step == &lab.steps.front() ? "step first" : "step",
                 fmt::format("Sort by step {}: {}, {} points", step.id, step.title, number(step.points)));
  }
  return fmt::format("<thead>\n<tr>{}</tr>\n<tr>{}</tr>\n</thead>\n", groups, columns);
}

std::string cell(const judge::StepResult* step, bool is_first) {
  const char* first = is_first ? " first" : "";
  if (step == nullptr) return fmt::format("<td class=\"step{}\" data-sort=\"-1\"></td>", first);
  const Standing stands = standing(*step);
  std::string title = fmt::format("{} {}: {}, {} of {}", step->id, step->title, stands.word,
                                  number(step->score * step->points), number(step->points));
  if (!step->mistake.empty()) title += ". " + cause(step->mistake, step->mistake_says);
  if (!step->overridden.empty()) title += ". Set by the teacher: " + step->overridden;
  return fmt::format(
      "<td class=\"step {}{}\" data-sort=\"{}\" title=\"{}\"><span aria-hidden=\"true\">{}{}</span>"
      "<span class=\"spoken\">{}</span></td>",
      stands.style, first, number(step->score, 6), escaped(title), stands.symbol,
      step->overridden.empty() ? "" : "*", stands.word);
}

std::string row(const store::StudentResult& student, const std::vector<judge::LabResult>& labs) {
  std::string mistakes, cells;
  bool all_passed = student.fault.empty();
  for (const judge::LabResult& lab : labs)
    for (const judge::StepResult& of_class : lab.steps) {
      const judge::StepResult* step = find_step(student, of_class.id);
      cells += cell(step, &of_class == &lab.steps.front());
      all_passed &= step != nullptr && step->status == judge::Status::passed;
      if (step != nullptr && step->status == judge::Status::failed && !step->mistake.empty())
        mistakes += " " + step->mistake;
    }
  const bool has_incident = !student.incident.empty(), has_no_mark = !student.unmarked().empty();
  std::string note;
  if (has_incident)
    note = "<span class=\"note incident\">! not graded</span>";
  else if (has_no_mark)
    note = fmt::format("<span class=\"note incident\">! not finished: {} of {} cases judged</span>",
                       student.judged, student.planned);
  else if (!student.fault.empty())
    note = fmt::format("<span class=\"note failed\">submission {}</span>", escaped(student.fault));
  else if (!student.logs.empty())
    note = "<span class=\"note failed\">does not compile</span>";
  const std::string points = has_no_mark ? "–" : number(student.points());
  return fmt::format(
      "<tr data-state=\"{}\" data-mistakes=\"{} \"><th scope=\"row\" class=\"name\"><a "
      "href=\"{}\"><bdi>{}</bdi>"
      "</a><span class=\"quiet\">{}</span>{}</th><td class=\"number\" data-sort=\"{}\">{}</td>{}</tr>\n",
      has_no_mark  ? "incident"
      : all_passed ? "passed"
                   : "open",
      escaped(mistakes), page_name(student), escaped(student.name), escaped(student.number), note,
      has_no_mark ? "-1" : number(student.points(), 6), points, cells);
}

std::string foot(const store::ClassResult& results, const std::vector<judge::LabResult>& labs) {
  std::string cells;
  for (const judge::LabResult& lab : labs)
    for (const judge::StepResult& of_class : lab.steps) {
      const auto passed = std::count_if(results.students.begin(), results.students.end(),
                                        [&](const store::StudentResult& student) {
                                          const judge::StepResult* step = find_step(student, of_class.id);
                                          return step != nullptr && step->status == judge::Status::passed;
                                        });
      cells += fmt::format("<td class=\"step{}\">{}</td>", &of_class == &lab.steps.front() ? " first" : "",
                           passed);
    }
  return fmt::format(
      "<tfoot><tr><th scope=\"row\" class=\"name\">Passed by</th><td class=\"number\"></td>{}</tr></tfoot>\n",
      cells);
}

/// What a mistake's text says after its title, as a sentence; or "".
std::string rest_of(const std::string& says) {
  const std::size_t begin = says.find_first_not_of(".:; ", material::title_of(says).size());
  if (begin == std::string::npos) return "";
  std::string rest = says.substr(begin);
  rest.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(rest.front())));
  return rest;
}

std::string students_section(const store::ClassResult& results, const std::vector<judge::LabResult>& labs) {
  std::string rows;
  for (const store::StudentResult& student : results.students) rows += row(student, labs);
  return fmt::format(
      "<section id=\"students\">\n<h2>Students</h2>\n<div class=\"filter\">\n"
      "<label>Find <input type=\"search\" id=\"find\" placeholder=\"name or number\" "
      "autocomplete=\"off\"></label>\n"
      "<label>Show <select id=\"show\"><option value=\"\">all</option><option value=\"open\">with work to do"
      "</option><option value=\"passed\">all steps passed</option><option value=\"incident\">not "
      "graded</option>"
      "</select></label>\n<button type=\"button\" id=\"mistake\" hidden></button>\n"
      "<p id=\"shown\" role=\"status\"></p>\n</div>\n"
      "<button type=\"button\" id=\"more\" hidden></button>\n"
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Students and steps\">\n"
      "<table class=\"class\">\n{}<tbody>\n{}</tbody>\n{}</table>\n</div>\n"
      "<p class=\"legend\"><span class=\"passed\">✓</span> passed <span class=\"partial\">◐</span> in part "
      "<span class=\"failed\">✗</span> not yet <span class=\"skipped\">–</span> not begun "
      "<span>·</span> not judged "
      "<span>*</span> set by the teacher</p>\n</section>\n",
      head(labs), rows, foot(results, labs));
}

std::string steps_section(const std::vector<Tried>& all) {
  std::string items;
  for (const Tried& tried : all)
    if (tried.failed > 0)
      items += histogram_line(
          tried.failed, all.front().failed,
          fmt::format("{} {} <span class=\"quiet\">{} % of {} who began it</span>", escaped(tried.step->id),
                      with_code(tried.step->title), (200 * tried.failed + tried.begun) / (2 * tried.begun),
                      counted(tried.begun, "student")));
  return "<section id=\"steps\">\n<h2>Steps that are not right yet</h2>\n" +
         (items.empty() ? "<p>None of those that are begun.</p>\n"
                        : "<ol class=\"histogram\">\n" + items + "</ol>\n") +
         "</section>\n";
}

std::string mistakes_section(const store::ClassResult& results, const std::vector<Tried>& tried) {
  const std::vector<Mistake> mistakes = histogram(results);
  std::size_t unnamed = 0;
  for (const store::StudentResult& student : results.students)
    for (const judge::LabResult& lab : student.labs)
      unnamed += static_cast<std::size_t>(
          std::count_if(lab.steps.begin(), lab.steps.end(), [](const judge::StepResult& step) {
            return step.status == judge::Status::failed && step.mistake.empty() && !step.cases.empty() &&
                   !step.is_untouched();
          }));
  std::string html = "<section id=\"mistakes\">\n<h2>Mistakes</h2>\n";
  if (!mistakes.empty()) {
    html += "<ol class=\"histogram\">\n";
    for (const Mistake& mistake : mistakes)
      html += histogram_line(
          mistake.students, mistakes.front().students,
          fmt::format("<button type=\"button\" class=\"pick\" data-mistake=\"{}\" title=\"Show these "
                      "students\">{}</button> <span class=\"quiet\">{}</span><p>{}</p>",
                      escaped(mistake.name), with_code(material::title_of(mistake.says)),
                      mistake.steps.size() == 1
                          ? escaped(share(mistake.students, tried, *mistake.steps.begin()))
                          : escaped(fmt::format("steps {}", fmt::join(mistake.steps, ", "))),
                      with_code(rest_of(mistake.says))));
    html += "</ol>\n";
  }
  html += unnamed == 0 && mistakes.empty()
              ? "<p>None.</p>\n"
              : fmt::format("<p class=\"quiet\">{} {} like no known mistake.</p>\n",
                            counted(unnamed, "failed step"), unnamed == 1 ? "looks" : "look");
  return html + "</section>\n";
}

std::string incidents_section(const store::ClassResult& results) {
  std::string items;
  for (const store::StudentResult& student : results.students)
    if (!student.unmarked().empty())
      items += fmt::format("<dt><a href=\"{}\"><bdi>{}</bdi></a></dt><dd>{}</dd>\n", page_name(student),
                           escaped(student.name), escaped(student.unmarked()));
  if (items.empty()) return "";
  return "<section id=\"incidents\">\n<h2>Not graded</h2>\n<p>The grader or the machine failed, or the run "
         "is not finished. These "
         "students have no new mark; earlier marks are kept. Grade again with <code>--resume</code>.</p>\n"
         "<dl class=\"incidents\">\n" +
         items + "</dl>\n</section>\n";
}

std::string changes_section(const store::ClassResult& results) {
  if (results.changes.empty()) return "";
  std::map<std::string, const store::StudentResult*> by_id;
  for (const store::StudentResult& student : results.students) by_id[student.id] = &student;
  std::string rows;
  for (const store::Change& change : results.changes) {
    const auto found = by_id.find(change.student);
    const std::string name =
        found == by_id.end()
            ? escaped(change.student)
            : fmt::format("<a href=\"{}#step-{}\"><bdi>{}</bdi></a>", page_name(*found->second),
                          escaped(change.step), escaped(found->second->name));
    rows += fmt::format(
        "<tr><th scope=\"row\" class=\"name\">{}</th><td>{}</td><td class=\"number\">{} %</td>"
        "<td class=\"number\">{} %</td><td class=\"{}\">{}</td></tr>\n",
        name, escaped(change.step), number(100 * change.before, 1), number(100 * change.after, 1),
        change.after > change.before ? "passed" : "failed", change.after > change.before ? "▲" : "▼");
  }
  return "<section id=\"changes\">\n<h2>Changed since the last grading</h2>\n<div class=\"scroll\">\n"
         "<table>\n<thead><tr><th scope=\"col\" class=\"name\">Student</th><th scope=\"col\">Step</th>"
         "<th scope=\"col\">before</th><th scope=\"col\">after</th><th></th></tr></thead>\n<tbody>\n" +
         rows + "</tbody>\n</table>\n</div>\n</section>\n";
}

/// "8 students. Mean 21.3 of 42 points, median 20. 1 not graded."
std::string summary(const store::ClassResult& results) {
  std::vector<double> points;
  double most = 0;
  for (const store::StudentResult& student : results.students) {
    most = std::max(most, student.max_points());
    if (student.unmarked().empty()) points.push_back(student.points());
  }
  std::string text = counted(results.students.size(), "student") + ".";
  if (!points.empty()) {
    std::sort(points.begin(), points.end());
    double sum = 0;
    for (const double each : points) sum += each;
    const std::size_t n = points.size();
    text += fmt::format(" Mean {} of {} points, median {}.", number(sum / static_cast<double>(n), 1),
                        number(most), number((points[(n - 1) / 2] + points[n / 2]) / 2, 1));
  }
  if (points.size() < results.students.size())
    text += fmt::format(" {} not graded.", results.students.size() - points.size());
  return text;
}

}  // namespace

std::string class_page(const store::ClassResult& results) {
  const std::vector<judge::LabResult> labs = all_labs(results);
  const std::vector<Tried> tried = tried_steps(results);
  const std::string incidents = incidents_section(results), changes = changes_section(results);
  return page(
      "Class report",
      fmt::format("<header class=\"masthead\">\n<h1>Class report</h1>\n<p>{}</p>\n</header>\n"
                  "<nav aria-label=\"Sections\"><ol><li><a href=\"#students\">Students</a></li>"
                  "<li><a href=\"#steps\">Steps</a></li><li><a "
                  "href=\"#mistakes\">Mistakes</a></li>{}{}<li><a href=\"#facts\">Facts</a></li></ol></nav>\n"
                  "<main>\n{}{}{}{}{}<section id=\"facts\">\n<h2>Facts</h2>\n{}</section>\n</main>\n",
                  summary(results), incidents.empty() ? "" : "<li><a href=\"#incidents\">Not graded</a></li>",
                  changes.empty() ? "" : "<li><a href=\"#changes\">Changed</a></li>",
                  students_section(results, labs), steps_section(tried), mistakes_section(results, tried),
                  incidents, changes, facts_list(results.facts, true)),
      kClassScript);
}

}  // namespace texel::reports
