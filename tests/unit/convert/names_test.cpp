// The names that targets get.
#include "convert/names.hpp"

#include <numeric>
#include <string>
#include <vector>

#include "convert/identifiers.hpp"
#include "convert_support.hpp"

namespace symplant::convert {
namespace {

std::vector<std::string> names_of(const std::vector<std::string>& names, const NameRule& rule, Report& report) {
  std::string rows;
  for (const std::string& name : names) rows += "VAR_GLOBAL,\"" + name + "\",,,BOOL,,\n";
  const auto symbols = gx_list(rows);
  std::vector<std::uint32_t> all(symbols->all.size());
  std::iota(all.begin(), all.end(), 0U);
  const Names made(*symbols, all, rule, report);
  std::vector<std::string> result;
  for (const std::uint32_t i : all) result.emplace_back(made[i]);
  return result;
}

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("An identifier of IEC 61131-3 has letters, digits and single underscores, and is no word of the language") {
  for (const char* name : {"A", "a1", "_a", "_1", "EXLINE_MB_AGV_I_P1", "ON_TIME", "LEFT_LIMIT", "P1"}) {
    INFO(name);
    CHECK(is_iec_identifier(name));
    CHECK(iec_identifier(name) == name);
  }
  for (const char* name : {"", "1a", "a__b", "a_", "_", "a b", "a.b", "Gerät", "at", "BOOL", "Ton", "LIMIT_REAL",
                           "BOOL_TO_INT", "WORD_BCD_TO_UINT"}) {
    INFO(name);
    CHECK_FALSE(is_iec_identifier(name));
    CHECK(is_iec_identifier(iec_identifier(name)));
  }
}

TEST_CASE("A name becomes an identifier that reads like it") {
  CHECK(iec_identifier("Spare(5)") == "Spare_5");
  CHECK(iec_identifier("NO. 1  valve") == "NO_1_valve");
  CHECK(iec_identifier("1abc") == "_1abc");
  CHECK(iec_identifier("left") == "_left");
  CHECK(iec_identifier("__a") == "_a");
  CHECK(iec_identifier("밸브1") == "uBC38uBE0C1");
  CHECK(iec_identifier("***") == "_1");
  CHECK(iec_identifier("Local:1:I.Data[3]") == "Local_1_I_Data_3");
}

TEST_CASE("Names stay where they can, and made names are unique regardless of case") {
  Report report;
  CHECK(names_of({"a b", "a_b", "A_B", "a.b", "x"}, kIecNames, report) == Texts{"a_b_2", "a_b", "A_B_3", "a_b_4", "x"});
  CHECK(report.renames() == std::vector<Rename>{{"a b", "a_b_2"}, {"A_B", "A_B_3"}, {"a.b", "a_b_4"}});
  REQUIRE(report.lines().size() == 1);
  CHECK(report.lines().front() ==
        "3 names are changed: a variable has a unique identifier of letters, digits and `_`: `a b` is `a_b_2`, `A_B` "
        "is `A_B_3`, `a.b` is `a_b_4`");
}

TEST_CASE("A made name may be another symbol's name already") {
  Report report;
  CHECK(names_of({"a b", "a_b_2", "a_b"}, kIecNames, report) == Texts{"a_b_3", "a_b_2", "a_b"});
}

TEST_CASE("Tags of TIA Portal have 128 characters without quotes") {
  Report report;
  const std::string word(200, 'x');
  CHECK(names_of({"a \"\"b\"\"", word, word + "y", "Gerät 1"}, kTiaNames, report) ==
        Texts{"a 'b'", word.substr(0, 128), word.substr(0, 126) + "_2", "Gerät 1"});
  CHECK(is_tia_name(std::string(128, 'x')));
  CHECK_FALSE(is_tia_name(std::string(129, 'x')));
  CHECK(is_tia_name("밸브"));
  CHECK(tia_name("a\nb") == "a b");
}

TEST_CASE("Many equal names get numbers in linear time") {
  Report report;
  const std::vector<std::string> made = names_of(std::vector<std::string>(20000, "a b"), kIecNames, report);
  CHECK(made.back() == "a_b_20000");
}

}  // namespace symplant::convert
