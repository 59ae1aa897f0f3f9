// What explains two groups of durations.
#include <string>

#include "learn_support.hpp"

namespace symplant::test {
namespace {

/// A clamp whose closing takes 800 ms, or 1400 ms while the gate is UP, in every `every`th cycle. `wrong` of the slow
/// moves are with the gate DOWN.
std::string gate_trace(int cycles, int every, int wrong = 0, const std::string& parts = "") {
  std::string text = "{\"symplant-trace\":1}\n";
  const auto add = [&](int time, const std::string& symbol, bool on) {
    text += "{\"t\":" + std::to_string(time * kMilli) + ",\"symbol\":\"L_P_" + symbol +
            "\",\"value\":" + (on ? "true" : "false") + "}\n";
  };
  add(0, "CL_I_OPEN", true);
  add(0, "GATE_I_DOWN", true);
  int now = 0;
  bool is_up = false;
  for (int i = 0; i < cycles; ++i) {
    now += 5000;
    const bool slow = i % every == 0;
    const bool up = slow && wrong-- <= 0;
    if (up != is_up) {
      add(now - 3000, up ? "GATE_O_DOWN" : "GATE_O_UP", false);
      add(now - 3000, up ? "GATE_O_UP" : "GATE_O_DOWN", true);
      add(now - 3000, up ? "GATE_I_DOWN" : "GATE_I_UP", false);
      add(now - 2000, up ? "GATE_I_UP" : "GATE_I_DOWN", true);
      is_up = up;
    }
    if (!parts.empty()) {
      text += "{\"t\":" + std::to_string((now - 1000) * kMilli) + ",\"part\":" + std::to_string(i + 1) +
              ",\"kind\":\"" + (slow ? "heavy" : "light") + "\",\"to\":\"" + parts + "\"}\n";
    }
    add(now, "CL_O_OPEN", false);
    add(now, "CL_O_CLOSED", true);
    add(now, "CL_I_OPEN", false);
    add(now + (slow ? 1400 : 800), "CL_I_CLOSED", true);
    now += 2000;
    add(now, "CL_O_CLOSED", false);
    add(now, "CL_O_OPEN", true);
    add(now, "CL_I_CLOSED", false);
    add(now + 500, "CL_I_OPEN", true);
  }
  return text;
}

std::string closing_groups(const std::string& trace) {
  std::vector<std::string> names = kClamp;
  names.insert(names.end(), {"L_P_GATE_I_DOWN", "L_P_GATE_I_UP", "L_P_GATE_O_DOWN", "L_P_GATE_O_UP"});
  const LearnedFrom from(names, R"("devices": {"L_*": {"actuation": "bistable"}})", {trace});
  std::string text;
  for (const learn::TimeRow& row : learn::time_rows(from.learned)) {
    if (row.of == "OPEN->CLOSED") text += learn::groups_text(from.learned, *row.time);
  }
  return text;
}

TEST_CASE("The state of another device explains two groups") {
  CHECK(closing_groups(gate_trace(40, 4)) ==
        "0.8 s: 30 moves; 1.4 s: 10 moves; it goes with L_P_GATE, shorter: DOWN; longer: UP (40 of 40 moves)");
}

TEST_CASE("An explanation may be wrong in a tenth of the moves of each group") {
  CHECK(contains(closing_groups(gate_trace(40, 4, 1)), "(39 of 40 moves)"));
  CHECK(closing_groups(gate_trace(40, 4, 2)) == "0.8 s: 30 moves; 1.4 s: 10 moves");
}

TEST_CASE("Few moves explain nothing") { CHECK(closing_groups(gate_trace(8, 4)) == "0.8 s: 6 moves; 1.4 s: 2 moves"); }

TEST_CASE("The kind of the last part explains two groups") {
  CHECK(closing_groups(gate_trace(40, 4, 99, "BELT")) ==
        "0.8 s: 30 moves; 1.4 s: 10 moves; it goes with the last part at BELT, shorter: light; longer: heavy (40 of 40 "
        "moves)");
  CHECK(contains(closing_groups(gate_trace(40, 4, 0, "BELT")),
                 "L_P_GATE, shorter: DOWN; longer: UP (40 of 40 moves; 1 other fit as well)"));
}

}  // namespace
}  // namespace symplant::test
