// SPDX-License-Identifier: MIT
#pragma once
#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>

#include "core/error.hpp"

namespace texel::tools {

inline void add_context(CLI::App* command, std::string& context) {
  command->add_option("--context", context, "Where OpenGL comes from")
      ->check(CLI::IsMember({"auto", "osmesa", "egl"}));
}

/// Commands that only some trees have: teach/commands adds those of who makes or teaches the course.
class MoreCommands {
 public:
  virtual ~MoreCommands() = default;
  /// Runs the one that was asked for; nothing when it was none of these.
  [[nodiscard]] virtual std::optional<Exit> run() const = 0;

  /// Adds them to the command line; null where the tree has none.
  static inline std::unique_ptr<MoreCommands> (*make)(CLI::App& app) = nullptr;
};

}  // namespace texel::tools
