// SPDX-License-Identifier: MIT
// The OpenGL layer on the headless contexts: EGL, and OSMesa where there is one.
#include <dlfcn.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "../support/picture_files.hpp"
#include "../support/said.hpp"
#include "../support/tolerance.hpp"
#include "core/files.hpp"
#include "gl/context.hpp"
#include "gl/mesh_buffers.hpp"
#include "gl/program.hpp"
#include "gl/recorder.hpp"
#include "gl/shader_source.hpp"
#include "gl/target.hpp"
#include "gl/upload.hpp"
#include "mesh/primitives.hpp"

namespace texel::gl {
namespace {

using image::Encoding;
using image::Image8;
using test::error_of;
using test::has;

Image8 filled(int width, int height, std::initializer_list<int> color) {
  Image8 image(width, height, static_cast<int>(color.size()));
  for (std::size_t i = 0; i < image.samples.size(); ++i)
    image.samples[i] =
        static_cast<std::uint8_t>(*(color.begin() + static_cast<std::ptrdiff_t>(i % color.size())));
  return image;
}

/// Everything below is done once with each kind of context.
class OpenGl : public testing::TestWithParam<const char*> {
 protected:
  OpenGl() : context_(create_headless(Shaders::quick_to_compile, GetParam())) {
    write_shader("full.vert",
                 "in vec3 position;\nin vec2 texcoord;\nout vec2 st;\n"
                 "void main() { st = texcoord; gl_Position = vec4(position, 1.0); }\n");
    write_shader("map.frag",
                 "in vec2 st;\nuniform sampler2D map;\nout vec4 c;\nvoid main() { c = texture(map, st); }\n");
    write_shader("plain.vert", "in vec3 position;\nvoid main() { gl_Position = vec4(position, 1.0); }\n");
    write_shader("white.frag", "out vec4 c;\nvoid main() { c = vec4(1.0); }\n");
  }
  ~OpenGl() override {
    for (const std::string& error : context_->take_errors()) ADD_FAILURE() << error;
  }

  [[nodiscard]] std::filesystem::path shaders() const { return folder_ / ""; }

  void write(const std::string& file, const std::string& text) const {
    test::put(folder_.path(), {{file, text}});
  }
  void write_shader(const std::string& file, const std::string& text) const {
    write(file, "#version 330 core\n" + text);
  }

  /// A program of full.vert and a fragment shader of this text.
  std::string compile_error(const std::string& fragment) {
    write("student.frag", fragment);
    ProgramCache cache(shaders());
    return error_of([&] { cache.get("full.vert", "student.frag", {}); });
  }

  /// The program of two of the files, in use.
  Program& use(const std::string& vertex, const std::string& fragment) {
    Program& program = cache_.get(vertex, fragment, {});
    program.use();
    return program;
  }

  std::unique_ptr<Context> context_;
  test::TemporaryFolder folder_;
  ProgramCache cache_{shaders()};
};

/// Fills the whole picture, in linear light.
void fill(const Target& target, const glm::vec4& color) {
  target.bind();
  glEnable(GL_FRAMEBUFFER_SRGB);
  glClearColor(color.r, color.g, color.b, color.a);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  target.resolve();
}

TEST_P(OpenGl, is_a_core_context_of_3_3_or_later_and_reports_errors_once) {
  EXPECT_GE(10 * integer(GL_MAJOR_VERSION) + integer(GL_MINOR_VERSION), 33);
  EXPECT_EQ(integer(GL_CONTEXT_PROFILE_MASK) & GL_CONTEXT_CORE_PROFILE_BIT, GL_CONTEXT_CORE_PROFILE_BIT);
  glBindTexture(0x1234, 0);
  EXPECT_FALSE(context_->take_errors().empty());
  EXPECT_TRUE(context_->take_errors().empty());
}

TEST_P(OpenGl, an_error_names_the_file_and_line_in_which_it_is) {
  write("lib/step.glsl", "// one\nfloat twice(float x) {\n  return undeclared * x;\n}\n");
  write("one.glsl", "float one() { return 1.0; }\n\n\n\n");
  const std::string color = "out vec4 c;\nvoid main() {";
  const std::tuple<std::string, std::string, std::string> rows[] = {
      {color + "\n  c = vec3(1.0);\n}\n", "student.frag:4:", ""},
      {"#include \"lib/step.glsl\"\n" + color + " c = vec4(twice(1.0)); }\n",
       "lib/step.glsl:3:", "undeclared"},
      // Not the line of the warning, nor an empty one at the end.
      {color + "\n  float never;\n  c = vec4(never);\n  oops;\n}\n", "student.frag:6:", ""},
      {"#include \"one.glsl\"\n" + color + " c = vec4(one()); oops; }\n", "student.frag:4:", ""},
      {"#if 0\n#include \"one.glsl\"\n#endif\n" + color + " c = vec3(1.0); }\n", "student.frag:6:", ""},
      {color + "\n  c = vec4(1.0)\n}\n",
       "student.frag:4: error: a ';' is missing at the end of this line: c = vec4(1.0)", ""}};
  for (const auto& [shader, begins, says] : rows) {
    const std::string error = compile_error("#version 330 core\n" + shader);
    EXPECT_TRUE(error.starts_with(begins)) << error;
    EXPECT_TRUE(has(error, says) && !error.ends_with("\n")) << error;
  }
  // From the folder of shaders on.
  write("shaders/a.frag", "void main() {}\n");
  EXPECT_TRUE(
      error_of([&] { ShaderSource(folder_ / "shaders", "a.frag"); }).starts_with("shaders/a.frag:1: "));
}

// Each row's shader compiles, and a mistake behind it is said to be in its own line.
TEST_P(OpenGl, includes_are_read_as_glsl_reads_comments_and_conditions) {
  write("step.glsl", "\xEF\xBB\xBF#define STEP\nfloat one() { return 1.0; }\n");
  write("lib/a.glsl", "#include \"../lib/b.glsl\"\n#include \"../step.glsl\"\n");
  write("lib/b.glsl", "#if VIEW\n#else\n#include \"./../step.glsl\"\n#endif\n");
  const std::string head = "#version 330 core\n", step = "#include \"step.glsl\"\n",
                    nowhere = "#include \"nowhere.glsl\"\n";
  for (const std::string& text : std::vector<std::string>{
           head + "/*\n" + nowhere + "*/\n" + step,
           head + "/* no end of line\n*/ float a;\n" + step,
           head + "#if 0\n" + nowhere + "#include\n#include \"student.frag\"\n#include \"lib\"\n#endif\n" +
               step,
           head + "#if 0\n#elif 0\n" + nowhere + "#else\n" + step + "#endif\n",
           head + "// \"\n// " + nowhere + step,
           head + "// goes on \\\n" + nowhere + step,
           head + "#ifdef A\n" + step + "#else\n" + step + "#endif\n" + step,
           head + "#ifndef A\n" + step + "#else\n" + step + "#endif\n" + step,
           head + "#if 0\n#include \"lib/a.glsl\"\n#endif\n#include \"lib/a.glsl\"\n",
           head + "#include \"lib/a.glsl\"\n#include \"./step.glsl\"\n#include \"lib/../step.glsl\"\n" + step,
           "  # version 330 core // that of the labs\n # include \"step.glsl\"  // for one\n",
           "/* a\n b */ #version 330 /* c */ core\n/* a\n b */ #include /*\n*/ \"step.glsl\" /*\n*/\n",
           head + "#include \\\n  \"step.glsl\"\nfloat a;  // \\\n#else\n",
           head + "#include <step.glsl>\n#include \"lib\\a.glsl\"\n#include \"lib//a.glsl\"\n",
           "\xEF\xBB\xBF#version 330 core\r\n#include \"step.glsl\"\r\n#define TWO \\\r\n  2\r\n",
           head + step + "#line 7\n/*\n#line seven\n*/\n",
           head + "#if 1\n" + step + "#version 450\n#endif\n",
       }) {
    SCOPED_TRACE(text);
    const auto lines = std::count(text.begin(), text.end(), '\n');
    const std::string rest = "out vec4 c;\n#ifdef STEP\nvoid main() { c = vec4(one()); ";
    EXPECT_EQ(compile_error(text + rest + "}\n#endif\n"), "");
    const std::string error = compile_error(text + rest + "oops; }\n#endif\n");
    EXPECT_TRUE(error.starts_with("student.frag:" + std::to_string(lines + 3) + ":")) << error;
    const ShaderSource source(shaders(), "student.frag");
    EXPECT_EQ(source.readable({}, {}).find("INCLUDED"), std::string::npos);
  }
}

TEST_P(OpenGl, an_include_that_cannot_be_followed_is_one_short_message) {
  write("a.glsl", "\n#include \"lib/.././a.glsl\"\n");
  write("b.glsl", "#include \"c.glsl\"\n");
  write("c.glsl", "#include \"b.glsl\"\n");
  write("doubled.glsl", "");
  for (int i = 0; i < 30; ++i) {
    const std::string next = i == 0 ? "doubled.glsl" : fmt::format("doubled{}.glsl", i - 1);
    write(fmt::format("doubled{}.glsl", i),
          fmt::format("#ifdef A\n#include \"{0}\"\n#else\n#include \"{0}\"\n#endif\n", next));
  }
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"#include \"./a.glsl\"", "a.glsl:2: 'lib/.././a.glsl' includes itself"},
      {"#include \"b.glsl\"", "c.glsl:1: 'b.glsl' includes itself"},
      {"#include \"student.frag\"", "student.frag:2: 'student.frag' includes itself"},
      {"#include \"a.glsl", "student.frag:2: this #include names no file; write it like"},
      {"#include a.glsl", "student.frag:2: this #include names no file; write it like"},
      {"#include \"../nowhere.glsl\"", "student.frag:2: there is no file '../nowhere.glsl' to include"},
      {"#include \"doubled29.glsl\"", "more than 1000 files are included"}};
  for (const auto& [line, message] : rows) {
    const std::string error = compile_error("#version 330 core\n" + line + "\nvoid main() {}\n");
    EXPECT_TRUE(has(error, message) && error.size() < 200U) << error;
  }
}

TEST_P(OpenGl, an_unknown_attribute_or_a_misspelt_uniform_is_an_error_and_an_inactive_one_is_not) {
  write_shader("odd.vert", "in vec4 vPosition;\nvoid main() { gl_Position = vPosition; }\n");
  EXPECT_TRUE(has(error_of([&] { use("odd.vert", "white.frag"); }), "'vPosition'"));
  write_shader("unused.frag", "uniform float tilt;\nout vec4 c;\nvoid main() { c = vec4(1.0); }\n");
  Program& program = use("full.vert", "unused.frag");
  EXPECT_EQ(error_of([&] { program.set("tilt", 1.0F); }), "");
  EXPECT_NE(error_of([&] { program.set("tlit", 1.0F); }), "");
}

TEST_P(OpenGl, a_uniform_that_is_read_must_be_set_and_a_sampler_takes_the_number_of_a_unit) {
  Program& program = use("full.vert", "map.frag");
  EXPECT_TRUE(has(error_of([&] { program.check_uniforms(); }), "'map' is read but never set"));
  EXPECT_NE(error_of([&] { program.set("map", 1.0F); }), "");
  for (const std::string& error :
       {error_of([&] { program.set("map", GL_TEXTURE0); }), error_of([&] { program.set("map", GLuint{1}); }),
        error_of([&] { program.set("map", int{GL_TEXTURE0}); }), error_of([&] { program.set("map", -1); })})
    EXPECT_TRUE(has(error, "number of a texture unit")) << error;
  program.set("map", 0);
  EXPECT_EQ(error_of([&] { program.check_uniforms(); }), "");
  write("same.frag", read_file(folder_ / "map.frag"));
  Program& fresh = use("full.vert", "same.frag");
  EXPECT_NE(error_of([&] { fresh.check_uniforms(); }), "");
  glUniform1i(glGetUniformLocation(fresh.id(), "map"), 0);  // as the slides have it
  EXPECT_EQ(error_of([&] { fresh.check_uniforms(); }), "");
  fresh.forget_uniforms();  // as before each picture
  EXPECT_NE(error_of([&] { fresh.check_uniforms(); }), "");
  write_shader("number.frag", "uniform float tilt;\nout vec4 c;\nvoid main() { c = vec4(tilt); }\n");
  Program& number = use("full.vert", "number.frag");
  number.set("tilt", 1.0F);
  EXPECT_EQ(error_of([&] { number.check_uniforms(); }), "");
  number.forget_uniforms();
  EXPECT_NE(error_of([&] { number.check_uniforms(); }), "");
}

TEST_P(OpenGl, sampling_that_an_earlier_picture_set_is_forgotten) {
  const auto state_of = [](const Texture& texture) {
    const ScopedBinding binding(GL_TEXTURE_2D, texture);
    std::vector<GLint> state;
    for (const GLenum name :
         {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER, GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
      glGetTexParameteriv(GL_TEXTURE_2D, name, &state.emplace_back());
    return state;
  };
  const Texture fresh, used;
  {
    const ScopedBinding binding(GL_TEXTURE_2D, used);
    set_sampling(GL_TEXTURE_2D, {GL_NEAREST, GL_NEAREST, GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT, 8});
  }
  EXPECT_NE(state_of(used), state_of(fresh));
  forget_sampling(used);
  EXPECT_EQ(state_of(used), state_of(fresh));
}

TEST_P(OpenGl, a_variant_is_compiled_once_and_only_for_constants_that_its_source_mentions) {
  write_shader(
      "variant.frag",
      "out vec4 c;\nvoid main() {\n#if METHOD == 1\n  c = vec4(1.0);\n#else\n  c = vec4(0.5);\n#endif\n}\n");
  const Program& one = cache_.get("full.vert", "variant.frag", {{"METHOD", "1"}, {"OTHER", "1"}});
  EXPECT_EQ(&one, &cache_.get("full.vert", "variant.frag", {{"METHOD", "1"}, {"OTHER", "2"}}));
  EXPECT_NE(&one, &cache_.get("full.vert", "variant.frag", {{"METHOD", "2"}, {"OTHER", "1"}}));
  EXPECT_EQ(cache_.programs().size(), 2U);
}

/// Draws a texture over a whole target of the same size and reads it back.
Image8 round_trip(Program& program, const Image8& image, Encoding encoding) {
  const Target target(Target::Kind::color, image.width, image.height, 1);
  target.bind();
  (encoding == Encoding::srgb ? glEnable : glDisable)(GL_FRAMEBUFFER_SRGB);
  const Texture texture = make_texture_2d(image, encoding, {.minify = GL_NEAREST, .magnify = GL_NEAREST});
  bind(0, GL_TEXTURE_2D, texture);
  program.set("map", 0);
  MeshBuffers(mesh::quad(1)).draw(program);
  return target.read8();
}

TEST_P(OpenGl, every_channel_count_and_row_length_comes_back_as_it_was) {
  for (int channels = 1; channels <= 4; ++channels)
    for (const int width : {1, 2, 3, 5, 7, 16}) {
      Image8 image(width, 3, channels);
      for (std::size_t i = 0; i < image.samples.size(); ++i)
        image.samples[i] = static_cast<std::uint8_t>(i * 37 + 5);
      const Image8 drawn = round_trip(use("full.vert", "map.frag"), image, Encoding::linear);
      for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < width; ++x)
          for (int c = 0; c < channels; ++c)
            ASSERT_EQ(drawn.at(x, y, c), image.at(x, y, c)) << channels << " channels, width " << width;
    }
}

TEST_P(OpenGl, all_256_values_survive_decoding_from_and_encoding_to_srgb) {
  Image8 image(256, 1, 3);
  for (int x = 0; x < 256; ++x)
    for (int c = 0; c < 3; ++c) image.at(x, 0, c) = static_cast<std::uint8_t>(x);
  const Image8 drawn = round_trip(use("full.vert", "map.frag"), image, Encoding::srgb);
  for (int x = 0; x < 256; ++x) EXPECT_EQ(drawn.at(x, 0, 1), x);
  const Image8 grey = round_trip(use("full.vert", "map.frag"), filled(2, 2, {100}), Encoding::srgb);
  for (const int c : {0, 2}) EXPECT_EQ(grey.at(1, 1, c), 100);
}

TEST_P(OpenGl, four_samples_are_averaged_in_linear_light) {
  if (integer(GL_MAX_SAMPLES) < 4) GTEST_SKIP() << "this driver has one sample a pixel";
  const Target target(Target::Kind::color, 8, 8, 4);
  ASSERT_EQ(target.samples(), 4);
  fill(target, {0, 0, 0, 1});
  target.bind();
  mesh::Mesh half = mesh::quad(1);  // its diagonal edge leaves half of the samples of a pixel there
  half.indices.resize(3);
  MeshBuffers(std::move(half)).draw(use("plain.vert", "white.frag"));
  target.resolve();
  // Two of four samples are white: linear 0.5 is 188 encoded. In encoded space it would be 128.
  EXPECT_WITHIN(target.read8().at(4, 4, 0), 188, 2);
}

TEST_P(OpenGl, a_data_target_keeps_values_and_nan) {
  const Target target(Target::Kind::data, 1, 1, 1);
  target.bind();
  glDisable(GL_DEPTH_TEST);
  write_shader("nan.frag",
               "uniform float zero;\nout vec4 c;\n"
               "void main() { c = vec4(-3.25, 1e6, zero / zero, 1.0); }\n");
  Program& program = use("plain.vert", "nan.frag");
  program.set("zero", 0.0F);
  MeshBuffers(mesh::quad(1)).draw(program);
  const image::ImageF values = target.read_float();
  EXPECT_EQ(values.samples[0], -3.25F);
  EXPECT_EQ(values.samples[1], 1e6F);
  EXPECT_TRUE(std::isnan(values.samples[2]));
}

TEST_P(OpenGl, making_a_texture_leaves_the_units_as_they_were) {
  const Texture first = make_texture_2d(filled(2, 2, {1, 2, 3}), Encoding::linear);
  bind(0, GL_TEXTURE_2D, first);
  const Texture second = make_texture_2d(filled(2, 2, {4, 5, 6}), Encoding::linear);
  EXPECT_EQ(integer(GL_TEXTURE_BINDING_2D), static_cast<GLint>(first.id()));
}

TEST_P(OpenGl, a_mesh_without_an_attribute_that_the_program_reads_is_an_error) {
  mesh::Mesh square = mesh::quad(1);
  square.texcoords.clear();
  MeshBuffers buffers(std::move(square));
  Program& program = use("full.vert", "map.frag");
  EXPECT_TRUE(has(error_of([&] { buffers.draw(program); }), "'texcoord'"));
  // An empty one draws nothing.
  const Target target(Target::Kind::color, 1, 1, 1);
  target.bind();
  buffers = MeshBuffers(mesh::Mesh{});
  write_shader("none.vert", "void main() { gl_Position = vec4(0.0); }\n");
  EXPECT_EQ(error_of([&] { buffers.draw(use("none.vert", "white.frag")); }), "");
}

TEST_P(OpenGl, a_picture_of_one_color_is_told_from_one_with_a_pixel_of_another) {
  const glm::vec4 slate(0.035F, 0.042F, 0.055F, 1);
  for (const Target::Kind kind : {Target::Kind::color, Target::Kind::data}) {
    const Target target(kind, 9, 9, kind == Target::Kind::color ? 4 : 1);
    fill(target, slate);
    EXPECT_TRUE(target.shows_only(slate));
    EXPECT_FALSE(target.shows_only(glm::vec4(0)));
    EXPECT_FALSE(target.shows_only(glm::vec4(glm::vec3(slate), 0)));
    for (const glm::ivec2 pixel : {glm::ivec2(8, 0), glm::ivec2(0, 8), glm::ivec2(4, 4)}) {
      target.bind();
      glEnable(GL_SCISSOR_TEST);
      glScissor(pixel.x, pixel.y, 1, 1);
      fill(target, {0.06F, 0.042F, 0.055F, 1});
      glDisable(GL_SCISSOR_TEST);
      EXPECT_FALSE(target.shows_only(slate)) << pixel.x << ' ' << pixel.y;
      fill(target, slate);
      EXPECT_TRUE(target.shows_only(slate)) << pixel.x << ' ' << pixel.y;
    }
  }
}

TEST_P(OpenGl, a_picture_stays_when_another_is_drawn_with_its_samples_and_depth) {
  for (const int samples : {1, 4}) {
    const Target first(Target::Kind::color, 8, 8, samples);
    const Target second(Target::Kind::color, 8, 8, samples, &first);
    fill(first, {1, 0, 0, 1});
    fill(second, {0, 0, 0, 1});
    EXPECT_TRUE(first.shows_only({1, 0, 0, 1})) << samples;
    EXPECT_TRUE(second.shows_only({0, 0, 0, 1})) << samples;
  }
}

TEST_P(OpenGl, only_a_picture_of_the_same_kind_size_and_samples_shares_them_and_a_whole_one_is_resolved) {
  if (integer(GL_MAX_SAMPLES) < 4) GTEST_SKIP() << "this driver has one sample a pixel";
  const Target first(Target::Kind::color, 8, 8, 4);
  const auto samples_of = [](const Target& target) {
    target.bind();
    return integer(GL_SAMPLES);
  };
  EXPECT_EQ(samples_of(first), 4);
  EXPECT_LE(samples_of(Target(Target::Kind::color, 8, 8, 1, &first)), 1);
  const Target wide(Target::Kind::color, 16, 8, 4, &first);
  fill(wide, {0, 1, 0, 1});
  EXPECT_TRUE(wide.shows_only({0, 1, 0, 1}));
  const Target data(Target::Kind::data, 8, 8, 4, &first);
  fill(data, {2.5F, 0, 0, 1});  // more than a colour's samples hold
  EXPECT_EQ(data.read_float().at(3, 3, 0), 2.5F);
  // A whole picture is resolved, whatever is cut off.
  const Target tall(Target::Kind::color, 8, 16, 4, &first);  // shares no samples: the other is lower
  tall.bind();
  glClearColor(0, 1, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 0, 1, 1);
  tall.resolve();
  glDisable(GL_SCISSOR_TEST);
  EXPECT_TRUE(tall.shows_only({0, 1, 0, 1}));
}

TEST_P(OpenGl, a_texture_has_the_anisotropy_that_is_asked_for) {
  if (GLAD_GL_EXT_texture_filter_anisotropic == 0) GTEST_SKIP() << "this driver has none";
  float most = 1;
  glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &most);
  for (const float asked : {0.5F, 1.0F, 4.0F, 1000.0F}) {
    const Texture texture = make_texture_2d(filled(2, 2, {9}), Encoding::linear, {.anisotropy = asked});
    bind(0, GL_TEXTURE_2D, texture);
    float has = 0;
    glGetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, &has);
    EXPECT_EQ(has, std::clamp(asked, 1.0F, most));
  }
}

/// The recorder, with a square that is drawn into a small target.
class Recording : public OpenGl {
 protected:
  Recording() : target_(Target::Kind::color, 4, 4, 1), square_(mesh::quad(1)) { target_.bind(); }

  Record draw(const Texture& texture) {
    Program& program = use("full.vert", "map.frag");
    bind(0, GL_TEXTURE_2D, texture);
    program.set("map", 0);
    Recorder recorder;
    square_.draw(program);
    return recorder.take();
  }

  static bool warns_of(const Record& record, const std::string& text) {
    return std::ranges::any_of(record.warnings, [&](const std::string& one) { return has(one, text); });
  }

  Target target_;
  MeshBuffers square_;
};

TEST_P(Recording, counts_what_is_drawn) {
  const Texture texture = make_texture_2d(filled(8, 8, {9, 9, 9}), Encoding::linear, {});
  const Record record = draw(texture);
  EXPECT_EQ(record.draw_calls, 1);
  EXPECT_EQ(record.triangles, 2);
  EXPECT_EQ(record.vertices, 4);
  ASSERT_EQ(record.attributes.size(), 2U);
  EXPECT_EQ(record.attributes[0].bytes, 4 * 12);
  ASSERT_EQ(record.textures.size(), 1U);
  EXPECT_EQ(record.textures[0].name, "map");
  EXPECT_EQ(record.textures[0].bytes, (64 + 16 + 4 + 1) * 3);
  EXPECT_TRUE(record.warnings.empty()) << record.warnings.front();
  // And a strip.
  const VertexArray vertices;
  glBindVertexArray(vertices.id());
  Recorder recorder;
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 5);
  glBindVertexArray(0);
  EXPECT_EQ(recorder.take().triangles, 3);
}

TEST_P(Recording, says_that_mipmaps_a_texture_or_all_is_missing) {
  EXPECT_TRUE(warns_of(Recorder().take(), "nothing is drawn"));
  const Texture texture = make_texture_2d(filled(8, 8, {9, 9, 9}), Encoding::linear, {.minify = GL_LINEAR});
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  bind(0, GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  EXPECT_TRUE(warns_of(draw(texture), "1 of 4 levels"));
  Program& program = use("full.vert", "map.frag");
  program.set("map", 5);
  Recorder recorder;
  square_.draw(program);
  EXPECT_TRUE(warns_of(recorder.take(), "reads unit 5, but no texture is bound there"));
}

std::string context_name(const testing::TestParamInfo<const char*>& kind) {
  return kind.param;
}
// Mesa lacks OSMesa since 25.1: then EGL draws all.
const bool has_osmesa = ::dlopen("libOSMesa.so.8", RTLD_LAZY | RTLD_LOCAL) != nullptr;
const auto headless = testing::ValuesIn(has_osmesa ? std::vector{"osmesa", "egl"} : std::vector{"egl"});
INSTANTIATE_TEST_SUITE_P(Contexts, OpenGl, headless, context_name);
INSTANTIATE_TEST_SUITE_P(Contexts, Recording, headless, context_name);

}  // namespace
}  // namespace texel::gl
