// SPDX-License-Identifier: MIT
// write_demo_class DIR: the demo class with its reports in every format, for tests/reports/formats_test.py.
#include "demo_class.hpp"
#include "reports/reports.hpp"

int main(int, char** arguments) {
  const std::filesystem::path folder = arguments[1];
  const texel::store::ClassResult results = texel::test::demo_class(folder);
  texel::reports::write_html(results, folder);
  for (const char* format : {"gradescope", "prairielearn", "junit", "csv"})
    texel::reports::write_format(format, results, folder);
}
