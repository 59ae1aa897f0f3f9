// A plant of several lists and controllers: names across the plant, addresses within a controller.
#include "model_support.hpp"

namespace symplant::test {
namespace {

using address::Radix;
using model::RadixChoice;

const std::vector<Row> kFirst{{"L_P_D_O_A", "Y1"}, {"L_P_D_I_A", "X1"}, {"L_P_D_O_B", "Y2"}, {"L_P_D_I_B", "X2"}};
const std::vector<Row> kOther{{"L_P_E_O_A", "Y1"}, {"L_P_E_I_A", "X1"}, {"L_P_E_O_B", "Y2"}, {"L_P_E_I_B", "X2"}};

Analysed two(const std::vector<Row>& first, const std::vector<Row>& second, const std::string& controller = "",
             const std::string& other = "") {
  return analyse_lists({{"first.csv", list_text(first), controller}, {"second.csv", list_text(second), other}});
}

std::string file_of(const diag::Location& index) { return index.source->path(); }

TEST_CASE("Rows of all lists make one plant, in the order of the lists") {
  const Analysed plant = two({{"L_P_D_O_A", "Y1"}, {"L_P_E_I_A", "X1"}}, {{"L_P_E_O_A", "Y2"}, {"L_P_D_I_A", "X2"}});
  std::string names;
  for (const model::Symbol& symbol : plant.model().symbols) {
    names += std::to_string(symbol.list) + std::string(symbol.name()) + " ";
  }
  CHECK(names == "0L_P_D_O_A 0L_P_E_I_A 1L_P_E_O_A 1L_P_D_I_A ");
  CHECK(plant.model().units.size() == 2);
  CHECK(unit_of(plant, "L_P_D").events == std::vector<std::uint32_t>{3});
  CHECK(plant.model().list_names() == "first.csv, second.csv");
  CHECK(plant.model().controllers == std::vector<std::string>{""});
  CHECK(plant.model().list_of(*plant.model().symbols[3].row) == 1);
  CHECK(plant.fired(diag::Severity::warning) == "");
}

TEST_CASE("Controllers are in the order of their first list, and are compared ignoring case") {
  const Analysed plant = analyse_lists({{"a.csv", list_text({{"L_P_D_O_A", "Y1"}}), "PLC1"},
                                        {"b.csv", list_text({{"L_P_E_O_A", "Y1"}})},
                                        {"c.csv", list_text({{"L_P_F_O_A", "Y2"}}), "plc1"}});
  CHECK(plant.model().controllers == std::vector<std::string>{"PLC1", ""});
  CHECK(plant.model().controller_of(plant.model().symbols[0]) == 0);
  CHECK(plant.model().controller_of(plant.model().symbols[1]) == 1);
  CHECK(plant.model().controller_of(plant.model().symbols[2]) == 0);
}

TEST_CASE("One address in lists of two controllers is two addresses") {
  const Analysed plant = two(kFirst, kOther, "PLC1", "PLC2");
  CHECK(plant.fired(diag::Severity::warning) == "");
  for (const model::Symbol& symbol : plant.model().symbols) CHECK(symbol.leader == model::kNone);
}

TEST_CASE("One address in two lists of one controller is one address") {
  const Analysed plant = two(kFirst, kOther, "PLC1", "plc1");
  CHECK(plant.count("address-used-twice") == 2);
  CHECK(plant.count("event-driven-twice") == 2);
  for (const diag::Diagnostic& finding : plant.diagnostics.all()) {
    if (finding.rule->slug != "event-driven-twice") continue;
    CHECK(file_of(finding.location) == "second.csv");
    CHECK(file_of(finding.related.front().location) == "first.csv");
  }
}

TEST_CASE("A name in two lists is declared twice, and both locations are reported") {
  const Analysed plant = two(kFirst, {{"L_P_D_O_A", "Y1"}});
  const diag::Diagnostic& finding = finding_of(plant, "duplicate-symbol");
  CHECK(file_of(finding.location) == "second.csv");
  CHECK(file_of(finding.related.front().location) == "first.csv");
  CHECK(plant.model().symbols.size() == 4);
  CHECK(two(kFirst, {{"L_P_D_O_A", "Y7"}}).count("symbol-declared-differently") == 1);
}

TEST_CASE("A name in lists of two controllers is an error, for any address") {
  const Analysed plant = two(kFirst, {{"L_P_D_O_A", "Y1"}}, "PLC1", "PLC2");
  CHECK(
      finding_of(plant, "symbol-declared-differently").message ==
      "`L_P_D_O_A` is declared again with another address, type or controller: rename it, or delete the wrong row, or "
      "give its list a `prefix` in plant.json, such as `\"prefix\": \"PLC2_\"`");
}

TEST_CASE("Findings are in the order of the lists, for any order of rules and size of lists") {
  std::vector<Row> long_list(30, Row{"", ""});
  for (std::size_t i = 0; i < long_list.size(); ++i) {
    long_list[i] = {"BAD" + std::to_string(i), "X" + std::to_string(i % 10)};
  }
  const Analysed plant = two(long_list, {{"L_P_D_O_A", "?"}, {"WORSE", "X9"}});
  std::string order;
  for (const diag::Diagnostic& finding : plant.diagnostics.all()) {
    const std::string file = file_of(finding.location);
    if (order.empty() || !std::string_view(order).ends_with(file + " ")) order += file + " ";
  }
  CHECK(order == "first.csv second.csv ");
}

TEST_CASE("X and Y count separately for each controller") {
  const std::vector<Row> octal{{"L_P_D_I_A", "X0010", "BOOL", "", "%IX8"}, {"L_P_D_I_B", "X0020"}};
  const std::vector<Row> hex{{"L_P_E_I_A", "X0010", "BOOL", "", "%IX16"}, {"L_P_E_I_B", "X0020"}};
  const Analysed plant = two(octal, hex, "PLC1", "PLC2");
  CHECK(symbol_of(plant, "L_P_D_I_B").address->number == 16);
  CHECK(symbol_of(plant, "L_P_E_I_B").address->number == 32);
}

TEST_CASE("The proof of a controller's list counts for its other lists") {
  const std::vector<Row> octal{{"L_P_D_I_A", "X0010", "BOOL", "", "%IX8"}};
  const Analysed plant = two({{"L_P_E_I_A", "X0020"}}, octal);
  CHECK(symbol_of(plant, "L_P_E_I_A").address->number == 16);
  CHECK(plant.model().lists[0].radix.by == RadixChoice::By::rows);
  CHECK(plant.count("radix-assumed") == 0);
  CHECK(two({{"L_P_E_I_A", "X0020"}}, octal, "PLC1", "PLC2").count("radix-assumed") == 1);
}

TEST_CASE("An assumption about a controller is reported once for all its lists") {
  const Analysed plant = two({{"L_P_D_I_A", "X1"}, {"L_P_D_I_B", "X10"}}, {{"L_P_E_I_A", "X20"}});
  CHECK(index_text(finding_of(plant, "radix-assumed")) == "X10");
  CHECK(two({{"L_P_D_I_B", "X10"}}, {{"L_P_E_I_A", "X20"}}, "PLC1", "PLC2").count("radix-assumed") == 2);
}

TEST_CASE("The most rows count if two lists of one controller count X and Y differently, with a warning") {
  const Analysed plant = two({{"L_P_D_I_A", "X0010", "BOOL", "", "%IX8"}}, {{"L_P_E_I_A", "X0010", "BOOL", "", "%IX16"},
                                                                            {"L_P_E_I_B", "X0011", "BOOL", "", "%IX17"},
                                                                            {"L_P_E_I_C", "X0020"}});
  CHECK(symbol_of(plant, "L_P_E_I_C").address->number == 32);
  const diag::Diagnostic& finding = finding_of(plant, "addresses-contradict");
  CHECK(finding.severity == diag::Severity::warning);
  CHECK(file_of(finding.location) == "first.csv");
  CHECK(index_text(finding) == "%IX8");
  CHECK(file_of(finding.related.front().location) == "second.csv");
}

TEST_CASE("The first option of one controller's lists counts, and a different one is reported") {
  const Analysed plant = analyse_lists({{"a.csv", list_text({{"L_P_D_I_A", "X10"}})},
                                        {"b.csv", list_text({{"L_P_E_I_A", "X20"}}), "", Radix::octal},
                                        {"c.csv", list_text({{"L_P_F_I_A", "X30"}}), "", Radix::hexadecimal}});
  CHECK(symbol_of(plant, "L_P_D_I_A").address->number == 8);
  CHECK(symbol_of(plant, "L_P_F_I_A").address->number == 24);
  CHECK(file_of(finding_of(plant, "radix-assumed").location) == "c.csv");
}

TEST_CASE("A list without a symbol is still a list") {
  const Analysed plant = two({{"M1", "M1"}}, kFirst, "PLC1", "PLC2");
  CHECK(plant.model().lists.size() == 2);
  CHECK(plant.model().controllers.size() == 2);
  CHECK(plant.model().symbols.front().list == 1);
}

TEST_CASE("A controller's name is valid in --link NAME=URL") {
  for (const char* good : {"PLC1", "Q03UDV (line 2)", "\xEC\x84\xA4\xEB\xB9\x84"})
    CHECK(description::is_controller_name(good));
  for (const char* bad : {"", "A=B", "A:B", " A", "A ", "A\nB", "A\x7F"}) {
    INFO(bad);
    CHECK_FALSE(description::is_controller_name(bad));
  }
}

/// "/links/0/controller: message", of a plant of these controllers.
std::string link_faults(const std::vector<std::string>& controllers, std::vector<description::LinkDescription> links) {
  std::vector<GivenList> lists;
  for (const std::string& name : controllers) {
    lists.push_back({"l" + std::to_string(lists.size()) + ".csv",
                     list_text({{"L_P_D" + std::to_string(lists.size()) + "_O_A", "Y1"}}), name});
  }
  description::Description description;
  description.links = std::move(links);
  const Analysed plant = analyse_lists(lists, std::move(description));
  std::string text;
  for (const description::DescriptionFault& fault : plant.evidence().faults) {
    text += fault.pointer + ": " + fault.message + "\n";
  }
  return text;
}

TEST_CASE("Links of the description name their controllers") {
  const std::string url = "modbus-tcp-server://:1502";
  CHECK(link_faults({"PLC1", "PLC2"}, {{url, "plc2"}, {url, "PLC1"}, {"loop:", ""}, {"loop:", "PLC1"}}) == "");
  CHECK(link_faults({""}, {{url, ""}}) == "");
  CHECK(link_faults({"PLC1"}, {{url, ""}}) == "");
  CHECK(link_faults({"PLC1", ""}, {{url, ""}}) == "");
  CHECK(link_faults({"PLC1", "PLC2"}, {{"loop:", ""}, {url, "PLC3"}}) ==
        "/links/1/controller: controller `PLC3` not found; did you mean `PLC1`?\n");
  CHECK(link_faults({"PLC1", "PLC2"}, {{url, ""}}) ==
        "/links/0: the plant has several controllers, and this link names none of them; give it a `controller`\n");
  CHECK(link_faults({"PLC1", "PLC2"}, {{url, "PLC1"}, {url, "PLC2"}, {url, "plc1"}}) ==
        "/links/2: this is the second link of its controller, and both would write its operations; remove one\n");
}

}  // namespace
}  // namespace symplant::test
