// Ten thousand devices under the guard: simple ones, and ones that the engine keeps a record for.
#include <bit>

#include "bench/two_state_plant.hpp"
#include "rt/expect_nothing.hpp"

namespace symplant::test {
namespace {

constexpr std::uint32_t kDevices = 10'000;

/// The controller of a closed loop: sends arrived devices back.
struct Controller {
  std::vector<std::uint64_t> seen;
  long motions = 0;

  void answer(plant::Plant& plant) noexcept {
    for (const std::uint32_t word : plant.changed_events()) {
      const std::uint64_t now = plant.events()[word];
      std::uint64_t arrived = now & ~seen[word];
      seen[word] = now;
      for (; arrived != 0; arrived &= arrived - 1) {
        const auto bit = static_cast<std::uint32_t>(std::countr_zero(arrived));
        const std::uint64_t both = std::uint64_t{3} << (bit & ~1U);
        plant.set_operations(word, both, std::uint64_t{1} << (bit ^ 1));
        ++motions;
      }
    }
    plant.forget_changed_events();
  }
};

template <class Made>
void runs_clean(long least_motions) {
  Made made(kDevices, {100 * tables::kMillisecond, 137 * tables::kMillisecond, 1'000'003});
  plant::Plant& plant = *made.plant;
  Controller controller{std::vector<std::uint64_t>(made.tables.event_bits / 64)};
  std::vector<std::byte> saved(plant.save().size());
  bool restored = false;
  const GuardReport report = run_guarded([&] {
    plant.reset(1);
    plant.advance_to(0);
    controller.answer(plant);
    for (tables::Time scan = 1; scan <= 100; ++scan) {
      plant.advance_to(scan * 10 * tables::kMillisecond);
      controller.answer(plant);
      if (scan == 50) {
        const auto block = plant.save();
        std::copy(block.begin(), block.end(), saved.begin());
      }
    }
    const std::uint64_t hash = plant.state_hash();
    restored = plant.restore(saved) && plant.state_hash() != hash;
    for (std::uint32_t unit = 0; unit < kDevices; unit += 7) plant.set_state(unit, 1);
    plant.advance_to(plant.now() + tables::kSecond);
  });
  REQUIRE(restored);
  REQUIRE(controller.motions > least_motions);
  expect_nothing(report);
}

TEST_CASE("Ten thousand simple devices run without heap, lock or system call") {
  runs_clean<bench::TwoStatePlant>(100'000);
}

TEST_CASE("Ten thousand devices with conditions and disables run without heap, lock or system call") {
  runs_clean<bench::RichPlant>(10'000);
}

}  // namespace
}  // namespace symplant::test
