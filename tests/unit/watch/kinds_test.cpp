// Anomalies of devices of each kind, and good recordings of them.
#include <algorithm>
#include <utility>

#include "watch_support.hpp"

namespace symplant::test {
namespace {

const std::vector<std::string> kValve = {"L_P_V_I_ADV", "L_P_V_I_RET", "L_P_V_O_ADV"};
const std::vector<std::string> kMotor = {"L_P_M_I_RUN", "L_P_M_O_RUN"};

TEST_CASE("A spring's return is judged from the end of its command") {
  const Watched plant(kValve, R"("name": "x")");  // takes 1 s to both sides
  const std::string forth =
      "0 L_P_V_I_RET 1; 1000 L_P_V_O_ADV 1; 1010 L_P_V_I_RET 0; 2010 L_P_V_I_ADV 1; 5000 L_P_V_O_ADV 0; ";
  CHECK(plant.found(forth + "5010 L_P_V_I_ADV 0; 6010 L_P_V_I_RET 1; 20000") == "");
  CHECK(plant.found(forth + "5010 L_P_V_I_ADV 0; 6400 L_P_V_I_RET 1; 20000") == "late L_P_V ADV->RET at 6400");
  CHECK(plant.found(forth + "5010 L_P_V_I_ADV 0; 20000") == "missing L_P_V ADV->RET at 8000");
  CHECK(plant.found(forth + "20000") == "missing L_P_V ADV->RET leaving at 8000");
}

TEST_CASE("A spring that is commanded again while it returns is no anomaly") {
  const Watched plant(kValve, R"("name": "x")");
  CHECK(plant.found("0 L_P_V_I_RET 1; 1000 L_P_V_O_ADV 1; 1010 L_P_V_I_RET 0; 1500 L_P_V_O_ADV 0; 2010 L_P_V_I_RET 1; "
                    "20000") == "");
  CHECK(plant.found("0 L_P_V_I_RET 1; 1000 L_P_V_O_ADV 1; 1010 L_P_V_I_RET 0; 1500 L_P_V_O_ADV 0; 1700 L_P_V_O_ADV 1; "
                    "2400 L_P_V_I_ADV 1; 20000") == "");
  // It turned round and is stuck.
  CHECK(plant.found("0 L_P_V_I_RET 1; 1000 L_P_V_O_ADV 1; 1010 L_P_V_I_RET 0; 1500 L_P_V_O_ADV 0; 20000") ==
        "missing L_P_V RET->ADV at 4500");
}

TEST_CASE("A motor with one feedback is judged by coming on, and by going off") {
  const Watched plant(kMotor, R"("defaults": {"travel": "500ms"})");
  const std::string on = "0 L_P_M_O_RUN 0; 1000 L_P_M_O_RUN 1; ";
  CHECK(plant.found(on + "1500 L_P_M_I_RUN 1; 5000 L_P_M_O_RUN 0; 5050 L_P_M_I_RUN 0; 20000") == "");
  CHECK(plant.found(on + "1700 L_P_M_I_RUN 1; 20000") == "late L_P_M NOT_RUN->RUN at 1700");
  CHECK(plant.found(on + "20000") == "missing L_P_M NOT_RUN->RUN at 2500");
  CHECK(plant.found(on + "1500 L_P_M_I_RUN 1; 5000 L_P_M_I_RUN 0; 20000") ==
        "unexpected L_P_M RUN->NOT_RUN at 5000\nmissing L_P_M NOT_RUN->RUN at 6500");
  CHECK(plant.found(on + "1500 L_P_M_I_RUN 1; 5000 L_P_M_O_RUN 0; 20000") ==
        "missing L_P_M RUN->NOT_RUN leaving at 6500");
  CHECK(plant.found(on + "1500 L_P_M_I_RUN 1; 5000 L_P_M_O_RUN 0; 5200 L_P_M_I_RUN 0; 20000") ==
        "late L_P_M RUN->NOT_RUN leaving at 5200");
}

TEST_CASE("A held device without a command stops, and its time with it") {
  const Watched plant(kClamp, R"("devices": {"L_P_CL": {"actuation": "held"}})");
  const std::string begin = "0 L_P_CL_I_OPEN 1; 1000 L_P_CL_O_CLOSED 1; 1010 L_P_CL_I_OPEN 0; ";
  CHECK(plant.found(begin + "1500 L_P_CL_O_CLOSED 0; 60000") == "");
  CHECK(plant.found(begin + "1500 L_P_CL_O_CLOSED 0; 30000 L_P_CL_O_CLOSED 1; 30500 L_P_CL_I_CLOSED 1; 60000") == "");
  CHECK(plant.found(begin + "1500 L_P_CL_O_CLOSED 0; 30000 L_P_CL_O_CLOSED 1; 60000") ==
        "missing L_P_CL OPEN->CLOSED at 32500");
  CHECK(plant.found(begin + "1500 L_P_CL_O_CLOSED 0; 1500 L_P_CL_O_OPEN 1; 2000 L_P_CL_I_OPEN 1; 60000") == "");
}

const std::string kHeld = R"("devices": {"L_P_CL": {"actuation": "held"}})";

/// `cycle` n times, each with its times moved by `ms` more.
std::string times(int n, int ms, const std::vector<std::pair<int, std::string>>& cycle) {
  std::string changes;
  for (int i = 0; i < n; ++i) {
    for (const auto& [at, what] : cycle) changes += std::to_string(1000 + i * ms + at) + " " + what + "; ";
  }
  return changes + std::to_string(1000 + n * ms);
}

std::size_t lines(const std::string& text) {
  return text.empty() ? 0 : 1 + static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST_CASE("A held device that never moves is missing when its command ends after it should have arrived") {
  const Watched plant(kClamp, kHeld);
  const auto stuck = [&](int n, int on) {
    return plant.found("0 L_P_CL_I_OPEN 1; " + times(n, 9000, {{0, "L_P_CL_O_CLOSED 1"}, {on, "L_P_CL_O_CLOSED 0"}}));
  };
  CHECK(lines(stuck(10, 2950)) == 10);
  CHECK(lines(stuck(10, 3100)) == 10);
  CHECK(stuck(1, 1300) == "missing L_P_CL OPEN->CLOSED leaving at 2320");
  CHECK(stuck(2, 1100) == "");
  CHECK(stuck(3, 1100) == "missing L_P_CL OPEN->CLOSED leaving at 20120");
  CHECK(stuck(10, 900) == "");
}

TEST_CASE("A held device that moves and does not arrive while it is commanded is missing") {
  const Watched plant(kClamp, kHeld);
  const std::string begin = "0 L_P_CL_I_OPEN 1; 1000 L_P_CL_O_CLOSED 1; 1010 L_P_CL_I_OPEN 0; ";
  CHECK(plant.found(begin + "2300 L_P_CL_O_CLOSED 0; 60000") == "missing L_P_CL OPEN->CLOSED at 2320");
  CHECK(plant.found(begin + "2100 L_P_CL_O_CLOSED 0; 60000") == "");
  CHECK(plant.found(begin + "2300 L_P_CL_O_CLOSED 0; 2310 L_P_CL_I_CLOSED 1; 60000") ==
        "late L_P_CL OPEN->CLOSED at 2310");
}

TEST_CASE("A held device whose event comes long after its command ended is late") {
  const Watched plant(kClamp, kHeld);
  const std::string begin = "0 L_P_CL_I_OPEN 1; 1000 L_P_CL_O_CLOSED 1; 1010 L_P_CL_I_OPEN 0; 2000 L_P_CL_O_CLOSED 0; ";
  CHECK(plant.found(begin + "2100 L_P_CL_I_CLOSED 1; 9000") == "");
  CHECK(plant.found(begin + "2500 L_P_CL_I_CLOSED 1; 9000") == "late L_P_CL OPEN->CLOSED at 2500");
}

TEST_CASE("A sensor that never comes on is missing after three moves to it, though each move was short") {
  const Watched held(kClamp, kHeld);
  const std::vector<std::pair<int, std::string>> up_and_down = {{0, "L_P_CL_O_CLOSED 1"},    {10, "L_P_CL_I_OPEN 0"},
                                                                {1010, "L_P_CL_O_CLOSED 0"}, {2000, "L_P_CL_O_OPEN 1"},
                                                                {3000, "L_P_CL_I_OPEN 1"},   {3010, "L_P_CL_O_OPEN 0"}};
  CHECK(held.found("0 L_P_CL_I_OPEN 1; " + times(2, 9000, up_and_down)) == "");
  CHECK(held.found("0 L_P_CL_I_OPEN 1; " + times(4, 9000, up_and_down)) ==
        "missing L_P_CL OPEN->CLOSED at 22000\nmissing L_P_CL OPEN->CLOSED at 31000");
  CHECK(held.sentences("0 L_P_CL_I_OPEN 1; " + times(3, 9000, up_and_down)) ==
        "at 22 s: L_P_CL did not arrive in CLOSED 3 times in a row: 1.01 s after O_CLOSED (symbols.csv:5) it was "
        "commanded elsewhere, or no more; L_P_CL_I_CLOSED (%IX1, symbols.csv:3) is still off");
  const Watched spring(kValve, R"("name": "x")");
  const auto out = [&](int on) {
    return spring.found(
        "0 L_P_V_I_RET 1; " +
        times(5, 9000,
              {{0, "L_P_V_O_ADV 1"}, {10, "L_P_V_I_RET 0"}, {on, "L_P_V_O_ADV 0"}, {on + 1000, "L_P_V_I_RET 1"}}));
  };
  CHECK(lines(out(1100)) == 3);
  CHECK(out(900) == "");  // it is turned before it can arrive
}

TEST_CASE("A position that is passed and never seen is missing after three moves to it") {
  const Watched plant({"L_P_T_I_POS1", "L_P_T_I_POS2", "L_P_T_I_POS3", "L_P_T_O_POS1", "L_P_T_O_POS2", "L_P_T_O_POS3"},
                      R"("devices": {"L_P_T": {"actuation": "held"}})");
  const auto round = [&](int n, bool seen) {
    std::vector<std::pair<int, std::string>> cycle = {{0, "L_P_T_O_POS2 1"}, {10, "L_P_T_I_POS1 0"}};
    if (seen) cycle.insert(cycle.end(), {{1000, "L_P_T_I_POS2 1"}});
    cycle.insert(cycle.end(), {{1010, "L_P_T_O_POS2 0"}, {2000, "L_P_T_O_POS3 1"}});
    if (seen) cycle.insert(cycle.end(), {{2010, "L_P_T_I_POS2 0"}});
    cycle.insert(cycle.end(), {{3000, "L_P_T_I_POS3 1"},
                               {3010, "L_P_T_O_POS3 0"},
                               {4000, "L_P_T_O_POS1 1"},
                               {4010, "L_P_T_I_POS3 0"},
                               {5000, "L_P_T_I_POS1 1"},
                               {5010, "L_P_T_O_POS1 0"}});
    return plant.found("0 L_P_T_I_POS1 1; " + times(n, 9000, cycle));
  };
  CHECK(round(10, true) == "");
  CHECK(round(2, false) == "");
  CHECK(lines(round(10, false)) == 8);
}

TEST_CASE("Without its operations a device is never unexpected") {
  const Watched plant(kMotor, R"("defaults": {"travel": "500ms"})");
  const std::string moves = "0 L_P_M_I_RUN 0; 1000 L_P_M_I_RUN 1; 5000 L_P_M_I_RUN 0; 9000";
  CHECK(plant.found(moves, R"(,"recorded":true,"cycle":10000000)") == "");
  CHECK(plant.found("0 L_P_M_O_RUN 0; " + moves, R"(,"recorded":true,"cycle":10000000)") ==
        "unexpected L_P_M NOT_RUN->RUN at 1000\nmissing L_P_M RUN->NOT_RUN leaving at 2500");
}

TEST_CASE("A first image that is read in two parts, operations first, is no change") {
  const Watched plant(kMotor, R"("name": "x")");
  CHECK(plant.found("0 L_P_M_O_RUN 1; 4 L_P_M_I_RUN 1; 9000", R"(,"recorded":true,"cycle":10000000)") == "");
  CHECK(plant.found("0 L_P_M_O_RUN 0; 4 L_P_M_I_RUN 1; 9000", R"(,"recorded":true,"cycle":10000000)") == "");
}

TEST_CASE("A disabled device has no time") {
  std::vector<std::string> names = kClamp;
  names.insert(names.end(), {"L_P_DOOR_I_SHUT*", "L_P_DOOR_I_OPEN"});
  const Watched plant(names, R"("devices": {"L_P_CL": {"actuation": "bistable"},
      "L_P_DOOR": {"disables": {"OPEN": ["L_P_CL"]}}})");
  const std::string begin = "0 L_P_DOOR_I_SHUT 1; 0 L_P_CL_I_OPEN 1; 1000 L_P_CL_O_CLOSED 1; 1010 L_P_CL_I_OPEN 0; ";
  CHECK(plant.found(begin + "1500 L_P_DOOR_I_SHUT 0; 1600 L_P_DOOR_I_OPEN 1; 60000") == "");
  const std::string enabled =
      begin + "1500 L_P_DOOR_I_SHUT 0; 1600 L_P_DOOR_I_OPEN 1; 30000 L_P_DOOR_I_OPEN 0; 30100 L_P_DOOR_I_SHUT 1; ";
  CHECK(plant.found(enabled + "30400 L_P_CL_I_CLOSED 1; 60000") == "");
  CHECK(plant.found(enabled + "31000 L_P_CL_I_CLOSED 1; 60000") == "late L_P_CL OPEN->CLOSED at 31000");
  CHECK(plant.found(enabled + "60000") == "missing L_P_CL OPEN->CLOSED at 32400");
}

TEST_CASE("Doors, buttons and selectors, which people move, are never unexpected") {
  const Watched plant({"L_P_DOOR_I_SHUT*", "L_P_DOOR_I_OPEN", "L_P_PB_I_ON"}, R"("name": "x")");
  CHECK(plant.found("0 L_P_DOOR_I_SHUT 1; 1000 L_P_DOOR_I_SHUT 0; 9000 L_P_DOOR_I_OPEN 1; 10000 L_P_PB_I_ON 1; "
                    "10100 L_P_PB_I_ON 0; 20000") == "");
}

TEST_CASE("A machine is judged by how long it works") {
  const Watched plant({"L_P_MC_I_IDLE1", "L_P_MC_I_RUN2", "L_P_MC_O_RUN2"},
                      R"("devices": {"L_P_MC": {"transitions": [
        {"from": "IDLE1", "to": "RUN2", "takes": "100ms"},
        {"from": "RUN2", "to": "IDLE1", "automatic": true, "after": {"min": "4s", "max": "6s"}}]}})");
  const std::string begin =
      "0 L_P_MC_I_IDLE1 1; 1000 L_P_MC_O_RUN2 1; 1010 L_P_MC_I_IDLE1 0; 1100 L_P_MC_I_RUN2 1; "
      "1110 L_P_MC_O_RUN2 0; ";
  const auto works = [&](const std::string& ms) {
    return plant.found(begin + ms + " L_P_MC_I_RUN2 0; " + ms + " L_P_MC_I_IDLE1 1; 60000");
  };
  CHECK(works("5100") == "");
  CHECK(works("8300") == "");  // 7.2 s: 6 s and 20 %
  CHECK(works("8310") == "late L_P_MC RUN2->IDLE1 at 8310");
  CHECK(works("3800") == "early L_P_MC RUN2->IDLE1 at 3800");
  CHECK(plant.found(begin + "60000") == "missing L_P_MC RUN2->IDLE1 leaving at 19100");
}

TEST_CASE("A state that is entered and left between two readings is no anomaly") {
  const Watched plant({"L_P_MC_I_IDLE1", "L_P_MC_I_RUN2", "L_P_MC_I_DONE3", "L_P_MC_O_RUN2", "L_P_MC_O_IDLE1"},
                      R"("devices": {"L_P_MC": {"only": true, "transitions": [
        {"from": "RUN2", "to": "DONE3", "automatic": true, "after": "5s"},
        {"from": "DONE3", "to": "IDLE1", "takes": "2s"}]}})");
  const std::string begin =
      "0 L_P_MC_I_RUN2 1; 1 L_P_MC_I_IDLE1 0; 1 L_P_MC_I_DONE3 0; 1 L_P_MC_O_RUN2 0; "
      "1 L_P_MC_O_IDLE1 0; 100 L_P_MC_O_RUN2 0; ";
  CHECK(plant.found(begin + "5000 L_P_MC_I_RUN2 0; 5010 L_P_MC_O_IDLE1 1; 7000 L_P_MC_I_IDLE1 1; 60000") == "");
  CHECK(plant.found(begin + "5000 L_P_MC_I_RUN2 0; 5010 L_P_MC_O_IDLE1 1; 9000 L_P_MC_I_IDLE1 1; 60000") ==
        "unexpected L_P_MC RUN2->IDLE1 at 9000");
}

TEST_CASE("What depends on what is not recorded is not unexpected") {
  const Watched plant({"L_P_MC_I_IDLE1", "L_P_MC_I_RUN2", "L_P_AIR_I_GOOD"},
                      R"("devices": {"L_P_MC": {"initial": "IDLE1", "only": true, "transitions": [
        {"from": "IDLE1", "to": "RUN2", "automatic": true, "when": "L_P_AIR_I_GOOD", "takes": "1s"}]}})");
  const std::string moves = "0 L_P_MC_I_IDLE1 1; 0 L_P_MC_I_RUN2 0; 1000 L_P_MC_I_IDLE1 0; 2000 L_P_MC_I_RUN2 1; 9000";
  const std::string recorded = R"(,"recorded":true,"cycle":10000000)";
  CHECK(plant.found(moves, recorded) == "");
  CHECK(plant.found("0 L_P_AIR_I_GOOD 0; " + moves, recorded) == "unexpected L_P_MC IDLE1->? leaving at 1000");
}

}  // namespace
}  // namespace symplant::test
