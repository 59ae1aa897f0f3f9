// SP319: which addresses have common bits, in each notation.
#include <algorithm>

#include "../model/model_support.hpp"

namespace symplant::test {
namespace {

std::string overlaps(const Analysed& list) {
  std::string text;
  for (const diag::Diagnostic& finding : list.diagnostics.all()) {
    if (finding.rule->id == "SP319") text += (text.empty() ? "" : "; ") + index_text(finding);
  }
  return text;
}

TEST_CASE("A word of SIMATIC overlaps its bits, once for all of them") {
  std::vector<Row> rows{{"L_P_D_I_CODE", "IW0", "WORD", "0"}};
  for (int i = 0; i < 16; ++i) {
    rows.push_back({"L_P_D_I_B" + std::to_string(i), "I" + std::to_string(i / 8) + "." + std::to_string(i % 8)});
  }
  rows.push_back({"L_P_D_I_OTHER", "I2.0"});
  const Analysed list = analyse_in(address::Notation::siemens, rows);
  const diag::Diagnostic& finding = finding_of(list, "addresses-overlap");
  CHECK(finding.message ==
        "`L_P_D_I_CODE` on `IW0` has bits of `L_P_D_I_B0` on `I0.0`, and they are not kept equal: let the PLC program "
        "use either the number or its bits");
  CHECK(finding.severity == diag::Severity::note);
  CHECK(finding.related.size() == 1);
}

TEST_CASE("The larger symbol has the finding, or the first of two equally large ones") {
  const auto siemens = [](const std::vector<Row>& rows) {
    return overlaps(analyse_in(address::Notation::siemens, rows));
  };
  CHECK(siemens({{"A", "IW102", "INT", "0"}, {"B", "ID100", "DINT", "0"}}) == "ID100");
  CHECK(siemens({{"A", "IW100", "INT", "0"}, {"B", "IW101", "INT", "0"}}) == "IW100");
  CHECK(siemens({{"A", "IW100", "INT", "0"}, {"B", "IW102", "INT", "0"}}) == "");
  CHECK(siemens({{"A", "IW100", "INT", "0"}, {"B", "QW100", "INT", "0"}, {"C", "Q99.7"}}) == "");
  // Each number is reported, and one bit; then the symbol that reaches farthest.
  CHECK(siemens({{"A", "ID100", "DINT", "0"}, {"B", "IW102", "INT", "0"}, {"C", "I103.7"}}) == "ID100; ID100");
  CHECK(siemens({{"A", "IW100", "INT", "0"}, {"B", "IW101", "INT", "0"}, {"C", "IW102", "INT", "0"}}) ==
        "IW100; IW101");
  const Analysed two =
      analyse_in(address::Notation::siemens, {{"A", "ID100", "DINT", "0"}, {"B", "IW102", "INT", "0"}});
  const diag::Diagnostic& finding = finding_of(two, "addresses-overlap");
  CHECK(finding.message ==
        "`A` on `ID100` has bits of `B` on `IW102`, and they are not kept equal: correct one of the addresses");
  CHECK(finding.severity == diag::Severity::warning);
}

TEST_CASE("Equal addresses share one symbol's bits and do not overlap") {
  const Analysed list = analyse_in(address::Notation::siemens,
                                   {{"A", "IW0", "INT", "0"}, {"B", "EW 0", "INT", "0"}, {"C", "I0.0"}, {"D", "E0.0"}});
  CHECK(overlaps(list) == "IW0");
  CHECK(list.count("address-used-twice") == 2);
}

TEST_CASE("IEC words and MELSEC digit designations overlap their bits only") {
  CHECK(overlaps(analyse_rows({{"A", "", "INT", "0", "%IW5"}, {"B", "", "BOOL", "", "%IW5.3"}})) == "%IW5");
  CHECK(overlaps(analyse_rows({{"A", "", "INT", "0", "%IW0"}, {"B", "", "BOOL", "", "%IX0.3"}})) == "");
  CHECK(overlaps(analyse_rows({{"A", "K4X0", "INT", "0"}, {"B", "X3"}, {"C", "X10"}})) == "K4X0");
  CHECK(overlaps(analyse_rows({{"A", "K4X0", "INT", "0"}, {"B", "", "BOOL", "", "%IX3"}})) == "K4X0");
}

TEST_CASE("Addresses of different controllers do not overlap, nor those of symbols on no link") {
  const Row word{"A", "K4X0", "INT", "0"};
  const Row bit{"B", "X3"};
  CHECK(overlaps(analyse_lists({{"a.csv", list_text({word}), "PLC1"}, {"b.csv", list_text({bit}), "PLC2"}})) == "");
  CHECK(overlaps(analyse_lists({{"a.csv", list_text({word}), "PLC1"}, {"b.csv", list_text({bit}), "PLC1"}})) == "K4X0");
  CHECK(overlaps(analyse_rows({{"A", "K4X0", "BOOL"}, {"B", "X3"}})) == "");  // SP306 reports its type
}

TEST_CASE("Addresses that are not assigned are never equal, nor overlap") {
  const Analysed list = analyse_rows({{"L_P_D_I_A", "", "BOOL", "", "%I*"},
                                      {"L_P_D_I_B", "", "BOOL", "", "%I*"},
                                      {"L_P_D_I_N", "", "INT", "0", "%I*"}});
  CHECK(list.count("address-used-twice") == 0);
  CHECK(list.count("type-against-address") == 0);
  CHECK(overlaps(list) == "");
  CHECK(symbol_of(list, "L_P_D_I_N").direction == tables::Direction::event);
  const Analysed twice = analyse_rows({{"L_P_D_I_A", "", "BOOL", "", "%I*"}, {"L_P_D_I_A", "", "BOOL", "", "%I*"}});
  CHECK(twice.count("symbol-declared-differently") == 1);
}

}  // namespace
}  // namespace symplant::test
