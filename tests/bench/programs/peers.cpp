// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/process.hpp"
#include "image/difference.hpp"
#include "image/load.hpp"
#include "measures.hpp"

namespace texel::bench {
namespace {

constexpr const char* kLab9 = "lab09_bump";
constexpr double kSameContent =
    2;  // 8-bit steps in the mean; 0.9 measured: mipmaps and the driver's filters differ

/// One round of tests/bench/peers/measure.mjs.
Json measure_pages(const Options& options) {
  const Ran ran =
      run_program({"node", (options.root / "tests/bench/peers/measure.mjs").string(), "1", "--json"});
  if (ran.exit_code != 0)
    throw Error::failed("the pages cannot be measured", {}, "./run performance makes them");
  return parse_json(ran.output).at(0);
}

/// A batch of so many pictures of 512x512 with 4 samples a pixel.
double batch_ms(const Options& options, int count) {
  Json entries = Json::array();
  for (int i = 0; i < count; ++i) entries.push_back({{"name", fmt::format("{}", i)}});
  const std::string file = options.work_file(fmt::format("peers_{}.json", count));
  write_file(file, to_text(entries));
  return run_process({options.program(kLab9), "--batch", file, "--out", options.work_file("peers")},
                     {"GALLIVM_PERF=no_aos_sampling"})
      .milliseconds;
}

}  // namespace

/// Our page and our program beside three.js' page of the same ball, in the same rounds.
void measure_peers(const Options& options, Report& report) {
  constexpr int more = 20;
  struct Figure {
    const char *what, *name, *unit, *why = "";
  };
  constexpr Figure figures[] = {
      {"page, first picture", "first_picture_ms", "ms",
       "by the worker's clock, milliseconds after navigation: it runs at 60, its WebGL context is there "
       "at 240, the lab is open at 300, seven pictures are unpacked at 370. Mipmaps, uploads and shaders "
       "take until 515, the drawing until 590. Meanwhile the page lays out the handout. three.js draws "
       "on the page's own thread; our worker keeps the page alive when a shader never ends. Tried, each "
       "within the noise: the context before the files, the files before the context, no extensions but "
       "the four that are used, no question to the driver between uploads, textures and shaders made "
       "before the page knows the picture's size, a handout that is laid out when it is scrolled to. With "
       "a graphics card (NVIDIA H200, Vulkan, 16 processors) ours takes 345 ms and three.js' 164."},
      {"page, antialiased", "antialiased_ms", "ms"},
      {"page, one sample", "plain_ms", "ms"},
      {"page, loaded", "bytes", "bytes"}};
  report.begin(
      "Beside three.js",
      "Lab 9's ball by three.js (`tests/bench/peers`): the same cube map, normal map, mesh and filters, "
      "in headless Chromium, which draws by SwiftShader. Pages: the first picture from navigation on, in "
      "a browser that has drawn both, is at rest, and keeps no files; one of many pictures of 512x512 "
      "with 4 samples a pixel and with one; what is loaded, as brotli compresses it. Our page comes with "
      "its handout, all labs and the judge, which the browser compiles and lays out while it waits for "
      "the picture, and with its pictures as lossless WebP; three.js' page loads the tree's PNG files. "
      "Our program draws by llvmpipe: one of many pictures with 4 samples; and one from the start of the "
      "process to its end, with the driver's cache of shaders, beside three.js' first one from the start "
      "of Chromium, and beside a program in a window as a tutorial has it (`tests/bench/peers/window.cpp`: "
      "GLFW, stb_image, `glGenerateMipmap`, one file after the other), which has the driver's cache too.");
  const auto snapshot_ms = [&] {
    return run_process({options.program(kLab9), "--snapshot", options.work_file("peers.png")},
                       options.kept_shaders())
        .milliseconds;
  };
  const auto window_ms = [&] {
    return run_process({options.program("peer_window"), options.assets(), options.work_file("window.png")},
                       options.kept_shaders())
        .milliseconds;
  };
  snapshot_ms(), window_ms();  // fill the cache
  if (image::compare(image::load8(options.work_file("peers.png"), 3),
                     image::load8(options.work_file("window.png"), 3))
          .mean > kSameContent)
    throw Error::failed("draws another picture than lab 9", {"peer_window"});
  std::vector<std::vector<Pair>> pages(std::size(figures));
  std::vector<Pair> one_more, cold, window;
  for (int i = 0; i < options.rounds; ++i) {
    const Json round = measure_pages(options);
    const Json &ours = round.at("ours"), &theirs = round.at("theirs");
    for (std::size_t k = 0; k < std::size(figures); ++k)
      pages[k].push_back({ours.at(figures[k].name), theirs.at(figures[k].name)});
    one_more.push_back(
        {(batch_ms(options, more + 1) - batch_ms(options, 1)) / more, theirs.at("antialiased_ms")});
    cold.push_back({snapshot_ms(), theirs.at("cold_ms")});
    window.push_back({snapshot_ms(), window_ms()});
  }
  for (std::size_t k = 0; k < std::size(figures); ++k)
    report.add(row_of(figures[k].what, "ours", "three.js", figures[k].unit, pages[k], Target::at_most, 1,
                      figures[k].why));
  report.add(row_of("program, one more", "ours", "three.js", "ms", one_more, Target::at_most, 0.6));
  report.add(row_of("program, first picture", "ours", "three.js", "ms", cold, Target::at_most, 0.07,
                    "of 150 ms by --stats, driver and context take 18, reading seven pictures 30, their "
                    "mipmaps and upload 22, compressing the picture 8. The first picture takes 65: one "
                    "more takes 20, the rest loads the machine code that the driver kept."));
  report.add(row_of("program, first picture, beside a window's", "ours", "window", "ms", window,
                    Target::at_most, 0.14,
                    "the window's program takes 0.3 s. The target is less than reading the pictures and "
                    "drawing one take, which both programs must do."));
}

}  // namespace texel::bench
