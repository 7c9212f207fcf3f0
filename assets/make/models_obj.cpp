// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "core/error.hpp"
#include "models_shapes.hpp"

namespace texel::assets {

namespace {

std::string number(double value, double unit = 1, int digits = 6) {
  if (!std::isfinite(value)) throw Error::failed("a made model has a number that is not finite");
  // Below the sixth digit of a unit model there is only rounding noise, which would differ between machines.
  const double rounded = std::round(value / unit * 1e6) * unit / 1e6;
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, rounded == 0 ? 0.0 : rounded);  // 0 and -0 are one number
  return text;
}

}  // namespace

int ObjText::Pool::add(const std::string& numbers, bool shared) {
  const auto [place, fresh] = index.try_emplace(numbers, count + 1);
  if (!fresh && shared) return place->second;
  lines += keyword + ' ' + numbers + '\n';
  return ++count;
}

ObjText::ObjText(const std::string& comment, const std::string& library, const ObjStyle& style)
    : style_(style) {
  std::istringstream lines(comment);
  for (std::string line; std::getline(lines, line);) head_ += "# " + line + '\n';
  if (!library.empty()) head_ += "mtllib " + library + '\n';
}

void ObjText::group(const std::string& name, const std::string& material) {
  faces_ += "g " + name + '\n';
  if (!material.empty()) faces_ += "usemtl " + material + '\n';
}

void ObjText::add(const Part& part) {
  const auto position = [&](double value) { return number(value, style_.unit, style_.digits); };
  for (const Face& face : part.faces) {
    faces_ += 'f';
    for (const Corner& corner : face) {
      const dvec3 p = corner.position, n = corner.normal;
      const auto put = [&](Pool& pool, const std::string& numbers) {
        faces_ += std::to_string(pool.add(numbers, style_.shared));
      };
      faces_ += ' ';
      put(positions_, position(p.x) + ' ' + position(p.y) + ' ' + position(p.z));
      if (style_.texcoords || n != dvec3(0)) faces_ += '/';
      if (style_.texcoords) put(texcoords_, number(corner.texcoord.x) + ' ' + number(corner.texcoord.y));
      if (n == dvec3(0)) continue;
      faces_ += '/';
      put(normals_, number(n.x) + ' ' + number(n.y) + ' ' + number(n.z));
    }
    faces_ += '\n';
  }
}

std::string ObjText::text() const {
  return head_ + positions_.lines + texcoords_.lines + normals_.lines + faces_;
}

namespace {

/// Puts the centre of the bounding box at the origin and the farthest corner at distance 1.
void fit_unit_sphere(std::vector<Group>& groups) {
  const auto each_position = [&](const auto& visit) {
    for (Group& group : groups)
      for (Face& face : group.part.faces)
        for (Corner& corner : face) visit(corner.position);
  };
  dvec3 low(1e300), high(-1e300);
  each_position([&](const dvec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  });
  const dvec3 middle = 0.5 * (low + high);
  double radius = 0;
  each_position([&](const dvec3& p) { radius = std::max(radius, glm::distance(p, middle)); });
  each_position([&](dvec3& p) { p = (p - middle) / radius; });
}

}  // namespace

std::string model_text(const std::string& comment, const std::string& library, std::vector<Group> groups,
                       double texture_size) {
  fit_unit_sphere(groups);
  ObjText obj(comment, library);
  for (Group& group : groups) {
    for (Face& face : group.part.faces)
      for (Corner& corner : face) corner.texcoord = corner.texcoord / texture_size + dvec2(0.5, 0);
    obj.group(group.name, group.name);
    obj.add(group.part);
  }
  return obj.text();
}

std::string material_text(const std::string& comment, const std::vector<Material>& materials) {
  std::string text = "# " + comment + '\n';
  for (const Material& material : materials) {
    text += "\nnewmtl " + material.name + "\nKd " + material.colour + '\n';
    if (!material.texture.empty()) text += "map_Kd ../textures/" + material.texture + '\n';
  }
  return text;
}

}  // namespace texel::assets
