// A plant with user code, generated and compiled: it equals the lowered plant, does what the code says,
// and continues from a saved state as before.
#include <bit>
#include <string>
#include <tuple>
#include <vector>

#include "dosing.hpp"
#include "dosing/plant_gen.hpp"
#include "dosing/types_gen.hpp"
#include "symplant/plant/owned_plant.hpp"
#include "symplant/tables/digest.hpp"
#include "symplant/trace/recorder.hpp"

namespace symplant::test {
namespace {

using ::dosing::Scale;
using ::dosing::Symbol;
constexpr tables::Time kMs = tables::kMillisecond;

const tables::SymbolRow& row(Symbol symbol) { return ::dosing::tables().symbols[static_cast<std::size_t>(symbol)]; }

/// A plant, and the values of its symbols.
class Watched {
 public:
  explicit Watched(plant::Plant& plant) : plant_(plant), recorder_(plant.tables(), 1 << 12) { recorder_.attach(plant); }

  void set(Symbol symbol, bool on) { plant_.set_operation(row(symbol).index, on); }
  void set(Symbol symbol, double number) {
    plant_.set_operation_value(row(symbol).index, std::bit_cast<std::uint64_t>(number));
  }
  double number(Symbol symbol) const { return std::bit_cast<double>(plant_.event_value(row(symbol).index)); }
  bool event(Symbol symbol) const { return plant_.event(row(symbol).index); }
  void to(tables::Time time) {
    plant_.advance_to(time, &recorder_);
    recorder_.drain([&](const trace::Record& record) {
      if (record.kind == trace::Record::Kind::change) trace.emplace_back(record.time, record.of, record.value);
    });
  }

  std::vector<std::tuple<tables::Time, std::uint32_t, std::uint64_t>> trace;

 private:
  plant::Plant& plant_;
  trace::Recorder recorder_;
};

/// Scale 1 is filled with 2.5 kg and emptied repeatedly, scale 2 at the same time.
void work(Watched& plant, tables::Time from, tables::Time until) {
  for (tables::Time now = from; now < until; now += 500 * kMs) {
    const bool fill = (now / (3000 * kMs)) % 2 == 0;
    plant.set(Symbol::L1_DOSE_HOPPER_O_OPEN, (now / (7000 * kMs)) % 2 == 0);
    plant.set(Symbol::L1_DOSE_SCALE1_O_TARGET, 2.5);
    plant.set(Symbol::L1_DOSE_SCALE2_O_TARGET, 0.7);
    plant.set(Symbol::L1_DOSE_SCALE1_O_FULL2, fill);
    plant.set(Symbol::L1_DOSE_SCALE1_O_EMPTY1, !fill);
    plant.set(Symbol::L1_DOSE_SCALE2_O_FULL2, !fill);
    plant.set(Symbol::L1_DOSE_SCALE2_O_EMPTY1, fill);
    plant.to(now);
  }
}

TEST_CASE("A scale shows the weight while it fills, stops near its target and counts its batches") {
  const auto owned = ::dosing::make_plant();
  Watched plant(*owned);
  plant.to(0);
  plant.set(Symbol::L1_DOSE_SCALE1_O_TARGET, 3.0);
  plant.set(Symbol::L1_DOSE_SCALE1_O_FULL2, true);
  plant.to(1000 * kMs);
  plant.to(1450 * kMs);
  CHECK(plant.number(Symbol::L1_DOSE_SCALE1_I_WEIGHT) == Catch::Approx(0.8));  // shown at 1.4 s: fine flow, 2 kg/s
  plant.to(2499 * kMs);
  CHECK_FALSE(plant.event(Symbol::L1_DOSE_SCALE1_I_FULL2));
  plant.to(2500 * kMs);
  CHECK(plant.event(Symbol::L1_DOSE_SCALE1_I_FULL2));
  const double full = plant.number(Symbol::L1_DOSE_SCALE1_I_WEIGHT);
  CHECK(full >= 2.9999);
  CHECK(full <= 3.0201);
  CHECK(owned->event_value(row(Symbol::L1_DOSE_SCALE1_I_BATCHES).index) == 1);
  CHECK(plant.number(Symbol::L1_DOSE_SCALE2_I_WEIGHT) == 0);

  plant.set(Symbol::L1_DOSE_SCALE1_O_FULL2, false);
  plant.set(Symbol::L1_DOSE_SCALE1_O_EMPTY1, true);
  plant.to(3000 * kMs);
  plant.to(4499 * kMs);
  CHECK(plant.number(Symbol::L1_DOSE_SCALE1_I_WEIGHT) == full);
  plant.to(4500 * kMs);  // as in the description, by model_takes
  CHECK(plant.number(Symbol::L1_DOSE_SCALE1_I_WEIGHT) == 0);
}

TEST_CASE("A condition in its inputs lets a scale fill five times as fast") {
  const auto owned = ::dosing::make_plant();
  Watched plant(*owned);
  plant.set(Symbol::L1_DOSE_HOPPER_O_OPEN, true);
  plant.to(0);
  plant.to(1000 * kMs);  // open
  plant.set(Symbol::L1_DOSE_SCALE1_O_TARGET, 3.0);
  plant.set(Symbol::L1_DOSE_SCALE1_O_FULL2, true);
  plant.to(2000 * kMs);
  plant.to(2300 * kMs);
  CHECK(plant.event(Symbol::L1_DOSE_SCALE1_I_FULL2));
}

TEST_CASE("A generated plant with behaviors equals the lowered plant, and does the same with the same code") {
  const CompiledText text = dosing();
  REQUIRE(text.compiled);
  const tables::PlantTables lowered = text.tables().tables();
  CHECK(tables::model_hash(::dosing::tables()) == tables::model_hash(lowered));
  const auto generated = ::dosing::make_plant();
  plant::OwnedPlant interpreted(lowered, ::dosing::behaviours());
  plant::OwnedPlant without(lowered);
  Watched a(*generated);
  Watched b(interpreted);
  Watched c(without);
  for (Watched* plant : {&a, &b, &c}) work(*plant, 0, 20'000 * kMs);
  CHECK(a.trace.size() > 100);
  CHECK(a.trace == b.trace);
  CHECK(generated->state_hash() == interpreted.state_hash());
  CHECK(c.trace != b.trace);
}

TEST_CASE("Save, run, restore and run again give the same trace and state, including behaviors and their memory") {
  const auto owned = ::dosing::make_plant();
  Watched plant(*owned);
  work(plant, 0, 7300 * kMs);
  const auto block = owned->save();
  const std::vector<std::byte> saved(block.begin(), block.end());
  const std::uint64_t hash = owned->state_hash();
  plant.trace.clear();
  work(plant, 7500 * kMs, 20'000 * kMs);
  const auto first = plant.trace;
  const std::uint64_t end = owned->state_hash();
  CHECK(first.size() > 50);
  CHECK(end != hash);

  REQUIRE(owned->restore(saved));
  CHECK(owned->state_hash() == hash);
  plant.trace.clear();
  work(plant, 7500 * kMs, 20'000 * kMs);
  CHECK(plant.trace == first);
  CHECK(owned->state_hash() == end);

  const auto other = ::dosing::make_plant();
  REQUIRE(other->restore(saved));
  Watched elsewhere(*other);
  work(elsewhere, 7500 * kMs, 20'000 * kMs);
  CHECK(elsewhere.trace == first);
  CHECK(other->state_hash() == end);
}

TEST_CASE("A behavior's memory is part of the state's digest") {
  const auto a = ::dosing::make_plant();
  const auto b = ::dosing::make_plant();
  for (auto* plant : {a.get(), b.get()}) plant->advance_to(0);
  CHECK(a->state_hash() == b->state_hash());
  // Filled by hand and emptied again: everything is as before except what the scale remembers.
  for (const auto state : {Scale::State::FULL2, Scale::State::EMPTY1}) {
    b->scale2().put(state);
  }
  for (auto* plant : {a.get(), b.get()}) plant->advance_to(tables::kSecond);
  CHECK(a->state_hash() != b->state_hash());
}

}  // namespace
}  // namespace symplant::test
