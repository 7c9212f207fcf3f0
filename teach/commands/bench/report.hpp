// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "course/lab_file.hpp"
#include "plot.hpp"
#include "results.hpp"

namespace texel::commands {

/// A lab with what was measured of it.
struct LabResults {
  course::Lab lab;
  std::vector<BenchResult> results;  ///< of its cases, in their order, then those over all cases
  std::vector<BenchResult> by_gpu;   ///< the same as a graphics card measured them, or none
};

/// The results of a report by lab, those over all cases added. Cases that the lab.toml no longer has are left
/// out.
std::vector<LabResults> by_lab(const std::vector<course::Lab>& labs, const BenchReport& report,
                               const BenchReport& by_gpu = {});

/// A table as the terminal shows it.
std::string terminal_table(const LabResults& lab);

/// Error against cost, one plot for each unit and set of parameters that vary, with a panel for each case;
/// and error against the number, for each case over one.
std::vector<Plot> plots(const LabResults& lab);

/// The folder of the page's pictures, beside the page. Each lab has one below it.
inline constexpr const char* kPictures = "pictures";

/// The pictures that the page shows of a result: the colours, and the error of each pixel.
std::vector<course::Case> pictures_of(const course::BenchCase& bench, const BenchResult& result);

/// The whole page as HTML. It names the pictures, and nothing else outside of itself.
std::string bench_page(const std::vector<LabResults>& labs, const std::string& renderer);

/// docs/accuracy.md, whose plots are `folder`/NN_name-1.svg …; `gpu` is the graphics card's name, or "".
std::string bench_markdown(const std::vector<LabResults>& labs, const std::string& renderer,
                           const std::string& gpu, const std::string& folder);

/// The name of a lab's plot, counted from 0, without a folder: "05_normal_map-1.svg".
std::string plot_file(const course::Lab& lab, std::size_t index);

}  // namespace texel::commands
