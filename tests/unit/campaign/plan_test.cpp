// Which faults there are, from when on, and which need no run.
#include "campaign/plan.hpp"

#include <algorithm>

#include "campaign_support.hpp"
#include "support/strings.hpp"

namespace symplant::campaign {
namespace {

using test::contains;

std::string names_of(const std::vector<Fault>& faults) {
  std::string names;
  for (const Fault& fault : faults) names += (names.empty() ? "" : ", ") + fault.malfunction;
  return names;
}

TEST_CASE("Every input, device, track and controller has its single faults, then those of plant.json") {
  std::vector<test::Row> rows = list();
  rows.push_back({"L_P_ALIAS_I_X", "", "BOOL", "FALSE", "%IX0"});  // on the address of L_P_A_I_X
  const test::DescribedPlant described(rows, R"("malfunctions": [{ "name": "spare", "force": { "L_P_A_I_X": false } },
    { "name": "both", "force": { "L_P_A_I_X": true, "L_P_B_I_X": true } }],
    "material": { "tracks": { "T": { "length": "1 m", "drives": [{ "forward": "L_P_M_O_RUN", "speed": "1 m/s" }], "end": "out" } } })");
  model::PlantModel plant = described.compiled().plant;
  CHECK(add_malfunctions(plant, 2).empty());
  const std::vector<Fault> faults = faults_of(plant, 2);
  CHECK(names_of(faults) ==
        "L_P_A_I_X stuck on, L_P_A_I_X stuck off, L_P_A_I_X loose, L_P_B_I_X stuck on, L_P_B_I_X stuck off, "
        "L_P_B_I_X loose, L_P_N_I_SPEED held, L_P_M stuck, L_P_M slow, L_P_HORN stuck, L_P_HORN slow, track T stuck, "
        "track T slow, PLC lost, spare, both");
  CHECK(faults.back().item == "L_P_A_I_X, L_P_B_I_X");
  CHECK(mode_words(faults.back()) == "both");
  CHECK(faults.back().symbols.size() == 2);
  CHECK(names_of(described_faults(plant, 1, 2)) == "both");
}

TEST_CASE(
    "A name of the plant that a campaign needs is reported, and malfunctions of a file wait for their condition") {
  const test::DescribedPlant described(
      list(), R"("malfunctions": [{ "name": "l_p_a_i_x LOOSE", "force": { "L_P_A_I_X": false } },
    { "name": "later", "force": { "L_P_A_I_X": true }, "when": "L_P_B_I_X" },
    { "name": "now", "force": { "L_P_A_I_X": true }, "chance": "5s" }])");
  model::PlantModel plant = described.compiled().plant;
  CHECK(add_malfunctions(plant, 1) == std::vector<std::string>{"L_P_A_I_X loose"});
  CHECK_FALSE(plant.malfunctions[1].condition);
  CHECK_FALSE(plant.malfunctions[2].chance);
  const std::vector<Fault> faults = described_faults(plant, 1, 3);
  REQUIRE(faults[0].begins == 3);
  CHECK(plant.malfunctions[3].name == "later (condition)");
  CHECK(plant.malfunctions[3].condition);
  CHECK(plant.malfunctions[3].effects.empty());
  CHECK(faults[1].begins == tables::kNone);
  Bench bench;
  CHECK_FALSE(plan({faults[0]}, Phases::start, bench.base, bench.names).front().needed);
  bench.base.log.malfunctions = {{700 * kMs, 1, 3}};
  const std::vector<Planned> planned = plan({faults[0]}, Phases::all, bench.base, bench.names);
  REQUIRE(planned.size() == 1);
  CHECK(planned.front().at == 700 * kMs);
}

struct Planning : Bench {
  Planning() { base.case_end = 5000 * kMs; }
  std::vector<Planned> planned(const Fault& fault, Phases phases = Phases::start) const {
    return plan({fault}, phases, base, names);
  }
  bool needed(Fault::Mode mode, const char* symbol, tables::Time at = 0) const {
    const std::vector<Planned> all = planned({mode, symbol, "", "", {plant.symbol(symbol)}, {}}, Phases::all);
    const auto found = std::find_if(all.begin(), all.end(), [&](const Planned& one) { return one.at == at; });
    REQUIRE(found != all.end());
    return found->needed;
  }
};

TEST_CASE("A fault that holds what the base case shows needs no run") {
  Planning bench;
  bench.set_base({{0, "L_P_B_I_X", 1}, {1000, "L_P_A_I_X", 1}, {2000, "L_P_A_I_X", 0}, {1500, "L_P_N_I_SPEED", 3}});
  using enum Fault::Mode;
  CHECK(bench.needed(stuck_on, "L_P_A_I_X"));
  CHECK(bench.needed(stuck_off, "L_P_A_I_X"));
  CHECK_FALSE(bench.needed(stuck_on, "L_P_B_I_X"));
  CHECK(bench.needed(stuck_off, "L_P_B_I_X"));
  CHECK(bench.needed(loose, "L_P_B_I_X"));
  CHECK(bench.needed(held, "L_P_N_I_SPEED"));
  // From a change on it still hides the change itself, within its instant.
  CHECK(bench.needed(stuck_off, "L_P_A_I_X", 2000 * kMs));
  CHECK(bench.needed(held, "L_P_N_I_SPEED", 1500 * kMs));
  bench.set_base({});
  CHECK_FALSE(bench.needed(stuck_off, "L_P_A_I_X"));
  CHECK_FALSE(bench.needed(held, "L_P_N_I_SPEED"));
}

TEST_CASE("A device that does not move in the base case needs no run") {
  Planning bench;
  const Fault fault{Fault::Mode::stuck, "L_P_M", "", "", {}, {bench.plant.unit("L_P_M")}};
  CHECK_FALSE(bench.planned(fault).front().needed);
  bench.base.log.units = {{700 * kMs, 0, bench.plant.unit("L_P_M")}};
  CHECK(bench.planned(fault).front().needed);
}

TEST_CASE("With all phases a fault begins at each change of its inputs and devices, too") {
  Planning bench;
  bench.set_base({{0, "L_P_B_I_X", 1}, {1000, "L_P_A_I_X", 1}, {2000, "L_P_A_I_X", 0}});
  const Fault fault{Fault::Mode::stuck_on, "L_P_A_I_X", "", "", {bench.plant.symbol("L_P_A_I_X")}, {}};
  const std::vector<Planned> all = bench.planned(fault, Phases::all);
  REQUIRE(all.size() == 3);
  CHECK(all[0].phase == "from the start");
  CHECK(all[1].at == 1000 * kMs);
  CHECK(all[1].phase == "just before L_P_A_I_X goes on");
  CHECK(all[2].phase == "just before L_P_A_I_X goes off");
  // What changes at the start is the phase from the start.
  CHECK(bench.planned({Fault::Mode::loose, "", "", "", {bench.plant.symbol("L_P_B_I_X")}, {}}, Phases::all).size() ==
        1);
  const std::uint32_t motor = bench.plant.unit("L_P_M");
  plant::UnitView moving{};
  moving.moving = true;
  bench.base.log.units = {{500 * kMs, trace::pack_unit(moving), motor}, {1500 * kMs, 1, motor}};
  const std::vector<Planned> moves = bench.planned({Fault::Mode::stuck, "", "", "", {}, {motor}}, Phases::all);
  REQUIRE(moves.size() == 3);
  CHECK(contains(moves[1].phase, "just before L_P_M leaves "));
  CHECK(contains(moves[2].phase, "just before L_P_M reaches "));
}

}  // namespace
}  // namespace symplant::campaign
