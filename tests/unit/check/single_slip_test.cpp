// One root cause gives one finding: a valid list with a single slip.
#include "../model/model_support.hpp"
#include "support/catch.hpp"
#include "support/compile.hpp"

namespace symplant::test {
namespace {

/// Two stations with a robot of two jobs and a valve each; only notes to find.
std::vector<Row> sound() {
  return bits({"L_S1_RBT_I_HOME1", "L_S1_RBT_I_WORK2", "L_S1_RBT_O_HOME1", "L_S1_RBT_O_WORK2", "L_S1_VLV_I_SHUT1",
               "L_S1_VLV_I_OPEN2", "L_S1_VLV_O_SHUT1", "L_S1_VLV_O_OPEN2"});
}

std::string with(std::size_t row, Row changed) {
  std::vector<Row> rows = sound();
  rows[row] = std::move(changed);
  return analyse_rows(rows).fired(diag::Severity::warning);
}

std::string with_more(Row more) {
  std::vector<Row> rows = sound();
  rows.push_back(std::move(more));
  return analyse_rows(rows).fired(diag::Severity::warning);
}

Row event(const std::string& name) { return {name, "", "BOOL", "FALSE", "%IX50"}; }

TEST_CASE("A valid list has no finding") { CHECK(analyse_rows(sound()).fired() == ""); }

TEST_CASE("An extra row with a slip in its name gives one finding") {
  CHECK(with_more(event("START")) == "wrong-number-of-levels");
  CHECK(with_more(event("L_S1_RBT_FAST_I_WORK3")) == "wrong-number-of-levels");
  CHECK(with_more(event("L__RBT_I_WORK3")) == "empty-level");
  CHECK(with_more(event("L_S1_RBT_X_WORK3")) == "direction-not-io");
  CHECK(with_more(event("L_S1_RBT-I_WORK3")) == "illegal-character");
}

TEST_CASE("The direction of the address is proposed for a word that is not one, or before it") {
  for (const std::string word : {"X", "0", "IN", "Input", "DI", "Light"}) {
    INFO(word);
    std::vector<Row> rows = sound();
    rows.push_back(event("EXTN_PLT1_FRT_" + word + "_Curtain1"));
    CHECK(finding_of(analyse_rows(rows), "direction-not-io").message ==
          "`EXTN_PLT1_FRT_" + word + "_Curtain1` has `" + word +
              "` where its direction belongs; write or insert `I`, as its address `%IX50` says");
  }
}

TEST_CASE("A copied and unchanged row gives one finding") {
  CHECK(with_more(sound()[0]) == "duplicate-symbol");
  Row elsewhere = sound()[0];
  elsewhere.iec = "%IX99";
  CHECK(with_more(elsewhere) == "symbol-declared-differently");
}

TEST_CASE("One wrong cell next to the name gives one finding") {
  Row row = sound()[0];
  row.iec = "I-O-1";
  CHECK(with(0, row) == "address-not-understood");
  row = sound()[0];
  row.initial = "YES";
  CHECK(with(0, row) == "initial-not-understood");
  row = sound()[0];
  row.iec = sound()[4].iec;  // the address of another device
  CHECK(with(0, row) == "event-driven-twice");
  row = sound()[2];
  row.iec = sound()[6].iec;
  CHECK(with(2, row) == "address-used-twice");
}

TEST_CASE("One address on the wrong side gives one finding") {
  // The operation's name is on an input; the event of its task exists already.
  Row row = sound()[3];
  row.iec = "%IX77";
  CHECK(with(3, row) == "direction-against-address");
  // The event's name is on an output.
  row = sound()[1];
  row.iec = "%QX77";
  CHECK(with(1, row) == "direction-against-address");
  // The wrong row precedes the right one.
  std::vector<Row> rows = sound();
  std::swap(rows[0], rows[2]);
  rows[0].iec = "%IX77";
  CHECK(analyse_rows(rows).fired(diag::Severity::warning) == "direction-against-address");
}

TEST_CASE("One missing row gives one finding, or none if the device is derived without the operation") {
  for (std::size_t i = 0; i < sound().size(); ++i) {
    std::vector<Row> rows = sound();
    rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(i));
    const Analysed list = analyse_rows(rows);
    INFO("without row " << i << ": " << list.fired());
    CHECK(list.diagnostics.all().size() == (sound()[i].name.find("_O_") == std::string::npos ? 1 : 0));
  }
}

TEST_CASE("One misspelled task gives one warning") {
  for (std::size_t i = 0; i < sound().size(); ++i) {
    std::vector<Row> rows = sound();
    rows[i].name += "X";
    const Analysed list = analyse_rows(rows);
    INFO("row " << i << ": " << list.fired());
    CHECK(list.diagnostics.count(diag::Severity::warning) == 1);
  }
}

}  // namespace
}  // namespace symplant::test
