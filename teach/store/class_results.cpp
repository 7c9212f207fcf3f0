// SPDX-License-Identifier: MIT
#include "store/class_results.hpp"

#include <fmt/format.h>

namespace texel::store {

double StudentResult::points() const {
  double sum = 0;
  for (const judge::LabResult& lab : labs) sum += lab.points();
  return sum;
}

double StudentResult::max_points() const {
  double sum = 0;
  for (const judge::LabResult& lab : labs) sum += lab.max_points();
  return sum;
}

std::string StudentResult::unmarked() const {
  if (!incident.empty() || !is_unfinished()) return incident;
  return fmt::format("the run is not finished: {} of {} cases are judged", judged, planned);
}

}  // namespace texel::store
