// SPDX-License-Identifier: MIT
// Step 3.3. Cuts a simple polygon in the plane into triangles (ear clipping; Meisters 1975: each simple
// polygon has two ears). False when it found a place without an ear and cut a corner all the same.
#include <numeric>

#include "mesh/polygon.hpp"

namespace texel::mesh {

bool clip_ears(const std::vector<glm::dvec2>& flat, std::vector<Triangle>& triangles) {
  //@step 3.3 begin
  std::vector<std::uint32_t> rest(flat.size());  // the corners not yet cut off, in order
  std::iota(rest.begin(), rest.end(), 0U);
  bool simple = true;
  std::size_t tip = 0, refused = 0;
  while (rest.size() > 3) {
    tip %= rest.size();
    const std::size_t before = (tip + rest.size() - 1) % rest.size();
    const Triangle ear{rest[before], rest[tip], rest[(tip + 1) % rest.size()]};
    const glm::dvec2 &a = flat[ear[0]], &b = flat[ear[1]], &c = flat[ear[2]];
    const bool stuck = refused >= rest.size();  // went all the way round and found none
    // No ear where the corner turns right, or another corner lies in the triangle.
    if (!stuck && (area(a, b, c) <= 0.0 || holds_a_corner(flat, rest, a, b, c))) {
      ++tip, ++refused;
      continue;
    }
    simple = simple && !(stuck && area(a, b, c) != 0.0);
    triangles.push_back(ear);
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(tip));
    refused = 0;
    tip = tip == 0 ? rest.size() - 1 : tip - 1;  // cutting may have made the corner before an ear
  }
  triangles.push_back({rest[0], rest[1], rest[2]});
  return simple;
  //@starter
  // // Cut off one ear after the other: a corner that turns left and whose triangle holds no other corner.
  // fan(flat.size(), triangles);
  // return true;
  //@end
}

}  // namespace texel::mesh
