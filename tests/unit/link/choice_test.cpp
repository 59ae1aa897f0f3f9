// Assigns links to controllers, and runs links of several controllers together.
#include "symplant/link/choice.hpp"

#include "support/catch.hpp"
#include "symplant/link/loop_link.hpp"
#include "unit/link/plant_server.hpp"
#include "unit/link/symbol_list.hpp"

using namespace symplant;
using test::SymbolList;

namespace {

const std::string kServer = "modbus-tcp-server://:0";

/// An operation and an event of each controller, at the same addresses.
SymbolList plant_of(const std::vector<std::string>& controllers) {
  SymbolList list;
  for (const std::string& name : controllers) {
    list.controller(name);
    list.add(name + "_O", SymbolList::kOut, 3);
    list.add(name + "_I", SymbolList::kIn, 4);
  }
  return list;
}

/// "0=URL 1=URL", or the error's message.
std::string chosen(const SymbolList& list, const std::vector<std::string>& texts) {
  std::vector<link::LinkRequest> requests;
  for (const std::string& text : texts) requests.push_back(link::parse_request(text));
  const tables::PlantTables tables = list.tables();
  const auto result = link::choose_links(tables, requests);
  if (const auto* error = std::get_if<link::LinkError>(&result)) {
    CHECK(error->kind == link::LinkError::Kind::usage);
    return error->message;
  }
  std::string text;
  for (const link::LinkChoice& choice : std::get<std::vector<link::LinkChoice>>(result)) {
    const bool all = choice.controller == link::kAllControllers;
    text.append(text.empty() ? "" : " ")
        .append(all ? "all" : std::to_string(choice.controller))
        .append("=" + choice.url);
  }
  return text;
}

}  // namespace

TEST_CASE("The text before an equals sign that precedes the colon names a controller") {
  CHECK(link::parse_request("PLC1=loop:").controller == "PLC1");
  CHECK(link::parse_request("PLC1=loop:").url == "loop:");
  CHECK(link::parse_request("loop:").controller.empty());
  CHECK(link::parse_request("slmp://h:1?a=b").controller.empty());
  CHECK(link::parse_request("slmp://h:1?a=b").url == "slmp://h:1?a=b");
  CHECK(link::parse_request("A B=slmp://h:1?a=b").controller == "A B");
}

TEST_CASE("A plant of one controller needs no name") {
  CHECK(chosen(plant_of({"PLC1"}), {kServer}) == "0=" + kServer);
  CHECK(chosen(plant_of({"PLC1"}), {"plc1=" + kServer}) == "0=" + kServer);
  CHECK(chosen(SymbolList(), {kServer}) == "0=" + kServer);
}

TEST_CASE("In a plant of several controllers a link names its controller, in any case") {
  const SymbolList list = plant_of({"PLC1", "PLC2"});
  CHECK(chosen(list, {"plc2=" + kServer, "PLC1=" + kServer}) == "1=" + kServer + " 0=" + kServer);
  CHECK(chosen(list, {kServer}) == "`" + kServer + "` does not say which controller it links: write `PLC1=" + kServer +
                                       "`; this plant has `PLC1`, `PLC2`");
}

TEST_CASE("A link without a name belongs to the lists without a name") {
  CHECK(chosen(plant_of({"PLC1", ""}), {kServer}) == "1=" + kServer);
}

TEST_CASE("An unknown controller is reported with the nearest one, or with the known ones") {
  CHECK(chosen(plant_of({"PLC1", "PLC2"}), {"PLC12=" + kServer}) ==
        "controller `PLC12` not found; did you mean `PLC1`?");
  CHECK(chosen(plant_of({"PLC1", "PLC2"}), {"robot=" + kServer}) ==
        "controller `robot` not found; this plant has `PLC1`, `PLC2`");
  CHECK(chosen(plant_of({""}), {"PLC1=" + kServer}) ==
        "controller `PLC1` not found; this plant's controller has no name, give only the URL");
}

TEST_CASE("Two links to PLCs of one controller are rejected, since both would write its operations") {
  CHECK(chosen(plant_of({"PLC1", "PLC2"}), {"PLC1=" + kServer, "PLC1=modbus-tcp-server://:1"}) ==
        "controller `PLC1` has two links, `" + kServer +
            "` and `modbus-tcp-server://:1`: both would write its operations, remove one");
  CHECK(chosen(plant_of({""}), {kServer, kServer}).substr(0, 38) == "the controller without a name has two ");
  CHECK(chosen(plant_of({"PLC1"}), {"loop:", kServer}) == "0=loop: 0=" + kServer);
}

TEST_CASE("Two links on one port are rejected, unless it is port 0") {
  const std::string fixed = "modbus-tcp-server://127.0.0.1:1502";
  const SymbolList list = plant_of({"PLC1", "PLC2"});
  CHECK(chosen(list, {"PLC1=" + fixed, "PLC2=" + fixed}) ==
        "controller `PLC1` and controller `PLC2` both have the link `" + fixed + "`: give each its own port");
  CHECK(chosen(list, {"PLC1=" + kServer, "PLC2=" + kServer}) == "0=" + kServer + " 1=" + kServer);
}

TEST_CASE("The loop without a name belongs to all controllers") {
  CHECK(chosen(plant_of({"PLC1", "PLC2"}), {"loop:"}) == "all=loop:");
  CHECK(chosen(plant_of({"PLC1", "PLC2"}), {"PLC2=loop:"}) == "1=loop:");
}

TEST_CASE("A loop carries only the symbols of its controller") {
  const SymbolList list = plant_of({"PLC1", "PLC2"});
  const tables::PlantTables tables = list.tables();
  test::OwnedPlant plant(tables);
  link::LoopLink first(tables, 0);
  link::LoopLink second(tables, 1);
  CHECK(first.set("PLC1_O", true));
  CHECK_FALSE(first.set("PLC2_O", true));
  CHECK_FALSE(first.event("PLC2_I").has_value());
  CHECK(second.event("PLC2_I") == false);
  first.read_operations(*plant, 0);
  second.read_operations(*plant, 0);
  plant->advance_to(0);
  CHECK(plant->operation(tables.symbols[0].index));
  CHECK_FALSE(plant->operation(tables.symbols[2].index));
}

TEST_CASE("Two Modbus links serve equal addresses of two controllers separately") {
  const SymbolList list = plant_of({"PLC1", "PLC2"});
  const tables::PlantTables tables = list.tables();
  test::OwnedPlant plant(tables);
  plant->advance_to(0);
  std::vector<std::unique_ptr<link::Link>> links;
  for (std::uint32_t controller = 0; controller < 2; ++controller) {
    auto opened = link::open_link({"modbus-tcp-server://127.0.0.1:0", controller}, tables, &*plant);
    REQUIRE(std::holds_alternative<std::unique_ptr<link::Link>>(opened));
    links.push_back(std::get<std::unique_ptr<link::Link>>(std::move(opened)));
  }
  const auto cycle = [&](tables::Time time) {
    for (const auto& link : links) link->read_operations(*plant, 0);
    plant->advance_to(time);
    for (const auto& link : links) link->write_events(*plant, {});
    plant->forget_changed_events();
  };
  test::RawClient first(test::port_of(*links[0]));
  test::RawClient second(test::port_of(*links[1]));
  CHECK(second.ask({5, 0, 3, 0xFF, 0}) == test::Bytes{5, 0, 3, 0xFF, 0});  // coil 3 of PLC2
  cycle(1);
  CHECK_FALSE(plant->operation(tables.symbols[0].index));
  CHECK(plant->operation(tables.symbols[2].index));
  CHECK(first.ask({1, 0, 3, 0, 1}) == test::Bytes{1, 1, 0});
  CHECK(second.ask({1, 0, 3, 0, 1}) == test::Bytes{1, 1, 1});
  plant->set_input(1, 1);
  cycle(2);
  CHECK(first.ask({2, 0, 4, 0, 1}) == test::Bytes{2, 1, 1});
  CHECK(second.ask({2, 0, 4, 0, 1}) == test::Bytes{2, 1, 0});
}
