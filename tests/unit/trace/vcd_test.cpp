// The VCD file: its variables, its values, and names that would break a reader.
#include "support/vcd.hpp"

#include <bit>
#include <limits>
#include <set>
#include <sstream>

#include "support/bare_tables.hpp"
#include "support/catch.hpp"
#include "symplant/trace/vcd_file.hpp"
#include "symplant/trace/vcd_header.hpp"

namespace symplant::test {
namespace {

using tables::DataType;

tables::SymbolRow symbol(DataType type, std::uint32_t index, std::uint32_t unit) {
  return {index, unit, 0, 2, tables::symbol_kind(type, tables::Direction::event, tables::AddressForm::none, false)};
}

/// Two units of one type, one with a bit; numbers without a unit.
struct Tables {
  std::vector<tables::EventMasks> masks{{1, 0}, {0, 1}};
  std::vector<tables::TypeRow> types{{0, 1, 2, tables::kNoState, tables::Actuation::latched, {}, masks, masks, {}, {}}};
  std::vector<tables::UnitRow> units{{0, 1, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0}};
  std::vector<tables::SymbolRow> symbols{symbol(DataType::boolean, 0, 0), symbol(DataType::int_, 0, tables::kNone),
                                         symbol(DataType::lreal, 1, tables::kNone)};
  std::string symbol_names{"L_A_I_X\0\0A B\0\0W\xC3\xBC\0\0", 18};
  std::string unit_names{"L_A\0L_B.F\0", 10};
  std::string state_names{"P 1\0\xC3\x9C\\\0", 8};
  tables::PlantTables rows = make();

  tables::PlantTables make() const {
    tables::PlantTables tables = bare_tables("my plant", 0, 64);
    tables.types = types;
    tables.units = units;
    tables.symbols = symbols;
    tables.symbol_names = symbol_names;
    tables.unit_names = unit_names;
    tables.state_names = state_names;
    tables.event_slots = 2;
    return tables;
  }
};

TEST_CASE("Every variable has its scope, its type and its width, names and states cannot break a reader") {
  const Tables tables;
  const trace::PlantNames names(tables.rows);
  trace::History history(names);
  std::ostringstream out;
  trace::VcdFile file({"VCD file", out}, names);
  using Record = trace::Record;
  file.write({0, 1, 0});  // before the first values: included in them
  file.begin(0, history);
  file.write({5, static_cast<std::uint64_t>(-3), 1});
  file.write({5, std::bit_cast<std::uint64_t>(std::numeric_limits<double>::infinity()), 2});
  file.write({7, trace::pack_unit({1, 0, true, false, false, false, 0, 0, 0}), 0, Record::Kind::unit});
  file.write({8, 0, 0, Record::Kind::finding});
  file.end(9);
  file.flush();
  const Vcd vcd = read_vcd(out.str());
  CHECK(vcd.fault == "");
  CHECK(out.str().find("$comment signed \" $end\n") != std::string::npos);
  CHECK(vcd.variables.at("my_plant.L.A.L_A").type == "string");
  CHECK(vcd.variables.at("my_plant.L.B.F.L_B.F").type == "string");
  CHECK(vcd.variables.at("my_plant.L.A.L_A_I_X").width == 1);
  CHECK(vcd.variables.at("my_plant.A_B").width == 16);
  CHECK(vcd.variables.at("my_plant.Wu00FC").type == "real");
  CHECK(vcd.initial ==
        "my_plant.L.A.L_A_I_X=0 my_plant.A_B=0 my_plant.Wu00FC=0 my_plant.L.A.L_A=\\xC3\\x9C\\x5C "
        "my_plant.L.B.F.L_B.F=P\\x201");
  CHECK(vcd.changes == std::vector<std::string>{"5 my_plant.A_B=1111111111111101", "5 my_plant.Wu00FC=inf",
                                                "7 my_plant.L.A.L_A=\\xC3\\x9C\\x5C->P\\x201"});
  CHECK(vcd.last_time == "9");
}

TEST_CASE("Identifiers are short, printable and unique") {
  std::set<std::string> seen;
  for (std::size_t i = 0; i < 20'000; ++i) {
    const std::string id = trace::vcd_identifier(i);
    CHECK(seen.insert(id).second);
    CHECK(id.size() <= 3);
    CHECK(id.find_first_not_of(
              "!\"#$%&'()*+,-./0123456789:;<=>?@ABCDEFGHIJKLMNOPQRSTUVWXYZ[\\]^_`abcdefghijklmnopqrstuvwxyz{|}~") ==
          std::string::npos);
  }
  CHECK(trace::vcd_identifier(0) == "!");
  CHECK(trace::vcd_identifier(94) == "!!");
}

}  // namespace
}  // namespace symplant::test
