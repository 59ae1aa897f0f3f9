// Overrun: a held unit whose motor runs against its end.
#include "bench.hpp"

namespace symplant::test {
namespace {

using tables::Actuation;

const std::vector<std::string> kDoor = {"A_O_SHUT1", "A_O_OPEN2", "A_I_SHUT1", "A_I_OPEN2"};

/// A held door that takes 1000 ms, with an overrun.
Said held(std::optional<tables::Time> overrun = {}) {
  Said said;
  said.device("L_P_A").actuation = Actuation::held;
  said.device("L_P_A").overrun = overrun;
  return said;
}

TEST_CASE("A held unit overruns when its command remains on at the reached state") {
  Bench bench(kDoor, held(300 * kMs));
  bench.at(0).set("A_O_OPEN2", true).at(0).at(1000);
  CHECK(bench.plant.next_due() == 1300 * kMs);
  bench.at(1299);
  CHECK(bench.findings() == "");
  bench.at(5000);
  CHECK(bench.findings() == "1300:overrun A");
  CHECK(bench.plant.next_due() == tables::kNever);
  bench.set("A_O_OPEN2", false).at(6000).set("A_O_OPEN2", true).at(7000).at(9000);
  CHECK(bench.findings() == "7300:overrun A");
}

TEST_CASE("The default overrun is two seconds, and `never` examines nothing") {
  Bench bench(kDoor, held());
  bench.set("A_O_SHUT1", true).at(0).at(9000);
  CHECK(bench.findings() == "2000:overrun A");
  Bench never(kDoor, held(tables::kNever));
  never.set("A_O_SHUT1", true).at(0);
  CHECK(never.plant.next_due() == tables::kNever);
  CHECK(never.at(9000).findings() == "");
  Said said = held();
  said.description.defaults.overrun = 0;
  Bench at_once(kDoor, said);
  CHECK(at_once.set("A_O_SHUT1", true).at(100).findings() == "100:overrun A");
}

TEST_CASE("Units of other actuations do not overrun") {
  for (const Actuation actuation : {Actuation::latched, Actuation::bistable, Actuation::spring}) {
    Said said;
    said.device("L_P_A").actuation = actuation;
    Bench bench(kDoor, said);
    bench.at(0).set("A_O_OPEN2", true).at(0).at(9000);
    CHECK(bench.findings() == "");
  }
}

TEST_CASE("A break of the command, a disabled interval and another state start the time over") {
  Said said = held(300 * kMs);
  said.device("L_P_D").disables = {{"ON", {"L_P_A"}}};
  std::vector<std::string> names = kDoor;
  names.emplace_back("D_I_ON");
  Bench bench(names, said);
  bench.set("A_O_SHUT1", true).at(0).set("A_O_SHUT1", false).at(200).set("A_O_SHUT1", true).at(250);
  CHECK(bench.plant.next_due() == 550 * kMs);
  bench.at(400).put("D", "ON").at(400);
  CHECK(bench.plant.next_due() == tables::kNever);
  bench.at(450).put("D", "NOT_ON").at(450);
  CHECK(bench.plant.next_due() == 750 * kMs);
  bench.at(600).put("A", "OPEN2").at(600);
  CHECK(bench.state("A") == "OPEN2->SHUT1");
  CHECK(bench.at(1899).findings() == "600:short A_I_OPEN2");
  CHECK(bench.at(1900).findings() == "1900:overrun A");
}

TEST_CASE("An overrun ends when the unit is disabled, and can be found again") {
  Said said = held(300 * kMs);
  said.device("L_P_D").disables = {{"ON", {"L_P_A"}}};
  std::vector<std::string> names = kDoor;
  names.emplace_back("D_I_ON");
  Bench bench(names, said);
  bench.set("A_O_SHUT1", true).at(0).at(300).put("D", "ON").at(500).put("D", "NOT_ON").at(600).at(2000);
  CHECK(bench.findings() == "300:overrun A 800:overrun A");  // enabled at 500
  CHECK(bench.plant.counters[reference::Counted::overrun_ended] == 1);
}

TEST_CASE("Operations of transitions to the state count, each with its own time") {
  Said said = held(300 * kMs);
  said.device("L_P_A").transitions = {transition("OPEN2", "SHUT1", "PUSH")};
  std::vector<std::string> names = kDoor;
  names.emplace_back("A_O_PUSH");
  Bench bench(names, said);
  bench.set("A_O_SHUT1", true).at(0).set("A_O_PUSH", true).at(200).set("A_O_SHUT1", false).at(250);
  CHECK(bench.at(499).findings() == "");
  CHECK(bench.at(500).findings() == "500:overrun A");
}

TEST_CASE("An operation that leads to two states counts for each by itself") {
  Said said = held(300 * kMs);
  said.device("L_P_A").transitions = {transition("OPEN2", "SHUT1", "PUSH"), transition("SHUT1", "OPEN2", "PUSH")};
  for (auto& given : said.device("L_P_A").transitions) given.when = "L_P_B.ON";
  std::vector<std::string> names = kDoor;
  names.insert(names.end(), {"A_O_PUSH", "B_I_ON"});
  Bench bench(names, said);
  bench.set("A_O_PUSH", true).at(0).at(100).put("A", "OPEN2").at(100);
  CHECK(bench.at(399).findings() == "");
  CHECK(bench.at(400).findings() == "400:overrun A");
}

TEST_CASE("A command for another state does not overrun, a break within an instant does not count") {
  Said said = held(300 * kMs);
  said.device("L_P_A").transitions = {automatic("SHUT1", "OPEN2", 0, "L_P_B.ON"), automatic("OPEN2", "SHUT1")};
  std::vector<std::string> names = kDoor;
  names.emplace_back("B_I_ON");
  said.device("L_P_B").transitions = {automatic("ON", "NOT_ON")};
  Bench bench(names, said);
  bench.set("A_O_SHUT1", true).at(0).at(100).put("B", "ON").at(100);
  CHECK(bench.findings() == "100:short A_I_SHUT1 100:short A_I_OPEN2 100:short B_I_ON");
  CHECK(bench.at(1000).findings() == "300:overrun A");
}

TEST_CASE("The digest holds the overrun") {
  Bench bench(kDoor, held(300 * kMs));
  Bench other(kDoor, held(400 * kMs));
  for (Bench* each : {&bench, &other}) each->set("A_O_SHUT1", true).at(0);
  CHECK(bench.at(299).plant.state_hash() == other.at(299).plant.state_hash());
  CHECK(bench.at(300).plant.state_hash() != other.at(300).plant.state_hash());
  CHECK(bench.at(400).plant.state_hash() == other.at(400).plant.state_hash());
}

}  // namespace
}  // namespace symplant::test
