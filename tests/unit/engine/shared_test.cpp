// Symbols of one address have equal values, values start as initialized.
#include <vector>

#include "support/catch.hpp"
#include "symplant/plant/owned_plant.hpp"

namespace symplant::test {
namespace {

using tables::AddressForm;
using tables::DataType;
using tables::Direction;
using tables::kNone;

/// A double solenoid (operations and events 0 and 1), free bits 2 and 3 that follow its bits 1, two numeric operations
/// on one address, a free event that starts on, and a numeric event that starts at 7.
struct SharedPlant {
  std::vector<tables::Transition> transitions{{1, 0, 0}, {0, 1, 1}};
  std::vector<tables::EventMasks> enter{{1, 0}, {2, 0}};
  std::vector<tables::EventMasks> leave{{0, 1}, {0, 2}};
  std::vector<std::uint8_t> targets{0, 1};
  std::vector<tables::TransitionTimes> times{{0, 10}};
  std::vector<tables::TypeRow> types{
      {2, 2, 2, tables::kNoState, tables::Actuation::latched, transitions, enter, leave, targets, times}};
  std::vector<tables::UnitRow> units{{0, 0, 0, 0, 0, 0}};
  std::vector<tables::SymbolRow> symbols{
      {1, 0, 1, 1, tables::symbol_kind(DataType::boolean, Direction::operation, AddressForm::number, true)},
      {2, kNone, 1, 2, tables::symbol_kind(DataType::boolean, Direction::operation, AddressForm::number, false)},
      {1, 0, 1, 3, tables::symbol_kind(DataType::boolean, Direction::event, AddressForm::number, true)},
      {2, kNone, 1, 4, tables::symbol_kind(DataType::boolean, Direction::event, AddressForm::number, false)},
      {3, kNone, 2, 5, tables::symbol_kind(DataType::boolean, Direction::event, AddressForm::number, false)},
      {0, kNone, 5, 6, tables::symbol_kind(DataType::int_, Direction::operation, AddressForm::number, false)},
      {1, kNone, 5, 7, tables::symbol_kind(DataType::int_, Direction::operation, AddressForm::number, false)},
      {0, kNone, 6, 8, tables::symbol_kind(DataType::int_, Direction::event, AddressForm::number, false)}};
  std::vector<tables::InitialValue> initial{{4, 1}, {7, 7}};
  std::vector<tables::SharedAddress> shared{{1, 0}, {3, 2}, {6, 5}};
  tables::PlantTables tables = rows();
  plant::OwnedPlant plant{tables};

  tables::PlantTables rows() const {
    tables::PlantTables all{};
    all.name = "shared";
    all.types = types;
    all.units = units;
    all.symbols = symbols;
    all.initial_values = initial;
    all.shared_addresses = shared;
    all.operation_bits = all.event_bits = 64;
    all.operation_slots = 2;
    all.event_slots = 1;
    return all;
  }
};

TEST_CASE("Writing one operation of an address writes all of them") {
  SharedPlant p;
  p.plant.advance_to(0);
  p.plant.set_operation(2, true);  // the follower
  p.plant.advance_to(1);
  CHECK(p.plant.operation(1));
  CHECK(p.plant.operation(2));
  CHECK(p.plant.unit(0).moving);
  p.plant.set_operation(1, false);
  p.plant.advance_to(2);
  CHECK_FALSE(p.plant.operation(2));
  p.plant.set_operation_value(1, 42);
  p.plant.advance_to(3);
  CHECK(p.plant.operation_value(0) == 42);
}

TEST_CASE("An event's other names follow the one that a unit drives") {
  SharedPlant p;
  p.plant.advance_to(0);
  CHECK_FALSE(p.plant.event(2));
  p.plant.set_operation(1, true);
  p.plant.advance_to(1);
  p.plant.advance_to(11);
  CHECK(p.plant.event(1));
  CHECK(p.plant.event(2));
}

TEST_CASE("A value that no unit drives keeps its initial value") {
  SharedPlant p;
  p.plant.advance_to(0);
  CHECK(p.plant.event(3));
  CHECK(p.plant.event_value(0) == 7);
}

}  // namespace
}  // namespace symplant::test
