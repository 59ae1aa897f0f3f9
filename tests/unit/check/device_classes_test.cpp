// Devices whose names differ in digits alone, and what they expect of each other.
#include "check/device_classes.hpp"

#include "support/catch.hpp"
#include "support/compile.hpp"

namespace symplant::test {
namespace {

using check::DeviceClasses;
using check::Expected;
using core::Direction;

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

TEST_CASE("Devices of a class differ in digits alone, whatever their case, process and line") {
  CHECK(check::class_name("Clamp12") == "CLAMP#");
  CHECK(check::class_name("S1CLAMP02B") == "S#CLAMP#B");
  const Analysed analysed = four_clamps();
  const DeviceClasses classes(analysed.model());
  REQUIRE(classes.classes().size() == 2);
  CHECK(classes.classes()[0].units == std::vector<std::uint32_t>{0, 1, 2, 3});
  CHECK(classes.class_of(4) == 1);
  CHECK(classes.parts(0).size() == 3);
  CHECK(classes.count(0, Direction::event, "ADV") == 3);
  CHECK(classes.count(0, Direction::event, "held") == 1);
  CHECK(classes.count(0, Direction::operation, "HELD") == 0);
}

TEST_CASE("What three quarters of the others have is expected, and what a quarter has at most is not") {
  const Analysed analysed = four_clamps();
  const DeviceClasses classes(analysed.model());
  CHECK(classes.expects(3, Direction::event, "ADV", false) == Expected::yes);
  CHECK(classes.expects(0, Direction::event, "ADV", true) == Expected::unclear);  // two of three others
  CHECK(classes.expects(3, Direction::event, "HELD", true) == Expected::no);
  CHECK(classes.expects(4, Direction::operation, "ON", true) == Expected::unclear);  // it has no siblings
}

}  // namespace
}  // namespace symplant::test
