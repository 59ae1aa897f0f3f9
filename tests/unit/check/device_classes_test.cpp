// Devices whose names differ only in digits, and the symbols expected from their siblings.
#include "check/spelling/device_classes.hpp"

#include "support/catch.hpp"
#include "support/compile.hpp"

namespace symplant::test {
namespace {

using check::DeviceClasses;
using check::Expected;
using tables::Direction;

Analysed four_clamps() {
  return analyse_text(list_text(bits({
      "L_A_CLAMP1_O_ADV",
      "L_A_CLAMP1_I_ADV",
      "L_A_CLAMP2_O_ADV",
      "L_A_CLAMP2_I_adv",
      "L_B_Clamp10_O_ADV",
      "L_B_Clamp10_I_ADV",
      "L_B_CLAMP11_O_ADV",
      "L_B_CLAMP11_I_HELD",
      "L_B_LAMP_O_ON",
  })));
}

TEST_CASE("Devices of a class differ only in digits, in any case, process and line") {
  CHECK(check::class_name("Clamp12") == "CLAMP#");
  CHECK(check::class_name("S1CLAMP02B") == "S#CLAMP#B");
  const Analysed analysed = four_clamps();
  const DeviceClasses classes(analysed.model());
  REQUIRE(classes.classes().size() == 2);
  CHECK(classes.classes()[0].devices == std::vector<std::uint32_t>{0, 1, 2, 3});
  CHECK(classes.class_of(4) == 1);
  CHECK(classes.classes()[0].parts.size() == 3);
  CHECK(classes.count(classes.find(0, Direction::event, "ADV")) == 3);
  CHECK(classes.count(classes.find(0, Direction::event, "held")) == 1);
  CHECK(classes.find(0, Direction::operation, "HELD") == model::kNone);
}

TEST_CASE("Numeric symbols count, and so do devices that have only those") {
  std::vector<Row> rows = bits({"L_A_ROBOT1_O_JOB", "L_A_ROBOT1_I_JOB", "L_A_ROBOT2_O_JOB"});
  rows.push_back({"L_A_robot1_O_PROG", "", "WORD", "", "%QW1"});
  rows.push_back({"L_A_GAUGE_I_GAP", "", "INT", "", "%IW1"});
  rows.push_back({"L_A_GAUGE_I_AGE", "", "INT", "", "%IW2"});
  const Analysed analysed = analyse_text(list_text(rows));
  const DeviceClasses classes(analysed.model());
  CHECK(classes.devices() == 3);
  CHECK(classes.device_of(3) == 0);
  CHECK(classes.device_of(4) == 2);
  CHECK(classes.device_of(5) == 2);
  CHECK(classes.first_symbol(2) == 4);
  CHECK(classes.count(classes.find(0, Direction::operation, "PROG")) == 1);
}

TEST_CASE("A symbol of three quarters of the others is expected, a symbol of at most a quarter is not") {
  const Analysed analysed = four_clamps();
  const DeviceClasses classes(analysed.model());
  CHECK(classes.expects(3, Direction::event, "ADV", false) == Expected::yes);
  CHECK(classes.expects(0, Direction::event, "ADV", true) == Expected::unclear);  // two of three others
  CHECK(classes.expects(3, Direction::event, "HELD", true) == Expected::no);
  CHECK(classes.expects(4, Direction::operation, "ON", true) == Expected::unclear);  // it has no siblings
}

}  // namespace
}  // namespace symplant::test
