// SPDX-License-Identifier: MIT
#include "store/class_results.hpp"

namespace texel::grade {

double StudentResult::points() const {
  double sum = 0;
  for (const LabResult& lab : labs) sum += lab.points();
  return sum;
}

double StudentResult::max_points() const {
  double sum = 0;
  for (const LabResult& lab : labs) sum += lab.max_points();
  return sum;
}

}  // namespace texel::grade
