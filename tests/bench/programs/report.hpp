// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "core/json.hpp"
#include "rounds.hpp"

namespace texel::bench {

/// The report as it grows: each line is printed when it is known.
class Report {
 public:
  void begin(const std::string& title, const std::string& text);
  void add(const Row& row);
  /// A sentence below the table.
  void note(const std::string& text);
  /// Milliseconds by stage of a lab's snapshot, as --stats says them.
  void add_stages(const std::string& lab, const Json& stages) { stages_.emplace_back(lab, stages); }

  [[nodiscard]] std::string as_json() const;
  /// `rounds` and `long_rounds` are told in the introduction.
  [[nodiscard]] std::string as_markdown(int rounds, int long_rounds) const;

 private:
  struct Section {
    std::string title, text;
    std::vector<Row> rows;
    std::vector<std::string> notes;
  };
  [[nodiscard]] std::string stage_table() const;

  std::vector<Section> sections_;
  std::vector<std::pair<std::string, Json>> stages_;
};

}  // namespace texel::bench
