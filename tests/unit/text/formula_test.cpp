// Cells that a spreadsheet would run.
#include "text/formula.hpp"

#include <string>

#include "support/catch.hpp"

namespace symplant::text {

TEST_CASE("Text that a spreadsheet would run is a formula, numbers and lone signs are not") {
  for (const char* cell :
       {"=1+1", "+A1", "-A1", "@SUM(A1)", "=", "@", "\t=1", "\n=1", "-1+1", "+1.", "1=", "＝1+1", "－a"}) {
    INFO(cell);
    CHECK(is_formula(cell) == (cell[0] != '1'));
  }
  for (const char* cell : {"", "-", "--", "+-", "-5", "+5", "-1.5", "-1.5e-3", "-2E10", "5", "A=1", "'=1", "%IX1"}) {
    INFO(cell);
    CHECK_FALSE(is_formula(cell));
  }
}

TEST_CASE("A protected cell is not a formula, and gives the text back") {
  const std::string apostrophe = "'";
  for (const std::string text :
       {"=1+1", "'=1+1", "''=1+1", "@a", "'", "''", "'a", "-", "'-5", "\r\n=1", "＝1", "plain", ""}) {
    INFO(text);
    const std::string cell = needs_protection(text) ? apostrophe + text : text;
    CHECK_FALSE(is_formula(cell));
    CHECK(unprotected(cell) == text);
  }
}

}  // namespace symplant::text
