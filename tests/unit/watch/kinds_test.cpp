// Anomalies of devices of each kind, and good recordings of them.
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
