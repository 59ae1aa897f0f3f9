// What moves an observer finds in recordings, with causes and times.
#include "observe_support.hpp"

namespace symplant::test {
namespace {

const std::vector<std::string> kMotor = {"L_P_M_I_RUN", "L_P_M_O_RUN"};

// `trace_text` makes X, Y and what has `_I_` or `_O_` BOOL.
TEST_CASE("A commanded move has its cause, its leaving and its arrival") {
  const Observed plant(kClamp, kBistable);
  CHECK(plant.moves("0 L_P_CL_I_OPEN 1; 100 L_P_CL_O_CLOSED 1; 130 L_P_CL_I_OPEN 0; 900 L_P_CL_I_CLOSED 1") ==
        "CL: OPEN->CLOSED #1 cause 100 left 130 arrived 900\n");
}

TEST_CASE("Steps follow each other from the cause to the arrival") {
  const Observed plant(kClamp, kBistable);
  CHECK(plant.steps("0 L_P_CL_I_OPEN 1; 100 L_P_CL_O_CLOSED 1; 130 L_P_CL_I_OPEN 0; 900 L_P_CL_I_CLOSED 1") ==
        "100 caused CL: OPEN->CLOSED #1 cause 100 left - arrived -\n"
        "130 left CL: OPEN->CLOSED #1 cause 100 left 130 arrived -\n"
        "900 arrived CL: OPEN->CLOSED #1 cause 100 left 130 arrived 900\n");
}

TEST_CASE("A command in the instant of leaving is its cause") {
  const Observed plant(kClamp, kBistable);
  CHECK(plant.moves("0 L_P_CL_I_OPEN 1; 100 L_P_CL_I_OPEN 0; 100 L_P_CL_O_CLOSED 1; 900 L_P_CL_I_CLOSED 1") ==
        "CL: OPEN->CLOSED #1 cause 100 left 100 arrived 900\n");
}

TEST_CASE("What no command causes has no cause") {
  const Observed plant(kClamp, kBistable);
  CHECK(plant.moves("0 L_P_CL_I_OPEN 1; 100 L_P_CL_I_OPEN 0; 900 L_P_CL_I_CLOSED 1") ==
        "CL: OPEN->CLOSED cause - left 100 arrived 900\n");
}

TEST_CASE("A command that ended when the device had begun to move is the cause") {
  const Observed plant(kClamp, kBistable);
  CHECK(plant.moves("0 L_P_CL_I_OPEN 1; 100 L_P_CL_O_CLOSED 1; 150 L_P_CL_O_CLOSED 0; 400 L_P_CL_I_OPEN 0; "
                    "900 L_P_CL_I_CLOSED 1") == "CL: OPEN->CLOSED #1 cause 100 left 400 arrived 900\n");
}

TEST_CASE("A command that is on at the beginning has no time") {
  const Observed plant(kClamp, kBistable);
  CHECK(plant.moves("0 L_P_CL_I_OPEN 1; 0 L_P_CL_O_CLOSED 1; 130 L_P_CL_I_OPEN 0; 900 L_P_CL_I_CLOSED 1") ==
        "CL: OPEN->CLOSED #1 cause - left 130 arrived 900\n");
}

TEST_CASE("A motor with one feedback shows the whole time to its state, and the time to leave it") {
  const Observed plant(kMotor, R"("name": "x")");
  CHECK(plant.moves("0 L_P_M_O_RUN 0; 100 L_P_M_O_RUN 1; 600 L_P_M_I_RUN 1; 2000 L_P_M_O_RUN 0; 2300 L_P_M_I_RUN 0; "
                    "5000 L_P_M_O_RUN 1; 5500 L_P_M_I_RUN 1") ==
        "M: NOT_RUN->RUN #0 cause 100 left - arrived 600\n"
        "M: RUN->NOT_RUN spring cause 2000 left 2300 arrived -\n"
        "M: NOT_RUN->RUN #0 cause 5000 left - arrived 5500\n");
}

TEST_CASE("A move after a command that came too early for rest is marked") {
  const Observed plant(kMotor, R"("name": "x")");
  CHECK(plant.moves("0 L_P_M_O_RUN 0; 100 L_P_M_O_RUN 1; 300 L_P_M_O_RUN 0; 350 L_P_M_O_RUN 1; 600 L_P_M_I_RUN 1") ==
        "M: NOT_RUN->RUN #0 cause 350 left - arrived 600 turned\n");
}

TEST_CASE("A move that is commanded back is marked, and its end is where it came from") {
  const Observed plant(kClamp, kBistable);
  CHECK(plant.moves("0 L_P_CL_I_OPEN 1; 100 L_P_CL_O_CLOSED 1; 130 L_P_CL_I_OPEN 0; 400 L_P_CL_O_CLOSED 0; "
                    "400 L_P_CL_O_OPEN 1; 700 L_P_CL_I_OPEN 1") ==
        "CL: OPEN->OPEN cause 100 left 130 arrived 700 turned\n");
}

TEST_CASE("A held move without a command is stopped for that time") {
  const Observed plant(kClamp, R"("devices": {"L_P_CL": {"actuation": "held"}})");
  CHECK(plant.moves("0 L_P_CL_I_OPEN 1; 100 L_P_CL_O_CLOSED 1; 130 L_P_CL_I_OPEN 0; 300 L_P_CL_O_CLOSED 0; "
                    "500 L_P_CL_O_CLOSED 1; 1100 L_P_CL_I_CLOSED 1") ==
        "CL: OPEN->CLOSED #1 cause 100 left 130 arrived 1100 stopped 200\n");
}

TEST_CASE("An automatic transition is caused by the arrival in its state and by its condition") {
  std::vector<std::string> names = kClamp;
  for (const char* const name : {"L_P_R_I_WORK", "L_P_R_I_HOME"}) names.emplace_back(name);
  const Observed plant(names, R"("devices": {"L_P_CL": {"actuation": "bistable"}, "L_P_R": {"transitions": [
      {"from": "HOME", "to": "WORK", "automatic": true, "when": "L_P_CL.CLOSED", "after": "1s"},
      {"from": "WORK", "to": "HOME", "automatic": true, "after": "2s"}]}})");
  CHECK(plant.moves("0 L_P_CL_I_OPEN 1; 0 L_P_R_I_HOME 1; 100 L_P_CL_O_CLOSED 1; 130 L_P_CL_I_OPEN 0; "
                    "900 L_P_CL_I_CLOSED 1; 1900 L_P_R_I_HOME 0; 2000 L_P_R_I_WORK 1; 4000 L_P_R_I_WORK 0; "
                    "4000 L_P_R_I_HOME 1") ==
        "CL: OPEN->CLOSED #1 cause 100 left 130 arrived 900\n"
        "R: HOME->WORK #0 cause 900 left 1900 arrived 2000\n"
        "R: WORK->HOME #1 cause 2000 left 4000 arrived 4000\n");
}

TEST_CASE("A condition that holds in the instant of another device's arrival is a cause in that instant") {
  std::vector<std::string> names = {"L_P_A_I_GO", "L_P_A_I_REST"};
  names.insert(names.end(), kClamp.begin(), kClamp.end());
  const Observed plant(names, R"("devices": {"L_P_CL": {"actuation": "bistable"}, "L_P_A": {"transitions": [
      {"from": "REST", "to": "GO", "automatic": true, "when": "L_P_CL.CLOSED", "after": "0s"}]}})");
  CHECK(plant.moves("0 L_P_CL_I_OPEN 1; 0 L_P_A_I_REST 1; 100 L_P_CL_O_CLOSED 1; 130 L_P_CL_I_OPEN 0; "
                    "900 L_P_A_I_REST 0; 900 L_P_A_I_GO 1; 900 L_P_CL_I_CLOSED 1") ==
        "CL: OPEN->CLOSED #1 cause 100 left 130 arrived 900\n"
        "A: REST->GO #0 cause 900 left 900 arrived 900\n");
}

TEST_CASE("A disabled device is stopped") {
  std::vector<std::string> names = kClamp;
  for (const char* const name : {"L_P_S_I_ON", "L_P_S_I_OFF"}) names.emplace_back(name);
  const Observed plant(names, R"("devices": {"L_P_CL": {"actuation": "bistable"},
      "L_P_S": {"disables": {"ON": ["L_P_CL"]}}})");
  CHECK(plant
            .moves("0 L_P_CL_I_OPEN 1; 0 L_P_S_I_OFF 1; 100 L_P_CL_O_CLOSED 1; 130 L_P_CL_I_OPEN 0; "
                   "300 L_P_S_I_OFF 0; 300 L_P_S_I_ON 1; 700 L_P_S_I_ON 0; 700 L_P_S_I_OFF 1; "
                   "1300 L_P_CL_I_CLOSED 1")
            .find("CL: OPEN->CLOSED #1 cause 100 left 130 arrived 1300 stopped 400\n") != std::string::npos);
}

TEST_CASE("A command that ends in the reading of the arrival is the cause") {
  const Observed plant(kMotor, R"("name": "x")");
  CHECK(plant.moves("0 L_P_M_O_RUN 0; 100 L_P_M_O_RUN 1; 600 L_P_M_I_RUN 1; 600 L_P_M_O_RUN 0",
                    ",\"every\":50000000") == "M: NOT_RUN->RUN #0 cause 100 left - arrived 600\n");
}

}  // namespace
}  // namespace symplant::test
