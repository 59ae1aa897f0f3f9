// Tests of the levels and of the shapes.
#include "score/levels.hpp"

#include <fmt/format.h>

#include <string>

#include "score/shapes.hpp"
#include "support/catch.hpp"
#include "support/compile.hpp"

namespace symplant::test {
namespace {

using score::Level;

Analysed two_stations() {
  return analyse_rows(bits({"L_P1_D_O_RUN", "L_P1_D_I_RUN", "L_P1_E_I_BUTTON1", "L_P2_D_I_BUTTON2", "l_p1_e_I_BUTTON7",
                            "START1", "START22"}));
}

std::string parts(const Analysed& analysed, Level level) {
  const score::PlantScore score = score::score_of(analysed.model());
  std::string text;
  for (const score::Part& part : score::parts_of(analysed.model(), score, level)) {
    const std::string name = part.path();
    text += fmt::format("{}{} {}/{}", text.empty() ? "" : ", ", name, part.counts.paired(), part.counts.counted());
  }
  return text;
}

TEST_CASE("Lines, stations and devices have their own counts, without regard to case") {
  const Analysed list = two_stations();
  CHECK(parts(list, Level::list) == " 2/7");
  CHECK(parts(list, Level::line) == "L 2/5,  0/2");
  CHECK(parts(list, Level::station) == "L_P1 2/4, L_P2 0/1,  0/2");
  CHECK(parts(list, Level::device) == "L_P1_D 2/2, L_P1_E 0/2, L_P2_D 0/1,  0/2");
}

TEST_CASE("Symbols that a custom rule reads count for their station, even if nothing pairs them") {
  name::Naming naming;
  naming.rules.emplace_back().patterns.push_back({name::Source::name, "{process}_{device}_{task}"});
  const Analysed list = analyse_by_rule(
      naming,
      {{"list.csv", list_text({{"S1_A_ADV", "", "BOOL", "FALSE", "%QX0"}, {"X", "", "BOOL", "FALSE", "%QX1"}})}});
  CHECK(parts(list, Level::station) == "S1 0/1,  0/1");
}

TEST_CASE("Symbols that are not accounted for are grouped by shape and reason, the most frequent first") {
  const Analysed list = two_stations();
  const auto shapes = score::left_over_shapes(list.model(), score::score_of(list.model()));
  std::string text;
  for (const score::Shape& shape : shapes) {
    text += fmt::format("{} {} {} {}\n", shape.count, shape.text, name::account_key(shape.account),
                        list.model().symbols[shape.first].name());
  }
  CHECK(text ==
        "2 L_P#_E_I_BUTTON# no_operation L_P1_E_I_BUTTON1\n"
        "2 START# no_rule START1\n"
        "1 L_P#_D_I_BUTTON# no_operation L_P2_D_I_BUTTON2\n");
}

TEST_CASE("A symbol that is named by its address has the shape of its comment, with one blank for several") {
  name::Naming naming;
  naming.rules.emplace_back().patterns.push_back({name::Source::comment, "{device} {task:known}"});
  const Analysed list = analyse_by_rule(
      naming, {{"list.csv",
                "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial,Comment\n"
                "VAR_GLOBAL,IN1,X10,,BOOL,FALSE,S12   RIGHT  3\nVAR_GLOBAL,IN2,X11,,BOOL,FALSE,S4 RIGHT 40\n"}});
  const auto shapes = score::left_over_shapes(list.model(), score::score_of(list.model()));
  REQUIRE(shapes.size() == 1);
  CHECK(shapes[0].text == "S# RIGHT #");
  CHECK(shapes[0].count == 2);
}

}  // namespace
}  // namespace symplant::test
