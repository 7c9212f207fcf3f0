// SPDX-License-Identifier: MIT

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/parallel.hpp"
#include "page.hpp"
#include "reports/reports.hpp"

namespace texel::reports {
namespace {

namespace fs = std::filesystem;

/// The id as a file name. It comes out of a store, which may be from elsewhere.
const std::string& checked(const std::string& id) {
  const bool sound = !id.empty() && id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-_") == id.npos;
  if (!sound)
    throw Error::failed("'" + id + "' is not a student's id", {}, "use a store that texel grade made");
  return id;
}

void write(const fs::path& file, const std::string& text) {
  make_folder(file.parent_path(), "choose another folder with --out");
  write_file(file, text);
}

}  // namespace

std::string page_name(const store::StudentResult& student) {
  // A student whose file was index.zip must not take the class's page; no id has a point.
  return student.id == "index" ? "index.student.html" : checked(student.id) + ".html";
}

void write_html(const store::ClassResult& results, const fs::path& folder) {
  const fs::path report = folder / "report";
  Pictures pictures(folder);
  in_parallel(processors(), results.students.size(), [&](std::size_t i) {
    const store::StudentResult& student = results.students[i];
    write(report / page_name(student), student_page(student, results.facts, pictures));
  });
  write(report / "index.html", class_page(results));
}

void write_format(const std::string& name, const store::ClassResult& results, const fs::path& folder) {
  if (name == "csv") {
    write(folder / "class.csv", csv(results));
    return;
  }
  for (const store::StudentResult& student : results.students) {
    const std::string& id = checked(student.id);
    if (name == "junit")
      write(folder / name / (id + ".xml"), junit(student, folder));
    else if (name == "prairielearn")
      write(folder / name / id / "results.json", prairielearn(student, folder));
    else if (name == "gradescope" && student.unmarked().empty())
      write(folder / name / id / "results.json", gradescope(student));
  }
}

}  // namespace texel::reports
