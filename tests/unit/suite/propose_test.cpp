// Cases that are proposed: which there are, and which are chosen.
#include "suite/propose.hpp"

#include <set>
#include <sstream>

#include "suite/state_pairs.hpp"
#include "support/compile.hpp"
#include "support/strings.hpp"

namespace symplant::suite {
namespace {

using test::contains;

/// A device with two states and a button.
constexpr const char* kList =
    "L_P_AGV_O_P1,%QX0\nL_P_AGV_O_P2,%QX1\nL_P_AGV_I_P1,%IX0\nL_P_AGV_I_P2,%IX1\nL_P_PB_I_START,%IX2\n";

struct Made {
  Made() : text(test::compile_text(list(), "list.csv")), tables(text.tables().tables()) {}
  static std::string list() {
    std::string text = "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial\n";
    std::istringstream rows(kList);
    for (std::string row; std::getline(rows, row);) {
      const std::size_t comma = row.find(',');
      text += "VAR_GLOBAL," + row.substr(0, comma) + ",," + row.substr(comma + 1) + ",BOOL,\n";
    }
    return text;
  }
  test::CompiledText text;
  tables::PlantTables tables;
};

BaseRun some_base() {
  BaseRun base;
  base.phases = {100, 300};
  base.end = 1000 * tables::kMillisecond;
  base.acts = {{200, "\"set\":{\"L_P_PB_I_START\":true}"}};
  base.toggles["L_P_PB_I_START"] = {200};
  return base;
}

const Proposal& named(const std::vector<Proposal>& all, const std::string& name) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Proposal& one) { return one.name == name; });
  REQUIRE(found != all.end());
  return *found;
}

TEST_CASE("Inputs are changed and programs restarted in each phase, and devices start in each other state") {
  const Made made;
  const std::vector<Proposal> all = proposals_of(some_base(), "base", made.tables, true);
  std::set<std::string> names;
  for (const Proposal& one : all) CHECK(names.insert(one.name).second);
  CHECK(contains(named(all, "press-L_P_PB_I_START-in-phase-1").text,
                 "{ \"at\": \"100ns\", \"set\":{\"L_P_PB_I_START\":true} },\n"
                 "    { \"at\": \"200ns\", \"set\":{\"L_P_PB_I_START\":true} },\n"
                 "    { \"at\": \"500000100ns\", \"set\":{\"L_P_PB_I_START\":false} },\n"
                 "    { \"at\": \"1000000000ns\" }"));
  // In phase 2 the base case has it on.
  CHECK(contains(named(all, "press-L_P_PB_I_START-in-phase-2").text,
                 "{ \"at\": \"300ns\", \"set\":{\"L_P_PB_I_START\":false} }"));
  CHECK(contains(named(all, "restart-in-phase-2").text, "{ \"at\": \"300ns\", \"restart\":true }"));
  CHECK(contains(named(all, "start-with-L_P_AGV-in-P2").text, "\"state\":{\"L_P_AGV\":\"P2\"}"));
  CHECK(contains(named(all, "L_P_AGV-slow").text, "\"start\":\"L_P_AGV slow\""));
  CHECK(contains(named(all, "L_P_AGV_I_P2-stuck-on").text, "\"start\":\"L_P_AGV_I_P2 stuck on\""));
  CHECK_FALSE(names.contains("start-with-L_P_AGV-in-P1"));  // as it starts anyway
  CHECK_FALSE(names.contains("press-L_P_AGV_I_P1-in-phase-1"));
  const std::vector<Proposal> without = proposals_of(some_base(), "base", made.tables, false);
  CHECK(without.size() == all.size() - 2);
}

TEST_CASE("Of many proposals each kind keeps a share") {
  std::vector<Proposal> many;
  for (int i = 0; i < 90; ++i) many.push_back({Proposal::Kind::press, "p" + std::to_string(i), "", ""});
  for (int i = 0; i < 3; ++i) many.push_back({Proposal::Kind::restart, "r" + std::to_string(i), "", ""});
  std::string names;
  for (const Proposal& one : spread(many, 9)) names += one.name + " ";
  CHECK(names == "p0 p29 p43 p57 p71 p85 r0 r1 r2 ");
  CHECK(spread(many, 100).size() == 93);
}

TEST_CASE("Those with most pairs that are new come first") {
  CHECK(choose({{1}, {1, 2}, {3}, {}}, 3) == std::vector<std::size_t>{1, 2, 0});
  CHECK(choose({{}, {}}, 5) == std::vector<std::size_t>{0, 1});
}

TEST_CASE("A pair is a state and an operation that is on at one time, and a device that moves is in no state") {
  const Made made;
  const trace::PlantNames names(made.tables);
  const auto pairs = [&](const std::string& changes) {
    std::istringstream vcd(
        "$var string 1 a L_P_AGV $end\n$var wire 1 b L_P_AGV_O_P1 $end\n$var wire 1 c L_P_AGV_O_P2 $end\n" + changes);
    return state_pairs(vcd, names);
  };
  CHECK(pairs("#0\nsP1 a\n#10\n1c\nsP1->P2 a\n").size() == 1);
  CHECK(pairs("#0\nsP1 a\n#10\n1c\nsP1->P2 a\n#20\n1b\nsP2 a\n").size() == 3);
  CHECK(pairs("#0\nsP1 a\n").empty());
}

}  // namespace
}  // namespace symplant::suite
