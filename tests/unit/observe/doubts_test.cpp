// What a recording does not show for certain: such moves are marked, their times do not count.
#include "observe_support.hpp"

namespace symplant::test {
namespace {

const std::vector<std::string> kGrip = {"L_P_G_I_SHUT", "L_P_G_O_SHUT"};

TEST_CASE("When commands conflicted, the cause begins when the conflict is over") {
  const Observed plant(kClamp, kBistable);
  CHECK(plant.moves("0 L_P_CL_I_OPEN 1; 0 L_P_CL_O_OPEN 1; 100 L_P_CL_O_CLOSED 1; 500 L_P_CL_O_OPEN 0; "
                    "520 L_P_CL_I_OPEN 0; 900 L_P_CL_I_CLOSED 1") ==
        "CL: OPEN->CLOSED #1 cause 500 left 520 arrived 900\n");
}

TEST_CASE("A device that had no time to come to a state without an event is marked") {
  const Observed plant(kGrip, R"("name": "x")");
  // It leaves SHUT at 1000 and is commanded back at 1300: it has not opened.
  CHECK(plant.moves("0 L_P_G_O_SHUT 1; 0 L_P_G_I_SHUT 1; 1000 L_P_G_O_SHUT 0; 1000 L_P_G_I_SHUT 0; "
                    "1300 L_P_G_O_SHUT 1; 1600 L_P_G_I_SHUT 1") ==
        "G: SHUT->NOT_SHUT spring cause 1000 left 1000 arrived -\n"
        "G: NOT_SHUT->SHUT #0 cause 1300 left - arrived 1600 turned\n");
  CHECK(plant.moves("0 L_P_G_O_SHUT 1; 0 L_P_G_I_SHUT 1; 1000 L_P_G_O_SHUT 0; 1000 L_P_G_I_SHUT 0; "
                    "4000 L_P_G_O_SHUT 1; 4900 L_P_G_I_SHUT 1") ==
        "G: SHUT->NOT_SHUT spring cause 1000 left 1000 arrived -\n"
        "G: NOT_SHUT->SHUT #0 cause 4000 left - arrived 4900\n");
}

TEST_CASE("A spring without a command returns before an automatic transition is due") {
  const Observed plant(kClamp, R"("devices": {"L_P_CL": {"actuation": "spring", "rest": "OPEN",
      "transitions": [{"from": "CLOSED", "to": "OPEN", "automatic": true, "after": "3s", "takes": "2s"}]}})");
  CHECK(plant.steps("0 L_P_CL_I_CLOSED 1; 0 L_P_CL_O_CLOSED 1; 500 L_P_CL_O_CLOSED 0")
            .find("500 caused CL: CLOSED->OPEN "
                  "spring cause 500") != std::string::npos);
}

TEST_CASE("A move that two causes explain is marked") {
  const Observed plant(kClamp, R"("devices": {"L_P_CL": {"actuation": "latched",
      "transitions": [{"from": "CLOSED", "to": "OPEN", "automatic": true, "after": "3s", "takes": "2s"}]}})");
  const std::string begin =
      "0 L_P_CL_I_OPEN 1; 100 L_P_CL_O_CLOSED 1; 100 L_P_CL_I_OPEN 0; 900 L_P_CL_I_CLOSED 1; "
      "1000 L_P_CL_O_CLOSED 0; ";
  const std::string first = "CL: OPEN->CLOSED #2 cause 100 left 100 arrived 900\n";
  CHECK(plant.moves(begin + "3900 L_P_CL_I_CLOSED 0; 5900 L_P_CL_I_OPEN 1") ==
        first + "CL: CLOSED->OPEN #0 cause 900 left 3900 arrived 5900\n");
  // The command of OPEN is on when it leaves, some time after that: it was either of them.
  CHECK(plant.moves(begin + "3000 L_P_CL_O_OPEN 1; 3900 L_P_CL_I_CLOSED 0; 5900 L_P_CL_I_OPEN 1").find("turned") !=
        std::string::npos);
}

TEST_CASE("A command that ended while the device was disabled is no cause") {
  std::vector<std::string> names = kClamp;
  names.insert(names.end(), {"L_P_D_I_SHUT", "L_P_D_I_OPEN", "L_P_D_O_SHUT", "L_P_D_O_OPEN"});
  const Observed plant(names, R"("devices": {"L_P_D": {"disables": {"OPEN": ["L_P_CL"]}}})");
  CHECK(plant.moves("0 L_P_CL_I_OPEN 1; 0 L_P_D_I_OPEN 1; 100 L_P_CL_O_CLOSED 1; 200 L_P_CL_O_CLOSED 0; "
                    "300 L_P_D_O_SHUT 1; 300 L_P_D_I_OPEN 0; 400 L_P_CL_O_CLOSED 1; 400 L_P_CL_I_OPEN 0; "
                    "900 L_P_CL_I_CLOSED 1") == "CL: OPEN->CLOSED #1 cause 400 left 400 arrived 900\n");
}

TEST_CASE("A stop before a device leaves for a state without an event counts") {
  std::vector<std::string> names = kGrip;
  names.insert(names.end(), {"L_P_D_I_SHUT", "L_P_D_I_OPEN", "L_P_D_O_SHUT", "L_P_D_O_OPEN"});
  const Observed plant(names, R"("devices": {"L_P_D": {"disables": {"OPEN": ["L_P_G"]}}})");
  CHECK(plant.moves("0 L_P_G_O_SHUT 1; 0 L_P_G_I_SHUT 1; 0 L_P_D_I_OPEN 1; 100 L_P_G_O_SHUT 0; "
                    "600 L_P_D_O_SHUT 1; 600 L_P_D_I_OPEN 0; 600 L_P_G_I_SHUT 0") ==
        "G: SHUT->NOT_SHUT spring cause 100 left 600 arrived - stopped 500\n");
}

TEST_CASE("A device that another one may disable from a state without an event is marked") {
  std::vector<std::string> names = kClamp;
  names.insert(names.end(), {"L_P_D_I_SHUT", "L_P_D_O_SHUT"});
  const Observed plant(names, R"("devices": {"L_P_D": {"disables": {"NOT_SHUT": ["L_P_CL"]}}})");
  CHECK(plant
            .moves("0 L_P_CL_I_OPEN 1; 0 L_P_D_I_SHUT 1; 0 L_P_D_O_SHUT 1; 100 L_P_CL_O_CLOSED 1; "
                   "100 L_P_CL_I_OPEN 0; 200 L_P_D_O_SHUT 0; 200 L_P_D_I_SHUT 0; 900 L_P_CL_I_CLOSED 1")
            .find("turned") != std::string::npos);
}

TEST_CASE("Events that are on when a device has left a state cannot show that it arrived") {
  const Observed plant(kClamp, R"("devices": {"L_P_CL": {"outputs": {"OPEN": {"leave": {"CLOSED": true}}}}})");
  CHECK(plant.moves("0 L_P_CL_I_OPEN 1; 100 L_P_CL_O_CLOSED 1; 100 L_P_CL_I_OPEN 0; 100 L_P_CL_I_CLOSED 1")
            .find("turned") != std::string::npos);
}

TEST_CASE("Events that stay on from before count when a device has left a state") {
  std::vector<std::string> names = kClamp;
  names.emplace_back("L_P_CL_I_BUSY");
  const Observed stays(names, R"("devices": {"L_P_CL": {"outputs": {
      "OPEN": {"leave": {"CLOSED": true}}, "CLOSED": {"enter": {"BUSY": true}}}}})");
  CHECK(stays
            .moves("0 L_P_CL_I_OPEN 1; 0 L_P_CL_I_BUSY 1; 100 L_P_CL_O_CLOSED 1; 100 L_P_CL_I_OPEN 0; "
                   "100 L_P_CL_I_CLOSED 1")
            .find("turned") != std::string::npos);
}

TEST_CASE("A condition on the state that the device leaves is that of the time before") {
  const Observed plant(kClamp, R"("devices": {"L_P_CL": {"transitions": [
      {"from": "OPEN", "to": "CLOSED", "when": "'L_P_CL_I_OPEN'"}]}})");
  CHECK(plant.moves("0 L_P_CL_I_OPEN 1; 100 L_P_CL_O_CLOSED 1; 100 L_P_CL_I_OPEN 0; 900 L_P_CL_I_CLOSED 1") ==
        "CL: OPEN->CLOSED #0 cause 100 left 100 arrived 900\n");
}

TEST_CASE("A device that may have passed a state unseen is marked") {
  // The command of OPEN is on when it comes to CLOSED: it may have left at once, gone and come back.
  const Observed plant(kClamp, kBistable);
  CHECK(plant.moves("0 L_P_CL_I_OPEN 1; 100 L_P_CL_O_CLOSED 1; 100 L_P_CL_I_OPEN 0; 200 L_P_CL_O_OPEN 1; "
                    "800 L_P_CL_O_OPEN 0; 900 L_P_CL_I_CLOSED 1") ==
        "CL: OPEN->CLOSED #1 cause 100 left 100 arrived 900 turned\n");
}

}  // namespace
}  // namespace symplant::test
