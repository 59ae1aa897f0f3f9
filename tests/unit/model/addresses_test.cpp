// The effects of addresses: direction, radix of X and Y, and symbols that share one.
#include "model_support.hpp"

namespace symplant::test {
namespace {

using address::Radix;
using model::RadixChoice;

TEST_CASE("The address decides the direction if the name disagrees, with a warning") {
  const Analysed list = analyse_rows({{"L_P_D_O_A", "X1"}, {"L_P_E_I_A", "", "BOOL", "", "%QX1"}});
  CHECK(symbol_of(list, "L_P_D_O_A").direction == tables::Direction::event);
  CHECK(symbol_of(list, "L_P_E_I_A").direction == tables::Direction::operation);
  CHECK(unit_of(list).events.size() == 1);
  CHECK(list.count("direction-against-address") == 2);
  CHECK(list.fired(diag::Severity::warning) == "direction-against-address direction-against-address");
}

TEST_CASE("A symbol without an address has the direction of its name, with a note") {
  const Analysed list = analyse_rows({{"L_P_D_O_A"}, {"L_P_D_I_A"}});
  CHECK(symbol_of(list, "L_P_D_O_A").direction == tables::Direction::operation);
  CHECK(symbol_of(list, "L_P_D_I_A").direction == tables::Direction::event);
  CHECK(list.count("no-address") == 1);
  CHECK(list.fired(diag::Severity::warning) == "");
}

TEST_CASE("An invalid address is reported once, and the name gives the direction") {
  const Analysed list = analyse_rows({{"L_P_D_O_A", "?Q?"}, {"L_P_D_I_A", "X1"}});
  CHECK(symbol_of(list, "L_P_D_O_A").direction == tables::Direction::operation);
  CHECK(list.count("address-not-understood") == 1);
  CHECK(list.count("no-address") == 0);
  CHECK(index_text(finding_of(list, "address-not-understood")) == "?Q?");
}

TEST_CASE("Rows with both addresses prove that X and Y count in hexadecimal or in octal") {
  const Analysed hex = analyse_rows({{"L_P_D_I_A", "X0010", "BOOL", "", "%IX16"}});
  CHECK(hex.model().lists.front().radix.radix == Radix::hexadecimal);
  CHECK(hex.model().lists.front().radix.by == RadixChoice::By::rows);
  const Analysed octal = analyse_rows({{"L_P_D_I_A", "X0010", "BOOL", "", "%IX8"}, {"L_P_E_I_A", "X0020"}});
  CHECK(octal.model().lists.front().radix.radix == Radix::octal);
  CHECK(symbol_of(octal, "L_P_E_I_A").address->number == 16);
  CHECK(octal.count("radix-assumed") == 0);
}

TEST_CASE("The proof of rows overrides the option") {
  const Analysed list =
      analyse_rows({{"L_P_D_I_A", "X0010", "BOOL", "", "%IX8"}, {"L_P_E_I_A", "X0020"}}, Radix::hexadecimal);
  CHECK(list.model().lists.front().radix.radix == Radix::octal);
  CHECK(symbol_of(list, "L_P_E_I_A").address->number == 16);
}

TEST_CASE("Without a proof the option counts, without a note") {
  const Analysed list = analyse_rows({{"L_P_D_I_A", "X0010"}}, Radix::octal);
  CHECK(list.model().lists.front().radix.by == RadixChoice::By::option);
  CHECK(symbol_of(list, "L_P_D_I_A").address->number == 8);
  CHECK(list.count("radix-assumed") == 0);
}

TEST_CASE("Without proof and option the radix is hexadecimal, with a note if a number from 10 on makes a difference") {
  const Analysed list = analyse_rows({{"L_P_D_I_A", "X0001"}, {"L_P_D_O_A", "Y0010"}, {"L_P_E_I_A", "X20"}});
  CHECK(list.model().lists.front().radix.radix == Radix::hexadecimal);
  CHECK(symbol_of(list, "L_P_D_O_A").address->number == 16);
  CHECK(index_text(finding_of(list, "radix-assumed")) == "Y0010");
  CHECK(analyse_rows({{"L_P_D_I_A", "X7"}, {"L_P_D_O_A", "Y0007"}}).count("radix-assumed") == 0);
  // Rows that agree in both systems prove nothing.
  CHECK(analyse_rows({{"L_P_D_I_A", "X7", "BOOL", "", "%IX7"}, {"L_P_D_O_A", "Y10"}}).count("radix-assumed") == 1);
}

TEST_CASE("A non-octal digit proves hexadecimal, except against an octal option or rows with both addresses") {
  const std::vector<Row> rows{{"L_P_D_O_A", "Y8"}, {"L_P_D_O_B", "YA"}, {"L_P_D_I_A", "X10"}};
  const Analysed list = analyse_rows(rows);
  CHECK(list.model().lists.front().radix.by == RadixChoice::By::rows);
  CHECK(list.count("radix-assumed") == 0);
  const Analysed octal = analyse_rows(rows, Radix::octal);
  CHECK(octal.model().lists.front().radix.by == RadixChoice::By::option);
  CHECK(octal.count("address-not-understood") == 2);
  CHECK(finding_of(analyse_rows({rows[0], rows[2]}, Radix::octal), "address-not-understood").message ==
        "`Y8` is not a valid address, since X and Y count in octal here (`--xy hex` changes that): `L_P_D_O_A` gets no "
        "address from it; correct it");
  const Analysed proved = analyse_rows({{"L_P_D_O_A", "Y8"}, {"L_P_D_I_A", "X0010", "BOOL", "", "%IX8"}});
  CHECK(proved.model().lists.front().radix.radix == Radix::octal);
}

TEST_CASE("Two operations on one address are kept equal, with a warning") {
  const Analysed list = analyse_rows({{"L_P_D_O_A", "Y1"}, {"L_P_E_O_A", "Y1"}, {"L_P_E_I_A", "X1"}});
  CHECK(symbol_of(list, "L_P_E_O_A").leader == 0);
  CHECK(symbol_of(list, "L_P_D_O_A").leader == model::kNone);
  CHECK(list.fired(diag::Severity::warning) == "address-used-twice");
  CHECK(list.model().units.size() == 2);
}

TEST_CASE("An event leads an unmodelled symbol on its address, in any order") {
  const Analysed list = analyse_rows({{"BUTTON", "X1"}, {"L_P_D_I_A", "X1"}, {"L_P_D_O_A", "Y1"}});
  CHECK(symbol_of(list, "BUTTON").leader == 1);
  CHECK(symbol_of(list, "L_P_D_I_A").leader == model::kNone);
  CHECK(list.count("address-used-twice") == 1);
  CHECK_FALSE(list.diagnostics.has_errors());
}

TEST_CASE("Of two events on one address that different units drive, the first keeps it, and only that is reported") {
  const Analysed list =
      analyse_rows({{"L_P_D_I_A", "X1"}, {"L_P_D_O_A", "Y1"}, {"L_P_E_I_A", "X1"}, {"L_P_E_O_A", "Y2"}});
  CHECK(list.fired(diag::Severity::warning) == "event-driven-twice");
  CHECK_FALSE(list.diagnostics.has_errors());
  CHECK(symbol_of(list, "L_P_D_I_A").address.has_value());
  CHECK_FALSE(symbol_of(list, "L_P_E_I_A").address.has_value());
  CHECK(symbol_of(list, "L_P_E_I_A").leader == model::kNone);
  const diag::Diagnostic& finding = finding_of(list, "event-driven-twice");
  CHECK(finding.message ==
        "`L_P_E_I_A` has the address `X1`, as `L_P_D_I_A` has, and the plant drives each of them: the address "
        "counts for `L_P_D_I_A` alone; correct one of them");
  CHECK(finding.location.source->position(finding.location.span.begin).line == 4);
}

TEST_CASE("Two events of one device on an address of another are one finding") {
  const Analysed list = analyse_rows({{"L_P_D_I_A", "X1"},
                                      {"L_P_D_O_A", "Y1"},
                                      {"L_P_E_I_A", "X1"},
                                      {"L_P_E_I_B", "X1"},
                                      {"L_P_E_O_A", "Y2"},
                                      {"L_P_E_O_B", "Y3"}});
  CHECK(list.count("event-driven-twice") == 1);
  CHECK(finding_of(list, "event-driven-twice").message.find("`L_P_E_I_A` and `L_P_E_I_B` have the address") == 0);
}

TEST_CASE("An event that no unit drives may share the address of one that a unit drives") {
  const Analysed list = analyse_rows({{"L_P_B_I_ON", "X1"}, {"L_P_D_I_A", "X1"}, {"L_P_D_O_A", "Y1"}});
  CHECK(list.fired(diag::Severity::warning) == "address-used-twice");
  CHECK(symbol_of(list, "L_P_B_I_ON").leader == 1);
}

TEST_CASE("Two events of one unit on one address are a warning") {
  const Analysed list =
      analyse_rows({{"L_P_D_I_A1", "X1"}, {"L_P_D_I_B2", "X1"}, {"L_P_D_O_A1", "Y1"}, {"L_P_D_O_B2", "Y2"}});
  CHECK(list.fired(diag::Severity::warning) == "address-used-twice");
}

TEST_CASE("One address in two notations is one address") {
  const Analysed list = analyse_rows({{"L_P_D_O_A", "Y1F"}, {"L_P_E_O_A", "", "BOOL", "", "%QX31"}});
  CHECK(list.count("address-used-twice") == 1);
}

TEST_CASE("A BOOL and a number on one address are not kept equal: the number has no bit there") {
  const Analysed list =
      analyse_rows({{"L_P_D_I_A", "X10"}, {"L_P_D_O_A", "Y1"}, {"LEVEL", "X10", "INT", "0"}}, Radix::hexadecimal);
  CHECK(list.fired(diag::Severity::warning) == "wrong-number-of-levels type-against-address");
  CHECK(symbol_of(list, "LEVEL").leader == model::kNone);
  CHECK(symbol_of(list, "L_P_D_I_A").leader == model::kNone);
  const Analysed number_first =
      analyse_rows({{"LEVEL", "X10", "INT", "0"}, {"L_P_B_I_ON", "X10"}, {"START", "X10"}}, Radix::hexadecimal);
  CHECK(symbol_of(number_first, "L_P_B_I_ON").leader == model::kNone);
  CHECK(symbol_of(number_first, "START").leader == 1);
}

}  // namespace
}  // namespace symplant::test
