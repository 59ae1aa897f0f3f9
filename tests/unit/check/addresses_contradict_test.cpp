// Compares the two addresses of a row.
#include <fmt/format.h>

#include "support/catch.hpp"
#include "support/compile.hpp"

namespace symplant::test {
namespace {

std::vector<Row> pairs(int count, int shift) {
  std::vector<Row> rows;
  for (int i = 0; i < count; ++i) {
    const std::string number = fmt::format("{:X}", 16 + i);
    rows.push_back({"L_P_DEV" + std::to_string(i) + "_O_ON", "Y" + number, "BOOL", "FALSE",
                    "%QX" + std::to_string(16 + i + shift)});
  }
  return rows;
}

TEST_CASE("Two notations of one address do not contradict each other") {
  CHECK(analyse_rows(pairs(20, 0)).count("addresses-contradict") == 0);
  // Different sizes, and parts beyond a link's number, cannot be compared.
  CHECK(analyse_rows({{"L_P_A_I_V", "X10", "WORD", "", "%IW1"}, {"L_P_B_I_V", "X11", "BOOL", "", "%IX1.2.3"}})
            .count("addresses-contradict") == 0);
  // Memory is not I/O, wherever it is.
  CHECK(analyse_rows({{"L_P_A_I_V", "M10", "BOOL", "", "%MX0.11"}}).count("addresses-contradict") == 0);
}

TEST_CASE("A contradicting row is reported, and its IEC address counts") {
  std::vector<Row> rows = pairs(20, 0);
  rows[3].iec = "%QX99";
  const Analysed list = analyse_rows(rows);
  CHECK(list.count("addresses-contradict") == 1);
  CHECK(list.model().symbols[3].address->number == 99);
}

TEST_CASE("Unrelated columns are reported once") {
  const Analysed list = analyse_rows(pairs(20, 1));
  CHECK(list.count("addresses-contradict") == 1);
  const Analysed few = analyse_rows(pairs(8, 1));
  REQUIRE(few.count("addresses-contradict") == 1);
  for (const diag::Diagnostic& finding : few.diagnostics.all()) {
    if (finding.rule->slug == "addresses-contradict") CHECK(finding.count == 8);  // of one shape
  }
}

TEST_CASE("A constant, and a row without an I/O address, are not checked") {
  std::vector<Row> rows = pairs(4, 1);
  for (Row& row : rows) row.klass = "VAR_GLOBAL_CONSTANT";
  rows.push_back({"L_P_A_I_V", "D10", "WORD", "", "%MW0.12"});
  rows.push_back({"L_P_B_I_ON", "X0", "BOOL", "", "%IX0"});
  CHECK(analyse_rows(rows).count("addresses-contradict") == 0);
}

TEST_CASE("A row that one of its addresses makes memory is reported") {
  const Analysed list = analyse_rows({{"L_P_B_I_ON", "X0", "BOOL", "", "%MX0"}});
  CHECK(list.count("addresses-contradict") == 1);
  CHECK(list.model().symbols.empty());
}

}  // namespace
}  // namespace symplant::test
