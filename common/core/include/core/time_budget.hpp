// SPDX-License-Identifier: MIT
#pragma once
#include <atomic>

namespace texel {

/// The seconds that several programs may take together. Members may be called by several threads.
class TimeBudget {
 public:
  explicit TimeBudget(double seconds) : left_(seconds) {}

  [[nodiscard]] double left() const { return left_; }
  void spend(double seconds) { left_.fetch_sub(seconds); }

 private:
  std::atomic<double> left_;
};

}  // namespace texel
