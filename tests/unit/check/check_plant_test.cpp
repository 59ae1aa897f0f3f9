// All rules at once.
#include "check/catalogue.hpp"
#include "check_support.hpp"
#include "diag/json.hpp"

using namespace symplant;
using namespace symplant::test;

namespace {

std::string found_by(const Analysed& analysed, std::size_t threads) {
  diag::Diagnostics diagnostics;
  check::check_plant(analysed.model(), analysed.evidence(), diagnostics, threads);
  CHECK(diagnostics.count(diag::Severity::warning) > 0);
  return diag::render_json(diagnostics.all());
}

}  // namespace

TEST_CASE("Several threads find what one finds, in its order") {
  std::vector<Row> rows = bits({"L_P_D_O_ADV", "L_P_D_I_ADV", "L_P_E_O_ADV", "L_P_E_I_AVD", "L_P_B_I_ON", "L_P_ON",
                                "L__B_I_ON", "L_P_B_X_ON", "L_P_C-1_I_ON", "L_P_RESET_O_EXTENDED_WORD", "LAMP"});
  for (Row& row : rows) row.address = "%IX3";
  const Analysed analysed = analyse_rows(rows);
  const std::string expected = found_by(analysed, 1);
  for (int i = 0; i < 20; ++i) REQUIRE(found_by(analysed, 4) == expected);
}
