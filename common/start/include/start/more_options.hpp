// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <memory>
#include <string>

#include "app/canvas.hpp"

namespace CLI {
class App;
}

namespace texel::start {

/// Options that only some trees have: teach/bench adds those that measure by the right answer.
class MoreOptions {
 public:
  virtual ~MoreOptions() = default;
  /// Whether one was given that needs no window.
  [[nodiscard]] virtual bool is_headless() const = 0;
  /// Reads the files that they name, and returns whether frames are timed. Throws Error (usage).
  [[nodiscard]] virtual bool prepare(app::AnyLab& lab) = 0;
  /// Before all else that is drawn without a window.
  virtual void run(app::Canvas& canvas, app::AnyLab& lab, glm::ivec2 size) = 0;

  /// Adds them to the command line; null where the tree has none.
  static inline std::unique_ptr<MoreOptions> (*make)(CLI::App& app) = nullptr;
};

/// To standard output for "-".
void write_report(const std::filesystem::path& file, const std::string& json);

}  // namespace texel::start
