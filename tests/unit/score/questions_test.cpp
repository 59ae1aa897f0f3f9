// Tests of questions about contacts that are on in a healthy plant.
#include "score/questions.hpp"

#include <string>

#include "support/catch.hpp"
#include "support/compile.hpp"
#include "support/strings.hpp"
#include "support/tool.hpp"

namespace symplant::test {
namespace {

const std::string kList =
    "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial,Comment\n"
    "VAR_GLOBAL,S1_I_RB1_HOME_POS,,%IX0,BOOL,FALSE,\n"
    "VAR_GLOBAL,S1_I_RB2_HOME_POS,,%IX1,BOOL,FALSE,\n"
    "VAR_GLOBAL,S1_I_A7,,%IX2,BOOL,FALSE,main air\n"
    "VAR_GLOBAL,S1_I_AIRCRAFT,,%IX3,BOOL,FALSE,\n"
    "VAR_GLOBAL,S1_Q_LAMP_OK,,%QX4,BOOL,FALSE,\n"
    "VAR_GLOBAL,S1_Q_DRIVE,,%QX5,BOOL,FALSE,\n"
    "VAR_GLOBAL,S1_I_DRIVE,,%IX6,BOOL,FALSE,drive ok\n";
const std::string kRules = R"({"pattern": "{process}_{direction}_{device...}", "task": "ON"})";

std::string naming_json(const std::string& rest) {
  return R"({"symplant-naming": 1, "rest": [)" + rest + R"(], "rules": [)" + kRules + "]}";
}

TEST_CASE("Events without an operation whose name or comment ends in a healthy word are asked for, and no others") {
  MemoryFileSystem files;
  files.files["list.csv"] = kList;
  files.files["naming.json"] = naming_json("");
  const std::string text = run_tool({"check", "list.csv", "--naming", "naming.json", "--verbose"}, files).out;
  INFO(text);
  CHECK(contains(text,
                 "  a PLC often waits for these before it starts; make them constant:\n"
                 "       2 like S#_I_RB#_HOME_POS (S1_I_RB1_HOME_POS)\n"
                 "       1 like S#_I_A# (S1_I_A7)\n"
                 "  to do so, put this first in `rest` of naming.json, and keep only the correct words:\n"));
}

TEST_CASE("The rule that a question proposes makes all its events constant, and no other symbol") {
  MemoryFileSystem files;
  files.files["list.csv"] = kList;
  files.files["naming.json"] = naming_json("");
  const std::string asked = run_tool({"check", "list.csv", "--naming", "naming.json", "--verbose"}, files).out;
  const std::size_t rule = asked.find(R"({ "name": "healthy")");
  REQUIRE(rule != std::string::npos);
  CHECK(contains(asked, ": 0 constant,"));
  files.files["naming.json"] = naming_json(asked.substr(rule, asked.find('\n', rule) - rule));
  const std::string answered = run_tool({"check", "list.csv", "--naming", "naming.json", "--verbose"}, files).out;
  INFO(answered);
  CHECK(contains(answered, ": 3 constant,"));
  CHECK_FALSE(contains(answered, "a PLC often waits"));
}

TEST_CASE("Without an address the proposed rule names no side") {
  score::Questions questions;
  questions.words = {"ok", "home pos"};
  CHECK(questions.rule() ==
        R"-({ "name": "healthy", "side": "event", "pattern": "* (ok|home pos)", "role": "constant", "value": true })-");
  questions.by_address = false;
  CHECK(questions.rule() ==
        R"-({ "name": "healthy", "pattern": "* (ok|home pos)", "role": "constant", "value": true })-");
}

TEST_CASE("Under the built-in rule the initial value is proposed") {
  MemoryFileSystem files;
  files.files["list.csv"] = list_text(bits({"L_P_D_O_RUN", "L_P_D_I_RUN", "L_P_E_I_READY"}));
  const std::string text = run_tool({"check", "list.csv", "--verbose"}, files).out;
  CHECK(contains(text,
                 "1 like L_P_E_I_READY (L_P_E_I_READY)\n  give those that are on in a healthy plant the initial "
                 "value TRUE in the list\n"));
  files.files["list.csv"] = list_text(bits({"L_P_D_O_RUN", "L_P_D_I_RUN", "L_P_E_I_READY*"}));
  CHECK_FALSE(contains(run_tool({"check", "list.csv", "--verbose"}, files).out, "a PLC often waits"));
}

}  // namespace
}  // namespace symplant::test
