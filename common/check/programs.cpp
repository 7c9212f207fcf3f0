// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "check/check.hpp"
#include "check/studio.hpp"

namespace texel::grade {
namespace {

Studio studio_of(const OwnTree& tree, const course::Lab& lab, const std::string& context) {
  Studio studio;
  studio.program = tree.build / "bin" / lab.program();
  studio.root = tree.source, studio.context = context;
  studio.shader_cache = tree.build / "check/shaders";
  return studio;
}

}  // namespace

Draws by_programs(const OwnTree& tree, const std::string& context) {
  return {
      [=](const course::Lab& lab, const std::vector<course::Case>& cases, const std::filesystem::path& out) {
        const Studio studio = studio_of(tree, lab, context);
        if (!std::filesystem::exists(studio.program))
          throw Error::failed("is not built", {studio.program.string()},
                              fmt::format("build it with ./run check {}", lab.number));
        return draw(studio, cases, out);
      },
      [=](const course::Lab& lab) {
        try {
          return renderer_of(studio_of(tree, lab, context));
        } catch (const Error&) {  // the cases say why the program does not draw
          return std::string();
        }
      }};
}

}  // namespace texel::grade
