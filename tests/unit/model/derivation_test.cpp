// From a unit's symbols to its I/O model: d_ext, the four inferences with all conditions, the initial state.
#include <algorithm>

#include "model_support.hpp"

namespace symplant::test {
namespace {

using description::Duration;
using model::InitialFrom;

Analysed analyse_bits(const std::vector<std::string>& names) { return analyse_rows(bits(names)); }

TEST_CASE("S contains every task that an operation or an event names") {
  const Analysed list = analyse_bits({"L_P_D_I_A", "L_P_D_O_B", "L_P_D_I_B", "L_P_D_O_C"});
  CHECK(states_text(unit_of(list)) == "A B C");
}

TEST_CASE("Every operation leads to its state from every other, sorted by S of the target, then of the source") {
  const Analysed list =
      analyse_bits({"L_P_D_O_C3", "L_P_D_I_C3", "L_P_D_O_A1", "L_P_D_I_A1", "L_P_D_O_B2", "L_P_D_I_B2"});
  CHECK(transitions_text(list, unit_of(list)) == "B2-O_A1>A1 C3-O_A1>A1 A1-O_B2>B2 C3-O_B2>B2 A1-O_C3>C3 B2-O_C3>C3");
  for (const model::Transition& t : unit_of(list).transitions) {
    CHECK(t.after == Duration{});
    CHECK(t.takes == Duration::fixed(tables::kSecond));
  }
  CHECK_FALSE(springs(unit_of(list)));
}

TEST_CASE("The derived model of the paper's cell equals the paper's") {
  const Analysed list =
      analyse_bits({"EXLINE_MB_AGV_I_P1", "EXLINE_MB_AGV_I_P2", "EXLINE_MB_AGV_O_P2", "EXLINE_MB_AGV_O_P1",
                    "EXLINE_MB_MC_I_IDLE1", "EXLINE_MB_MC_I_RUN2", "EXLINE_MB_MC_O_IDLE1", "EXLINE_MB_MC_O_RUN2"});
  const model::Unit& agv = unit_of(list, "EXLINE_MB_AGV");
  CHECK(states_text(agv) == "P1 P2");
  CHECK(initial_text(agv) == "P1");
  CHECK(transitions_text(list, agv) == "P2-O_P1>P1 P1-O_P2>P2");
  const model::Unit& mc = unit_of(list, "EXLINE_MB_MC");
  CHECK(states_text(mc) == "IDLE1 RUN2");
  CHECK(initial_text(mc) == "IDLE1");
  CHECK(transitions_text(list, mc) == "RUN2-O_IDLE1>IDLE1 IDLE1-O_RUN2>RUN2");
  CHECK(list.fired() == "");
}

// Inference 1.

TEST_CASE("One state with an operation and an event gets a rest state, ordered first, and a spring return to it") {
  const Analysed list = analyse_bits({"L_P_D_O_RUN", "L_P_D_I_RUN"});
  const model::Unit& unit = unit_of(list);
  CHECK(states_text(unit) == "NOT_RUN RUN");
  CHECK(springs(unit));
  CHECK(rest_text(unit) == "NOT_RUN");
  CHECK(initial_text(unit) == "NOT_RUN");
  CHECK(unit.initial_from == InitialFrom::rest_state);
  CHECK(unit.states[0].event == model::kNone);
  CHECK(unit.states[0].operation == model::kNone);
  CHECK(transitions_text(list, unit) == "NOT_RUN-O_RUN>RUN");
  CHECK(list.fired() == "");
}

TEST_CASE("One state with only an operation is a spring, too") {
  const Analysed list = analyse_bits({"L_P_D_O_GREEN"});
  CHECK(states_text(unit_of(list)) == "NOT_GREEN GREEN");
  CHECK(springs(unit_of(list)));
  CHECK(list.fired() == "");
}

TEST_CASE("One state with only an event is not a spring: something else drives it") {
  const Analysed list = analyse_bits({"L_P_D_I_ON"});
  const model::Unit& unit = unit_of(list);
  CHECK(states_text(unit) == "NOT_ON ON");
  CHECK_FALSE(springs(unit));
  CHECK(rest_text(unit) == "NOT_ON");
  CHECK(initial_text(unit) == "NOT_ON");
  CHECK(unit.transitions.empty());
  CHECK_FALSE(unit.moves());
  CHECK(list.fired() == "event-not-driven");
}

TEST_CASE("A push button with Initial TRUE starts pressed") {
  CHECK(initial_text(unit_of(analyse_bits({"L_P_D_I_ON*"}))) == "ON");
}

TEST_CASE("A single numbered state gets a rest state before it") {
  const Analysed list = analyse_bits({"L_P_D_O_RUN2", "L_P_D_I_RUN2"});
  CHECK(states_text(unit_of(list)) == "NOT_RUN2 RUN2");
  CHECK(initial_text(unit_of(list)) == "NOT_RUN2");
  CHECK(transitions_text(list, unit_of(list)) == "NOT_RUN2-O_RUN2>RUN2");
}

// Inference 2.

TEST_CASE("Two states, one with an operation and an event, the other with only an event, are a single solenoid") {
  for (const auto& names : {std::vector<std::string>{"L_P_D_O_ADV", "L_P_D_I_ADV", "L_P_D_I_RET"},
                            std::vector<std::string>{"L_P_D_I_RET", "L_P_D_I_ADV", "L_P_D_O_ADV"}}) {
    const Analysed list = analyse_bits(names);
    const model::Unit& unit = unit_of(list);
    CHECK(springs(unit));
    CHECK(rest_text(unit) == "RET");
    CHECK(initial_text(unit) == "RET");
    CHECK(transitions_text(list, unit) == "RET-O_ADV>ADV");
    CHECK(list.fired() == "");
  }
}

TEST_CASE("The commanded state may be numbered: only the other one counts") {
  CHECK(springs(unit_of(analyse_bits({"L_P_D_O_ADV2", "L_P_D_I_ADV2", "L_P_D_I_RET"}))));
}

TEST_CASE("A numbered state without an operation prevents a single solenoid") {
  const Analysed list = analyse_bits({"L_P_D_O_RUN2", "L_P_D_I_RUN2", "L_P_D_I_IDLE1"});
  CHECK_FALSE(springs(unit_of(list)));
}

TEST_CASE("Two states with operations, or three states, are no single solenoid") {
  CHECK_FALSE(springs(unit_of(analyse_bits({"L_P_D_O_ADV", "L_P_D_I_ADV", "L_P_D_O_RET", "L_P_D_I_RET"}))));
  CHECK_FALSE(springs(unit_of(analyse_bits({"L_P_D_O_ADV", "L_P_D_I_ADV", "L_P_D_I_RET", "L_P_D_I_MID"}))));
}

TEST_CASE("Two words, one with only an operation, the other with only an event, give a question and no inference") {
  const Analysed list = analyse_bits({"L_P_D_O_CLAMP", "L_P_D_I_CLAMPED"});
  const model::Unit& unit = unit_of(list);
  CHECK_FALSE(springs(unit));
  CHECK(rest_text(unit) == "none");
  CHECK(transitions_text(list, unit) == "CLAMPED-O_CLAMP>CLAMP");
  CHECK(list.fired(diag::Severity::warning) == "two-words-one-state");
}

TEST_CASE("Two numbered words, the second automatic, are no slip") {
  const Analysed list = analyse_bits({"L_P_D_O_RUN1", "L_P_D_I_DONE2"});
  CHECK(list.count("two-words-one-state") == 0);
  CHECK(transitions_text(list, unit_of(list)) == "DONE2-O_RUN1>RUN1 RUN1>DONE2");
}

TEST_CASE("A lone operation next to a state with both gives no question") {
  const Analysed list = analyse_bits({"L_P_D_O_ADV", "L_P_D_I_ADV", "L_P_D_O_RET"});
  CHECK_FALSE(springs(unit_of(list)));
  CHECK(list.count("two-words-one-state") == 0);
}

// Inference 3.

TEST_CASE("A numbered state with an event and no operation follows its predecessor") {
  const Analysed list =
      analyse_bits({"L_P_D_O_A1", "L_P_D_I_A1", "L_P_D_O_B2", "L_P_D_I_B2", "L_P_D_I_C3", "L_P_D_O_D4", "L_P_D_I_D4"});
  const model::Unit& unit = unit_of(list);
  const model::Transition& last = unit.transitions.back();
  CHECK(last.on == model::kNone);
  CHECK(unit.states[last.from].name == "B2");
  CHECK(unit.states[last.to].name == "C3");
  CHECK(last.after == Duration::fixed(tables::kSecond));
  CHECK(last.takes == Duration{});
  CHECK(list.fired() == "");
}

TEST_CASE("The lowest state follows the highest") {
  const Analysed list = analyse_bits({"L_P_D_O_RUN2", "L_P_D_I_RUN2", "L_P_D_I_IDLE1"});
  CHECK(transitions_text(list, unit_of(list)) == "IDLE1-O_RUN2>RUN2 RUN2>IDLE1");
  CHECK(initial_text(unit_of(list)) == "IDLE1");
  CHECK(list.fired() == "");
}

TEST_CASE("The predecessor is the next lower number, with or without gaps, and may have no event") {
  const Analysed list = analyse_bits({"L_P_D_O_A1", "L_P_D_I_A1", "L_P_D_O_B20", "L_P_D_I_C300"});
  CHECK(transitions_text(list, unit_of(list)) == "B20-O_A1>A1 C300-O_A1>A1 A1-O_B20>B20 C300-O_B20>B20 B20>C300");
}

TEST_CASE("Several states in a row may be automatic") {
  const Analysed list = analyse_bits({"L_P_D_O_S1", "L_P_D_I_S1", "L_P_D_I_S2", "L_P_D_I_S3"});
  CHECK(transitions_text(list, unit_of(list)) == "S2-O_S1>S1 S3-O_S1>S1 S1>S2 S2>S3");
}

TEST_CASE("Without an operation on a numbered state there is no sequence") {
  const Analysed list = analyse_bits({"L_P_D_I_S1", "L_P_D_I_S2", "L_P_D_O_GO", "L_P_D_I_GO"});
  CHECK(transitions_text(list, unit_of(list)) == "S1-O_GO>GO S2-O_GO>GO");
  CHECK(analyse_bits({"L_P_D_I_S1", "L_P_D_I_S2", "L_P_D_I_S3"}).model().units[0].transitions.empty());
}

TEST_CASE("States without a number take no part in a sequence") {
  const Analysed list = analyse_bits({"L_P_D_O_RUN2", "L_P_D_I_RUN2", "L_P_D_I_IDLE1", "L_P_D_I_FAULT"});
  CHECK(transitions_text(list, unit_of(list)) == "IDLE1-O_RUN2>RUN2 FAULT-O_RUN2>RUN2 RUN2>IDLE1");
  CHECK(list.count("event-without-operation") == 1);
}

TEST_CASE("A numbered state without an event is not automatic") {
  const Analysed list = analyse_bits({"L_P_D_O_A1", "L_P_D_I_A1", "L_P_D_O_B2"});
  CHECK(transitions_text(list, unit_of(list)) == "B2-O_A1>A1 A1-O_B2>B2");
}

TEST_CASE("Several states with the predecessor's number prevent the inference, with a warning") {
  const Analysed list = analyse_bits({"L_P_D_O_A1", "L_P_D_I_A1", "L_P_D_O_B1", "L_P_D_I_B1", "L_P_D_I_C2"});
  CHECK(transitions_text(list, unit_of(list)).find("C2 ") == std::string::npos);
  for (const model::Transition& t : unit_of(list).transitions) CHECK(t.on != model::kNone);
  // The ambiguous predecessor is a consequence of the duplicate number.
  CHECK(list.fired(diag::Severity::warning) == "sequence-repeated");
  const diag::Diagnostic& finding = finding_of(list, "sequence-repeated");
  CHECK(index_text(finding) == "L_P_D_O_B1");
  CHECK(std::any_of(finding.related.begin(), finding.related.end(), [](const diag::Related& related) {
    return related.message.starts_with("follows from this (event-without-operation)");
  }));
}

TEST_CASE("Numbers that differ only in leading zeros are one number") {
  const Analysed list = analyse_bits({"L_P_D_O_A1", "L_P_D_I_A1", "L_P_D_O_B01", "L_P_D_I_B01", "L_P_D_I_C2"});
  CHECK(list.count("sequence-repeated") == 1);
}

TEST_CASE("The highest state is ambiguous for the lowest if two states share it") {
  const Analysed list = analyse_bits({"L_P_D_I_A1", "L_P_D_O_B2", "L_P_D_I_B2", "L_P_D_O_C2", "L_P_D_I_C2"});
  CHECK(list.count("sequence-repeated") == 1);
  for (const model::Transition& t : unit_of(list).transitions) CHECK(t.on != model::kNone);
}

TEST_CASE("States of one number without operations all have the same predecessor") {
  const Analysed list = analyse_bits({"L_P_D_O_A1", "L_P_D_I_A1", "L_P_D_I_B2", "L_P_D_I_C2"});
  CHECK(transitions_text(list, unit_of(list)) == "B2-O_A1>A1 C2-O_A1>A1 A1>B2 A1>C2");
}

// Inference 4.

TEST_CASE("The only state whose event has Initial TRUE is the initial one") {
  const Analysed list = analyse_bits({"L_P_D_O_A1", "L_P_D_I_A1", "L_P_D_O_B2", "L_P_D_I_B2*"});
  CHECK(initial_text(unit_of(list)) == "B2");
  CHECK(unit_of(list).initial_from == InitialFrom::initial_column);
  CHECK(list.fired() == "");
}

TEST_CASE("Initial TRUE overrides the rest state") {
  const Analysed list = analyse_bits({"L_P_D_O_ADV", "L_P_D_I_ADV*", "L_P_D_I_RET"});
  CHECK(initial_text(unit_of(list)) == "ADV");
  CHECK(rest_text(unit_of(list)) == "RET");
}

TEST_CASE("Several events with Initial TRUE do not count, with a warning") {
  const Analysed numbered = analyse_bits({"L_P_D_O_A1", "L_P_D_I_A1*", "L_P_D_O_B2", "L_P_D_I_B2*"});
  CHECK(initial_text(unit_of(numbered)) == "A1");
  CHECK(numbered.fired(diag::Severity::warning) == "initial-ambiguous");
  CHECK(initial_text(unit_of(analyse_bits({"L_P_D_O_ADV", "L_P_D_I_ADV*", "L_P_D_I_RET*"}))) == "RET");
}

TEST_CASE("An operation's Initial TRUE does not affect the initial state, a note reports that it starts off") {
  const Analysed list = analyse_bits({"L_P_D_O_A1", "L_P_D_I_A1", "L_P_D_O_B2*", "L_P_D_I_B2"});
  CHECK(initial_text(unit_of(list)) == "A1");
  CHECK(list.fired() == "operation-initial-ignored");
}

TEST_CASE("Otherwise the first of S is the initial state, without a note if a number decides") {
  const Analysed list = analyse_bits({"L_P_D_O_B2", "L_P_D_I_B2", "L_P_D_O_A1", "L_P_D_I_A1"});
  CHECK(initial_text(unit_of(list)) == "A1");
  CHECK(unit_of(list).initial_from == InitialFrom::sequence);
  CHECK(list.fired() == "");
  CHECK(analyse_bits({"L_P_D_O_ZZ", "L_P_D_I_ZZ", "L_P_D_O_A1", "L_P_D_I_A1"}).fired() == "");
}

TEST_CASE("Where nothing else decides the initial state, the order of rows does") {
  const Analysed words = analyse_bits({"L_P_D_O_UP", "L_P_D_I_UP", "L_P_D_O_DOWN", "L_P_D_I_DOWN"});
  CHECK(initial_text(unit_of(words)) == "UP");
  CHECK(words.fired() == "");
  const Analysed equal = analyse_bits({"L_P_D_O_B1", "L_P_D_I_B1", "L_P_D_O_A1", "L_P_D_I_A1"});
  CHECK(initial_text(unit_of(equal)) == "B1");
  CHECK(equal.fired() == "");
}

// Units without operations, and without events.

TEST_CASE("A unit without operations has no d_ext and is reported once") {
  const Analysed list = analyse_bits({"L_P_D_I_S1", "L_P_D_I_S2"});
  CHECK(unit_of(list).transitions.empty());
  CHECK_FALSE(unit_of(list).moves());
  CHECK(list.fired() == "event-not-driven");
  CHECK(finding_of(list, "event-not-driven").severity == diag::Severity::note);
}

TEST_CASE("A unit without events moves") {
  const Analysed list = analyse_bits({"L_P_D_O_S1", "L_P_D_O_S2"});
  CHECK(transitions_text(list, unit_of(list)) == "S2-O_S1>S1 S1-O_S2>S2");
  CHECK(list.fired() == "");
}

TEST_CASE("An unreachable state and a state without an event are reported") {
  const Analysed unreached = analyse_bits({"L_P_D_O_A", "L_P_D_I_A", "L_P_D_O_B", "L_P_D_I_B", "L_P_D_I_C"});
  CHECK(unreached.fired(diag::Severity::warning) == "event-without-operation");
  CHECK(index_text(finding_of(unreached, "event-without-operation")) == "L_P_D_I_C");
  const Analysed silent = analyse_bits({"L_P_D_O_A", "L_P_D_I_A", "L_P_D_O_B", "L_P_D_I_B", "L_P_D_O_C"});
  CHECK(silent.fired(diag::Severity::warning) == "operation-without-event");
  CHECK(index_text(finding_of(silent, "operation-without-event")) == "L_P_D_O_C");
}

TEST_CASE("A device's symbols need not be adjacent in the list") {
  const Analysed list =
      analyse_bits({"L_P_D_O_A1", "L_P_E_O_A1", "L_P_D_I_A1", "L_P_E_I_A1", "L_P_D_O_B2", "L_P_E_O_B2"});
  CHECK(transitions_text(list, unit_of(list)) == transitions_text(list, unit_of(list, "L_P_E")));
}

TEST_CASE("The order of rows decides only ties") {
  const Analysed a = analyse_bits({"L_P_D_O_A1", "L_P_D_I_A1", "L_P_D_I_B2", "L_P_D_O_C3", "L_P_D_I_C3"});
  const Analysed b = analyse_bits({"L_P_D_I_C3", "L_P_D_O_C3", "L_P_D_I_B2", "L_P_D_I_A1", "L_P_D_O_A1"});
  CHECK(states_text(unit_of(a)) == states_text(unit_of(b)));
  CHECK(transitions_text(a, unit_of(a)) == transitions_text(b, unit_of(b)));
}

}  // namespace
}  // namespace symplant::test
