// Where symbols lie in a PLC that is a Modbus server.
#include "symplant/link/modbus/client_map.hpp"

#include "support/catch.hpp"
#include "symplant/link/client_parts.hpp"
#include "unit/link/symbol_list.hpp"

using namespace symplant;
using Catch::Matchers::ContainsSubstring;
using link::LinkSettings;
using tables::DataType;
using test::SymbolList;

namespace {

SymbolList filling_list() {
  SymbolList list;
  list.add("OPEN", SymbolList::kOut, 3);
  list.add("IS_OPEN", SymbolList::kIn, 3);
  list.add("SETPOINT", SymbolList::kOut, 5, DataType::dint);
  list.add("LEVEL", SymbolList::kIn, 5, DataType::int_);
  return list;
}

link::client::PartsResult parts_of(const SymbolList& list, const std::string& parameters,
                                   const LinkSettings& settings = {}) {
  return link::client_parts({"modbus-tcp://127.0.0.1:502?" + parameters, 0, settings}, list.tables());
}

std::vector<std::string> addresses_of(const SymbolList& list, const std::string& parameters) {
  auto parts = parts_of(list, parameters);
  if (const auto* error = std::get_if<link::LinkError>(&parts)) FAIL(error->message);
  return std::get<link::client::ClientParts>(parts).addresses;
}

std::string map_fault(const SymbolList& list, const std::string& parameters, const LinkSettings& settings = {}) {
  const auto parts = parts_of(list, parameters, settings);
  const auto* const error = std::get_if<link::LinkError>(&parts);
  if (error == nullptr) return "";
  CHECK(error->kind == link::LinkError::Kind::usage);
  return error->message;
}

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("The address in the PLC is the number of the map plus the offset") {
  CHECK(addresses_of(filling_list(), "events=coils:100&event-values=holding-registers:1024") ==
        Texts{"coil 3", "coil 103", "holding registers 10-11", "holding register 1029"});
}

TEST_CASE("Packed bits are addressed by register and bit") {
  SymbolList list = filling_list();
  list.add("LAST", SymbolList::kOut, 17);
  const std::string events = "&events=holding-registers:300&event-values=holding-registers:400";
  CHECK(addresses_of(list, "operations=input-registers:50" + events) ==
        Texts{"input register 50.3", "holding register 300.3", "holding registers 10-11", "holding register 405",
              "input register 51.1"});
  CHECK(addresses_of(list, "operations=input-registers:50&bit-order=high-first" + events)[4] == "input register 51.14");
}

TEST_CASE("Events without a chosen area are a usage error that explains the choice") {
  CHECK_THAT(map_fault(filling_list(), "event-values=holding-registers:1024"),
             ContainsSubstring("`IS_OPEN` is an event") && ContainsSubstring("events=coils:OFFSET") &&
                 ContainsSubstring("OpenPLC"));
  CHECK_THAT(
      map_fault(filling_list(), "events=coils:100"),
      ContainsSubstring("`LEVEL` is a numeric event") && ContainsSubstring("event-values=holding-registers:OFFSET"));
}

TEST_CASE("A plant without events needs no area for them") {
  SymbolList list;
  list.add("OPEN", SymbolList::kOut, 3);
  CHECK(addresses_of(list, "") == Texts{"coil 3"});
}

TEST_CASE("Operations and events that overlap in the PLC are a usage error with both symbols") {
  const std::string values = "&event-values=holding-registers:1024";
  CHECK_THAT(map_fault(filling_list(), "events=coils" + values),
             ContainsSubstring("`OPEN` on coil 3 and `IS_OPEN` on coil 3 overlap in the PLC"));
  CHECK(map_fault(filling_list(), "events=coils:1" + values).empty());
  CHECK_THAT(map_fault(filling_list(), "events=holding-registers:11" + values),
             ContainsSubstring("`SETPOINT` on holding registers 10-11 and `IS_OPEN` on holding register 11.3 overlap"));
  CHECK_THAT(map_fault(filling_list(), "events=coils:100&event-values=holding-registers:5"),
             ContainsSubstring("`SETPOINT`") && ContainsSubstring("`LEVEL` on holding register 10"));
}

TEST_CASE("Bits that are packed into a register of numbers are an overlap") {
  CHECK_THAT(
      map_fault(filling_list(), "operations=holding-registers:10&events=coils&event-values=holding-registers:50"),
      ContainsSubstring("`OPEN` on holding register 10.3") && ContainsSubstring("`SETPOINT`"));
}

TEST_CASE("Addresses above 65535 are a usage error") {
  CHECK_THAT(map_fault(filling_list(), "events=coils:65533&event-values=holding-registers:100"),
             ContainsSubstring("`IS_OPEN`") && ContainsSubstring("65535"));
}

TEST_CASE("The status block is written only to a register that the settings give") {
  const std::string parameters = "events=coils:100&event-values=holding-registers:1024";
  auto parts = parts_of(filling_list(), parameters);
  CHECK_FALSE(std::get<link::client::ClientParts>(parts).map.status.has_value());
  LinkSettings settings;
  settings.status_block = 40;
  parts = parts_of(filling_list(), parameters, settings);
  CHECK(std::get<link::client::ClientParts>(parts).map.status.has_value());
  settings.status_block = 8;
  CHECK_THAT(map_fault(filling_list(), "events=coils:100&event-values=holding-registers", settings),
             ContainsSubstring("the status block on holding registers 8-19"));
  settings.watchdog = 3;
  CHECK_THAT(map_fault(filling_list(), parameters, settings), ContainsSubstring("no `watchdog`"));
}

TEST_CASE("Symbols without a number are listed as not linked") {
  SymbolList list = filling_list();
  list.add("LOOSE", SymbolList::kOut, tables::AddressForm::none);
  list.add("SMALL", SymbolList::kOut, 7, DataType::usint);
  const auto parts = parts_of(list, "events=coils:100&event-values=holding-registers:1024");
  const auto& unreachable = std::get<link::client::ClientParts>(parts).unreachable;
  REQUIRE(unreachable.size() == 2);
  CHECK(unreachable[0].symbol == 4);
  CHECK(unreachable[0].reason == "has no address");
  CHECK_THAT(unreachable[1].reason, ContainsSubstring("has 8 bits"));
}
