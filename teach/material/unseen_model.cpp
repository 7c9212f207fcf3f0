// SPDX-License-Identifier: MIT
#include "material/unseen_model.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/process.hpp"

namespace texel::material {

std::string unseen_model(const std::string& kind, std::uint64_t seed) {
  const std::vector<std::string> kinds(std::begin(kUnseenKinds), std::end(kUnseenKinds));
  if (std::ranges::count(kinds, kind) == 0)
    throw Error::usage(fmt::format("there is no unseen model of kind '{}'", kind), did_you_mean(kind, kinds));
  const Ran script = run_program({"python3", "-I", "-S", TEXEL_UNSEEN_MODEL, kind, fmt::format("{}", seed)});
  if (script.exit_code != 0)
    throw Error::failed("made no unseen model; see its message above", {TEXEL_UNSEEN_MODEL});
  return script.output;
}

}  // namespace texel::material
