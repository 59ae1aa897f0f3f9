// Each archetype of a naming rule is equal to a device that plant.json describes under the built-in rule.
#include <array>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/compile.hpp"
#include "symplant/plant/owned_plant.hpp"

namespace symplant {
namespace {

using description::Duration;
using name::ArchetypeModel;
using name::ArchetypeRole;

constexpr tables::Time kMs = tables::kMillisecond;

/// A plant, run by numbers of its symbols.
class Run {
 public:
  explicit Run(test::CompiledText text) : text_(std::move(text)) {
    REQUIRE(text_.compiled);
    tables_ = text_.tables().tables();
    plant_.emplace(tables_);
  }

  /// The events after `toggles` random changes of operations, with their times: "0:10 250:11 ...". With `by_hand` the
  /// device is also put into states at random.
  std::string events(std::uint32_t seed, int toggles, bool by_hand) {
    std::mt19937 random(seed);
    std::string trace;
    std::string last;
    tables::Time now = 0;
    for (int i = 0; i < toggles; ++i) {
      const std::size_t symbol = random() % tables_.symbols.size();
      const tables::SymbolRow& row = tables_.symbols[symbol];
      if (row.direction() == tables::Direction::operation)
        plant_->set_operation(row.index, !plant_->operation(row.index));
      if (by_hand && random() % 3 == 0) {
        const auto state = random() % model().units[0].states.size();
        plant_->set_state(0, static_cast<std::uint8_t>(state_called(kStates[state % kStates.size()])));
      }
      // Steps of 50 ms between the toggles show when events change.
      for (auto steps = random() % 12; steps > 0; --steps) {
        plant_->advance_to(now += 50 * kMs);
        const std::string bits = bits_now();
        if (bits != last) trace += std::to_string(now / kMs) + ":" + bits + " ";
        last = bits;
      }
    }
    return trace;
  }

  const model::PlantModel& model() const { return text_.plant(); }

 private:
  static constexpr std::array<std::string_view, 3> kStates = {"IDLE", "RUN", "DONE"};

  std::size_t state_called(std::string_view name) const {
    const auto& states = model().units[0].states;
    for (std::size_t s = 0; s < states.size(); ++s) {
      if (states[s].name == name) return s;
    }
    return 0;
  }

  std::string bits_now() const {
    std::string bits;
    for (const tables::SymbolRow& row : tables_.symbols) {
      if (row.direction() == tables::Direction::event) bits += plant_->event(row.index) ? '1' : '0';
    }
    return bits;
  }

  test::CompiledText text_;
  tables::PlantTables tables_;
  std::optional<plant::OwnedPlant> plant_;
};

/// Checks that a list under an archetype and one under the built-in rule give the same events.
void check_equal(const name::Archetype& archetype, const std::vector<std::string>& symbols,
                 const std::vector<std::string>& strict, const description::DeviceDescription& by_hand,
                 bool put_by_hand = false) {
  name::Naming naming;
  naming.rules.emplace_back().patterns.push_back({name::Source::name, "{device}_{task...}"});
  naming.archetypes.push_back(archetype);
  std::vector<test::Row> rows = test::bits(strict);
  const std::string described = test::list_text(rows);
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].name = symbols[i];
  description::Description description;
  description.devices.push_back(by_hand);

  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    Run first(test::lower_analysed(test::analyse_by_rule(naming, {{"list.csv", test::list_text(rows)}})));
    Run second(test::lower_analysed(test::analyse_described(described, description)));
    REQUIRE(first.model().units.size() == 1);
    REQUIRE(second.model().units.size() == 1);
    const std::string events = first.events(seed, 100, put_by_hand);
    CHECK(events == second.events(seed, 100, put_by_hand));
    CHECK(events.size() > 40);
  }
}

description::GivenTransition commanded(std::string from, std::string to, std::string on, tables::Time takes,
                                       bool once = false) {
  description::GivenTransition given;
  given.from = std::move(from);
  given.to = std::move(to);
  given.on = std::move(on);
  given.takes = Duration::fixed(takes);
  given.once = once;
  return given;
}

description::GivenTransition automatic(std::string from, std::string to, std::string when, tables::Time after) {
  description::GivenTransition given;
  given.from = std::move(from);
  given.to = std::move(to);
  given.when = std::move(when);
  given.automatic = true;
  given.after = Duration::fixed(after);
  return given;
}

description::DeviceDescription device(std::string initial, std::vector<std::string> states = {}) {
  description::DeviceDescription described;
  described.path = "L_P_RB";
  described.initial = std::move(initial);
  described.states = std::move(states);
  described.actuation = tables::Actuation::latched;
  described.only = true;
  return described;
}

TEST_CASE("A mirror is a device whose event follows its operation") {
  for (const bool inverted : {false, true}) {
    name::Archetype mirror{
        "echo", ArchetypeModel::mirror, {{ArchetypeRole::operation, "GO"}, {ArchetypeRole::event, "GO ECHO"}}};
    mirror.delay = 150 * kMs;
    mirror.inverted = inverted;
    auto by_hand = device("OFF", inverted ? std::vector<std::string>{} : std::vector<std::string>{"OFF"});
    auto on = commanded("OFF", "ON", "ON", 0);
    on.after = Duration::fixed(150 * kMs);
    by_hand.transitions = {on, automatic("ON", "OFF", "not L_P_RB_O_ON", 150 * kMs)};
    check_equal(mirror, {"RB_GO", "RB_GO_ECHO"}, {"L_P_RB_O_ON", inverted ? "L_P_RB_I_OFF" : "L_P_RB_I_ON"}, by_hand);
  }
}

TEST_CASE("A handshake runs once for each start, and is done until it is acknowledged") {
  name::Archetype work{"work",
                       ArchetypeModel::handshake,
                       {{ArchetypeRole::start, "GO"},
                        {ArchetypeRole::busy, "BUSY"},
                        {ArchetypeRole::done, "COMP"},
                        {ArchetypeRole::ack, "COMP ECHO"},
                        {ArchetypeRole::reset, "RST"}}};
  work.takes = 400 * kMs;
  auto by_hand = device("IDLE", {"IDLE"});
  by_hand.transitions = {commanded("IDLE", "RUN", "RUN", 0), automatic("RUN", "DONE", "", 400 * kMs),
                         commanded("DONE", "IDLE", "ACK", 0, true), commanded("RUN", "IDLE", "RESET", 0, true),
                         commanded("DONE", "IDLE", "RESET", 0, true)};
  check_equal(work, {"RB_GO", "RB_BUSY", "RB_COMP", "RB_COMP_ECHO", "RB_RST"},
              {"L_P_RB_O_RUN", "L_P_RB_I_RUN", "L_P_RB_I_DONE", "L_P_RB_O_ACK", "L_P_RB_O_RESET"}, by_hand);
}

TEST_CASE("A handshake without acknowledge is idle again when the start is off") {
  name::Archetype work{
      "work", ArchetypeModel::handshake, {{ArchetypeRole::start, "GO"}, {ArchetypeRole::done, "COMP"}}};
  work.takes = 400 * kMs;
  auto by_hand = device("IDLE", {"IDLE"});
  by_hand.transitions = {commanded("IDLE", "RUN", "RUN", 0), automatic("RUN", "DONE", "", 400 * kMs),
                         automatic("DONE", "IDLE", "not L_P_RB_O_RUN", 0)};
  check_equal(work, {"RB_GO", "RB_COMP"}, {"L_P_RB_O_RUN", "L_P_RB_I_DONE"}, by_hand);
}

TEST_CASE("A handshake without start stays idle until something else moves it") {
  name::Archetype work{
      "work", ArchetypeModel::handshake, {{ArchetypeRole::done, "COMP"}, {ArchetypeRole::ack, "COMP ECHO"}}};
  work.takes = 400 * kMs;
  auto by_hand = device("IDLE", {"IDLE", "RUN"});
  by_hand.transitions = {automatic("RUN", "DONE", "", 400 * kMs), commanded("DONE", "IDLE", "ACK", 0, true)};
  check_equal(work, {"RB_COMP", "RB_COMP_ECHO"}, {"L_P_RB_I_DONE", "L_P_RB_O_ACK"}, by_hand, true);
}

TEST_CASE("A device of two positions is bistable, or a spring if it has one command") {
  name::Archetype lift{"lift",
                       ArchetypeModel::two_position,
                       {{ArchetypeRole::a, "LOWER"},
                        {ArchetypeRole::b, "RAISE"},
                        {ArchetypeRole::at_a, "LOW"},
                        {ArchetypeRole::at_b, "HIGH"}}};
  lift.takes = 350 * kMs;
  auto by_hand = device("A");
  by_hand.actuation = tables::Actuation::bistable;
  by_hand.transitions = {commanded("A", "B", "B", 350 * kMs), commanded("B", "A", "A", 350 * kMs)};
  check_equal(lift, {"RB_LOWER", "RB_RAISE", "RB_LOW", "RB_HIGH"},
              {"L_P_RB_O_A", "L_P_RB_O_B", "L_P_RB_I_A", "L_P_RB_I_B"}, by_hand);
  by_hand.actuation = tables::Actuation::spring;
  by_hand.transitions = {commanded("A", "B", "B", 350 * kMs), commanded("B", "A", "", 350 * kMs)};
  by_hand.rest = "A";
  check_equal(lift, {"RB_RAISE", "RB_LOW", "RB_HIGH"}, {"L_P_RB_O_B", "L_P_RB_I_A", "L_P_RB_I_B"}, by_hand);
}

TEST_CASE("A contactor pulls in after its delay and drops at once") {
  name::Archetype contactor{
      "motor", ArchetypeModel::contactor, {{ArchetypeRole::on, "RUN"}, {ArchetypeRole::is_on, "RUN FB"}}};
  contactor.delay = 200 * kMs;
  auto by_hand = device("OFF", {"OFF"});
  by_hand.actuation = tables::Actuation::spring;
  by_hand.rest = "OFF";
  by_hand.transitions = {commanded("OFF", "ON", "ON", 200 * kMs), commanded("ON", "OFF", "", 0)};
  check_equal(contactor, {"RB_RUN", "RB_RUN_FB"}, {"L_P_RB_O_ON", "L_P_RB_I_ON"}, by_hand);
}

TEST_CASE("A constant keeps its value from the start") {
  name::Naming naming;
  naming.rules.emplace_back().patterns.push_back({name::Source::name, "{device}_{task...}"});
  naming.archetypes.push_back({"healthy", ArchetypeModel::constant, {{ArchetypeRole::event, "*OK"}}});
  naming.archetypes.push_back(
      {"go", ArchetypeModel::mirror, {{ArchetypeRole::operation, "GO"}, {ArchetypeRole::event, "GONE"}}});
  std::vector<test::Row> rows = test::bits({"RB_I_AIR_OK", "RB_I_GONE", "RB_O_GO"});
  rows[0].name = "RB_AIR_OK";
  rows[1].name = "RB_GONE";
  rows[2].name = "RB_GO";
  Run run(test::lower_analysed(test::analyse_by_rule(naming, {{"list.csv", test::list_text(rows)}})));
  const std::string events = run.events(1, 200, false);
  CHECK(events.starts_with("50:10 "));
  CHECK(events.find(":00") == std::string::npos);
  CHECK(events.find(":11") != std::string::npos);
}

}  // namespace
}  // namespace symplant
