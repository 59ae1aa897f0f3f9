// Tests of the report on a proposed naming rule.
#include "infer/report.hpp"

#include <algorithm>
#include <random>

#include "infer/infer.hpp"
#include "unit/infer/samples.hpp"

namespace symplant::infer {
namespace {

using name::ArchetypeModel;
using name::ArchetypeRole;

name::SymbolRule rule_of(std::string pattern) {
  name::SymbolRule rule;
  rule.patterns.push_back({name::Source::name, std::move(pattern)});
  return rule;
}

name::Naming naming_of(std::vector<std::string> patterns) {
  name::Naming naming;
  for (std::string& pattern : patterns) naming.rules.push_back(rule_of(std::move(pattern)));
  return naming;
}

name::Archetype mirror(std::string operation, std::string event) {
  return {"mirror",
          ArchetypeModel::mirror,
          {{ArchetypeRole::operation, std::move(operation)}, {ArchetypeRole::event, std::move(event)}}};
}

/// "WHAT: LINKED of CANDIDATES, OPERATION -> EVENT; ..."
std::string links(const Report& report) {
  std::string all;
  for (const Correspondence& one : report.correspondences) {
    all.append(all.empty() ? "" : "; ").append(one.what).append(": ").append(std::to_string(one.linked));
    all.append(" of ").append(std::to_string(one.candidates)).append(", ").append(one.operation).append(" -> ");
    all.append(one.event);
  }
  return all;
}

std::string shapes(const Shapes& shapes) {
  std::string all;
  for (const TextShape& shape : shapes.shown) {
    all.append(all.empty() ? "" : "; ").append(std::to_string(shape.count)).append(" ").append(shape.text);
    all.append(", ").append(shape.example);
  }
  return all;
}

std::vector<std::string> robots() {
  std::vector<std::string> symbols;
  for (const char* robot : {"S1_RB1", "S1_RB2", "S2_RB1"}) {
    const std::string begin = std::string(robot) + " ";
    for (const char* text : {"Q PICK 1", "Q PICK 2", "Q GO", "I PICK ECHO 1", "I PICK ECHO 2", "I GO", "I AIR OK"}) {
      symbols.push_back(std::string(text).substr(0, 2) + begin + std::string(text).substr(2));
    }
  }
  symbols.emplace_back("Q S3_RB1 PICK 1");
  return symbols;
}

name::Naming robot_rule() {
  name::Naming naming = naming_of({"{process}_{device}_{task...}"});
  naming.archetypes.push_back(mirror("PICK {x}", "PICK ECHO {x}"));
  return naming;
}

TEST_CASE("Report: Each archetype and each rule that links is a correspondence, the largest first") {
  const Samples samples(robots());
  const Report report = report_of(robot_rule(), samples);
  CHECK(links(report) ==
        "PICK {x} -> PICK ECHO {x}, mirror: 6 of 7, S1_RB1 PICK 1 -> S1_RB1 PICK ECHO 1; "
        "{process}_{device}_{task...} (GO): 3 of 4, S1_RB1 GO -> S1_RB1 GO");
  CHECK(report.correspondences[0].archetypes == std::vector<std::size_t>{0});
  CHECK(report.correspondences[1].rules == std::vector<std::size_t>{0});
  CHECK(report.correspondences[1].needed_by == std::vector<std::size_t>{0});
  CHECK(report.score.paired() == 18);
  CHECK(report.operations == 10);
  CHECK(report.operations_paired == 9);
}

TEST_CASE("Report: A rule for operations and one for events that meet are one correspondence") {
  name::Naming naming = naming_of({"{device...}_CMD_{task...}", "{device...}_FBK_{task...}", "{device...}_{task}"});
  naming.rules[0].side = name::Direction::operation;
  naming.rules[1].side = name::Direction::event;
  const Samples samples({"Q A_CMD_1", "I A_FBK_1", "Q B_CMD_1", "I B_FBK_1", "Q C_X", "I C_X"});
  const Report report = report_of(naming, samples);
  CHECK(links(report) ==
        "{device...}_CMD_{task...} -> {device...}_FBK_{task...} (#): 2 of 2, A_CMD_1 -> A_FBK_1; "
        "{device...}_{task} (X): 1 of 1, C_X -> C_X");
  CHECK(report.correspondences[0].rules == std::vector<std::size_t>{0, 1});
  const name::Naming without = with_answers(naming, report, {0}, {});
  REQUIRE(without.rules.size() == 1);
  CHECK(without.rules[0].patterns[0].pattern == "{device...}_{task}");
}

TEST_CASE("Report: A constant archetype is a correspondence without operations") {
  name::Naming naming = robot_rule();
  naming.archetypes.push_back({"air", ArchetypeModel::constant, {{ArchetypeRole::event, "AIR OK"}}});
  const Report report = report_of(naming, Samples(robots()));
  REQUIRE(report.correspondences.size() == 3);
  CHECK(report.correspondences[2].what == "AIR OK, always on");
  CHECK(report.correspondences[2].linked == 3);
  CHECK(report.correspondences[2].candidates == 3);
  CHECK(report.correspondences[2].operation.empty());
  CHECK(report.constants == 3);
  CHECK(report.questions.empty());
}

TEST_CASE("Report: A refused correspondence links nothing any more") {
  const Samples samples(robots());
  const Report report = report_of(robot_rule(), samples);
  const name::Naming without = with_answers(robot_rule(), report, {0}, {});
  CHECK(without.archetypes.empty());
  CHECK(score_of(without, samples).paired() == 6);
  CHECK(with_answers(robot_rule(), report, {1}, {}).rules.empty());
}

TEST_CASE("Report: Contacts that may be on in a healthy plant are questions, and constants once accepted") {
  const Samples samples(robots());
  const Report report = report_of(robot_rule(), samples);
  REQUIRE(report.questions.size() == 1);
  CHECK(report.questions[0].shape.text == "S#_RB# AIR OK");
  CHECK(report.questions[0].shape.count == 3);
  const name::Naming with = with_answers(robot_rule(), report, {}, {0});
  REQUIRE(with.rest.size() == 1);
  CHECK(with.rest.front().role == name::Role::constant);
  CHECK(report.asked == 3);
  CHECK(report.left_over.shown.size() == 1);
  CHECK(score_of(with, samples).paired() == report.score.paired());
  CHECK(score_of(with, samples).accounted() == report.score.accounted() + 3);
}

TEST_CASE("Report: Alarms are no questions") {
  CHECK(report_of(robot_rule(), Samples({"I S1_RB1 AIR FAULT"})).questions.empty());
}

TEST_CASE("Report: A constant takes no linked event of its shape") {
  const Samples samples({"Q S1_RB1 READY", "I S1_RB1 READY", "I S1_RB2 READY"});
  const Report report = report_of(robot_rule(), samples);
  REQUIRE(report.questions.size() == 1);
  CHECK(report.questions[0].shape.count == 1);
  const name::Counts score = score_of(with_answers(robot_rule(), report, {}, {0}), samples);
  CHECK(score.paired() == 2);
  CHECK(score.accounted() == 3);
}

TEST_CASE("Report: Contacts that the rule leaves to questions are asked for") {
  name::Naming naming = robot_rule();
  naming.rest.push_back(rule_of("*_OK"));
  naming.rest.back().role = name::Role::none;
  const Samples samples(robots());
  const Report report = report_of(naming, samples);
  REQUIRE(report.questions.size() == 1);
  CHECK(score_of(with_answers(naming, report, {}, {0}), samples).accounted() == report.score.accounted() + 3);
}

TEST_CASE("Report: What is left over is counted by shape") {
  const Samples samples({"I K1.7", "I K22.4", "Q K3.1", "I spare 1"});
  name::Naming naming = robot_rule();
  naming.ignore.emplace_back("spare*");
  CHECK(shapes(report_of(naming, samples).left_over) == "2 K#.#, K1.7; 1 K#.#, K3.1");
}

TEST_CASE("Report: Only the commonest shapes are shown, and the others are counted") {
  std::vector<std::string> symbols;
  for (char c = 'a'; c <= 'z'; ++c) symbols.push_back(std::string("I ") + c + "1");
  symbols.emplace_back("I z2");
  const Report report = report_of(robot_rule(), Samples(symbols));
  CHECK(report.left_over.shown.size() == 20);
  CHECK(report.left_over.shown[0].text == "z#");
  CHECK(report.left_over.more_shapes == 6);
  CHECK(report.left_over.more_symbols == 6);
}

TEST_CASE("Report: Names that contradict the address are counted by shape") {
  const Samples samples({"Q S1_I_RB1_A ECHO", "Q S2_I_RB1_A ECHO", "I S1_I_RB1_B", "Q S1_O_RB1_C"});
  CHECK(shapes(report_of(naming_of({"{process}_{direction}_{device}_{task...}"}), samples).direction_conflicts) ==
        "2 S#_I_RB#_A ECHO, S1_I_RB1_A ECHO");
}

TEST_CASE("Report: An unpaired operation has the events that share most of its words") {
  const Samples samples(
      {"Q S1 TABLE TURN LEFT", "I S1 TABLE AT LEFT", "I S1 TABLE FREE", "I S9 OTHER LEFT", "Q S1 ALONE"});
  const Report report = report_of(naming_of({"{process}_{device}_{task...}"}), samples);
  REQUIRE(report.near_misses.size() == 1);
  CHECK(report.near_misses[0].operation == "S1 TABLE TURN LEFT");
  CHECK(report.near_misses[0].events == std::vector<std::string>{"S1 TABLE AT LEFT", "S1 TABLE FREE"});
}

TEST_CASE("Report: A series of motions against switches that are numbered otherwise is open for links by hand") {
  const Samples samples({"Q S1_SOL_CLAMP1_ADV", "Q S1_SOL_CLAMP2_ADV", "Q S1_SOL_CLAMP3_ADV", "I S1_LS_CLAMP11_ADV",
                         "I S1_LS_CLAMP12_ADV", "I S1_LS_CLAMP13_ADV", "Q S1_SOL_PIN1_ADV", "I S1_LS_PIN7_ADV"});
  const Report report = report_of(naming_of({"{process}_{class}_{device}_{task:known}"}), samples);
  CHECK(report.score.paired() == 0);
  REQUIRE(report.open_links.size() == 3);
  CHECK(report.open_links[1].operation == "S1_SOL_CLAMP2_ADV");
  CHECK(report.open_links[1].state == "ADV");
  CHECK(report.open_links[1].events ==
        std::vector<std::string>{"S1_LS_CLAMP11_ADV", "S1_LS_CLAMP12_ADV", "S1_LS_CLAMP13_ADV"});
}

TEST_CASE("Report: Symbols of another controller are no near miss") {
  std::vector<Sample> samples(2);
  samples[0].text.name = "S1 TABLE TURN LEFT";
  samples[0].side = name::Direction::operation;
  samples[1].text.name = "S1 TABLE AT LEFT";
  samples[1].side = name::Direction::event;
  for (Sample& sample : samples) sample.text.address = sample.side;
  const name::Naming naming = naming_of({"{process}_{device}_{task...}"});
  CHECK(report_of(naming, samples).near_misses.size() == 1);
  samples[1].controller = 1;
  CHECK(report_of(naming, samples).near_misses.empty());
}

TEST_CASE("Report: Pairs that their names do not prove are suspicious") {
  name::Naming naming = naming_of({"{process}_{device}_{task...}"});
  naming.archetypes = {mirror("PBLY {x}", "PBLX {x}"), mirror("{x} WORK COMP", "{x} START")};
  const Report report = report_of(naming, Samples({"Q S1 RB1 MUTUAL 1", "I S1 RB1 MUTUAL 1", "Q S1 GB1 PBLY A",
                                                   "I S1 GB1 PBLX A", "Q S1 RB1 2ND WORK COMP", "I S1 RB1 2ND START"}));
  REQUIRE(report.correspondences.size() == 3);
  std::vector<Suspicion> found;
  for (const Correspondence& one : report.correspondences) {
    REQUIRE(one.suspicious.size() == 1);
    CHECK(one.suspicious[0].count == 1);
    CHECK(one.suspicious[0].operation == one.operation);
    found.push_back(one.suspicious[0].why);
  }
  std::sort(found.begin(), found.end());
  CHECK(found ==
        std::vector{Suspicion::interlock_both_ways, Suspicion::lamp_and_button, Suspicion::completion_before_request});
}

TEST_CASE("Report: Names do not link if few of many outputs are paired") {
  std::vector<std::string> symbols;
  for (int i = 1; i <= 9; ++i) symbols.push_back("Q S1 CONVEYOR" + std::to_string(i) + " RUN");
  symbols.emplace_back("I S1 CONVEYOR1 RUN");
  const Report report = report_of(naming_of({"{process}_{device}_{task...}"}), Samples(symbols));
  CHECK(report.operations == 9);
  CHECK(report.operations_paired == 1);
  CHECK(report.names_do_not_link());
  CHECK_FALSE(report_of(robot_rule(), Samples(robots())).names_do_not_link());
}

TEST_CASE("Report: The order of the samples does not matter") {
  std::vector<std::string> symbols = robots();
  for (const char* more : {"Q S1 TABLE TURN LEFT", "I S1 TABLE AT LEFT", "I S1 TABLE FREE", "I K1.7", "I K22.4"}) {
    symbols.emplace_back(more);
  }
  const Report first = report_of(robot_rule(), Samples(symbols));
  std::mt19937 random(7);  // NOLINT: the same order in each run
  for (int i = 0; i < 20; ++i) {
    std::shuffle(symbols.begin(), symbols.end(), random);
    const Report shuffled = report_of(robot_rule(), Samples(symbols));
    CHECK(links(shuffled) == links(first));
    CHECK(shapes(shuffled.left_over) == shapes(first.left_over));
    REQUIRE(shuffled.near_misses.size() == first.near_misses.size());
    CHECK(shuffled.near_misses[0].events == first.near_misses[0].events);
  }
}

TEST_CASE("Report: No name breaks it") {
  std::vector<std::string> symbols = robots();
  const std::string large(std::size_t{1} << 16U, 'A');
  std::string blanks;
  for (int i = 0; i < 4'000; ++i) blanks += "A1_";
  for (const std::string& hostile : {std::string(), std::string("___"), large, blanks, std::string("{x}*|()\\"),
                                     std::string("\0\x01", 2), std::string("가나다라 3번")}) {
    symbols.push_back("Q " + hostile);
    symbols.push_back("I " + hostile);
    symbols.push_back("I " + hostile + " READY");
  }
  const Samples samples(symbols);
  const Report report = report_of(robot_rule(), samples);
  CHECK(report.score.paired() >= 18);
  std::set<std::size_t> all;
  for (std::size_t i = 0; i < report.questions.size(); ++i) all.insert(i);
  const name::Naming with = with_answers(robot_rule(), report, {}, all);
  std::vector<name::NamingFault> faults;
  name::CompiledNaming::compile(with, faults);
  for (const name::NamingFault& fault : faults) CHECK(fault.message.empty());
  CHECK(score_of(with, samples).accounted() >= report.score.accounted());
}

TEST_CASE("Report: Without samples it is empty") {
  const Report report = report_of(robot_rule(), {});
  CHECK(report.correspondences.empty());
  CHECK_FALSE(report.names_do_not_link());
}

}  // namespace
}  // namespace symplant::infer
