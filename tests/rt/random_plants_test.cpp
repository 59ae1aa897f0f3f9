// Random plants of every feature, with random stimuli: the whole Plant interface under the guard.
#include "lower/lower.hpp"
#include "property/behaviours.hpp"
#include "property/random_plant.hpp"
#include "rt/exercise.hpp"
#include "rt/expect_nothing.hpp"

namespace symplant::test {
namespace {

constexpr std::uint64_t kPlants = 300;

/// Reads what the behaviors of the random plants do not read.
void look_round(engine::BehaviourView& view, std::uint8_t) noexcept {
  static_cast<void>(view.quality());
  static_cast<void>(view.target());
}

TEST_CASE("No member of Plant uses heap, lock or system call, for any plant and any action") {
  Happened all;
  GuardReport last;
  for (std::uint64_t seed = 1; seed <= kPlants; ++seed) {
    const property::DrawnPlant drawn = property::random_plant(seed);
    const lower::EngineTables lowered = lower::lower(drawn.model);
    const tables::PlantTables tables = lowered.tables();
    std::vector<engine::Behaviour> behaviours = property::engine_behaviours(tables);
    for (engine::Behaviour& behaviour : behaviours) {
      if (behaviour.entered == nullptr) behaviour.entered = look_round;
    }
    Exercise exercise(drawn.model, tables, behaviours, property::random_stimulus(seed, drawn.model));
    exercise.run();
    const Happened free = exercise.happened();
    last = run_guarded([&] { exercise.run(); });
    INFO("plant " << seed);
    INFO(last.text());
    REQUIRE(last.count == 0);
    // The run under the guard is identical to the last bit.
    REQUIRE(exercise.happened().digest == free.digest);
    all += free;
  }
  // The guard checks only what happened, so all of this must happen.
  REQUIRE(all.instants > 10'000);
  REQUIRE(all.restores > 100);
  REQUIRE(all.restores_elsewhere > 50);
  REQUIRE(all.refused_blocks == all.restores);
  for (std::size_t kind = 0; kind < all.findings.size(); ++kind) {
    INFO("finding " << kind);
    REQUIRE(all.findings[kind] > 0);
    REQUIRE(all.findings_reported[kind] >= all.findings[kind]);
  }
  expect_trap(last);
}

}  // namespace
}  // namespace symplant::test
