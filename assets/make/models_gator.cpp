// SPDX-License-Identifier: MIT
// An alligator: the head points to +x, the tail sweeps to -x, y is up. Body and lower jaw are superelliptic
// sections swept along one curved spine; legs, scutes, teeth and eyes are pieces of their own that sink into
// it.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "models_list.hpp"
#include "models_shapes.hpp"

namespace texel::assets {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double texture_size = 0.32;  // length that one copy of the texture covers
constexpr double length = 2.42;        // from the snout's tip (0) along the spine to the tail's tip
constexpr double hinge = 0.40;         // of the jaws
constexpr double ground = -0.185;

double mix(double a, double b, double t) {
  return a + (b - a) * t;
}

/// The spine: walked from the snout's tip at distance 0; heading 0 looks to +x.
class Spine {
 public:
  Spine() {
    dvec3 p(0);
    for (int i = 0; i <= steps; ++i) {
      const double s = length * i / steps;
      points_.push_back(p + dvec3(0, height_(s), 0));
      const double angle = glm::radians(heading_(s));
      p += length / steps * dvec3(-std::cos(angle), 0, std::sin(angle));
    }
  }
  [[nodiscard]] dvec3 at(double s) const {
    const double x = std::clamp(s / length, 0.0, 1.0) * steps;
    const auto i = std::size_t(std::min(x, double(steps - 1)));
    return glm::mix(points_[i], points_[i + 1], x - double(i));
  }
  /// `side` is to the animal's left, `up` as near to y as the spine allows.
  [[nodiscard]] Frame frame(double s) const {
    const dvec3 forward = glm::normalize(at(s - 0.012) - at(s + 0.012));
    const dvec3 up = glm::normalize(dvec3(0, 1, 0) - forward.y * forward);
    return {at(s), glm::cross(up, forward), up};
  }

 private:
  static constexpr int steps = 600;
  std::vector<dvec3> points_;
  Profile heading_{0, -24, 0.35, -18, 0.62, -4, 0.95, 8, 1.25, 20, 1.6, 48, 1.95, 52, 2.2, 10, length, -34};
  Profile height_{0, 0.085, 0.2,   0.062, 0.4,   0.035, 0.55,   0.015,  0.85,
                  0, 1.2,   -0.01, 1.5,   -0.06, 1.9,   -0.125, length, -0.16};
};

/// Half width and heights of the section at each distance along the spine.
struct Shape {
  Profile width, up, down, up_exponent, down_exponent;
  [[nodiscard]] Section at(double s) const {
    return {width(s), up(s), down(s), up_exponent(s), down_exponent(s)};
  }
};

/// Trunk, neck, tail, and the head down to the line of the upper teeth.
const Shape& body_shape() {
  static const Shape shape{
      .width = {0,    0,     0.004, 0.042, 0.014, 0.070, 0.035, 0.090, 0.07, 0.098, 0.12,   0.096,
                0.17, 0.100, 0.24,  0.113, 0.31,  0.133, 0.37,  0.146, 0.42, 0.142, 0.49,   0.116,
                0.55, 0.118, 0.65,  0.150, 0.78,  0.186, 0.92,  0.196, 1.05, 0.178, 1.17,   0.138,
                1.30, 0.106, 1.55,  0.074, 1.85,  0.045, 2.15,  0.022, 2.38, 0.008, length, 0},
      .up = {0,    0,     0.004, 0.024, 0.014, 0.040, 0.04, 0.052, 0.065, 0.050, 0.11, 0.044, 0.18,   0.051,
             0.25, 0.068, 0.30,  0.086, 0.35,  0.092, 0.41, 0.088, 0.48,  0.083, 0.56, 0.094, 0.70,   0.116,
             0.88, 0.130, 1.05,  0.122, 1.2,   0.100, 1.5,  0.078, 1.85,  0.056, 2.2,  0.032, length, 0},
      .down = {0,    0,     0.01, 0.010, 0.1,  0.014, 0.28, 0.020, 0.37,   0.034,
               0.42, 0.066, 0.50, 0.086, 0.62, 0.102, 0.85, 0.122, 1.05,   0.116,
               1.2,  0.098, 1.5,  0.074, 1.85, 0.050, 2.2,  0.026, length, 0},
      .up_exponent = {0, 2, 0.1, 2.4, 0.3, 2.6, 0.42, 2.7, 0.6, 2.3, 0.9, 2.2, 1.3, 2.0, 1.7, 1.6, length,
                      1.5},
      .down_exponent = {0, 2.5, 0.2, 3.4, 0.35, 3, 0.5, 2.4, 0.85, 3.2, 1.1, 2.8, 1.5, 2.2, length, 1.8}};
  return shape;
}

/// The lower jaw: flat above, a little narrower than the snout.
const Shape& jaw_shape() {
  static const Shape shape{
      .width = {0.022, 0,    0.026, 0.034, 0.036, 0.058, 0.06,  0.078, 0.1,   0.085, 0.16,
                0.089, 0.24, 0.102, 0.31,  0.120, 0.37,  0.132, 0.43,  0.122, 0.5,   0.09},
      .up = {0.022, 0, 0.032, 0.010, 0.3, 0.014, 0.5, 0.03},
      .down = {0.022, 0, 0.026, 0.010, 0.04, 0.021, 0.1, 0.029, 0.2, 0.036, 0.32, 0.050, 0.40, 0.060, 0.5,
               0.05},
      .up_exponent = {0, 3.4, 0.5, 3},
      .down_exponent = {0, 2.2, 0.5, 2.3}};
  return shape;
}

/// How far the lower jaw hangs below the spine at a distance: closed at the hinge, open at the tip.
double jaw_drop(double s) {
  return 0.018 + 0.245 * std::max(0.0, hinge + 0.03 - s);
}

/// The upper lip hangs in waves over the lower teeth.
double lip(double s) {
  return 0.007 * std::sin(2 * pi * s / 0.15) * std::clamp(8 * s, 0.0, 1.0) *
         std::clamp(8 * (0.42 - s), 0.0, 1.0);
}

class Gator {
 public:
  [[nodiscard]] std::string obj();

 private:
  void add(Part& group, Part part, double crease) {
    smooth(part, crease);
    group += part;
  }
  Part swept(const Shape& shape, const std::vector<double>& stations, int columns, bool jaw);
  Frame surface(double s, double aside) const;
  void add_skin(Part part, double inward);
  void add_body();
  void add_scutes();
  void add_scute(double s, double aside, dvec3 size);
  void add_head();
  void add_teeth();
  void add_leg(double s, double side, bool front, double stride);

  Spine spine_;
  Part skin_, mouth_, scutes_, teeth_, claws_, eyes_, dark_;
};

/// Stations from `from` back to `to`, closer near `from` where a snout is round, in the order of travel
/// (forwards).
std::vector<double> stations_between(double from, double to, int count, double crowding) {
  std::vector<double> s;
  for (int i = count; i >= 0; --i) {
    const double t = double(i) / count;
    s.push_back(mix(from, to, crowding * t * t * t + (1 - crowding) * t));
  }
  return s;
}

Part Gator::swept(const Shape& shape, const std::vector<double>& stations, int columns, bool jaw) {
  Rows rows;
  for (const double s : stations) {
    Frame frame = spine_.frame(s);
    if (jaw) frame.origin.y -= jaw_drop(s);
    std::vector<dvec3> row;
    Section section = shape.at(s);
    if (!jaw) section.down += lip(s);
    for (const dvec2 p : ring(section, columns)) row.push_back(frame.at(p));
    rows.push_back(std::move(row));
  }
  return solid(rows, {.middle = columns / 2});
}

/// Sorts the faces before the hinge that look into the mouth (`inward` is their normal's sign in y) from the
/// skin.
void Gator::add_skin(Part part, double inward) {
  smooth(part, 75);
  const Frame at = spine_.frame(hinge - 0.03);
  const dvec3 forward = glm::cross(at.side, at.up);
  for (Face& face : part.faces) {
    const bool before = glm::dot(face.front().position - at.origin, forward) > 0;
    (before && inward * face_normal(face).y > 0.75 ? mouth_ : skin_).faces.push_back(std::move(face));
  }
}

void Gator::add_body() {
  // The head needs finer sections than the trunk and the tail.
  std::vector<double> stations = stations_between(0.46, length, 52, 0);
  const std::vector<double> head = stations_between(0, 0.46, 30, 0.75);
  stations.insert(stations.end(), head.begin() + 1, head.end());
  add_skin(swept(body_shape(), stations, 32, false), -1);
  add_skin(swept(jaw_shape(), stations_between(0.022, 0.5, 22, 0.75), 20, true), 1);
  Frame tongue = spine_.frame(0.21);
  tongue.origin.y -= jaw_drop(0.21) - 0.012;
  tongue.up = glm::normalize(tongue.up + 0.2 * glm::cross(tongue.side, tongue.up));
  add(mouth_, ellipsoid(tongue, {0.050, 0.012, 0.13}, 14, 10), 180);
}

/// A frame on the skin at arc length `aside` from the middle of the back: origin on the skin, `up` outwards,
/// and side x up towards the head.
Frame Gator::surface(double s, double aside) const {
  constexpr int columns = 96;
  const Frame frame = spine_.frame(s);
  const std::vector<dvec2> points = ring(body_shape().at(s), columns);
  const double step = glm::distance(points[columns / 2], points[columns / 2 + 1]);
  const double at = columns / 2.0 - aside / step;
  const auto i = std::size_t(at);
  const dvec2 p = glm::mix(points[i], points[i + 1], at - double(i));
  const dvec2 along = glm::normalize(points[i] - points[i + 1]);  // to the animal's left over the back
  const dvec2 out(-along.y, along.x);
  const dvec3 side = along.x * frame.side + along.y * frame.up, up = out.x * frame.side + out.y * frame.up;
  return {frame.at(p), side, up};
}

/// A keeled plate: half length, half width and height; its ridge rises towards the tail.
void Gator::add_scute(double s, double aside, dvec3 size) {
  const Frame at = surface(s, aside);
  const dvec3 forward = glm::cross(at.side, at.up);
  const auto point = [&](double ahead, double right, double up) {
    return at.origin + size.x * ahead * forward - size.y * right * at.side + up * at.up;
  };
  const double sunk = -0.35 * size.z - 0.006;
  const std::vector<dvec3> base{point(1, 0, sunk),     point(0.3, -1, sunk),   point(-0.7, -0.9, sunk),
                                point(-1.05, 0, sunk), point(-0.7, 0.9, sunk), point(0.3, 1, sunk)};
  const dvec3 front = point(0.45, 0, 0.45 * size.z), peak = point(-0.6, 0, size.z);
  Part part;
  const auto face = [&](std::initializer_list<dvec3> points) {
    Face corners;
    for (const dvec3& p : points) corners.push_back({p});
    // The scale of the skin: u from the middle of the back, unrolled up the side on which the face lies; v
    // along the spine.
    const dvec3 n = face_normal(corners);
    const double below = glm::dot(n, at.up) < -0.9 ? -1 : 1, left = glm::dot(n, at.side) > 0 ? 1 : -1;
    for (Corner& corner : corners) {
      const dvec3 d = corner.position - at.origin;
      const double across = aside + below * (glm::dot(d, at.side) - left * glm::dot(d, at.up));
      corner.texcoord = {-across, length - s + glm::dot(d, forward)};
    }
    part.add(std::move(corners));
  };
  face({base[0], base[1], front});
  face({base[1], base[2], peak, front});
  face({base[2], base[3], peak});
  face({base[3], base[4], peak});
  face({base[4], base[5], front, peak});
  face({base[5], base[0], front});
  face({base[5], base[4], base[3], base[2], base[1], base[0]});
  add(scutes_, std::move(part), 25);
}

void Gator::add_scutes() {
  // The back: rows across, of which the middle ones are the highest.
  for (int row = 0; row < 17; ++row) {
    const double s = 0.615 + 0.0355 * row;
    const double full = std::sin(pi * (row + 2.5) / 21);  // narrower towards neck and hips
    for (int k = 0; k < 3; ++k) {
      const double aside = (k + 0.5) * mix(0.033, 0.046, full);
      for (const double side : {-1.0, 1.0})
        add_scute(s + 0.004 * k, side * aside, {0.0185, 0.0155, 0.020 - 0.003 * k});
    }
  }
  // The neck's plates, in rows of two, four and two.
  for (const dvec2 p : {dvec2(0.475, 0.026), dvec2(0.525, 0.028), dvec2(0.525, 0.072), dvec2(0.568, 0.026)})
    for (const double side : {-1.0, 1.0}) add_scute(p.x, side * p.y, {0.022, 0.016, 0.018});
  // The tail: two crests that draw together, then one that ends before the tip.
  for (int i = 0; i < 15; ++i) {
    const double s = 1.225 + 0.038 * i, t = i / 14.0;
    for (const double side : {-1.0, 1.0})
      add_scute(s, side * mix(0.054, 0.016, t), {0.021, 0.009, mix(0.020, 0.046, std::sin(0.5 * pi * t))});
  }
  for (int i = 0; i < 15; ++i) {
    const double t = i / 14.0;
    add_scute(1.80 + 0.037 * i, 0, {mix(0.023, 0.016, t), mix(0.010, 0.005, t), mix(0.058, 0.018, t)});
  }
}

void Gator::add_head() {
  for (const double side : {-1.0, 1.0}) {
    // Brow, eyeball and slit pupil; the eyes look outwards and a little forwards.
    const Frame head = spine_.frame(0.305);
    const dvec3 forward = glm::cross(head.side, head.up);
    const dvec3 brow = head.at({side * 0.064, 0.074});
    add(skin_, ellipsoid({brow, head.side, head.up}, {0.034, 0.034, 0.062}, 16, 10), 180);
    const dvec3 look = glm::normalize(side * head.side + 0.55 * forward + 0.15 * head.up);
    const dvec3 eye = head.at({side * 0.081, 0.080}) + 0.010 * forward;
    const dvec3 across = glm::normalize(glm::cross(dvec3(0, 1, 0), look));
    const Frame ball{eye, across, glm::cross(look, across)};
    add(eyes_, ellipsoid(ball, dvec3(0.0225), 14, 10), 180);
    add(dark_, ellipsoid({eye + 0.0175 * look, ball.side, ball.up}, {0.0042, 0.0145, 0.0065}, 8, 6), 180);
    // The nostril on its bump.
    const Frame nose = spine_.frame(0.042);
    add(dark_, ellipsoid({nose.at({side * 0.033, 0.057}), nose.side, nose.up}, {0.006, 0.004, 0.008}, 8, 6),
        180);
    add(skin_, ellipsoid({nose.at({side * 0.030, 0.045}), nose.side, nose.up}, {0.018, 0.015, 0.021}, 12, 8),
        180);
  }
}

void Gator::add_teeth() {
  const auto row = [&](bool upper, double first, double last, int count) {
    for (int i = 0; i < count; ++i) {
      const double s = mix(first, last, double(i) / (count - 1));
      Frame frame = spine_.frame(s);
      const Shape& shape = upper ? body_shape() : jaw_shape();
      if (!upper) frame.origin.y -= jaw_drop(s);
      // Every third or fourth tooth is long, as in the animal.
      const double tall =
          0.024 + 0.012 * std::pow(std::sin(1.1 * i + (upper ? 0.4 : 1.3)), 2.0) - 0.010 * i / count;
      for (const double side : {-1.0, 1.0}) {
        const double x = side * (shape.width(s) - 0.010);
        const double root = upper ? -0.4 * shape.down(s) : 0.4 * shape.up(s);
        const double tip = upper ? -shape.down(s) - tall : shape.up(s) + tall;
        add(teeth_, cone(frame.at({x, root}), frame.at({x + side * 0.003, tip}), 0.0085, 6), 80);
      }
    }
  };
  // The front teeth stand across the tip of the snout.
  for (const double x : {-0.047, -0.018, 0.018, 0.047}) {
    const Frame upper = spine_.frame(0.014);
    Frame lower = spine_.frame(0.036);
    lower.origin.y -= jaw_drop(0.036);
    add(teeth_, cone(upper.at({x, -0.002}), upper.at({x, -0.034}), 0.0075, 6), 80);
    add(teeth_, cone(lower.at({0.9 * x, 0.002}), lower.at({0.9 * x, 0.032}), 0.0075, 6), 80);
  }
  row(true, 0.020, 0.335, 13);
  row(false, 0.042, 0.315, 12);
}

/// A leg with its foot. `s` is where it leaves the spine, `side` 1 (left) or -1 (right), `stride` moves the
/// foot ahead.
void Gator::add_leg(double s, double side, bool front, double stride) {
  const Frame body = spine_.frame(s);
  const dvec3 ahead = glm::normalize(dvec3(1, 0, 1) * glm::cross(body.side, body.up)),
              left = glm::normalize(dvec3(1, 0, 1) * body.side);
  const auto place = [&](double forward, double out, double y) {
    dvec3 p = body.origin + forward * ahead + side * out * left;
    p.y = y;
    return p;
  };
  const double wrist_y = ground + 0.042;
  std::vector<dvec3> joints;
  if (front)
    joints = {place(0.02, 0.07, -0.01), place(-0.03, 0.165, -0.012),
              place(-0.055 + 0.4 * stride, 0.235, -0.065), place(0.01 + stride, 0.255, wrist_y),
              place(0.05 + stride, 0.262, ground + 0.022)};
  else
    joints = {place(-0.01, 0.06, -0.02), place(0.055, 0.165, -0.012),
              place(0.09 + 0.4 * stride, 0.245, -0.05), place(-0.035 + stride, 0.265, wrist_y),
              place(0.03 + stride, 0.283, ground + 0.022)};
  const Profile thick = front
                            ? Profile{0, 0.075, 0.25, 0.066, 0.5, 0.048, 0.75, 0.033, 0.95, 0.026, 1, 0.016}
                            : Profile{0, 0.082, 0.25, 0.078, 0.5, 0.056, 0.75, 0.035, 0.95, 0.028, 1, 0.016};
  // From the foot up, so that v grows towards the body and the scales hang towards the foot.
  std::reverse(joints.begin(), joints.end());
  add(skin_,
      tube(curve_through(joints, 4), ahead, 14,
           [&](double t) { return dvec2(thick(1 - t), thick(1 - t) * 1.05); }),
      75);

  // The foot: a flat palm, and toes that spread and end in claws.
  const int toes = front ? 5 : 4;
  const double reach = front ? 0.082 : 0.105, turned = glm::radians(side * 14.0);
  const dvec3 palm = joints.front();
  const auto direction = [&](double angle) { return std::cos(angle) * ahead + std::sin(angle) * left; };
  const dvec3 toward = direction(turned);
  add(skin_,
      ellipsoid({palm + 0.012 * toward - dvec3(0, 0.006, 0), glm::cross(dvec3(0, 1, 0), toward), {0, 1, 0}},
                {0.042, 0.021, 0.052}, 12, 8),
      180);
  for (int i = 0; i < toes; ++i) {
    const double spread = mix(-1, 1, double(i) / (toes - 1));
    const dvec3 way = direction(turned + spread * glm::radians(front ? 58.0 : 42.0));
    const double toe = reach * (1 - 0.18 * spread * spread);
    const auto along = [&](double t, double y) { return dvec3(palm.x, ground + y, palm.z) + t * toe * way; };
    const std::vector<dvec3> path =
        curve_through({along(1.0, 0.010), along(0.85, 0.014), along(0.6, 0.024), along(0.25, 0.022)}, 2);
    add(skin_, tube(path, {0, 1, 0}, 6, [](double t) { return dvec2(mix(0.010, 0.0155, t)); }), 75);
    add(claws_,
        tube(curve_through({along(0.95, 0.011), along(1.12, 0.013), along(1.28, 0.002)}, 2), {0, 1, 0}, 6,
             [](double t) { return dvec2(0.0085 * (1 - t)); }),
        75);
  }
}

std::string Gator::obj() {
  add_body();
  add_scutes();
  add_head();
  add_teeth();
  add_leg(0.64, 1, true, 0.045);
  add_leg(0.64, -1, true, -0.03);
  add_leg(1.09, 1, false, -0.035);
  add_leg(1.09, -1, false, 0.05);
  return model_text(
      "gator.obj: an alligator with open jaws; the head points to +x.\n"
      "Texture coordinates: u round the body from the middle of the back (seam on the belly), v along it "
      "towards\n"
      "the head, one scale everywhere and never mirrored.\n"
      "Made by make_assets (assets/make/models_gator.cpp). CC0 1.0.",
      "gator.mtl",
      {{"skin", skin_},
       {"mouth", mouth_},
       {"scutes", scutes_},
       {"teeth", teeth_},
       {"claws", claws_},
       {"eyes", eyes_},
       {"dark", dark_}},
      texture_size);
}

}  // namespace

std::string gator_materials() {
  return material_text("The alligator's materials. Colours are sRGB. CC0 1.0.",
                       {{"skin", "1 1 1", "scales.png"},
                        {"mouth", "0.78 0.48 0.42", ""},
                        {"scutes", "0.75 0.8 0.7", "scales.png"},
                        {"teeth", "0.95 0.92 0.80", ""},
                        {"claws", "0.22 0.20 0.16", ""},
                        {"eyes", "0.90 0.72 0.18", ""},
                        {"dark", "0.05 0.05 0.04", ""}});
}

std::string gator() {
  return Gator().obj();
}

}  // namespace texel::assets
