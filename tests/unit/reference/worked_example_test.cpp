// The paper's Figure 6 on the reference.
#include "support/worked_example.hpp"

#include "bench.hpp"

namespace symplant::test {
namespace {

TEST_CASE("The reference plays the paper's cell") {
  Bench bench({"AGV_I_P1", "AGV_I_P2", "AGV_O_P1", "AGV_O_P2", "MC_I_IDLE1", "MC_I_RUN2", "MC_O_IDLE1", "MC_O_RUN2"});
  for (const ExampleRow& row : worked_example()) {
    INFO("at " << row.milliseconds << " ms");
    if (row.milliseconds > 0) bench.plant.advance_to(row.milliseconds * kMs - 1);
    for (const auto& [name, on] : row.writes) bench.set(std::string(name), on);
    bench.at(row.milliseconds);
    std::string wanted;
    for (const char c : " " + std::string(row.changes)) {
      wanted += c == ' ' ? " " + std::to_string(row.milliseconds) + ":" : std::string(1, c);
    }
    CHECK(" " + bench.changes() == wanted);
    CHECK(bench.state("AGV") == row.agv);
    CHECK(bench.state("MC") == row.mc);
  }
  CHECK(bench.plant.next_due() == tables::kNever);
}

TEST_CASE("A saved and restored plant runs the same again, to the same digest") {
  Bench bench({"AGV_I_P1", "AGV_I_P2", "AGV_O_P1", "AGV_O_P2"});
  bench.at(0).set("AGV_O_P2", true).at(500);
  const reference::World saved = bench.plant.save();
  const auto run = [&] {
    bench.plant.clear_instants();
    bench.at(700).set("AGV_O_P2", false).set("AGV_O_P1", true).at(5000);
    return bench.changes() + " " + std::to_string(bench.plant.state_hash());
  };
  const std::string first = run();
  bench.plant.restore(saved);
  CHECK(run() == first);
}

}  // namespace
}  // namespace symplant::test
