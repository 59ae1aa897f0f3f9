// Rows that are I/O, rows that are served, and devices that are too large.
#include "model/classify.hpp"
#include "model_support.hpp"

namespace symplant::test {
namespace {

using model::InternalReason;
using name::Account;

TEST_CASE("Devices differ by line, process and device") {
  const Analysed list = analyse_rows(bits({"L_P_D_O_A1", "L_P_E_O_A1", "L_Q_D_O_A1", "M_P_D_O_A1", "L_P_D_I_A1"}));
  CHECK(list.model().units.size() == 4);
  CHECK(unit_of(list).operations.size() == 1);
  CHECK(unit_of(list).events.size() == 1);
}

TEST_CASE("Names are compared without ASCII case and shown as declared") {
  const Analysed list = analyse_rows(bits({"Line_p_Dev_I_Home1", "LINE_P_DEV_o_HOME1", "line_P_dev_I_work2"}));
  REQUIRE(list.model().units.size() == 1);
  const model::Unit& unit = list.model().units[0];
  CHECK(unit.path == "Line_p_Dev");
  CHECK(states_text(unit) == "Home1 work2");
  CHECK(unit.states[0].operation == 0);
  CHECK(unit.states[0].event == 0);
  // The case of other letters counts.
  CHECK(analyse_rows(bits({"L_P_Ä_I_A", "L_P_ä_I_A"})).model().units.size() == 2);
}

TEST_CASE("Rows with an address in the PLC's memory are internal") {
  const Analysed list = analyse_rows({{"L_P_D_I_A", "M100"},
                                      {"L_P_D_I_B", "D10", "INT"},
                                      {"L_P_D_I_C", "", "BOOL", "", "%MX1.1"},
                                      {"L_P_D_I_D", "", "WORD", "", "%MW5"},
                                      {"L_P_D_O_A", "Y1"}});
  CHECK(internal(list, InternalReason::memory) == 4);
  CHECK(list.model().symbols.size() == 1);
}

TEST_CASE("Constants are internal, with any address") {
  Row row{"L_P_D_I_A", "X1"};
  row.klass = "VAR_CONSTANT";
  Row global = {"L_P_D_I_B", "X2"};
  global.klass = "VAR_GLOBAL_CONSTANT";
  const Analysed list = analyse_rows({row, global, {"L_P_D_O_A", "Y1"}});
  CHECK(internal(list, InternalReason::constant) == 2);
  CHECK(list.model().symbols.size() == 1);
}

TEST_CASE("TIME, STRING, arrays, structures and function blocks are internal") {
  const Analysed list = analyse_text(
      "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial\n"
      "VAR_GLOBAL,L_P_D_I_A,X1,,TIME,T#1s\n"
      "VAR_GLOBAL,L_P_D_I_B,X2,,STRING(32),\n"
      "VAR_GLOBAL,L_P_D_I_C,M3,,ARRAY [0..7] OF BOOL,\n"
      "VAR_GLOBAL,L_P_D_I_D,,,MyStruct,\n"
      "VAR_GLOBAL,L_P_D_I_E,,,TON,\n"
      "VAR_GLOBAL,L_P_D_O_A,Y1,,BOOL,\n");
  CHECK(internal(list, InternalReason::type) == 4);
  CHECK(internal(list, InternalReason::memory) == 1);
  CHECK(list.model().symbols.size() == 1);
}

TEST_CASE("Internal rows raise no warning, single or together") {
  Row constant{"SPEED", "", "INT", "5"};
  constant.klass = "VAR_CONSTANT";
  const Analysed list = analyse_rows({{"L_P_D_I_A1", "X1"},
                                      {"L_P_D_O_A1", "Y1"},
                                      {"L_P_D_I_B2", "X2"},
                                      {"L_P_D_O_B2", "Y2"},
                                      constant,
                                      {"MY_TIMER", "?T7", "TON", ""},
                                      {"some thing", "M1", "BOOL", "maybe"},
                                      {"text", "", "STRING", "'a'"},
                                      {"anything", "", "BOOL", "FALSE"}});
  CHECK(list.model().symbols.size() == 4);
  CHECK(list.fired() == "");
}

TEST_CASE("Every elementary type is I/O, ignoring case") {
  for (const char* type : {"BOOL", "SINT", "INT", "DINT", "LINT", "USINT", "UINT", "UDINT", "ULINT", "REAL", "LREAL",
                           "BYTE", "WORD", "DWORD", "LWORD", "bool", "Int"}) {
    INFO(type);
    CHECK(analyse_rows({{"L_P_D_I_A", "", type, ""}}).model().symbols.size() == 1);
  }
}

TEST_CASE("Numeric symbols are served, belong to their device and keep their Initial") {
  const Analysed list = analyse_rows({{"L_P_D_I_LEVEL", "", "INT", "-5", "%IW1"},
                                      {"L_P_D_O_SPEED", "", "WORD", "16#FFFF", "%QW1"},
                                      {"L_P_D_I_TEMP", "", "REAL", "1.5", "%ID4"}});
  REQUIRE(list.model().units.size() == 1);
  const model::Unit& unit = list.model().units.front();
  CHECK(unit.values == std::vector<std::uint32_t>{0, 1, 2});
  REQUIRE(unit.states.size() == 1);  // no symbol names one
  CHECK(unit.states.front().name == "IDLE");
  CHECK(list.count("no-device") == 1);  // nothing moves
  REQUIRE(list.model().symbols.size() == 3);
  for (const model::Symbol& symbol : list.model().symbols) CHECK(symbol.account == Account::numeric);
  CHECK(list.model().symbols[0].initial == static_cast<std::uint64_t>(-5));
  CHECK(list.model().symbols[1].initial == 0xFFFF);
  CHECK(list.model().symbols[2].initial == 0x3FF8'0000'0000'0000);
}

TEST_CASE("A symbol whose name breaks the rule is served and in no unit") {
  const Analysed list = analyse_rows({{"START", "X1"}, {"LAMP", "Y1"}, {"L_P_D_I_A", "X2"}});
  CHECK(list.model().symbols.size() == 3);
  CHECK(symbol_of(list, "START").account == Account::no_rule);
  CHECK(symbol_of(list, "LAMP").direction == tables::Direction::operation);
  CHECK(list.model().units.size() == 1);
}

TEST_CASE("The first of two rows with one name counts, the second is a warning if address and type agree") {
  const Analysed list = analyse_rows({{"L_P_D_I_A", "X1"}, {"l_p_d_i_a", "X1", "bool"}});
  CHECK(list.model().symbols.size() == 1);
  CHECK(list.count("duplicate-symbol") == 1);
  CHECK_FALSE(list.diagnostics.has_errors());
  // The same address in another notation is equal.
  const Analysed notation = analyse_rows({{"L_P_D_I_A", "X1F"}, {"L_P_D_I_A", "", "BOOL", "FALSE", "%IX31"}});
  CHECK(notation.count("duplicate-symbol") == 1);
  CHECK(list.fired(diag::Severity::warning) == "duplicate-symbol");
}

TEST_CASE("A second row of one name with another address or type is an error") {
  const Analysed address = analyse_rows({{"L_P_D_I_A", "X1"}, {"L_P_D_I_A", "X2"}});
  CHECK(address.fired(diag::Severity::warning) == "symbol-declared-differently");
  CHECK(address.diagnostics.has_errors());
  CHECK(address.model().symbols.size() == 1);
  const Analysed type = analyse_rows({{"L_P_D_I_A", "", "BOOL"}, {"L_P_D_I_A", "", "INT"}});
  CHECK(type.count("symbol-declared-differently") == 1);
  CHECK(analyse_rows({{"N", "M1"}, {"N", "M2"}}).count("symbol-declared-differently") == 1);
}

TEST_CASE("The name of an internal row counts as declared, too") {
  CHECK(analyse_rows({{"L_P_D_I_A", "M1"}, {"L_P_D_I_A", "X1"}}).count("symbol-declared-differently") == 1);
}

/// One unit with these numbers of operations and events; they share tasks while there are both.
std::vector<Row> unit_of_size(int operations, int events, int first_event_task = 0) {
  std::vector<std::string> names;
  for (int i = 0; i < operations; ++i) names.push_back("L_P_D_O_T" + std::to_string(i));
  for (int i = 0; i < events; ++i) names.push_back("L_P_D_I_T" + std::to_string(first_event_task + i));
  return bits(names);
}

TEST_CASE("A unit may have 64 operations and 64 events") {
  const Analysed exact = analyse_rows(unit_of_size(64, 64));
  CHECK(unit_of(exact).operations.size() == 64);
  CHECK(unit_of(exact).events.size() == 64);
  CHECK(unit_of(exact).states.size() == 64);
  CHECK(exact.count("unit-too-large") == 0);
  const Analysed apart = analyse_rows(unit_of_size(64, 64, 64));
  CHECK(unit_of(apart).states.size() == 128);
  CHECK(apart.count("unit-too-large") == 0);
}

TEST_CASE("A unit of 65 operations or 65 events is unmodelled, its symbols are served") {
  for (const auto& rows : {unit_of_size(65, 10), unit_of_size(10, 65)}) {
    std::vector<Row> with_other = rows;
    with_other.push_back({"L_P_E_I_ON", "", "BOOL", "FALSE", "%IX900"});
    const Analysed list = analyse_rows(with_other);
    CHECK(find_unit(list.model(), "L_P_D") == nullptr);
    CHECK(list.model().symbols.size() == 76);
    CHECK(symbol_of(list, "L_P_D_O_T3").account == Account::unit_too_large);
    CHECK(list.fired(diag::Severity::warning) == "unit-too-large");
    const model::Symbol& other = symbol_of(list, "L_P_E_I_ON");
    REQUIRE(other.unit == 0);
    CHECK(list.model().units[0].path == "L_P_E");
  }
}

TEST_CASE("The first of two symbols that claim one task and direction keeps it, with a warning") {
  // The second one's name says operation; its address overrides it.
  const Analysed list =
      analyse_rows({{"L_P_D_I_P1", "X1"}, {"L_P_D_I_P2", "X2"}, {"L_P_D_O_P2", "Y2"}, {"L_P_D_O_P1", "X5"}});
  const model::Unit& unit = unit_of(list);
  CHECK(unit.events.size() == 2);
  CHECK(unit.operations.size() == 1);
  CHECK(symbol_of(list, "L_P_D_O_P1").account == Account::task_taken);
  CHECK(symbol_of(list, "L_P_D_I_P1").account == Account::modelled);
  CHECK(list.fired(diag::Severity::warning) == "direction-against-address");
  // The overridden one comes first and keeps the task.
  const Analysed first = analyse_rows({{"L_P_D_O_P1", "X5"}, {"L_P_D_I_P1", "X1"}});
  CHECK(symbol_of(first, "L_P_D_O_P1").account == Account::modelled);
  CHECK(symbol_of(first, "L_P_D_I_P1").account == Account::task_taken);
  CHECK(first.fired(diag::Severity::warning) == "direction-against-address");
}

TEST_CASE("Many claims of one task differ from many tasks") {
  std::vector<Row> rows = unit_of_size(0, 60);
  rows.push_back({"L_P_D_O_T0", "", "BOOL", "", "%IX500"});
  rows.push_back({"L_P_D_O_T59", "", "BOOL", "", "%IX501"});
  const Analysed list = analyse_rows(rows);
  CHECK(unit_of(list).events.size() == 60);
  CHECK(symbol_of(list, "L_P_D_O_T0").account == Account::task_taken);
  CHECK(symbol_of(list, "L_P_D_O_T59").account == Account::task_taken);
}

TEST_CASE("An unreadable Initial counts as off, and is reported") {
  const Analysed list = analyse_rows({{"L_P_D_I_A", "X1", "BOOL", "MAYBE"}, {"N", "", "INT", "70000", "%IW1"}});
  CHECK(list.count("initial-not-understood") == 2);
  CHECK(symbol_of(list, "L_P_D_I_A").initial == 0);
  CHECK(symbol_of(list, "N").initial == 0);
}

TEST_CASE("Initial values are read in every notation") {
  using tables::DataType;
  const auto value = [](const char* text, DataType type) { return model::initial_value(text, type); };
  CHECK(value("", DataType::boolean) == 0U);
  CHECK(value("true", DataType::boolean) == 1U);
  CHECK(value("1", DataType::boolean) == 1U);
  CHECK(value("BOOL#TRUE", DataType::boolean) == 1U);
  for (const char* word : {"WAHR", "vrai", "Vero", "VERDADERO"}) CHECK(value(word, DataType::boolean) == 1U);
  for (const char* word : {"FALSCH", "faux", "Falso"}) CHECK(value(word, DataType::boolean) == 0U);
  CHECK_FALSE(value("2", DataType::boolean));
  CHECK(value("-32768", DataType::int_) == static_cast<std::uint64_t>(-32768));
  CHECK_FALSE(value("-32769", DataType::int_));
  CHECK(value("32767", DataType::int_) == 32767U);
  CHECK_FALSE(value("32768", DataType::int_));
  CHECK(value("16#FFFF", DataType::int_) == static_cast<std::uint64_t>(-1));
  CHECK(value("65535", DataType::word) == 65535U);
  CHECK_FALSE(value("65536", DataType::word));
  CHECK_FALSE(value("-1", DataType::uint));
  CHECK(value("K5", DataType::int_) == 5U);
  CHECK(value("K-5", DataType::int_) == static_cast<std::uint64_t>(-5));
  CHECK(value("H1F", DataType::word) == 31U);
  CHECK(value("2#1010_1010", DataType::byte) == 170U);
  CHECK(value("INT#7", DataType::int_) == 7U);
  CHECK(value("WORD#16#ff", DataType::word) == 255U);
  CHECK(value("18446744073709551615", DataType::ulint) == ~std::uint64_t{0});
  CHECK_FALSE(value("18446744073709551616", DataType::ulint));
  CHECK(value("-9223372036854775808", DataType::lint) == std::uint64_t{1} << 63);
  CHECK_FALSE(value("--1", DataType::int_));
  CHECK_FALSE(value("16#", DataType::word));
  CHECK_FALSE(value("0x1F", DataType::word));
  CHECK(value("1.5", DataType::real) == 0x3FF8'0000'0000'0000U);
  CHECK(value("E1.5", DataType::real) == 0x3FF8'0000'0000'0000U);
  CHECK(value("1,5", DataType::real) == 0x3FF8'0000'0000'0000U);
  CHECK_FALSE(value("1,5,0", DataType::real));
  CHECK_FALSE(value("1.000,5", DataType::real));
  CHECK(value("-1e3", DataType::lreal).has_value());
  CHECK_FALSE(value("inf", DataType::lreal));
  CHECK_FALSE(value("nan", DataType::lreal));
}

}  // namespace
}  // namespace symplant::test
