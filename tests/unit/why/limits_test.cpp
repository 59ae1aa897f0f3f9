// Circles, and the depth and width of an explanation.
#include "why_support.hpp"

namespace symplant::test {
namespace {

/// Devices D0, D1, ...; each waits for P2 of the next one.
DescribedPlant chain(int count, bool closed) {
  std::vector<std::string> names;
  std::string devices;
  for (int d = 0; d < count; ++d) {
    const std::string name = "D" + std::to_string(d);
    for (const char* task : {"_I_P1", "_I_P2", "_O_P2"}) names.push_back(name + task);
    if (d + 1 == count && !closed) continue;
    devices += fmt::format(R"({}"L_P_{}": {{"transitions": [{{"from": "P1", "to": "P2", "when": "L_P_D{}.P2"}}]}})",
                           devices.empty() ? "" : ", ", name, (d + 1) % count);
  }
  return {with_prefix(names), "\"devices\": {" + devices + "}"};
}

TEST_CASE("Devices that wait for each other are a circle") {
  const DescribedPlant plant = chain(3, true);
  Asked asked(plant);
  for (const char* name : {"D0_O_P2", "D1_O_P2", "D2_O_P2"}) asked.set(name);
  asked.to(1000);
  CHECK(asked.why("D0") ==
        "L_P_D0 has been in P1 since the start: %QX2 (operation P2, symbols.csv:4) has been on since 1 s, but `when` "
        "needs L_P_D1.P2\n"
        "    L_P_D1 has been in P1 since the start: %QX5 (operation P2, symbols.csv:7) has been on since 1 s, but "
        "`when` needs L_P_D2.P2\n"
        "        L_P_D2 has been in P1 since the start: %QX8 (operation P2, symbols.csv:10) has been on since 1 s, but "
        "`when` needs L_P_D0.P2\n"
        "            L_P_D0 has been in P1 since the start; a circle: L_P_D0 waits for L_P_D1, which waits for L_P_D2, "
        "which waits for L_P_D0\n");
}

TEST_CASE("An explanation is at most six levels deep") {
  const DescribedPlant plant = chain(9, false);
  const std::string text = Asked(plant).why("D0");
  CHECK(std::count(text.begin(), text.end(), '\n') == 6);
  CHECK(contains(text, "\n                    L_P_D5 has been in P1"));
}

TEST_CASE("A level has at most twelve causes, and says how many more there are") {
  std::vector<std::string> names{"ROB_I_HOME1"};
  for (int job = 2; job < 20; ++job) names.push_back("ROB_O_JOB" + std::to_string(job));
  const DescribedPlant plant(with_prefix(names), "\"name\": \"x\"");
  const std::string text = Asked(plant).why("ROB");
  CHECK(std::count(text.begin(), text.end(), '\n') == 14);
  CHECK(contains(text, "JOB13, symbols.csv:14) has never been on\n    and 6 more\n"));
}

}  // namespace
}  // namespace symplant::test
