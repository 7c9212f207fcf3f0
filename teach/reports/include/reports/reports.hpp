// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

#include "store/class_results.hpp"

/// What grading found, for people and for the systems that keep marks. `folder` is the results' folder, in
/// which each case's `picture` and `reference` lie. A picture that is missing, broken or too large is said to
/// be so in its place, and stops nothing.
///
/// A student with an incident gets no mark from any of these, since a fault of the grader must never become a
/// zero.
///
/// Of hidden cases the drawn parameters stay secret as long as `reference` is empty: then no command is
/// shown.
namespace texel::reports {

/// Writes `folder`/report/index.html for the class and one page a student beside it, each a file that needs
/// no other and no network. Each page is replaced whole. Throws Error (exit 3) when a file cannot be written.
void write_html(const store::ClassResult& results, const std::filesystem::path& folder);

/// The name of a student's page in the folder "report": "<id>.html".
std::string page_name(const store::StudentResult& student);

/// A results.json for Gradescope: one test a step, with its score, and for each step with hidden cases one
/// without points that only teachers see. At most 1,000,000 bytes: the outputs are shortened, never the
/// scores. Throws Error (exit 3) for a student with an incident: without a results.json Gradescope reports
/// that the grader failed. Source: https://gradescope-autograders.readthedocs.io/en/latest/specs/
std::string gradescope(const store::StudentResult& student);

/// A results.json for PrairieLearn: one test a step. A student with an incident or a submission that could
/// not be read is "not gradable", which costs no attempt. At most 1,000,000 bytes: pictures are left out
/// first, from the last, then outputs are shortened. Source: https://docs.prairielearn.com/externalGrading/
std::string prairielearn(const store::StudentResult& student, const std::filesystem::path& folder);

/// JUnit XML: one suite a lab and one test a case. Pictures are attached by lines [[ATTACHMENT|path]], with
/// `folder` as it was given: absolute for Jenkins, relative to the project for GitLab. A student's own text
/// cannot make such a line. Sources: https://docs.gitlab.com/ci/testing/unit_test_reports/ and
/// https://plugins.jenkins.io/junit-attachments/
std::string junit(const store::StudentResult& student, const std::filesystem::path& folder);

/// One row a student: name, id, number, total, each lab, each step (all in points), the numbers
/// of the labs of which a step is written, and a note. A student with an incident has no points there: empty
/// cells, which Canvas and Moodle leave as they are. RFC 4180; a text that a spreadsheet would take for a
/// formula begins with an apostrophe.
std::string csv(const store::ClassResult& results);

/// Writes one of the formats above into the results' folder: "gradescope" and "prairielearn" as
/// <format>/<id>/results.json, "junit" as junit/<id>.xml, "csv" as class.csv. Gradescope's file of a student
/// with an incident is left as it was. Throws Error (exit 3) when a file cannot be written.
void write_format(const std::string& name, const store::ClassResult& results,
                  const std::filesystem::path& folder);

}  // namespace texel::reports
