// SPDX-License-Identifier: MIT
// What must not compile. The file compiles as it is, so that nothing else is what fails. Each line of this
// table is a test: its name, what it defines, and the reason that the compiler must give.
// clang-format off
// choice_default_is_no_item | METHOD=~,static_cast<Method>(2) | the default is not one of the items
// choice_item_without_help | HELP=~, | an item needs a name and a line of help
// choice_with_duplicate_items | ITEM=~,nearest | two items have the same name
// file_default_is_no_item | FILE_NAME=~,brick | the default is not one of the items
// number_default_out_of_range | TILT=~,90 | the default is outside the range
// number_logarithmic_from_zero | NEAREST=~,0 | a logarithmic range must be positive
// number_with_bad_name | NUMBER=~,BumpStrength | a parameter's name is snake_case
// number_with_empty_range | LEAST=~,89 | a range goes from a smaller to a larger value
// toggle_with_trailing_underscore | TOGGLE=~,flip_ | a parameter's name is snake_case
// toggle_without_help | TOGGLE_HELP=~, | a parameter needs a line of help
// lab_with_misspelt_draw | DRAW=~,drawn | override
// lab_with_misspelt_mesh | MESH=~,meshes | override
// lab_with_misspelt_preparation | PREPARATION=~,preparations | override
// lab_with_the_view_error | VIEW=~,error | a lab has the view error by its answer
// answer_with_misspelt_declare | DECLARE=~,declares | override
// answer_with_misspelt_measure | MEASURE=~,measures | override
// answer_with_misspelt_truth | TRUTH=~,truths | override
// clang-format on
#include "params/set.hpp"

#define QUOTED(words) #words
#define TEXT(words) QUOTED(words)
// USUALLY(ITEM, linear) is linear, unless ITEM is defined: as "~, nearest" it is nearest.
#define SECOND(first, second, ...) second
#define USUALLY(...) SECOND(__VA_ARGS__, ~)

namespace texel::params {

enum class Method { nearest, linear };
constexpr Item methods[] = {{"nearest", "The nearest texel"},
                            {TEXT(USUALLY(ITEM, linear)), TEXT(USUALLY(HELP, Four texels))}};
constexpr Choice<Method> choice("method", USUALLY(METHOD, Method::linear), methods,
                                "How the texture is filtered");
constexpr Item files[] = {{"nearest", "The nearest texel"}, {"linear", "Four texels"}};
constexpr File file("texture", TEXT(USUALLY(FILE_NAME, linear)), files, "The picture on the square");
constexpr Number tilt("tilt", USUALLY(TILT, 60), USUALLY(LEAST, -89), 89, "degrees", "Leans the quad back");
constexpr Number near("near", 1, USUALLY(NEAREST, 0.1), 10, "", "The near plane", Scale::logarithmic);
constexpr Number number(TEXT(USUALLY(NUMBER, bump_strength)), 1, 0, 4, "", "How deep the bumps are");
constexpr Toggle toggle(TEXT(USUALLY(TOGGLE, flip_v)), true,
                        TEXT(USUALLY(TOGGLE_HELP, Turns the picture over)));

}  // namespace texel::params

#ifndef PARAMETERS_ALONE  // which compile five times as fast
#include "answers/answer.hpp"
#include "app/lab.hpp"

namespace texel {

struct SmallParameters {
  void declare(params::Set&) {}
};

struct SmallLab : app::Lab<SmallParameters> {
  static constexpr app::View kViews[] = {app::View::USUALLY(VIEW, color)};
  static constexpr app::Info info{10, "small", "Small", "As small as a lab can be.", kViews};
  explicit SmallLab(const app::Assets&) {}
  void USUALLY(DRAW, draw)(const Parameters&, app::Frame&) override {}
  const mesh::Mesh* USUALLY(MESH, mesh)(const Parameters&) override { return nullptr; }
  std::optional<app::Preparation> USUALLY(PREPARATION, preparation)(const Parameters&) override { return {}; }
};
template class app::LabOf<SmallLab>;

struct SmallAnswer final : answers::Answer<SmallParameters> {
  void USUALLY(DECLARE, declare)(params::Set&) override {}
  app::Measure USUALLY(MEASURE, measure)(const SmallParameters&) const override {
    return {app::View::color, app::Unit::steps, "a truth"};
  }
  answers::Truth USUALLY(TRUTH, truth)(const SmallParameters&, glm::ivec2) const override { return {}; }
};
const bool known = answers::know<SmallParameters, SmallAnswer>();

}  // namespace texel
#endif
