// SPDX-License-Identifier: MIT
#include "comparison.hpp"

#include <algorithm>

namespace texel::image {

Box box_to_compare(const Image8& reference, const Image8& image, int radius) {
  Box box{reference.width, reference.height, 0, 0};
  for (int y = 0; y < reference.height; ++y)
    for (int x = 0; x < reference.width; ++x) {
      bool differs = false;
      for (int c = 0; c < 3; ++c) differs |= rgb_sample(reference, x, y, c) != rgb_sample(image, x, y, c);
      if (!differs) continue;
      box = {std::min(box.left, x), std::min(box.bottom, y), std::max(box.right, x + 1),
             std::max(box.top, y + 1)};
    }
  if (box.right == 0) return {};
  const int margin = 2 * radius;
  return {std::max(0, box.left - margin), std::max(0, box.bottom - margin),
          std::min(reference.width, box.right + margin), std::min(reference.height, box.top + margin)};
}

}  // namespace texel::image
