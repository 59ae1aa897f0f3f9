// Lists in the notations of other vendors: direction and its evidence, sizes, messages.
#include "description_support.hpp"
#include "model_support.hpp"

namespace symplant::test {
namespace {

using address::Notation;
using model::DirectionBy;

TEST_CASE("Each notation gives its symbols a direction and a type") {
  const Analysed siemens = analyse_in(Notation::siemens, {{"A", "E 0.0"}, {"B", "PAW 256", ""}, {"C", "T5", "TIMER"}});
  CHECK(symbol_of(siemens, "A").direction == tables::Direction::event);
  CHECK(symbol_of(siemens, "B").direction == tables::Direction::operation);
  CHECK(symbol_of(siemens, "B").type == tables::DataType::word);
  CHECK(internal(siemens, model::InternalReason::memory) == 1);
  const Analysed modbus = analyse_in(Notation::modbus, {{"A", "10001"}, {"B", "00002"}, {"C", "40001", "INT", "0"}});
  CHECK(symbol_of(modbus, "A").address->number == 0);
  CHECK(symbol_of(modbus, "B").direction == tables::Direction::operation);
  CHECK(internal(modbus, model::InternalReason::memory) == 1);
}

TEST_CASE("A holding register is an output if its name says so, and else memory") {
  const Analysed modbus =
      analyse_in(Notation::modbus, {{"L_P_D_O_SPEED", "40001", "INT", "0"}, {"B", "40002", "INT", "0"}});
  CHECK(symbol_of(modbus, "L_P_D_O_SPEED").direction == tables::Direction::operation);
  CHECK(symbol_of(modbus, "L_P_D_O_SPEED").address->number == 0);
  CHECK(internal(modbus, model::InternalReason::memory) == 1);
}

TEST_CASE("The type gives the size of an address whose text does not") {
  const Analysed list = analyse_in(Notation::rockwell, {{"A", "Local:4:I.Ch0Data", "INT", "0"},
                                                        {"B", "Local:4:I.Ch1Data", "REAL", "0"},
                                                        {"C", "Local:4:I.Ch2Data", "", ""},
                                                        {"D", "Local:1:I.Data.0", ""}});
  CHECK(symbol_of(list, "A").address->size == address::Size::word);
  CHECK(symbol_of(list, "B").address->size == address::Size::dword);
  CHECK(symbol_of(list, "C").type == tables::DataType::dword);
  CHECK(symbol_of(list, "D").type == tables::DataType::boolean);
  CHECK(list.count("type-against-address") == 0);
}

TEST_CASE("A symbol knows what gave its direction") {
  const std::vector<Row> rows{{"L_P_D_I_A", "X1"}, {"L_P_D_O_A", "Y1"}, {"L_P_D_I_B"}};
  const Analysed list = analyse_changed(rows, [](read::SymbolTable& table) {
    for (read::ListRow& row : table.rows) {
      if (row.vendor_address == "X1") continue;
      row.extra = static_cast<std::uint32_t>(table.extras.size());
      table.extras.push_back({{}, {}, "Valve"});
    }
  });
  CHECK(symbol_of(list, "L_P_D_I_A").direction_by == DirectionBy::address);
  CHECK(symbol_of(list, "L_P_D_O_A").direction_by == DirectionBy::alias);
  CHECK(symbol_of(list, "L_P_D_I_B").direction_by == DirectionBy::name);  // an alias of nothing that has an address
}

}  // namespace
}  // namespace symplant::test
