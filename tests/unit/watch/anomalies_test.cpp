// One test for each anomaly, and recordings without any.
#include "watch_support.hpp"

namespace symplant::test {
namespace {

const std::string kOpen = "0 L_P_CL_I_OPEN 1; ";

TEST_CASE("A move within its limits and the margin is no anomaly") {
  const Watched plant(kClamp, kBistable);  // takes 1 s
  const auto arrives = [&](const std::string& ms) {
    return plant.found(kOpen + "1000 L_P_CL_O_CLOSED 1; 1010 L_P_CL_I_OPEN 0; " + ms + " L_P_CL_I_CLOSED 1; 9000");
  };
  CHECK(arrives("2000") == "");
  CHECK(arrives("2200") == "");
  CHECK(arrives("1800") == "");
  CHECK(arrives("2210") == "late L_P_CL OPEN->CLOSED at 2210");
  CHECK(arrives("1790") == "early L_P_CL OPEN->CLOSED at 1790");
}

TEST_CASE("The margin is at least two resolutions") {
  const Watched plant(kClamp, R"("defaults": {"travel": "50ms"}, "devices": {"L_P_CL": {"actuation": "bistable"}})");
  const auto arrives = [&](const std::string& ms) {
    return plant.found(kOpen + "1000 L_P_CL_O_CLOSED 1; 1010 L_P_CL_I_OPEN 0; " + ms + " L_P_CL_I_CLOSED 1; 9000",
                       R"(,"cycle":20000000)");
  };
  CHECK(arrives("1090") == "");
  CHECK(arrives("1010") == "");
  CHECK(arrives("1100") == "late L_P_CL OPEN->CLOSED at 1100");
}

TEST_CASE("A device that does not arrive is missing once, at three times the longest time") {
  const Watched plant(kClamp, kBistable);
  const std::string begin = kOpen + "1000 L_P_CL_O_CLOSED 1; 1010 L_P_CL_I_OPEN 0; ";
  CHECK(plant.found(begin + "3990") == "");
  CHECK(plant.found(begin + "9000") == "missing L_P_CL OPEN->CLOSED at 4000");
  CHECK(plant.found(begin + "9000 L_P_CL_I_CLOSED 1; 20000") == "missing L_P_CL OPEN->CLOSED at 4000");
}

TEST_CASE("A device that is commanded back before it is missing did not arrive if it had the time to") {
  const Watched plant(kClamp, kBistable);
  const auto back = [&](const std::string& at, const std::string& open) {
    return plant.found(kOpen + "1000 L_P_CL_O_CLOSED 1; 1010 L_P_CL_I_OPEN 0; " + at + " L_P_CL_O_CLOSED 0; " + at +
                       " L_P_CL_O_OPEN 1; " + open + " L_P_CL_I_OPEN 1; 9000");
  };
  CHECK(back("2200", "3200") == "");
  CHECK(back("2300", "3300") == "missing L_P_CL OPEN->CLOSED at 3300");
}

TEST_CASE("A device that does not leave is missing") {
  const Watched plant(kClamp, kBistable);
  CHECK(plant.found(kOpen + "1000 L_P_CL_O_CLOSED 1; 9000") == "missing L_P_CL OPEN->CLOSED leaving at 4000");
  CHECK(plant.found(kOpen + "1000 L_P_CL_O_CLOSED 1; 1200 L_P_CL_O_CLOSED 0; 9000") ==
        "missing L_P_CL OPEN->CLOSED leaving at 4000");
}

TEST_CASE("After a missing arrival the next cycle is judged again") {
  const Watched plant(kClamp, kBistable);
  const std::string cycle1 = kOpen +
                             "1000 L_P_CL_O_CLOSED 1; 1010 L_P_CL_I_OPEN 0; 5000 L_P_CL_O_CLOSED 0; "
                             "5000 L_P_CL_O_OPEN 1; 6000 L_P_CL_I_OPEN 1; 7000 L_P_CL_O_OPEN 0; ";
  CHECK(plant.found(cycle1 + "10000 L_P_CL_O_CLOSED 1; 10010 L_P_CL_I_OPEN 0; 20000") ==
        "missing L_P_CL OPEN->CLOSED at 4000\nmissing L_P_CL OPEN->CLOSED at 13000");
  CHECK(plant.found(cycle1 + "10000 L_P_CL_O_CLOSED 1; 10010 L_P_CL_I_OPEN 0; 11000 L_P_CL_I_CLOSED 1; 20000") ==
        "missing L_P_CL OPEN->CLOSED at 4000");
}

TEST_CASE("A change that nothing caused is unexpected, and then the device is where its events say") {
  const Watched plant(kClamp, kBistable);
  CHECK(plant.found(kOpen + "1000 L_P_CL_I_OPEN 0; 9000") == "unexpected L_P_CL OPEN->? leaving at 1000");
  CHECK(plant.found(kOpen + "1000 L_P_CL_I_OPEN 0; 1500 L_P_CL_I_OPEN 1; 9000") ==
        "unexpected L_P_CL OPEN->? leaving at 1000");
  CHECK(plant.found(kOpen + "1000 L_P_CL_I_OPEN 0; 1010 L_P_CL_I_OPEN 1; 9000") ==
        "unexpected L_P_CL OPEN->OPEN leaving at 1000");
  CHECK(plant.found(kOpen + "1000 L_P_CL_I_OPEN 0; 1000 L_P_CL_I_CLOSED 1; 9000") ==
        "unexpected L_P_CL OPEN->CLOSED at 1000");
  // It was moved by hand: it can be commanded back, in time.
  CHECK(plant.found(kOpen + "1000 L_P_CL_I_OPEN 0; 1500 L_P_CL_I_CLOSED 1; 3000 L_P_CL_O_OPEN 1; "
                            "3010 L_P_CL_I_CLOSED 0; 4000 L_P_CL_I_OPEN 1; 9000") ==
        "unexpected L_P_CL OPEN->? leaving at 1000");
}

TEST_CASE("A change whose command is read one image later is not unexpected") {
  const Watched plant(kClamp, kBistable);
  const auto commanded = [&](const std::string& ms, const std::string& operation) {
    return plant.found(kOpen + "1000 L_P_CL_I_OPEN 0; " + ms + " L_P_CL_O_" + operation +
                       " 1; 2000 L_P_CL_I_CLOSED 1; 4000");
  };
  CHECK(commanded("1010", "CLOSED") == "");
  CHECK(commanded("1020", "CLOSED") == "");
  CHECK(commanded("1030", "CLOSED") == "unexpected L_P_CL OPEN->? leaving at 1000");
  CHECK(commanded("1010", "OPEN") == "unexpected L_P_CL OPEN->? leaving at 1000");
}

TEST_CASE("The program's answer to an unexpected change does not hide it") {
  const Watched plant(kClamp, kBistable);
  CHECK(plant.found(kOpen + "1000 L_P_CL_I_OPEN 0; 1000 L_P_CL_I_CLOSED 1; 1010 L_P_CL_O_OPEN 1; "
                            "1020 L_P_CL_I_CLOSED 0; 2010 L_P_CL_I_OPEN 1; 9000") ==
        "unexpected L_P_CL OPEN->CLOSED at 1000");
}

TEST_CASE("Two ends at once are a contradiction if it lasts over two resolutions") {
  const Watched plant(kClamp, kBistable);
  const std::string begin = kOpen + "1000 L_P_CL_O_CLOSED 1; 2000 L_P_CL_I_CLOSED 1; ";
  CHECK(plant.found(begin + "2020 L_P_CL_I_OPEN 0; 9000") == "");
  CHECK(plant.found(begin + "2030 L_P_CL_I_OPEN 0; 9000") == "contradiction L_P_CL OPEN->CLOSED at 2000");
  CHECK(plant.found(begin + "9000") == "contradiction L_P_CL OPEN->CLOSED at 2000");
}

TEST_CASE("After a contradiction that ended a device is judged again") {
  const Watched plant(kClamp, kBistable);
  CHECK(plant.found(kOpen + "1000 L_P_CL_I_CLOSED 1; 2000 L_P_CL_I_CLOSED 0; 3000 L_P_CL_I_OPEN 0; 9000") ==
        "contradiction L_P_CL OPEN->? at 1000\nunexpected L_P_CL OPEN->? leaving at 3000");
}

TEST_CASE("No end at all for longer than any move is a contradiction") {
  const Watched plant(kClamp, kBistable);
  CHECK(plant.found("0 L_P_CL_O_CLOSED 0; 1000 L_P_CL_O_CLOSED 1; 9000") == "contradiction L_P_CL ?->? at 2200");
  CHECK(plant.found("0 L_P_CL_O_CLOSED 0; 1000 L_P_CL_O_CLOSED 1; 2100 L_P_CL_I_CLOSED 1; 9000") == "");
  CHECK(plant.found("0 L_P_CL_O_CLOSED 0; 9000") == "");
}

}  // namespace
}  // namespace symplant::test
