// Edge cases of the engine found in a review: the last word of a plane, blocks between plants with and without code,
// what behaviors see and may do.
#include <array>
#include <string>
#include <vector>

#include "support/plant_bench.hpp"
#include "symplant/engine/finding_ring.hpp"

namespace symplant::test {
namespace {

TEST_CASE("A unit without events after a full plane switches no event") {
  std::vector<std::string> names;
  for (int d = 0; d < 32; ++d) {
    for (const char* task : {"_O_A1", "_O_B2", "_I_A1", "_I_B2"}) names.push_back("D" + std::to_string(d) + task);
  }
  names.insert(names.end(), {"BLIND_O_A1", "BLIND_O_B2"});
  const BenchTables tables(names);
  REQUIRE(tables.rows.event_bits == 64);
  BenchPlant plant(tables);
  plant.to(0);
  plant.set("BLIND_O_B2", 1).to(1);
  plant.to(2000);
  CHECK(plant.state("BLIND") == "B2");
  for (int d = 0; d < 32; ++d) CHECK(plant.on("D" + std::to_string(d) + "_I_A1"));
}

/// ARM has a behavior without memory, which counts its calls.
int asked = 0;
const std::array<engine::Behaviour, 1> kAsking{engine::Behaviour{.wanted = [](engine::BehaviourView& view) noexcept {
  ++asked;
  return view.value(0) == 7 ? std::uint8_t{200} : tables::kNoState;  // 200 is not a state of ARM
}}};

const BenchTables& asking() {
  static const BenchTables tables = [] {
    Reported reported;
    reported.device("ARM").behaviour = "Asking";
    return BenchTables(reported,
                       {{"L_P_ARM_O_A1"}, {"L_P_ARM_I_A1"}, {"L_P_ARM_I_B2"}, {"L_P_ARM_I_LEVEL", "", "INT"}});
  }();
  return tables;
}

TEST_CASE("A behavior is called again when a number of its device is set, and an unknown state is ignored") {
  plant::OwnedPlant plant(asking().rows, kAsking);
  plant.advance_to(0);
  asked = 0;
  REQUIRE(plant.set_input(asking().symbol("ARM_I_LEVEL"), 7));
  plant.advance_to(0);
  CHECK(asked > 0);
  CHECK(plant.unit(0).state == 0);
  plant.set_state(0, 200);
  plant.advance_to(0);
  CHECK(plant.unit(0).state == 0);
}

TEST_CASE("A block of a plant with code continues in one without, and the reverse") {
  plant::OwnedPlant with(asking().rows, kAsking);
  plant::OwnedPlant without(asking().rows);
  with.advance_to(0);
  REQUIRE(without.restore(with.save()));
  without.set_operation(0, true);
  without.advance_to(tables::kSecond);
  asked = 0;
  REQUIRE(with.restore(without.save()));
  with.set_operation(0, false);
  with.advance_to(2 * tables::kSecond);
  CHECK(asked > 0);
}

/// Requests a wake-up where it may only read.
const std::array<engine::Behaviour, 1> kWaking{engine::Behaviour{
    .wanted =
        [](engine::BehaviourView& view) noexcept {
          view.wake_at(view.now());
          return tables::kNoState;
        },
    .woken = [](engine::BehaviourView&) noexcept { ++asked; },
}};

TEST_CASE("A wake-up request in `wanted` leaves nothing that a reset or a restore would lose") {
  plant::OwnedPlant plant(asking().rows, kWaking);
  plant::OwnedPlant copy(asking().rows, kWaking);
  for (int i = 0; i < 20; ++i) {
    plant.reset();
    plant.advance_to(0);
    REQUIRE(copy.restore(plant.save()));
    asked = 0;
    plant.set_operation(0, i % 2 == 0);
    plant.advance_to(tables::kSecond);
    const int here = asked;
    asked = 0;
    copy.set_operation(0, i % 2 == 0);
    copy.advance_to(tables::kSecond);
    CHECK(asked == here);
    CHECK(copy.state_hash() == plant.state_hash());
  }
}

/// Takes twice as long as the model says, for transitions and causes.
const std::array<engine::Behaviour, 1> kSlow{engine::Behaviour{
    .takes = [](engine::BehaviourView& view,
                std::uint16_t transition) noexcept { return 2 * view.model_takes(transition); },
    .after = [](engine::BehaviourView& view,
                std::uint16_t transition) noexcept { return 2 * view.model_after(transition); },
}};

TEST_CASE("A behavior may query the model's own rule, also without a command and for a random time") {
  Reported reported;
  reported.device("CYL").behaviour = "Slow";
  reported.on_command("CYL", "RET", "ADV", {description::Duration::Kind::uniform, 700 * kMs, 900 * kMs});
  reported.by_itself("CYL", "ADV", "RET",
                     {description::Duration::Kind::uniform, 5 * tables::kSecond, 6 * tables::kSecond});
  const BenchTables tables({"CYL_O_ADV", "CYL_I_ADV", "CYL_I_RET"}, reported);
  plant::OwnedPlant slow(tables.rows, kSlow);
  plant::OwnedPlant own(tables.rows);
  for (plant::Plant* plant : {static_cast<plant::Plant*>(&slow), static_cast<plant::Plant*>(&own)}) {
    plant->reset(7);
    plant->advance_to(0);
    plant->set_operation(0, true);
    plant->advance_to(tables::kSecond);
  }
  CHECK(own.unit(0).remaining >= 700 * kMs);
  CHECK(slow.unit(0).remaining == 2 * own.unit(0).remaining);
  own.advance_to(own.next_due());
  slow.advance_to(slow.next_due());
  REQUIRE_FALSE(own.unit(0).moving);
  REQUIRE_FALSE(slow.unit(0).moving);
  CHECK(slow.next_due() - slow.now() == 2 * (own.next_due() - own.now()));
  for (plant::Plant* plant : {static_cast<plant::Plant*>(&slow), static_cast<plant::Plant*>(&own)}) {
    plant->set_operation(0, false);  // spring return, of the default travel time
    plant->advance_to(plant->now() + 1);
  }
  CHECK(own.unit(0).remaining == tables::kSecond);
  CHECK(slow.unit(0).remaining == 2 * tables::kSecond);
}

TEST_CASE("A loop cut off by a full ring ends with the last stored finding") {
  std::vector<std::max_align_t> memory(1024);
  engine::Arena arena(reinterpret_cast<std::byte*>(memory.data()));
  engine::FindingRing ring;
  ring.take(arena);
  for (std::uint32_t unit = 0; unit < engine::FindingRing::kCapacity + 10; ++unit) {
    ring.add({0, unit, tables::FindingKind::instantaneous_loop, true});
  }
  tables::Finding last{};
  while (ring.pop(last)) CHECK(last.more == (last.of + 1 != engine::FindingRing::kCapacity));
  CHECK(last.of + 1 == engine::FindingRing::kCapacity);
  CHECK(ring.lost() == 10);
}

}  // namespace
}  // namespace symplant::test
