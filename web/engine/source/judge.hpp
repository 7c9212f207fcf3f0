// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "check/check.hpp"
#include "opened.hpp"

namespace texel::web {

/// Where `check` keeps what it remembers.
inline constexpr const char* kBuild = "/build";

/// The public cases of a lab, drawn here and judged as `texel check` does it.
class Judge {
 public:
  /// `opened` gives what draws a lab.
  Judge(std::filesystem::path tree, gl::Context& context, const app::Assets& assets,
        std::function<Opened&(const course::Lab&)> opened);

  /// Of one step, or of all: "".
  const judge::LabResult& check(const course::Lab& lab, const std::string& step);
  /// A case of the last check by its name; nullptr where it has no picture.
  [[nodiscard]] const judge::CaseResult* drawn(const std::string& name) const;

 private:
  check::Drawn draw(const course::Lab& lab, const std::vector<course::Case>& cases,
                    const std::filesystem::path& out);

  std::filesystem::path tree_;
  gl::Context& context_;
  const app::Assets& assets_;
  std::function<Opened&(const course::Lab&)> opened_;
  judge::LabResult checked_;
};

}  // namespace texel::web
