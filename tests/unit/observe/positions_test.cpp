// What an observer makes of events that show no state, or several.
#include "observe_support.hpp"

namespace symplant::test {
namespace {

TEST_CASE("Two ends at once are a contradiction until one is off") {
  const Observed plant(kClamp, kBistable);
  CHECK(plant.steps("0 L_P_CL_I_OPEN 1; 500 L_P_CL_I_CLOSED 1; 800 L_P_CL_I_CLOSED 0") ==
        "500 contradiction CL: OPEN->? cause - left - arrived -\n"
        "800 settled CL: OPEN->OPEN cause - left - arrived -\n");
}

TEST_CASE("An end that shows too long does not hide the move") {
  const Observed plant(kClamp, kBistable);
  CHECK(plant.moves("0 L_P_CL_I_OPEN 1; 100 L_P_CL_O_CLOSED 1; 500 L_P_CL_I_CLOSED 1; 600 L_P_CL_I_OPEN 0") ==
        "CL: OPEN->CLOSED #1 cause 100 left - arrived 500\n");
}

TEST_CASE("A device of which no end is on at the beginning is in no known state") {
  const Observed plant(kClamp, kBistable);
  CHECK(plant.moves("0 L_P_CL_O_OPEN 0; 500 L_P_CL_I_CLOSED 1") == "CL: ?->CLOSED cause - left - arrived 500\n");
}

TEST_CASE("Inverted symbols are read by their meaning") {
  const Observed plant(
      kClamp, R"("inverted": ["L_P_CL_I_OPEN", "L_P_CL_O_CLOSED"], "devices": {"L_P_CL": {"actuation": "bistable"}})");
  CHECK(plant.moves("0 L_P_CL_I_OPEN 0; 0 L_P_CL_O_CLOSED 1; 100 L_P_CL_O_CLOSED 0; 130 L_P_CL_I_OPEN 1; "
                    "900 L_P_CL_I_CLOSED 1") == "CL: OPEN->CLOSED #1 cause 100 left 130 arrived 900\n");
}

TEST_CASE("What is not recorded shows nothing") {
  const Observed plant(kClamp, kBistable);
  CHECK(plant.moves("0 L_P_CL_I_CLOSED 0; 0 L_P_CL_O_CLOSED 0; 100 L_P_CL_O_CLOSED 1; 900 L_P_CL_I_CLOSED 1",
                    ",\"recorded\":true") == "CL: OPEN->CLOSED #1 cause 100 left - arrived 900\n");
}

TEST_CASE("Names that are no symbol are listed with the nearest one that the recording lacks") {
  const Observed plant(kClamp, kBistable);
  const recording::Recording recording =
      recorded(trace_text("0 L_P_CL_I_OPEM 1; 0 L_P_CL_I_CLOSED 1; 0 Q 1", ",\"recorded\":true"));
  const observe::Matched matched = observe::match(plant.model(), recording);
  REQUIRE(matched.unknown.size() == 2);
  CHECK(matched.unknown[0].name == "L_P_CL_I_OPEM");
  CHECK(matched.unknown[0].nearest == "L_P_CL_I_OPEN");
  CHECK(matched.unknown[1].nearest.empty());
}

}  // namespace
}  // namespace symplant::test
