// Tests of the counts under both naming rules.
#include "score/score.hpp"

#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/compile.hpp"

namespace symplant::test {
namespace {

using name::Account;

/// "no_event no_rule": the accounts in list order.
std::string accounts(const Analysed& analysed) {
  std::string text;
  for (const Account account : score::score_of(analysed.model()).accounts) {
    text.append(text.empty() ? "" : " ").append(name::account_key(account));
  }
  return text;
}

TEST_CASE("Under the built-in rule each symbol has its account") {
  std::vector<Row> rows = bits({"L_P_D_O_RUN", "L_P_D_I_RUN", "L_P_E_O_LAMP", "L_P_F_I_AIR*", "L_P_F_I_DOOR", "START"});
  rows.push_back({"L_P_D_I_LEVEL", "", "INT", "0", "%IW9"});
  const Analysed list = analyse_rows(rows);
  CHECK(accounts(list) == "paired paired no_event constant no_operation no_rule numeric");
  const score::PlantScore score = score::score_of(list.model());
  CHECK(score.total.counted() == 6);
  CHECK(score.total.paired() == 2);
  CHECK(score.total.accounted() == 3);
  CHECK(score.total.left_over() == 3);
  CHECK(score.named == 6);
}

TEST_CASE("A contact is constant if the leading symbol on its address keeps its value") {
  const Analysed list = analyse_rows({{"L_P_D_O_RUN", "Y0"},
                                      {"L_P_D_I_RUN", "X0"},
                                      {"L_P_E_I_RUNS", "X0", "BOOL", "TRUE"},
                                      {"L_P_F_I_AIR", "X1", "BOOL", "TRUE"},
                                      {"L_P_G_I_AIR", "X1", "BOOL", "TRUE"}});
  CHECK(accounts(list) == "paired paired no_operation constant constant");
}

TEST_CASE("Under a custom rule the pairing gives the accounts") {
  name::Naming naming;
  naming.ignore = {"SPARE*"};
  const auto rule = [](std::string pattern, name::Role role) {
    name::SymbolRule one;
    one.patterns.push_back({name::Source::name, std::move(pattern)});
    one.role = role;
    return one;
  };
  naming.rules = {rule("PB_{device}", name::Role::operator_panel), rule("OK_{device}", name::Role::constant),
                  rule("BIT_{device}", name::Role::data), rule("NONE_{device}", name::Role::none),
                  rule("S_{device}_{task}", name::Role::io)};
  const std::vector<Row> rows = {{"S_A_ADV", "", "BOOL", "FALSE", "%QX0"}, {"S_A_ADV1", "", "BOOL", "FALSE", "%IX1"},
                                 {"PB_1", "", "BOOL", "FALSE", "%IX2"},    {"OK_1", "", "BOOL", "FALSE", "%IX3"},
                                 {"BIT_1", "", "BOOL", "FALSE", "%IX4"},   {"NONE_1", "", "BOOL", "FALSE", "%IX5"},
                                 {"S_B_UP", "", "BOOL", "FALSE", "%QX6"},  {"S_C_UP", "", "BOOL", "FALSE", "%IX7"},
                                 {"SPARE_1", "", "BOOL", "FALSE", "%IX8"}, {"OTHER", "", "BOOL", "FALSE", "%IX9"},
                                 {"S_D_VALUE", "", "INT", "0", "%IW20"}};
  const Analysed list = analyse_by_rule(naming, {{"list.csv", list_text(rows)}});
  CHECK(accounts(list) ==
        "paired paired operator constant data role_none no_event no_operation ignored no_rule numeric");
  CHECK(score::score_of(list.model()).total.accounted() == 5);
}

}  // namespace
}  // namespace symplant::test
