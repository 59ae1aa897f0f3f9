// Naming rules inferred from invented lists.
#include "infer/infer.hpp"

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "infer/report.hpp"
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

/// One pair of texts for each of some stations, with `%` for the number of the station.
Lines stations(const Lines& lines, int count = 6) {
  Lines all;
  for (int i = 1; i <= count; ++i) {
    for (std::string line : lines) {
      for (std::size_t at = line.find('%'); at != line.npos; at = line.find('%'))
        line.replace(at, 1, std::to_string(i));
      all.push_back(std::move(line));
    }
  }
  return all;
}

bool has_pair(const Lines& lines, const std::string& pair) {
  const auto found = pairs(inferred(lines).naming, lines);
  return std::find(found.begin(), found.end(), pair) != found.end();
}

TEST_CASE("Interlocks with one text on both sides are apart, unless they are to be paired") {
  const Lines lines =
      stations({"Q Q_RB%_MUTUAL_INT1", "I I_RB%_MUTUAL_INT1", "Q Q_RB%_MUTUAL_INT2", "I I_RB%_MUTUAL_INT2",
                "Q Q_RB%_CLAMP_ADV", "I I_RB%_CLAMP_ADV", "Q Q_RB%_CLAMP_RET", "I I_RB%_CLAMP_RET"});
  const Proposal apart = inferred(lines);
  CHECK(apart.score.paired() == 24);
  CHECK(apart.score.of(name::Account::interlock) == 24);
  CHECK(apart.score.accounted() == 48);
  const Proposal paired = infer(Samples(lines), {}, Interlocks::paired);
  CHECK(paired.score.paired() == 48);
  const naming::NamingReading read = naming::read_naming(naming::naming_text(apart.naming));
  REQUIRE(read.naming.has_value());
  CHECK(read.faults.empty());
  CHECK(score_of(*read.naming, Samples(lines)).of(name::Account::interlock) == 24);
}

TEST_CASE("A word of interlocks that only one side has sets nothing apart") {
  const Lines lines = stations(
      {"Q S%_Q_INTERLOCK_LOCK", "I S%_I_INTERLOCK_LOCKED", "Q S%_Q_INTERLOCK_UNLOCK", "I S%_I_INTERLOCK_UNLOCKED"});
  CHECK(inferred(lines).score.of(name::Account::interlock) == 0);
}

TEST_CASE("A reset switches off what the event shows: it does not drive it, and nothing switches it on") {
  const Lines lines = stations({"Q S1_Q_RB%_WORK_COMP_RST", "I S1_I_RB%_LAST_WORK_COMP", "Q S1_Q_RB%_PROG_SELECT_1",
                                "I S1_I_RB%_PROG_ECHO_1", "Q S1_Q_RB%_PROG_SELECT_2", "I S1_I_RB%_PROG_ECHO_2"});
  CHECK(has_pair(lines, "S1_Q_RB3_PROG_SELECT_2>S1_I_RB3_PROG_ECHO_2"));
  const std::vector<name::Archetype> archetypes = inferred(lines).naming.archetypes;
  const auto reset = std::find_if(archetypes.begin(), archetypes.end(),
                                  [](const name::Archetype& one) { return one.name == "last-work-comp"; });
  REQUIRE(reset != archetypes.end());
  CHECK(reset->model == name::ArchetypeModel::handshake);
  using Text = std::pair<name::ArchetypeRole, std::string>;
  CHECK(reset->texts == std::vector<Text>{{name::ArchetypeRole::done, "last work comp"},
                                          {name::ArchetypeRole::reset, "work comp rst"}});
}

TEST_CASE("A lamp and the contact or button of one text are no pair") {
  const Lines lines = stations(
      {"Q L%_OVERLOAD", "I L%_OVERLOAD", "Q L%_RESET", "I L%_RESET", "Q L%_UP", "I L%_UP", "Q L%_DOWN", "I L%_DOWN"});
  CHECK(has_pair(lines, "L3_UP>L3_UP"));
  CHECK_FALSE(has_pair(lines, "L3_OVERLOAD>L3_OVERLOAD"));
  CHECK_FALSE(has_pair(lines, "L3_RESET>L3_RESET"));
}

TEST_CASE("One lamp of a reset button leaves the resets of robots as they are") {
  Lines lines = stations({"Q S1_Q_RB%_WORK_COMP_RST", "I S1_I_RB%_LAST_WORK_COMP", "Q S1_Q_RB%_PROG_SELECT_1",
                          "I S1_I_RB%_PROG_ECHO_1", "Q S1_Q_RB%_PROG_SELECT_2", "I S1_I_RB%_PROG_ECHO_2"});
  lines.emplace_back("Q S1_Q_PANEL_RST");
  lines.emplace_back("I S1_I_PANEL_RST");
  const auto accounts = inferred(lines).score;
  CHECK(accounts.of(name::Account::operator_panel) == 0);
}

TEST_CASE("A permission and an interlock of another text are no pair, unlike a permission and what it starts") {
  const Lines lines = stations({"Q S1_Q_RB%_PLT2_IN_OK", "I S1_I_RB%_PLT2_NON_INTF", "Q S1_Q_RB%_1ST_IN_OK",
                                "I S1_I_RB%_1ST_WORK_COMP", "Q S1_Q_RB%_PROG_SELECT_1", "I S1_I_RB%_PROG_ECHO_1"});
  CHECK(has_pair(lines, "S1_Q_RB3_1ST_IN_OK>S1_I_RB3_1ST_WORK_COMP"));
  CHECK_FALSE(has_pair(lines, "S1_Q_RB3_PLT2_IN_OK>S1_I_RB3_PLT2_NON_INTF"));
}

TEST_CASE("Program 1 of robot 4 is not program 4 of robot 1") {
  Lines lines;
  for (const std::string bit : {"1", "2", "4", "8"}) {
    for (const std::string& line : stations({"Q S1_INTO_RB%_PROGRAM_NO_", "I S1_INTI_RB%_PROGRAM_ECHO_"}, 8))
      lines.push_back(line + bit);
  }
  CHECK(inferred(lines).score.paired() == lines.size());
  CHECK(has_pair(lines, "S1_INTO_RB4_PROGRAM_NO_1>S1_INTI_RB4_PROGRAM_ECHO_1"));
  CHECK_FALSE(has_pair(lines, "S1_INTO_RB4_PROGRAM_NO_1>S1_INTI_RB1_PROGRAM_ECHO_4"));
}

TEST_CASE("Two letters say a direction if the other side has the same text: TO and FR do, RH does not") {
  CHECK(has_pair(stations({"Q TO:STM.%Servo On", "I FR:STM.%Servo On", "Q TO:STM.%Drive", "I FR:STM.%Busy"}, 8),
                 "TO:STM.3Servo On>FR:STM.3Servo On"));
  const Lines sides = stations({"Q BC%_Q_READY_ON", "I BC%_I_READY_ON", "Q BC%_Q_HOME", "I BC%_I_HOME",
                                "I S%_LH_AREA_CHK", "I S%_RH_AREA_CHK", "I S%_RH_MAT_CHK", "I S%_RH_GATE_CHK"});
  CHECK(naming::naming_text(inferred(sides).naming).find("\"rh\": \"event\"") == std::string::npos);
}

TEST_CASE("Plain pairs are found: feedback, started, brackets, words behind a direction") {
  CHECK(has_pair({"Q brakes Contactor 1", "I brakes Contactor 1 feedback", "Q brakes Contactor 2",
                  "I brakes Contactor 2 feedback", "Q slew Contactor 1", "I slew Contactor 1 feedback"},
                 "slew Contactor 1>slew Contactor 1 feedback"));
  const Lines carts = stations({"Q Cart #% Align ADV [1,2]", "I Cart #% Align ADV [1]", "I Cart #% Align ADV [2]",
                                "Q Cart #% Align RET [1,2]", "I Cart #% Align RET [1]", "I Cart #% Align RET [2]"});
  CHECK(has_pair(carts, "Cart #2 Align ADV [1,2]>Cart #2 Align ADV [1]"));
  CHECK(has_pair(carts, "Cart #2 Align ADV [1,2]>Cart #2 Align ADV [2]"));
  CHECK_FALSE(has_pair(carts, "Cart #2 Align ADV [1,2]>Cart #3 Align ADV [2]"));
  const Lines lifts =
      stations({"Q qResin%_MotorUp", "I iResin%_LimitUp", "Q qResin%_MotorDown", "I iResin%_LimitDown"});
  CHECK(has_pair(lifts, "qResin2_MotorUp>iResin2_LimitUp"));
  CHECK_FALSE(has_pair(lifts, "qResin2_MotorUp>iResin3_LimitUp"));
  CHECK(has_pair(stations({"Q O_MIS_3107%_S", "I I_MIS_3107%_R"}), "O_MIS_31072_S>I_MIS_31072_R"));
  const Lines conveyors = stations({"Q oConv%_run", "I iConv%_running", "I iConv%_prox"});
  CHECK(has_pair(conveyors, "oConv2_run>iConv2_running"));
  CHECK_FALSE(has_pair(conveyors, "oConv2_run>iConv2_prox"));
}

TEST_CASE("A lamp of two words is not the command of a fault of two words") {
  const Lines lines = stations({"Q qConv%_10_Light_Ind", "I iConv%_10_VSD_F"}, 20);
  CHECK(inferred(lines).score.paired() == 0);
}

TEST_CASE("Texts that mean no text are spare") {
  Lines lines = stations({"Q S%_SOL_CLAMP_ADV", "I S%_LS_CLAMP_ADV", "Q S%_SOL_CLAMP_RET", "I S%_LS_CLAMP_RET"});
  const std::size_t real = lines.size();
  for (const char* text : {"I -", "I [T]", "Q [D]", "Q [DT]", "I ---", "I Reserva I0.1", "Q RISERVA 3"})
    lines.emplace_back(text);
  const Proposal proposal = inferred(lines);
  CHECK(proposal.score.counted() == real);
  CHECK(proposal.score.paired() == real);
  CHECK(inferred({"I [TABLE]", "Q T", "I D-1"}).score.counted() == 3);
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
