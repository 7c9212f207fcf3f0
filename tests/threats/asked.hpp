// SPDX-License-Identifier: MIT
// Stands in a threat's source for @ASKED@: what a lab's program is asked for by the grader.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

struct Asked {
  std::filesystem::path list, out;
  std::vector<std::string> files;
};

inline Asked asked(int argc, char** argv) {
  Asked all;
  for (int i = 1; i + 1 < argc; ++i) {
    if (argv[i] == std::string("--batch")) all.list = argv[i + 1];
    if (argv[i] == std::string("--out")) all.out = argv[i + 1];
  }
  std::ifstream file(all.list);
  const std::string text{std::istreambuf_iterator<char>(file), {}}, key = "\"name\": \"";
  for (std::size_t at = 0; (at = text.find(key, at)) != text.npos;) {
    at += key.size();
    all.files.push_back(text.substr(at, text.find('"', at) - at));
  }
  return all;
}

/// What would harm the machine outside a sandbox is tried in one only.
inline void only_in_a_sandbox() {
  char name[64] = {};
  if (::gethostname(name, sizeof name - 1) != 0 || name != std::string("sandbox")) std::_Exit(99);
}

inline bool can_read(const std::filesystem::path& file) {
  return std::ifstream(file).get() != std::ifstream::traits_type::eof();
}
