// SPDX-License-Identifier: MIT
#pragma once
#include <glad/gl.h>

#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <list>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/answer.hpp"
#include "app/assets.hpp"
#include "app/camera.hpp"
#include "course/case.hpp"
#include "gl/mesh_buffers.hpp"
#include "gl/program.hpp"
#include "gl/texture.hpp"
#include "params/set.hpp"

/// What a lab needs to be a program:
///
///     struct TextureQuad : app::Lab<TextureQuadParameters> {
///       static constexpr app::View kViews[] = {app::View::color, app::View::texcoord};
///       static constexpr app::Info info{1, "texture_quad", "Texture quad", "…one line…", kViews};
///       explicit TextureQuad(const app::Assets& assets);
///       void draw(const Parameters& parameters, app::Frame& frame) override;
///     };
///     int main(int argc, char** argv) { return app::run<TextureQuad>(argc, argv); }
///
/// A misspelt one of these does not compile.
namespace texel::app {

/// A lab's name, title and lesson.
struct Info {
  int number;
  const char* name;             ///< "normal_map", as in the program's name and the shaders' folder
  const char* title;            ///< "Normal map"
  const char* lesson;           ///< one line for --help and the panel
  std::span<const View> views;  ///< without `error`

  [[nodiscard]] std::string folder() const;                               ///< "05_normal_map"
  [[nodiscard]] std::string program() const { return "lab" + folder(); }  ///< "lab05_normal_map"
};

/// The constants in a lab's shaders: of all choices and toggles, and of the view.
std::vector<gl::Define> constants(const params::Set& parameters, View view);

/// A lab draws one picture with this. The target is bound and cleared, the depth test and sRGB encoding are
/// on.
class Frame {
 public:
  Frame(glm::ivec2 size, View view, const params::Set& parameters, const Assets& assets,
        gl::ProgramCache& programs)
      : size_(size), view_(view), parameters_(parameters), assets_(assets), programs_(programs) {}

  [[nodiscard]] float aspect() const { return static_cast<float>(size_.x) / static_cast<float>(size_.y); }
  [[nodiscard]] View view() const { return view_; }
  [[nodiscard]] const Assets& assets() const { return assets_; }

  /// The program of `stem`.vert and `stem`.frag below shaders/, in use. Choices and toggles are constants in
  /// it (METHOD, METHOD_NEAREST, NORMAL_MAPPING, VIEW, VIEW_NORMAL …): what is off costs nothing;
  /// numbers are uniforms of the parameter's name, already set, angles in radians. Throws Error with the
  /// shader's file and line.
  gl::Program& program(const std::string& stem);

  /// What the lab says of what it drew, in the panel and in --stats.
  void note(const Notes& notes) { notes_ = notes; }
  [[nodiscard]] const Notes& notes() const { return notes_; }

  /// Throws Error when a used program reads a uniform that was not set.
  void check() const;

 private:
  glm::ivec2 size_;
  View view_;
  const params::Set& parameters_;
  const Assets& assets_;
  gl::ProgramCache& programs_;
  std::vector<const gl::Program*> used_;
  Notes notes_;
};

/// The base of a lab. Write `override` behind its functions: then the compiler refuses a misspelt one.
/// `AllParameters` has `void declare(params::Set& set)`.
template <class AllParameters>
class Lab {
 public:
  using Parameters = AllParameters;

  Lab& operator=(Lab&&) = delete;
  virtual ~Lab() = default;

  virtual void draw(const Parameters& parameters, Frame& frame) = 0;
  /// The vertex stream as drawn, for --mesh. A lab that takes any OBJ file has one.
  virtual const mesh::Mesh* mesh(const Parameters& /*parameters*/) { return nullptr; }
  /// For a lab whose methods differ before the first frame.
  virtual std::optional<Preparation> preparation(const Parameters& /*parameters*/) { return {}; }
};

/// A lab of any type with its parameters: what the window, the snapshots and the panel work with.
class AnyLab {
 public:
  virtual ~AnyLab() = default;
  [[nodiscard]] const Info& info() const { return info_; }
  /// The pictures that it draws in this tree: with `error` where it has the right answer.
  [[nodiscard]] std::span<const View> views() const { return views_; }
  [[nodiscard]] params::Set& parameters() { return set_; }
  /// Null where the tree does not have its right answer.
  [[nodiscard]] Answer* answer() const { return answer_.get(); }
  /// Makes the lab again at the next draw, which reads its files again.
  virtual void forget() = 0;
  virtual void draw(Frame& frame) = 0;
  /// The vertex stream as drawn, for --mesh; null when the lab has none.
  virtual const mesh::Mesh* mesh(const Assets& assets) = 0;
  virtual std::optional<Preparation> preparation(const Assets& assets) = 0;

 protected:
  explicit AnyLab(const Info& info) : info_(info), views_(info.views.begin(), info.views.end()) {}
  const Info& info_;
  std::vector<View> views_;
  params::Set set_;
  std::unique_ptr<Answer> answer_;
};

template <class TheLab>
class LabOf final : public AnyLab {
  using Parameters = typename TheLab::Parameters;
  static_assert(std::count(TheLab::info.views.begin(), TheLab::info.views.end(), View::error) == 0,
                "a lab has the view error by its answer (app/answer.hpp)");

 public:
  LabOf() : AnyLab(TheLab::info) {
    parameters_.declare(set_);
    if (make_answer<Parameters> == nullptr) return;
    answer_ = make_answer<Parameters>(parameters_, set_);
    views_.push_back(View::error);
  }
  void forget() override { lab_.reset(); }
  void draw(Frame& frame) override { lab(frame.assets()).draw(parameters_, frame); }
  const mesh::Mesh* mesh(const Assets& assets) override { return lab(assets).mesh(parameters_); }
  std::optional<Preparation> preparation(const Assets& assets) override {
    return lab(assets).preparation(parameters_);
  }

 private:
  TheLab& lab(const Assets& assets) {
    if (!lab_) lab_.emplace(assets);
    return *lab_;
  }
  Parameters parameters_;
  std::optional<TheLab> lab_;
};

/// The whole program: window or snapshot, as the arguments say. Returns its exit code. What starts the labs
/// defines it: common/start on a desktop, teach/web/engine/source/engine.cpp on a page.
int run(AnyLab& lab, int argc, char** argv);

template <class TheLab>
int run(int argc, char** argv) {
  static LabOf<TheLab> lab;  // in the browser it outlives this call
  return run(lab, argc, argv);
}

/// The number of the frame that is drawn: a canvas counts them, for the caches.
inline std::uint64_t present_frame = 0;

/// Keeps what was made for a key. A picture or mesh is loaded when a parameter first selects it, and not in
/// every frame. What this frame and the last one needed always stays; of the rest goes what was used longest
/// ago, as soon as there are more than kMost.
template <class Key, class Value>
class Cache {
 public:
  /// Each of nine methods can have a mesh of its own, and each texture of 1024x1024 texels 5 MB.
  static constexpr std::size_t kMost = 16;

  /// The value of `key`, which `make` makes if it is not there. Valid until the end of the frame.
  template <class Make>
  Value& get(const Key& key, Make&& make) {
    auto found = entries_.begin();  // by hand: it is compiled in half the time of std::ranges::find
    while (found != entries_.end() && found->key != key) ++found;
    if (found != entries_.end())
      entries_.splice(entries_.begin(), entries_, found);
    else
      entries_.push_front({key, make()});
    entries_.front().frame = present_frame;
    while (entries_.size() > kMost && entries_.back().frame + 1 < present_frame) entries_.pop_back();
    return entries_.front().value;
  }

 private:
  struct Entry {
    Key key;
    Value value;
    std::uint64_t frame = 0;  // that used it last
  };
  std::list<Entry> entries_;  // the last one used first
};

}  // namespace texel::app
