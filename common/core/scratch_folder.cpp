// SPDX-License-Identifier: MIT
#include "core/scratch_folder.hpp"

#include <stdlib.h>  // mkdtemp

#include <string>

#include "core/error.hpp"

namespace texel {

ScratchFolder::ScratchFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "texel_XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr)
    throw Error::failed("cannot make a temporary folder", {name},
                        "check that this folder is writable and has free space");
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;  // a destructor cannot report it
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace texel
