// What an observer makes of gaps in a recording.
#include "observe_support.hpp"

namespace symplant::test {
namespace {

TEST_CASE("What began before a gap has no times after it") {
  const Observed plant(kClamp, R"("devices": {"L_P_CL": {"actuation": "bistable"}})");
  recording::Recording recording = recorded(
      trace_text("0 L_P_CL_I_OPEN 1; 100 L_P_CL_O_CLOSED 1; 130 L_P_CL_I_OPEN 0; 900 L_P_CL_I_CLOSED 1; "
                 "1500 L_P_CL_O_CLOSED 0; 1600 L_P_CL_O_OPEN 1; 1700 L_P_CL_I_CLOSED 0; 2500 L_P_CL_I_OPEN 1"));
  recording.gaps.push_back({200 * tables::kMillisecond, 500 * tables::kMillisecond});
  const observe::Matched matched = observe::match(plant.model(), recording);
  std::string text;
  for (const observe::Move& move : observe::moves_of(plant.model(), recording, matched)) {
    text += text_of(plant.model(), move) + "\n";
  }
  CHECK(text ==
        "CL: ?->CLOSED cause - left - arrived 900\n"
        "CL: CLOSED->OPEN #0 cause 1600 left 1700 arrived 2500\n");
}

}  // namespace
}  // namespace symplant::test
