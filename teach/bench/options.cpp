// SPDX-License-Identifier: MIT
// --measure, --bench and --report.
#include <CLI/CLI.hpp>

#include "app/reports.hpp"
#include "bench/bench.hpp"
#include "start/more_options.hpp"

namespace texel::bench {
namespace {

class Options final : public start::MoreOptions {
 public:
  explicit Options(CLI::App& app) {
    app.add_option("--measure", measure_,
                   "Write as JSON how far the picture is from the exact answer (- prints it)");
    app.add_option("--bench", bench_,
                   "Measure error and cost of the cases in a JSON file that texel bench wrote");
    app.add_option("--report", report_, "Where --bench writes its figures, as JSON [-]");
  }
  [[nodiscard]] bool is_headless() const override { return !measure_.empty() || !bench_.empty(); }
  [[nodiscard]] bool prepare(app::AnyLab& lab) override {
    if (bench_.empty()) return false;
    list_ = read_bench(lab, bench_);
    return !list_.cases.empty() && (list_.seconds > 0 || list_.counts);
  }
  void run(app::Canvas& canvas, app::AnyLab& lab, glm::ivec2 size) override {
    if (!measure_.empty()) {
      canvas.draw(app::View::error, size, 1);
      start::write_report(measure_, lab.answer()->report(lab, *canvas.error_figures()));
    }
    if (!bench_.empty()) start::write_report(report_, run_bench(canvas, lab, list_));
  }

 private:
  std::filesystem::path measure_, bench_, report_ = "-";
  BenchList list_;
};

const bool options_are_known = [] {
  start::MoreOptions::make = [](CLI::App& app) -> std::unique_ptr<start::MoreOptions> {
    return std::make_unique<Options>(app);
  };
  return true;
}();

}  // namespace
}  // namespace texel::bench
