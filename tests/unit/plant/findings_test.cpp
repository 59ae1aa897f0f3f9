// How findings reach the reader, loops, and short events within a cycle.
#include <cstdint>
#include <vector>

#include "support/plant_bench.hpp"

namespace symplant::test {
namespace {

const std::vector<std::string> kTwoAgvs = {"AGV_O_P1", "AGV_I_P1", "AGV_O_P2", "AGV_I_P2",
                                           "BUS_O_P1", "BUS_I_P1", "BUS_O_P2", "BUS_I_P2"};

std::size_t words_in(const std::string& text) {
  std::size_t words = text.empty() ? 0 : 1;
  for (std::size_t at = 0; (at = text.find(' ', at + 1)) != std::string::npos;) ++words;
  return words;
}

TEST_CASE("Findings of one instant are sorted by kind, then by unit or symbol, for ring and observer") {
  Reported reported;
  reported.description.requirements.push_back({"not both", "L_P_AGV_O_P2 and L_P_BUS_O_P2", "", "", 0});
  const BenchTables tables(kTwoAgvs, reported);
  BenchPlant plant(tables);
  plant.to(0).set("BUS_O_P1", 1).set("BUS_O_P2", 1).set("AGV_O_P1", 1).set("AGV_O_P2", 1).to(5);
  plant.set("AGV_O_P2", 0).set("BUS_O_P2", 0).to(7);
  const std::string all = "5:conflicting AGV 5:conflicting BUS 5:violated not both 7:lost AGV_O_P2 7:lost BUS_O_P2";
  CHECK(plant.reported() == all);
  CHECK(plant.findings() == all);
  CHECK(plant.findings() == "");
}

TEST_CASE("A finding is raised when it becomes true, and again after it was not") {
  const BenchTables tables(kTwoAgvs);
  BenchPlant plant(tables);
  plant.to(0).set("AGV_O_P1", 1).set("AGV_O_P2", 1).to(1).to(2);
  plant.set("BUS_O_P1", 1).to(3);
  CHECK(plant.findings() == "1:conflicting AGV");
  plant.set("AGV_O_P2", 0).to(4).set("AGV_O_P2", 1).to(5);
  CHECK(plant.findings() == "4:lost AGV_O_P2 5:conflicting AGV");
}

TEST_CASE("A full ring keeps the oldest findings and counts the rest, the observer receives all") {
  const BenchTables tables(kTwoAgvs);
  BenchPlant plant(tables);
  plant.to(0).set("AGV_O_P1", 1).to(0);
  for (tables::Time i = 0; i < 300; ++i) {  // two findings each
    plant.set("AGV_O_P2", 1).to(2 * i + 1).set("AGV_O_P2", 0).to(2 * i + 2);
  }
  CHECK(words_in(plant.reported()) == 2 * 600);  // "1:conflicting AGV": two words each
  CHECK(plant.plant.lost_findings() == 88);
  tables::Finding finding{};
  for (tables::Time i = 1; i <= 512; ++i) {
    REQUIRE(plant.plant.take_finding(finding));
    REQUIRE(finding.time == i * kMs);
    REQUIRE(finding.kind ==
            (i % 2 == 1 ? tables::FindingKind::conflicting_operations : tables::FindingKind::lost_command));
  }
  CHECK_FALSE(plant.plant.take_finding(finding));

  plant.set("AGV_O_P2", 1).to(1000);  // there is space again
  CHECK(plant.findings() == "1000:conflicting AGV");
  CHECK(plant.plant.lost_findings() == 88);
  plant.plant.reset();
  CHECK(plant.plant.lost_findings() == 0);
}

TEST_CASE("A reset discards unread findings") {
  const BenchTables tables(kTwoAgvs);
  BenchPlant plant(tables);
  plant.to(0).set("AGV_O_P1", 1).set("AGV_O_P2", 1).to(1);
  plant.plant.reset();
  CHECK(plant.findings() == "");
}

TEST_CASE("An instant with only a finding is reported") {
  Reported reported;
  reported.description.requirements.push_back({"answer", "", "L_P_AGV_O_P2", "L_P_BUS.P2", 20 * kMs});
  const BenchTables tables(kTwoAgvs, reported);
  BenchPlant plant(tables);
  plant.to(0).set("AGV_O_P2", 1).to(5);
  CHECK(plant.plant.next_due() == 25 * kMs);
  plant.to(30);
  CHECK(plant.reported() == "25:violated answer");
}

TEST_CASE("An expectation that comes true too early is violated once, and its watch ends") {
  Reported reported;
  reported.description.requirements.push_back({"answer", "", "L_P_AGV_O_P2", "L_P_BUS_O_P2", 20 * kMs, "", 10 * kMs});
  const BenchTables tables(kTwoAgvs, reported);
  const auto answers_after = [&](int ms) {
    BenchPlant plant(tables);
    plant.to(0).set("AGV_O_P2", 1).to(5).set("BUS_O_P2", 1).to(5 + ms).to(100);
    return plant.findings();
  };
  CHECK(answers_after(0) == "5:violated answer");
  CHECK(answers_after(9) == "14:violated answer");
  CHECK(answers_after(10) == "");
  CHECK(answers_after(20) == "");
  CHECK(answers_after(21) == "25:violated answer");
}

/// While GO is on, `FLIP` changes state forever without time passing, `FLOP` follows it; `CALM` is a machine of 1 s.
std::vector<Row> loop_rows() {
  std::vector<Row> list =
      bits({"L_P_FLIP_I_A1", "L_P_FLIP_I_B2", "L_P_FLOP_I_A1", "L_P_FLOP_I_B2", "L_P_CALM_I_A1", "L_P_CALM_I_B2"});
  list.push_back({"GO", "", "BOOL", "FALSE", "%IX100"});
  return list;
}

const BenchTables& loops() {
  static const BenchTables tables(Reported()
                                      .by_itself("FLIP", "A1", "B2", fixed(0), "GO")
                                      .by_itself("FLIP", "B2", "A1", fixed(0))
                                      .by_itself("FLOP", "A1", "B2", fixed(0), "L_P_FLIP.B2")
                                      .by_itself("FLOP", "B2", "A1", fixed(0), "L_P_FLIP.A1")
                                      .by_itself("CALM", "A1", "B2", fixed(1000 * kMs)),
                                  loop_rows());
  return tables;
}

TEST_CASE("A loop is reported unit by unit and frozen, and the rest of the plant continues") {
  BenchPlant plant(loops());
  plant.to(0);
  plant.input("GO", 1);
  plant.to(500);
  CHECK(plant.findings() == "0:loop FLIP+ 0:loop FLOP");
  CHECK(plant.unit("FLIP").frozen);
  CHECK(plant.unit("FLOP").frozen);
  CHECK_FALSE(plant.unit("CALM").frozen);
  const std::string flip = plant.state("FLIP");
  plant.to(2000);
  CHECK(plant.state("CALM") == "B2");
  CHECK(plant.state("FLIP") == flip);
  CHECK(plant.findings() == "");
}

TEST_CASE("A frozen unit stays frozen after a manual move, a reset unfreezes it") {
  BenchPlant plant(loops());
  plant.to(0);
  plant.input("GO", 1);
  plant.to(10);
  plant.put("FLIP", "B2").to(10);
  CHECK(plant.state("FLIP") == "B2#");
  CHECK(plant.on("FLIP_I_B2"));
  plant.put("FLIP", "A1").to(5000);
  CHECK(plant.state("FLIP") == "A1#");
  CHECK(plant.findings() == "0:loop FLIP+ 0:loop FLOP");
  plant.plant.reset();
  plant.to(1000);
  CHECK(plant.state("FLIP") == "A1");
  CHECK_FALSE(plant.unit("FLOP").frozen);
}

/// A row of devices, each of which follows the previous one without time passing.
std::vector<std::string> row_of_devices(std::size_t count, Reported& reported) {
  std::vector<std::string> names = {"D0_O_A1", "D0_I_A1", "D0_O_B2", "D0_I_B2"};
  reported.on_command("D0", "A1", "B2", fixed(0));
  for (std::size_t i = 1; i < count; ++i) {
    const std::string name = "D" + std::to_string(i);
    names.push_back(name + "_I_A1");
    names.push_back(name + "_I_B2");
    reported.by_itself(name, "A1", "B2", fixed(0), "L_P_D" + std::to_string(i - 1) + ".B2");
  }
  return names;
}

TEST_CASE("A ripple through hundreds of devices in one instant is no loop, for any number of rounds") {
  Reported reported;
  const BenchTables tables(row_of_devices(950, reported), reported);  // more than 200, 400 and 800 rounds
  BenchPlant plant(tables);
  plant.to(0).set("D0_O_B2", 1).to(7);
  CHECK(plant.findings() == "");
  CHECK(plant.state("D949") == "B2");
  CHECK(plant.plant.now() == 7 * kMs);
  CHECK_FALSE(plant.unit("D0").frozen);
}

TEST_CASE("A loop at the end of a long ripple is reported, and nothing else is frozen") {
  Reported reported;
  std::vector<std::string> names = row_of_devices(300, reported);
  names.insert(names.end(), {"FLIP_I_A1", "FLIP_I_B2"});
  reported.by_itself("FLIP", "A1", "B2", fixed(0), "L_P_D299.B2").by_itself("FLIP", "B2", "A1", fixed(0));
  const BenchTables tables(names, reported);
  BenchPlant plant(tables);
  plant.to(0).set("D0_O_B2", 1).to(7);
  CHECK(plant.findings() == "7:loop FLIP");
  CHECK(plant.state("D299") == "B2");
}

/// RUN2 lasts 10 ms.
const BenchTables& quick_machine() {
  static const BenchTables tables(
      {"MC_I_IDLE1", "MC_O_RUN2", "MC_I_RUN2"},
      Reported().on_command("MC", "IDLE1", "RUN2", fixed(0)).by_itself("MC", "RUN2", "IDLE1", fixed(10 * kMs)));
  return tables;
}

TEST_CASE("An event shorter than a cycle is reported, one of a whole cycle is not") {
  BenchPlant plant(quick_machine());
  plant.plant.reset(0, 10 * kMs);
  plant.to(0).set("MC_O_RUN2", 1).to(100).to(200);
  CHECK(plant.findings() == "");
  plant.plant.reset(0, 10 * kMs + 1);
  plant.to(0).set("MC_O_RUN2", 1).to(100).to(200);
  CHECK(plant.findings() == "110:short MC_I_RUN2");
}

TEST_CASE("In real time an event that is on while plant time does not advance is not too short") {
  BenchPlant plant(quick_machine());
  plant.plant.reset(0, 20 * kMs);
  const auto cycle = [&](tables::Time milliseconds) {
    plant.to(milliseconds);
    plant.plant.forget_changed_events();
  };
  cycle(0);
  plant.set("MC_O_RUN2", 1);
  cycle(100);
  cycle(100);  // the link has shown RUN2 for a whole cycle
  cycle(200);
  CHECK(plant.findings() == "");
}

TEST_CASE("In real time an event that a link shows on request is too short only within an instant") {
  BenchPlant plant(quick_machine());
  plant.plant.reset(0, 20 * kMs);
  plant.plant.show_on_request(std::vector<std::uint64_t>(plant.plant.events().size(), ~std::uint64_t{0}));
  plant.to(0).set("MC_O_RUN2", 1).to(100).to(200);
  CHECK(plant.findings() == "");

  const BenchTables tables(
      {"MC_I_IDLE1", "MC_O_RUN2", "MC_I_RUN2"},
      Reported().on_command("MC", "IDLE1", "RUN2", fixed(0)).by_itself("MC", "RUN2", "IDLE1", fixed(0)));
  BenchPlant flickering(tables);
  flickering.plant.reset(0, 20 * kMs);
  flickering.plant.show_on_request(std::vector<std::uint64_t>(flickering.plant.events().size(), ~std::uint64_t{0}));
  flickering.to(0).set("MC_O_RUN2", 1).to(100);
  CHECK(flickering.findings() == "100:short MC_I_IDLE1 100:short MC_I_RUN2");
}

TEST_CASE("In real time the events that changed in more than one instant of a cycle are known at its end") {
  const BenchTables& tables = quick_machine();
  BenchPlant plant(tables);
  plant.plant.reset(0, 20 * kMs);
  const std::uint32_t bit = tables.rows.symbols[tables.symbol("MC_I_RUN2")].index;
  const auto pulsed = [&] { return (plant.plant.pulsed_events(bit / 64) >> (bit % 64) & 1) != 0; };
  plant.to(0);
  plant.plant.forget_changed_events();
  plant.set("MC_O_RUN2", 1).to(100);
  CHECK_FALSE(pulsed());
  plant.to(200);
  CHECK(pulsed());
  plant.plant.forget_changed_events();
  CHECK_FALSE(pulsed());
}

TEST_CASE("In virtual time no event seen between two instants is too short") {
  BenchPlant plant(quick_machine());
  plant.to(0).set("MC_O_RUN2", 1).to(100).to(200);
  CHECK(plant.findings() == "");
}

TEST_CASE("An event on and off within one instant is too short in virtual time, too") {
  const BenchTables tables(
      {"MC_I_IDLE1", "MC_O_RUN2", "MC_I_RUN2"},
      Reported().on_command("MC", "IDLE1", "RUN2", fixed(0)).by_itself("MC", "RUN2", "IDLE1", fixed(0)));
  BenchPlant plant(tables);
  plant.to(0).set("MC_O_RUN2", 1).to(100);
  CHECK(plant.findings() == "100:short MC_I_IDLE1 100:short MC_I_RUN2");
}

TEST_CASE("A forced event does not flicker") {
  BenchPlant plant(quick_machine());
  plant.plant.reset(0, 20 * kMs);
  plant.to(0).force("MC_I_RUN2", 0).set("MC_O_RUN2", 1).to(100).to(200);
  CHECK(plant.findings() == "");
}

}  // namespace
}  // namespace symplant::test
