// From the plant model to the engine's tables.
#include "lower/lower.hpp"

#include <set>

#include "symplant/tables/digest.hpp"
#include "symplant/tables/lists.hpp"
#include "symplant/tables/names.hpp"
#include "unit/lower/altered_model.hpp"

namespace symplant::test {
namespace {

std::vector<std::string> device(const std::string& path, const std::vector<std::string>& tasks) {
  std::vector<std::string> names;
  for (const std::string& task : tasks) names.push_back(path + "_" + task);
  return names;
}

std::vector<std::string> operator+(std::vector<std::string> a, const std::vector<std::string>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

const std::vector<std::string> kRobot{"O_A1", "O_B2", "O_C3", "I_A1", "I_B2", "I_C3"};

CompiledText compile_bits(const std::vector<std::string>& names) {
  CompiledText text = compile_rows(bits(names));
  REQUIRE(text.compiled);
  return text;
}

TEST_CASE("All bits of a unit are in one word of each plane") {
  std::vector<std::string> names;
  for (int size = 1; size <= 40; ++size) {
    std::vector<std::string> tasks;
    for (int i = 0; i < size; ++i) {
      tasks.push_back("O_T" + std::to_string(i));
      if (i % 3 != 0) tasks.push_back("I_T" + std::to_string(i));
    }
    names = names + device("L_P_D" + std::to_string(size), tasks);
  }
  const CompiledText text = compile_bits(names);
  for (const tables::UnitRow& unit : text.tables().units) {
    const tables::TypeRow& type = text.tables().type_rows[unit.type];
    CHECK(unit.operation_bit / 64 == (unit.operation_bit + type.operations - 1U) / 64);
    if (type.events != 0) CHECK(unit.event_bit / 64 == (unit.event_bit + type.events - 1U) / 64);
    CHECK(unit.operation_bit + type.operations <= text.tables().operation_bits);
  }
}

TEST_CASE("Bits are packed: units share words if they fit, and unmodelled symbols follow") {
  std::vector<std::string> names;
  for (int i = 0; i < 21; ++i) names = names + device("L_P_R" + std::to_string(i), kRobot);
  const CompiledText exact = compile_bits(names + std::vector<std::string>{"START"});
  CHECK(exact.tables().event_bits == 64);  // 21 * 3 and one
  CHECK(exact.tables().operation_bits == 64);
  const CompiledText more = compile_bits(names + device("L_P_R99", kRobot));
  CHECK(more.tables().event_bits == 128);
  CHECK(more.tables().units.back().event_bit == 64);
}

TEST_CASE("Planes are whole words, a plant without symbols of a kind has no such plane") {
  const CompiledText text = compile_rows({{"LEVEL", "", "INT", "0", "%IW1"}, {"SPEED", "", "WORD", "7", "%QW1"}});
  CHECK(text.tables().operation_bits == 0);
  CHECK(text.tables().event_bits == 0);
  CHECK(text.tables().operation_slots == 1);
  CHECK(text.tables().event_slots == 1);
}

TEST_CASE("Every symbol has a separate bit or slot, also those on one address") {
  const CompiledText text = compile_rows({{"L_P_D_O_A", "Y1"},
                                          {"L_P_E_O_A", "Y1"},
                                          {"LAMP", "Y1"},
                                          {"L_P_D_I_A", "X1"},
                                          {"START", "X2"},
                                          {"N1", "", "INT", "0", "%IW1"},
                                          {"N2", "", "INT", "0", "%IW1"}});
  REQUIRE(text.compiled);
  const lower::EngineTables& tables = text.tables();
  std::set<std::uint32_t> operations{tables.symbols[0].index, tables.symbols[1].index, tables.symbols[2].index};
  CHECK(operations.size() == 3);
  CHECK(tables.symbols[3].index != tables.symbols[4].index);
  CHECK(tables.symbols[5].index != tables.symbols[6].index);
  CHECK(tables.shared_addresses.size() == 3);
}

TEST_CASE("An event that follows another unit's event is switched by that unit alone") {
  const CompiledText text = compile_rows({{"L_P_A_O_P1", "Y1"},
                                          {"L_P_A_O_P2", "Y2"},
                                          {"L_P_A_I_P1", "X1"},
                                          {"L_P_A_I_P2", "X2"},
                                          {"L_P_B_I_P1", "X2"},
                                          {"L_P_B_I_P2", "X3"}});
  REQUIRE(text.compiled);
  const lower::EngineTables& tables = text.tables();
  const lower::Type& follower = tables.types[tables.units[1].type];
  CHECK(masks(follower.enter) == Masks{{0, 0}, {2, 0}});
  CHECK(masks(follower.leave) == Masks{{0, 0}, {0, 2}});
}

TEST_CASE("Numbers of different types on one address are not kept equal bit by bit: links handle each type") {
  const CompiledText text = compile_rows({{"N1", "", "INT", "-1", "%QW1"}, {"N2", "", "WORD", "5", "%QW1"}});
  REQUIRE(text.compiled);
  CHECK(text.tables().shared_addresses.empty());
  CHECK(text.tables().initial_values.size() == 2);
}

TEST_CASE("The first of several numbers of one type on an address leads, for any first symbol of the address") {
  const CompiledText text = compile_rows({{"N1", "", "INT", "", "%QW5"},
                                          {"N2", "", "WORD", "", "%QW5"},
                                          {"N3", "", "WORD", "", "%QW5"},
                                          {"N4", "", "INT", "", "%QW5"}});
  REQUIRE(text.compiled);
  const auto& shared = text.tables().shared_addresses;
  REQUIRE(shared.size() == 2);
  CHECK(shared[0].symbol == 2);
  CHECK(shared[0].leader == 1);
  CHECK(shared[1].symbol == 3);
  CHECK(shared[1].leader == 0);
}

TEST_CASE("Units of equal structure and names share a type and its times") {
  const CompiledText text = compile_bits(device("L_P_R1", kRobot) + device("L_P_R2", kRobot) +
                                         device("L_Q_OTHER", kRobot) + device("L_P_V", {"O_ADV", "I_ADV", "I_RET"}));
  CHECK(text.tables().types.size() == 2);
  CHECK(text.tables().units[0].type == text.tables().units[2].type);
  // All robots and the valve need the default travel time, for all their transitions.
  for (const lower::Type& type : text.tables().types) CHECK(type.times.size() == 1);
  CHECK(text.tables().times.empty());
}

TEST_CASE("The order of rows within a device does not matter for its structure if S is the same") {
  const CompiledText text =
      compile_bits(device("L_P_R1", kRobot) + device("L_P_R2", {"O_A1", "O_B2", "O_C3", "I_A1", "I_B2", "I_C3"}));
  CHECK(text.tables().types.size() == 1);
}

TEST_CASE("Units that differ in a task's name, in its case, in actuation or in an event share no type") {
  const auto types = [](const std::vector<std::string>& a, const std::vector<std::string>& b) {
    return compile_bits(device("L_P_R1", a) + device("L_P_R2", b)).tables().types.size();
  };
  CHECK(types({"O_A1", "I_A1", "O_B2", "I_B2"}, {"O_A1", "I_A1", "O_C2", "I_C2"}) == 2);
  CHECK(types({"O_Run1", "I_Run1", "O_B2"}, {"O_RUN1", "I_RUN1", "O_B2"}) == 2);
  CHECK(types({"O_Run1", "I_RUN1", "O_B2"}, {"I_RUN1", "O_Run1", "O_B2"}) == 2);  // the first row names the state
  CHECK(types({"O_A1", "I_A1", "O_B2", "I_B2"}, {"O_A1", "I_A1", "O_B2"}) == 2);
  CHECK(types({"O_ADV", "I_ADV", "I_RET"}, {"O_ADV", "I_ADV", "I_RET1"}) == 2);
}

TEST_CASE("The initial state is per unit: it does not separate types") {
  const CompiledText text = compile_bits(device("L_P_R1", {"O_A1", "I_A1", "O_B2", "I_B2"}) +
                                         device("L_P_R2", {"O_A1", "I_A1", "O_B2", "I_B2*"}));
  CHECK(text.tables().types.size() == 1);
  CHECK(text.tables().units[0].initial == 0);
  CHECK(text.tables().units[1].initial == 1);
}

TEST_CASE("Two events of one unit on one address are set and reset together") {
  const CompiledText text =
      compile_rows({{"L_P_D_I_A1", "X1"}, {"L_P_D_I_B2", "X1"}, {"L_P_D_O_A1", "Y1"}, {"L_P_D_O_B2", "Y2"}});
  const lower::Type& type = text.tables().types[0];
  CHECK(masks(type.enter) == Masks{{3, 0}, {3, 0}});
  CHECK(masks(type.leave) == Masks{{0, 3}, {0, 3}});
}

TEST_CASE("Only numeric symbols and unmodelled inputs have starting values") {
  const CompiledText text = compile_rows({{"L_P_D_I_ON", "X1", "BOOL", "TRUE"},
                                          {"AIR", "X2", "BOOL", "TRUE"},
                                          {"LAMP", "Y1", "BOOL", "TRUE"},
                                          {"LEVEL", "", "INT", "-5", "%IW1"},
                                          {"SPEED", "", "WORD", "7", "%QW1"},
                                          {"ZERO", "", "WORD", "0", "%QW2"}});
  std::vector<std::pair<std::uint32_t, std::uint64_t>> values;
  for (const tables::InitialValue& value : text.tables().initial_values) values.emplace_back(value.symbol, value.value);
  CHECK(values ==
        std::vector<std::pair<std::uint32_t, std::uint64_t>>{{1, 1}, {3, static_cast<std::uint64_t>(-5)}, {4, 7}});
}

TEST_CASE("Names are in blobs in the order of their rows") {
  const CompiledText text = compile_rows({{"L_P_D_O_A", "Y1"}, {"L_P_D_I_A", "X1"}, {"START"}, {"LAMP", "Y2"}});
  const auto names = tables::split_names(text.tables().symbol_names);
  CHECK(names == std::vector<std::string_view>{"L_P_D_O_A", "Y1", "L_P_D_I_A", "X1", "LAMP", "Y2"});
  CHECK(text.tables().unit_names == std::string("L_P_D\0", 6));
  CHECK(text.tables().state_names == std::string("NOT_A\0A\0", 8));
}

TEST_CASE("Lowering twice gives one model_hash, which does not depend on the row in the list") {
  const std::vector<Row> rows = bits(device("L_P_R1", kRobot) + device("L_P_V", {"O_ADV", "I_ADV", "I_RET"}));
  const auto hash = [](const std::string& list, const char* name) {
    return tables::model_hash(compile_text(list, name).tables().tables());
  };
  const std::string list = list_text(rows);
  CHECK(hash(list, "a.csv") == hash(list, "a.csv"));
  std::string with_gap = list;
  with_gap.insert(with_gap.find('\n') + 1, "\n\n");
  CHECK(hash(with_gap, "a.csv") == hash(list, "a.csv"));
}

TEST_CASE("Every symbol has its list and its controller") {
  const CompiledText text = compile_lists({{"a.csv", list_text(bits({"L_P_D_O_A", "L_P_D_I_A"})), "PLC1"},
                                           {"none.csv", list_text({{"M1", "M1"}}), "PLC2"},
                                           {"b.csv", list_text(bits({"L_P_E_O_A"})), "PLC3"},
                                           {"c.csv", list_text(bits({"L_P_F_I_A", "L_P_F_O_A"})), "plc1"}});
  REQUIRE(text.compiled);
  const tables::PlantTables tables = text.tables().tables();
  std::vector<std::uint32_t> lists;
  std::vector<std::uint32_t> controllers;
  for (std::uint32_t i = 0; i < tables.symbols.size(); ++i) {
    lists.push_back(tables::list_of(tables, i));
    controllers.push_back(tables::controller_of(tables, i));
  }
  CHECK(lists == std::vector<std::uint32_t>{0, 0, 2, 3, 3});
  CHECK(controllers == std::vector<std::uint32_t>{0, 0, 2, 0, 0});
  CHECK(tables::split_names(tables.list_names) == std::vector<std::string_view>{"a.csv", "none.csv", "b.csv", "c.csv"});
  CHECK(tables::split_names(tables.controller_names) == std::vector<std::string_view>{"PLC1", "PLC2", "PLC3"});
}

TEST_CASE("Symbols of two controllers on one address are not kept equal") {
  const std::vector<Row> first{{"L_P_D_O_A", "Y1"}};
  const std::vector<Row> second{{"L_P_E_O_A", "Y1"}};
  const auto shared = [&](const std::string& controller) {
    const CompiledText text =
        compile_lists({{"a.csv", list_text(first), "PLC1"}, {"b.csv", list_text(second), controller}});
    return text.tables().shared_addresses.size();
  };
  CHECK(shared("PLC1") == 1);
  CHECK(shared("PLC2") == 0);
}

TEST_CASE("A list of only the default controller is one row and one empty name") {
  const CompiledText text = compile_bits({"L_P_D_O_A"});
  CHECK(text.tables().lists.size() == 1);
  CHECK(text.tables().controller_names == std::string(1, '\0'));
  CHECK(text.tables().list_names == std::string("symbols.csv\0", 12));
}

}  // namespace
}  // namespace symplant::test
