// model_hash: equal for equal tables, different if anything differs.
#include "symplant/tables/digest.hpp"

#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "support/catch.hpp"

namespace symplant::test {
namespace {

using tables::PlantTables;

/// Tables with a row of every kind.
struct Sample {
  std::vector<tables::Transition> transitions{{0, 1, 0}, {1, 0, tables::kNoOperation}};
  std::vector<tables::EventMasks> enter{{1, 0}, {2, 0}};
  std::vector<tables::EventMasks> leave{{0, 1}, {0, 2}};
  std::vector<std::uint8_t> targets{1};
  std::vector<tables::UnitRow> units{{0, 0, 0, 0, 0, 0}};
  std::vector<tables::TransitionTimes> type_times{{0, 5}, {1, 0}};
  std::uint16_t travel = 0;
  std::vector<tables::TransitionTimes> times{{0, 5}, {0, 6}, {7, 0}};
  std::vector<tables::RandomTime> random{{tables::RandomTime::Kind::uniform, 1, 2}};
  std::vector<tables::SymbolRow> symbols{{0, 0, 3, 2,
                                          tables::symbol_kind(tables::DataType::boolean, tables::Direction::operation,
                                                              tables::AddressForm::number, true)}};
  std::vector<tables::InitialValue> initial{{0, 1}};
  std::vector<tables::SharedAddress> shared{{0, 0}};
  std::vector<tables::DisableRow> disables{{0, 1, 1}};
  std::vector<tables::ConditionRow> conditions{{0b10, 0, 0, tables::ReaderKind::unit}};
  std::vector<tables::ConditionedUnit> conditioned{{0, 0}};
  std::vector<tables::UnitWatch> unit_watches{{0, 0, 1, 0}};
  std::vector<tables::BitWatch> operation_watches{{0, 0, 0}};
  std::vector<tables::BitWatch> event_watches{{0, 0, 0}};
  std::vector<tables::ValueWatch> operation_values{
      {5, 0, 0, 0, tables::Comparison::less, tables::NumberKind::signed_integer}};
  std::vector<tables::ValueWatch> event_values{{5, 0, 0, 0, tables::Comparison::less, tables::NumberKind::real}};
  std::vector<tables::RequirementRow> requirements{{tables::RequirementRow::Kind::expect, 0, 1, 9}};
  std::vector<tables::BehaviourUnit> behaviours{{0, 0, 0, 1, 0, 1}};
  std::vector<std::uint32_t> behaviour_values{3};
  std::vector<tables::MalfunctionRow> malfunctions{{{0, 1}, 0, false, 3, 4, 5, 0, 0}};
  std::vector<tables::EffectRow> effects{{tables::MalfunctionKind::slower, {0, 1}, {0, 1}, 3000, 0, 1, 2, 1, 0, 0}};
  std::vector<tables::MalfunctionUnit> malfunction_units{{0, 0}};
  std::vector<std::uint32_t> malfunction_tracks{0};
  std::vector<tables::MalfunctionForce> malfunction_forces{{0, 1, false}};
  std::vector<tables::MalfunctionSet> malfunction_sets{{0, 1}};
  std::uint8_t rest = tables::kNoState;
  tables::Actuation actuation = tables::Actuation::latched;
  std::string name = "plant";
  std::string unit_names{"U\0", 2};
  std::string state_names{"A\0B\0", 4};
  std::string symbol_names{"S\0Y3\0", 5};
  std::string requirement_names{"R\0", 2};
  std::string behaviour_names{"B\0", 2};
  std::string malfunction_names{"M\0", 2};
  std::string list_names{"list.csv\0", 9};
  std::string controller_names{"PLC1\0PLC2\0", 10};
  std::vector<tables::SymbolListRow> lists{{0, 0}};
  std::uint32_t operation_bits = 64;
  std::uint32_t event_bits = 64;
  std::uint32_t operation_slots = 0;
  std::uint32_t event_slots = 0;

  std::uint64_t hash() const {
    const std::vector<tables::TypeRow> types{
        {1, 2, 2, rest, actuation, transitions, enter, leave, targets, type_times, travel}};
    PlantTables tables{};
    tables.name = name;
    tables.types = types;
    tables.units = units;
    tables.times = times;
    tables.random_times = random;
    tables.symbols = symbols;
    tables.initial_values = initial;
    tables.shared_addresses = shared;
    tables.disables = disables;
    tables.conditions = conditions;
    tables.conditioned_units = conditioned;
    tables.unit_watches = unit_watches;
    tables.operation_watches = operation_watches;
    tables.event_watches = event_watches;
    tables.operation_value_watches = operation_values;
    tables.event_value_watches = event_values;
    tables.requirements = requirements;
    tables.behaviour_units = behaviours;
    tables.behaviour_values = behaviour_values;
    tables.operation_bits = operation_bits;
    tables.event_bits = event_bits;
    tables.operation_slots = operation_slots;
    tables.event_slots = event_slots;
    tables.unit_names = unit_names;
    tables.state_names = state_names;
    tables.symbol_names = symbol_names;
    tables.requirement_names = requirement_names;
    tables.behaviour_names = behaviour_names;
    tables.list_names = list_names;
    tables.controller_names = controller_names;
    tables.lists = lists;
    tables.malfunctions = {malfunctions,       effects,          malfunction_units, malfunction_tracks,
                           malfunction_forces, malfunction_sets, malfunction_names};
    return tables::model_hash(tables);
  }
};

TEST_CASE("Every field of every row changes the hash") {
  const std::vector<std::function<void(Sample&)>> changes{
      [](Sample& s) { s.transitions[0].from = 1; },
      [](Sample& s) { s.transitions[0].to = 0; },
      [](Sample& s) { s.transitions[1].on = 0; },
      [](Sample& s) { s.transitions[1].once = true; },
      [](Sample& s) { s.transitions[1].when = 0; },
      [](Sample& s) { s.transitions[1].when = 0xFF00; },
      [](Sample& s) { s.transitions[1].timed = true; },
      [](Sample& s) { s.enter[1].on = 3; },
      [](Sample& s) { s.enter[1].off = 1; },
      [](Sample& s) { s.leave[1].on = 1; },
      [](Sample& s) { s.leave[1].off = 3; },
      [](Sample& s) { s.targets[0] = 0; },
      [](Sample& s) { s.rest = 0; },
      [](Sample& s) { s.actuation = tables::Actuation::spring; },
      [](Sample& s) { s.units[0].type = 1; },
      [](Sample& s) { s.units[0].operation_bit = 1; },
      [](Sample& s) { s.units[0].event_bit = 1; },
      [](Sample& s) { s.units[0].times = 1; },
      [](Sample& s) { s.units[0].initial = 1; },
      [](Sample& s) { s.units[0].general = 1; },
      [](Sample& s) { s.transitions[1].dt = 1; },
      [](Sample& s) { s.type_times[0].takes = 7; },
      [](Sample& s) { s.type_times[1].after = 8; },
      [](Sample& s) {
        s.type_times.push_back({0, 0});
      },
      [](Sample& s) { s.travel = 1; },
      [](Sample& s) { s.times[1].takes = 7; },
      [](Sample& s) { s.times[2].after = 8; },
      [](Sample& s) { s.random[0].kind = tables::RandomTime::Kind::normal; },
      [](Sample& s) { s.random[0].a = 0; },
      [](Sample& s) { s.random[0].b = 3; },
      [](Sample& s) { s.symbols[0].index = 1; },
      [](Sample& s) { s.symbols[0].unit = tables::kNone; },
      [](Sample& s) { s.symbols[0].number = 4; },
      [](Sample& s) {
        s.symbols[0].kind = tables::symbol_kind(tables::DataType::int_, tables::Direction::operation,
                                                tables::AddressForm::number, true);
      },
      [](Sample& s) {
        s.symbols[0].kind =
            tables::symbol_kind(tables::DataType::boolean, tables::Direction::event, tables::AddressForm::number, true);
      },
      [](Sample& s) {
        s.symbols[0].kind = tables::symbol_kind(tables::DataType::boolean, tables::Direction::operation,
                                                tables::AddressForm::none, true);
      },
      [](Sample& s) {
        s.symbols[0].kind = tables::symbol_kind(tables::DataType::boolean, tables::Direction::operation,
                                                tables::AddressForm::number, false);
      },
      [](Sample& s) { s.initial[0].value = 0; },
      [](Sample& s) { s.initial[0].symbol = 1; },
      [](Sample& s) { s.shared[0].leader = 1; },
      [](Sample& s) { s.shared[0].symbol = 1; },
      [](Sample& s) { s.disables[0].by = 1; },
      [](Sample& s) { s.disables[0].unit = 0; },
      [](Sample& s) { s.disables[0].state = 0; },
      [](Sample& s) { s.conditions[0].truth = 1; },
      [](Sample& s) { s.conditions[0].reader = 1; },
      [](Sample& s) { s.conditions[0].reader_input = 1; },
      [](Sample& s) { s.conditions[0].reader_kind = tables::ReaderKind::requirement; },
      [](Sample& s) { s.conditioned[0].unit = 1; },
      [](Sample& s) { s.conditioned[0].first_condition = 1; },
      [](Sample& s) { s.unit_watches[0].unit = 1; },
      [](Sample& s) { s.unit_watches[0].condition = 1; },
      [](Sample& s) { s.unit_watches[0].state = tables::kMovingState; },
      [](Sample& s) { s.unit_watches[0].input = 1; },
      [](Sample& s) { s.operation_watches[0].bit = 1; },
      [](Sample& s) { s.operation_watches[0].condition = 1; },
      [](Sample& s) { s.operation_watches[0].input = 1; },
      [](Sample& s) { s.event_watches[0].bit = 1; },
      [](Sample& s) { s.event_watches[0].condition = 1; },
      [](Sample& s) { s.event_watches[0].input = 1; },
      [](Sample& s) { s.operation_values[0].operand = 6; },
      [](Sample& s) { s.operation_values[0].slot = 1; },
      [](Sample& s) { s.operation_values[0].condition = 1; },
      [](Sample& s) { s.operation_values[0].input = 1; },
      [](Sample& s) { s.operation_values[0].comparison = tables::Comparison::equal; },
      [](Sample& s) { s.operation_values[0].kind = tables::NumberKind::unsigned_integer; },
      [](Sample& s) { s.event_values[0].operand = 6; },
      [](Sample& s) { s.event_values[0].slot = 1; },
      [](Sample& s) { s.event_values[0].condition = 1; },
      [](Sample& s) { s.event_values[0].input = 1; },
      [](Sample& s) { s.event_values[0].comparison = tables::Comparison::equal; },
      [](Sample& s) { s.event_values[0].kind = tables::NumberKind::signed_integer; },
      [](Sample& s) { s.requirements[0].kind = tables::RequirementRow::Kind::never; },
      [](Sample& s) { s.requirements[0].condition = 1; },
      [](Sample& s) { s.requirements[0].expected = 0; },
      [](Sample& s) { s.requirements[0].within = 8; },
      [](Sample& s) { s.requirements[0].earliest = 1; },
      [](Sample& s) { s.behaviours[0].unit = 1; },
      [](Sample& s) { s.behaviours[0].name = 1; },
      [](Sample& s) { s.behaviours[0].first_input = 1; },
      [](Sample& s) { s.behaviours[0].input_count = 0; },
      [](Sample& s) { s.behaviours[0].first_value = 1; },
      [](Sample& s) { s.behaviours[0].value_count = 0; },
      [](Sample& s) { s.behaviour_values[0] = 4; },
      [](Sample& s) { s.effects[0].kind = tables::MalfunctionKind::stuck; },
      [](Sample& s) { s.effects[0].of.first = 1; },
      [](Sample& s) { s.effects[0].of.count = 0; },
      [](Sample& s) { s.effects[0].tracks.first = 1; },
      [](Sample& s) { s.effects[0].tracks.count = 0; },
      [](Sample& s) { s.effects[0].factor = 2000; },
      [](Sample& s) { s.effects[0].subject = 1; },
      [](Sample& s) { s.effects[0].every = 2; },
      [](Sample& s) { s.effects[0].shows = 3; },
      [](Sample& s) { s.effects[0].gain = 2; },
      [](Sample& s) { s.effects[0].offset = 1; },
      [](Sample& s) { s.effects[0].drift = 1; },
      [](Sample& s) { s.effects.push_back(s.effects[0]); },
      [](Sample& s) { s.malfunctions[0].effects.first = 1; },
      [](Sample& s) { s.malfunctions[0].effects.count = 0; },
      [](Sample& s) { s.malfunctions[0].during = true; },
      [](Sample& s) { s.malfunction_tracks[0] = 1; },
      [](Sample& s) { s.malfunction_forces[0].holds = true; },
      [](Sample& s) { s.malfunction_sets[0].value = 1; },
      [](Sample& s) { s.malfunction_sets[0].number = 2; },
      [](Sample& s) { s.malfunctions[0].condition = tables::kNone; },
      [](Sample& s) { s.malfunctions[0].chance = -1; },
      [](Sample& s) { s.malfunctions[0].lasts = -1; },
      [](Sample& s) { s.malfunctions[0].after = 0; },
      [](Sample& s) { s.malfunctions[0].next = tables::kNone; },
      [](Sample& s) { s.malfunctions[0].unless = tables::kNone; },
      [](Sample& s) { s.malfunctions.push_back(s.malfunctions[0]); },
      [](Sample& s) { s.malfunction_units[0].unit = 1; },
      [](Sample& s) { s.malfunction_units[0].state = tables::kNoState; },
      [](Sample& s) { s.malfunction_forces[0].symbol = 1; },
      [](Sample& s) { s.malfunction_forces[0].value = 0; },
      [](Sample& s) { s.malfunction_names[0] = 'N'; },
      [](Sample& s) { s.name = "plane"; },
      [](Sample& s) { s.unit_names[0] = 'V'; },
      [](Sample& s) { s.state_names[0] = 'C'; },
      [](Sample& s) { s.symbol_names[0] = 'T'; },
      [](Sample& s) { s.requirement_names[0] = 'Q'; },
      [](Sample& s) { s.behaviour_names[0] = 'C'; },
      [](Sample& s) { s.operation_bits = 128; },
      [](Sample& s) { s.event_bits = 128; },
      [](Sample& s) { s.operation_slots = 1; },
      [](Sample& s) { s.event_slots = 1; },
      [](Sample& s) { s.units.push_back(s.units[0]); },
      [](Sample& s) { s.initial.clear(); },
      [](Sample& s) { s.random.clear(); },
      [](Sample& s) { s.disables.clear(); },
      [](Sample& s) { s.operation_watches.clear(); },  // one watch, on one side or on the other
      [](Sample& s) { s.event_watches.clear(); },
      [](Sample& s) { std::swap(s.operation_values, s.event_values); },
  };
  std::set<std::uint64_t> hashes{Sample{}.hash()};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Sample sample;
    changes[i](sample);
    INFO("change " << i);
    CHECK(hashes.insert(sample.hash()).second);
  }
}

TEST_CASE("The controllers of symbols change the hash, and the division into lists does not") {
  Sample two;
  two.symbols.push_back(two.symbols[0]);
  two.symbols.push_back(two.symbols[0]);
  const std::uint64_t one_controller = two.hash();
  two.lists = {{0, 0}, {1, 0}, {3, 0}};
  CHECK(two.hash() == one_controller);
  two.lists = {{0, 0}, {1, 1}};
  const std::uint64_t second = two.hash();
  CHECK(second != one_controller);
  two.lists = {{0, 0}, {0, 1}, {0, 0}, {1, 1}, {2, 1}};
  CHECK(two.hash() == second);
  two.lists = {{0, 0}, {1, 1}, {2, 0}};
  CHECK(two.hash() != second);
  two.lists = {{0, 0}, {2, 1}};
  CHECK(two.hash() != second);
  Sample named;
  const std::uint64_t before = named.hash();
  named.controller_names = {"PLC1\0PLC3\0", 10};
  CHECK(named.hash() != before);
}

TEST_CASE("A plant without malfunctions digests none of their tables") {
  Sample without;
  without.malfunctions.clear();
  const std::uint64_t hash = without.hash();
  without.effects.clear();
  without.malfunction_units.clear();
  without.malfunction_tracks.clear();
  without.malfunction_forces.clear();
  without.malfunction_sets.clear();
  without.malfunction_names.clear();
  CHECK(without.hash() == hash);
}

TEST_CASE("The path of the list and the lines of symbols do not change the hash") {
  Sample sample;
  const std::uint64_t before = sample.hash();
  sample.list_names = {"other.csv\0", 10};
  sample.symbols[0].row = 99;
  CHECK(sample.hash() == before);
}

}  // namespace
}  // namespace symplant::test
