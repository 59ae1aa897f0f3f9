// The settings of the link `opc-ua`, the nodes of its symbols, and its words for status codes.
#include <array>

#include "support/catch.hpp"
#include "symplant/link/opc_ua/client_map.hpp"
#include "symplant/link/opc_ua/status_text.hpp"
#include "unit/link/symbol_list.hpp"

using namespace symplant;
using namespace symplant::link::opc_ua;
using Catch::Matchers::ContainsSubstring;
using link::MapRow;
using test::SymbolList;

namespace {

ClientSettings settings_of(const std::string& rest) {
  auto read = read_client_settings(rest);
  if (const auto* error = std::get_if<link::LinkError>(&read)) FAIL(error->message);
  return std::get<ClientSettings>(std::move(read));
}

std::variant<ClientMap, link::LinkError> make(const SymbolList& list, const std::string& nodes,
                                              std::span<const MapRow> rows = {}) {
  ClientSettings settings;
  settings.nodes = nodes;
  return make_client_map(list.tables(), 0, {.rows = rows}, settings);
}

ClientMap map_of(const SymbolList& list, const std::string& nodes, std::span<const MapRow> rows = {}) {
  auto made = make(list, nodes, rows);
  if (const auto* error = std::get_if<link::LinkError>(&made)) FAIL(error->message);
  return std::get<ClientMap>(std::move(made));
}

std::string fault(const SymbolList& list, const std::string& nodes, std::span<const MapRow> rows = {}) {
  const auto made = make(list, nodes, rows);
  const auto* const error = std::get_if<link::LinkError>(&made);
  return error == nullptr ? "" : error->message;
}

}  // namespace

TEST_CASE("A URL of an OPC UA client has an address, a path and settings") {
  const ClientSettings settings = settings_of(
      "//10.0.0.5:4840/server?nodes=ns=3;s=\"IO\".\"{symbol}\"&poll=20ms&read-back=0s&timeout=2s&at-end=zero");
  CHECK(settings.address.host == "10.0.0.5");
  CHECK(settings.address.port == 4840);
  CHECK(settings.path == "/server");
  CHECK(settings.nodes == "ns=3;s=\"IO\".\"{symbol}\"");
  CHECK(settings.times.poll == 20 * tables::kMillisecond);
  CHECK(settings.times.read_back == 0);
  CHECK(settings.timeout == 2 * tables::kSecond);
  CHECK(settings.times.zero_at_end);
  CHECK(settings_of("//plc:4840?nodes=s7").nodes == "nsu=http://www.siemens.com/simatic-s7-opcua;s=\"{symbol}\"");
  CHECK(settings_of("//plc:4840").nodes.empty());
}

TEST_CASE("An invalid URL of an OPC UA client is found on any machine") {
  CHECK_THAT(client_fault("//plc:0"), ContainsSubstring("port 0"));
  CHECK_THAT(client_fault("//plc:4840?nodes={symbol}"), ContainsSubstring("write a node id"));
  CHECK_THAT(client_fault("//plc:4840?node=s7"), ContainsSubstring("did you mean `nodes`?"));
  CHECK_THAT(client_fault("//plc:4840?user=a&password-file=b"), ContainsSubstring("security="));
  CHECK_THAT(client_fault("//plc:4840?poll=0s"), ContainsSubstring("write a time"));
  CHECK(client_fault("//plc:4840/a?nodes=s7&security=encrypt&user=a&password-file=b&trust=c").empty());
}

TEST_CASE("Each symbol has the node of the template, with or without an address") {
  SymbolList list;
  list.add_device("A", SymbolList::kOut, "%QX0");
  list.add("B", SymbolList::kIn, tables::AddressForm::none, 0, tables::DataType::real);
  const ClientMap map = map_of(list, "ns=3;s=\"{symbol}\"");
  CHECK(map.addresses == std::vector<std::string>{"ns=3;s=\"A\"", "ns=3;s=\"B\""});
  REQUIRE(map.operations.size() == 1);
  CHECK(map.operations[0].symbol == "A");
  REQUIRE(map.events.size() == 1);
  CHECK(map.events[0].type == tables::DataType::real);
  CHECK(map.events[0].id == NodeId{"", 3, 's', "\"B\""});
}

TEST_CASE("The node of a symbol in plant.json comes before the template of the link") {
  SymbolList list;
  list.add_device("A", SymbolList::kOut, "%QX0");
  list.add_device("B", SymbolList::kIn, "%IX0");
  const std::array<MapRow, 1> rows{MapRow{.symbol = 1, .node = "nsu=urn:x;s={address}"}};
  CHECK(map_of(list, "ns=3;s={symbol}", rows).addresses == std::vector<std::string>{"ns=3;s=A", "nsu=urn:x;s=%IX0"});
  CHECK_THAT(fault(list, "", rows), ContainsSubstring("`A` has no node"));
}

TEST_CASE("A symbol without an address is left out if its node id needs one") {
  SymbolList list;
  list.add_device("A", SymbolList::kOut, "%QX0");
  list.add("B", SymbolList::kIn, tables::AddressForm::none);
  const ClientMap map = map_of(list, "ns=3;s={address}");
  CHECK(map.addresses == std::vector<std::string>{"ns=3;s=%QX0"});
  REQUIRE(map.left_out.size() == 1);
  CHECK(map.left_out[0].symbol == 1);
}

TEST_CASE("Symbols of one address have one node, that of the first of them with its own") {
  SymbolList list;
  list.add_device("A", SymbolList::kIn, "%IX0");
  list.add_device("B", SymbolList::kIn, "%IX0");
  list.share(1, 0);
  CHECK(map_of(list, "ns=3;s={symbol}").addresses == std::vector<std::string>{"ns=3;s=A", "ns=3;s=A"});
  const std::array<MapRow, 1> rows{MapRow{.symbol = 1, .node = "ns=4;s=own"}};
  const ClientMap map = map_of(list, "ns=3;s={symbol}", rows);
  CHECK(map.addresses == std::vector<std::string>{"ns=4;s=own", "ns=4;s=own"});
  REQUIRE(map.events.size() == 1);
  CHECK(map.events[0].symbol == "B");
}

TEST_CASE("An event does not share its node") {
  SymbolList list;
  list.add_device("A", SymbolList::kOut, "%QX0");
  list.add_device("B", SymbolList::kOut, "%QX1");
  list.add_device("C", SymbolList::kIn, "%IX0");
  list.add_device("D", SymbolList::kIn, "%IX1");
  const auto row = [](std::uint32_t symbol, std::string_view node) { return MapRow{.symbol = symbol, .node = node}; };
  constexpr std::string_view kTemplate = "ns=3;s={symbol}";
  const std::array events{row(2, "ns=3;s=x"), row(3, "ns=3;s=x")};
  CHECK_THAT(fault(list, std::string(kTemplate), events),
             ContainsSubstring("the event `C` and `D` have the same node `ns=3;s=x`"));
  const std::array both{row(0, "ns=3;s=x"), row(3, "ns=3;s=x")};
  CHECK_THAT(fault(list, std::string(kTemplate), both), ContainsSubstring("the event `D` and `A` have the same node"));
  const std::array operations{row(0, "ns=3;s=x"), row(1, "ns=3;s=x")};
  CHECK(fault(list, std::string(kTemplate), operations).empty());
}

TEST_CASE("A status code says what it means and what to do") {
  CHECK_THAT(
      status_text(0x80340000),
      Catch::Matchers::StartsWith("BadNodeIdUnknown (80340000, the server has no such node): check the node ids"));
  CHECK_THAT(status_text(0x80FE0000), Catch::Matchers::StartsWith("status 80FE0000: "));
  CHECK(is_bad(0x80000000));
  CHECK(!is_bad(0x40000000));
  CHECK(answer_of(0x80100000) == link::client::Answer::busy);
  CHECK(answer_of(0x80340000) == link::client::Answer::refused);
}

TEST_CASE("A refused node is the same in the trace") {
  const tables::Refusal refusal = tables::unpack_refusal(pack(refusal_of(true, 0x803B0000)));
  CHECK(refusal == refusal_of(true, 0x803B0000));
  CHECK_THAT(refusal_text(refusal), Catch::Matchers::StartsWith("writing: BadNotWritable (803B0000, "));
}
