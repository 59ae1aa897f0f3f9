// Naming rules inferred from invented lists.
#include "infer/infer.hpp"

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "infer/task_links.hpp"
#include "naming/naming_file.hpp"
#include "naming/naming_text.hpp"
#include "unit/infer/samples.hpp"

namespace symplant::infer {
namespace {

using Lines = std::vector<std::string>;

/// Stations with robots (select and echo, work handshake), clamps with classes, a panel, spares.
Lines body_shop() {
  Lines lines;
  for (const std::string station : {"T10", "T20", "T30"}) {
    for (const std::string robot : {"RB1", "RB2"}) {
      for (const std::string bit : {"1", "2", "4", "8", "16"}) {
        lines.push_back("Q " + station + "_Q_" + robot + "_JOB_SELECT_" + bit);
        lines.push_back("I " + station + "_I_" + robot + "_JOB_ECHO_" + bit);
      }
      for (const std::string turn : {"1ST", "2ND"}) {
        lines.push_back("Q " + station + "_Q_" + robot + "_" + turn + "_IN_OK");
        lines.push_back("I " + station + "_I_" + robot + "_" + turn + "_WORK_COMP");
      }
      lines.push_back("I " + station + "_I_" + robot + "_TIP_FAULT");
    }
    for (const std::string clamp : {"CLAMP1", "CLAMP2", "CLAMP3"}) {
      for (const std::string motion : {"ADV", "RET"}) {
        lines.push_back("Q " + station + "_SOL_" + clamp + "_" + motion);
        lines.push_back("I " + station + "_LS_" + clamp + "_" + motion + "1");
        lines.push_back("I " + station + "_LS_" + clamp + "_" + motion + "2");
      }
    }
    lines.push_back("I " + station + "_PB_START");
    lines.push_back("Q " + station + "_LAMP_START");
    lines.push_back("I " + station + "_I_SPARE1");
  }
  return lines;
}

Proposal inferred(const Lines& lines) { return infer(Samples(lines), {}); }

/// "operation>event" for each pair of a facet, sorted.
std::vector<std::string> pairs(const name::Naming& naming, const Lines& lines) {
  const Samples samples(lines);
  const std::span<const Sample> all = samples;
  std::vector<name::NamingFault> faults;
  const Applied applied = apply_rule(name::CompiledNaming::compile(naming, faults), all);
  std::vector<std::string> found;
  for (const pairing::Facet& facet : applied.pairing.facets) {
    for (const pairing::Member& a : facet.members) {
      for (const pairing::Member& b : facet.members) {
        if (all[a.input].side != name::Direction::operation || all[b.input].side != name::Direction::event) continue;
        found.push_back(std::string(all[a.input].text.name) + ">" + std::string(all[b.input].text.name));
      }
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

TEST_CASE("Clamps, robots and their handshakes are found without a hand") {
  const Lines lines = body_shop();
  const Proposal proposal = inferred(lines);
  const auto found = pairs(proposal.naming, lines);
  const auto has = [&](const std::string& pair) { return std::find(found.begin(), found.end(), pair) != found.end(); };
  CHECK(has("T10_SOL_CLAMP2_ADV>T10_LS_CLAMP2_ADV1"));
  CHECK(has("T10_SOL_CLAMP2_ADV>T10_LS_CLAMP2_ADV2"));
  CHECK(has("T20_Q_RB2_JOB_SELECT_8>T20_I_RB2_JOB_ECHO_8"));
  CHECK(has("T30_Q_RB1_2ND_IN_OK>T30_I_RB1_2ND_WORK_COMP"));
  CHECK_FALSE(has("T10_LAMP_START>T10_PB_START"));
  CHECK_FALSE(has("T10_SOL_CLAMP2_ADV>T10_LS_CLAMP1_ADV1"));
  CHECK_FALSE(has("T10_Q_RB1_JOB_SELECT_8>T10_I_RB1_JOB_ECHO_1"));
  CHECK(proposal.score.paired_share() > 0.9);
  CHECK(proposal.score.accounted_share() > 0.95);
  CHECK(proposal.score.counted() == lines.size() - 3);  // without spares
}

TEST_CASE("Two inferences of one list are equal, and the order of rows does not matter") {
  Lines lines = body_shop();
  const Proposal first = inferred(lines);
  CHECK(naming::naming_text(first.naming) == naming::naming_text(inferred(lines).naming));
  std::shuffle(lines.begin(), lines.end(), std::mt19937(5));
  CHECK(inferred(lines).score.paired() == first.score.paired());
}

TEST_CASE("An inferred rule is the same after it was written and read") {
  const Lines lines = body_shop();
  const Proposal proposal = inferred(lines);
  const naming::NamingReading read = naming::read_naming(naming::naming_text(proposal.naming));
  REQUIRE(read.naming.has_value());
  CHECK(read.faults.empty());
  CHECK(pairs(*read.naming, lines) == pairs(proposal.naming, lines));
}

TEST_CASE("The result is never below a known rule") {
  Lines lines;
  for (const std::string letter : {"A", "B", "C"}) {  // too few for any correspondence to be credible
    lines.push_back("Q GO." + letter);
    lines.push_back("I THERE." + letter);
  }
  name::Naming known;
  known.name = "known";
  known.rules.resize(2);
  known.rules[0].patterns = {{name::Source::name, "GO.{device}"}};
  known.rules[1].patterns = {{name::Source::name, "THERE.{device}"}};
  for (name::SymbolRule& rule : known.rules) rule.task = "GO";
  known.separators = ".";
  const Proposal proposal = infer(Samples(lines), std::vector<name::Naming>{known});
  CHECK(proposal.score.paired() == 6);
}

TEST_CASE("An alarm, a lamp or a healthy contact is not caused") {
  Lines lines;
  for (int i = 0; i < 8; ++i) {
    const std::string pump = "HALL_PUMP" + std::to_string(i);
    lines.insert(lines.end(), {"Q " + pump + "_MOTOR", "I " + pump + "_FAULT", "I " + pump + "_READY"});
  }
  CHECK(inferred(lines).score.paired() == 0);
}

TEST_CASE("Lists without texts, with one symbol or with numbers as names give no rule and no fault") {
  CHECK(inferred({}).naming.rules.empty());
  CHECK(inferred({"Q A"}).score.paired() == 0);
  CHECK(inferred({"Q 1", "I 2", "Q ", "I ___"}).score.paired() == 0);
}

TEST_CASE("Tasks in other words of one device are linked where three operations agree") {
  std::vector<Task> tasks;
  const auto add = [&](std::uint32_t device, bool operation, const std::vector<std::string>& words) {
    tasks.push_back({static_cast<std::uint32_t>(tasks.size()), device, 2, operation, tokens_of(words)});
  };
  for (std::uint32_t device = 0; device < 3; ++device) {
    add(device, true, {"count", "reset", "ok"});
    add(device, false, {"count", "reset", "taken"});
  }
  const name::Vocabulary vocabulary({}, {});
  const auto found = task_differences(tasks, vocabulary);
  REQUIRE(found.size() == 1);
  CHECK(found[0].operation == std::vector<std::string>{"ok"});
  CHECK(found[0].event == std::vector<std::string>{"taken"});
  CHECK(found[0].links.size() == 3);
  tasks.resize(4);
  CHECK(task_differences(tasks, vocabulary).empty());
}

TEST_CASE("Digits at the end of a word are a separate token") {
  const auto tokens = tokens_of({"plt3", "in", "12"});
  REQUIRE(tokens.size() == 4);
  CHECK(tokens[1].word == "3");
  CHECK(tokens[1].glued);
  CHECK_FALSE(tokens[3].glued);
}

}  // namespace
}  // namespace symplant::infer
