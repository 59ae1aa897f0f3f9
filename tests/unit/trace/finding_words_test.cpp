// Findings in the words of a PLC programmer: one sentence for each kind.
#include "symplant/trace/finding_words.hpp"

#include <sstream>

#include "support/plant_bench.hpp"
#include "support/strings.hpp"
#include "symplant/tables/missed_pulse.hpp"
#include "symplant/tables/refusal.hpp"
#include "symplant/trace/finding_file.hpp"
#include "symplant/trace/recorder.hpp"

namespace symplant::test {
namespace {

/// A plant whose records become sentences, "2 s: ...", one per line.
class Reporter {
 public:
  explicit Reporter(const BenchTables& tables)
      : tables_(tables), names_(tables.rows), history_(names_), recorder_(tables.rows, 1024), plant(tables.rows) {
    recorder_.attach(plant);
    to(0);
  }
  Reporter& set(const std::string& name, bool on) {
    plant.set_operation(tables_.rows.symbols[tables_.symbol(name)].index, on);
    return *this;
  }
  Reporter& to(tables::Time milliseconds) {
    plant.advance_to(milliseconds * kMs, &recorder_);
    std::vector<trace::FoundThing> found;  // of one instant: reported with the plant's state at its end
    bool more = false;
    recorder_.drain([&](const trace::Record& record) {
      history_.apply(record);
      if (record.kind == trace::Record::Kind::finding) {
        if (!more) found.push_back({record.time, record.finding, {}});
        found.back().of.push_back(record.of);
        more = record.more;
      }
      if (!record.last) return;
      for (const trace::FoundThing& thing : found) {
        reported += trace::seconds(thing.time) + ": " + trace::finding_words(thing, names_, history_) + "\n";
        names += trace::name_of(thing, names_) + "\n";
      }
      found.clear();
    });
    return *this;
  }
  std::string reported;
  std::string names;

 private:
  const BenchTables& tables_;
  trace::PlantNames names_;
  trace::History history_;
  trace::Recorder recorder_;

 public:
  plant::OwnedPlant plant;
};

const std::vector<std::string> kAgv = {"AGV_I_P1", "AGV_I_P2", "AGV_O_P2", "AGV_O_P1"};

TEST_CASE("A unit's finding shows its state and its operations, an operation's shows its address and row") {
  const BenchTables tables(kAgv);
  Reporter reporter(tables);
  reporter.set("AGV_O_P2", true).set("AGV_O_P1", true).to(500);
  CHECK(reporter.reported ==
        "0.5 s: conflicting operations: L_P_AGV (P1) has commands to several states at once and obeys none of them; "
        "operations: %QX2 (P2 of L_P_AGV) on since 0.5 s, %QX3 (P1 of L_P_AGV) on since 0.5 s; check for a missing "
        "interlock between these outputs\n");
  reporter.reported.clear();
  reporter.set("AGV_O_P2", false).to(700);
  CHECK(contains(reporter.reported,
                 "0.7 s: lost command: PLC output %QX2, operation P2 of L_P_AGV (symbols.csv:4), on since "
                 "0.5 s, went off before L_P_AGV (P1) moved; check"));
}

TEST_CASE("A command without effect, and one to a disabled device, report the reason") {
  Reported reported;
  reported.disables("DOOR", "SHUT2", "AGV").on_command("AGV", "P1", "P2", fixed(100 * kMs));
  reported.device("AGV").only = true;
  const BenchTables tables({"AGV_I_P1", "AGV_I_P2", "AGV_O_P2", "AGV_O_P1", "DOOR_I_OPEN1", "DOOR_I_SHUT2"}, reported);
  Reporter reporter(tables);
  reporter.plant.set_state(tables.unit_index("DOOR"), tables.state_index("DOOR", "SHUT2"));
  reporter.to(100).set("AGV_O_P2", true).to(200);
  CHECK(contains(reporter.reported,
                 "0.2 s: command to a disabled unit: PLC output %QX2, operation P2 of L_P_AGV (symbols.csv:4), "
                 "came on while L_P_AGV (P1, disabled) cannot move, disabled by L_P_DOOR in SHUT2"));
  reporter.reported.clear();
  reporter.plant.set_state(tables.unit_index("DOOR"), tables.state_index("DOOR", "OPEN1"));
  reporter.to(300);
  CHECK(contains(reporter.reported,
                 "0.2 s: started on enabling: L_P_AGV (P1->P2) started to move as soon as it was no longer disabled"));
  reporter.reported.clear();
  reporter.to(400).set("AGV_O_P2", false).to(500).set("AGV_O_P1", true).to(600);
  CHECK(contains(reporter.reported,
                 "0.6 s: command without effect: PLC output %QX3, operation P1 of L_P_AGV (symbols.csv:5), "
                 "came on while L_P_AGV is in P2, from where it has no transition"));
}

TEST_CASE("A stopped held device reports which command is on instead") {
  Reported reported;
  reported.device("AGV").actuation = tables::Actuation::held;
  const BenchTables tables({"AGV_I_P1", "AGV_I_P2", "AGV_I_P3", "AGV_O_P1", "AGV_O_P2", "AGV_O_P3"}, reported);
  Reporter reporter(tables);
  reporter.set("AGV_O_P2", true).to(100).set("AGV_O_P2", false).set("AGV_O_P3", true).to(200);
  CHECK(contains(reporter.reported,
                 "0.2 s: stopped under another command: L_P_AGV (P1->P2, stopped midway) has stopped, since"));
  CHECK(contains(reporter.reported,
                 "%QX5 (P3 of L_P_AGV) on since 0.2 s, %QX4 (P2 of L_P_AGV) on at 0.1 s, off since 0.2 s"));
}

TEST_CASE("An instantaneous loop names its units in one finding") {
  const BenchTables tables({"A_I_P1", "A_I_P2"},
                           Reported().by_itself("A", "P1", "P2", fixed(0)).by_itself("A", "P2", "P1", fixed(0)));
  Reporter reporter(tables);
  CHECK(contains(
      reporter.reported,
      "0 s: instantaneous loop: L_P_A loops through states without time passing and is frozen until the run ends"));
  CHECK(contains(reporter.names, "L_P_A\n"));
}

TEST_CASE("An event within one instant is too short for a PLC") {
  const BenchTables tables({"A_I_P1", "A_I_P2", "A_I_P3", "A_O_P2"}, Reported().by_itself("A", "P2", "P3", fixed(0)));
  Reporter reporter(tables);
  reporter.set("A_O_P2", true).to(100).to(2000);
  CHECK(
      contains(reporter.reported,
               "1.1 s: event too short: PLC input %IX1, event P2 of L_P_A (symbols.csv:3), changed and changed back"));
  CHECK(contains(reporter.reported, "L_P_A is in P3; operations: %QX3 (P2 of L_P_A) on since 0.1 s"));
}

TEST_CASE("What a PLC refuses is reported with the request, its address and the code in words") {
  using Side = tables::Refusal::Side;
  const BenchTables tables(kAgv);
  trace::PlantNames names(tables.rows);
  names.name_links({{"PLC1", "", ""}});
  const trace::History history(names);
  const auto words = [&](tables::FindingKind kind, std::uint32_t of, const tables::Refusal& refusal) {
    return trace::finding_words({0, kind, {of}, tables::pack(refusal)}, names, history);
  };
  CHECK(contains(words(tables::FindingKind::request_refused, 0, {Side::modbus_client, 15, 2, 800}),
                 "request refused: PLC1, the PLC refused function 15 (write coils) from 800 on: exception 02 (illegal "
                 "data address)"));
  CHECK(contains(words(tables::FindingKind::request_refused, 0, {Side::slmp_client, 0x11, 0x4031, 0xA8000064}),
                 "request refused: PLC1, the PLC refused writing from D100 on: end code 4031"));
  const std::string left_out =
      words(tables::FindingKind::symbol_left_out, 2, {Side::slmp_client, 0x80, 0x4031, 0x9D000008});
  CHECK(contains(left_out, "symbol left out: PLC output %QX2, operation P2 of L_P_AGV (symbols.csv:4), the PLC"));
  CHECK(contains(left_out, "it refused reading from Y10 on: end code 4031"));
}

TEST_CASE("Times are printed exactly, without trailing zeros") {
  CHECK(trace::seconds(0) == "0 s");
  CHECK(trace::seconds(1) == "0.000000001 s");
  CHECK(trace::seconds(2'500'000'000) == "2.5 s");
  CHECK(trace::seconds(3600 * tables::kSecond) == "3600 s");
}

/// The words of a finding of a link.
std::string link_words(const BenchTables& tables, tables::FindingKind kind, std::uint32_t of, std::uint64_t value) {
  trace::PlantNames names(tables.rows);
  names.name_links({{"modbus-tcp-server://127.0.0.1:1502", "", ""}});
  const trace::History history(names);
  return trace::finding_words({0, kind, {of}, value}, names, history);
}

TEST_CASE("An event that is not read shows how long it was on and how often the PLC reads it") {
  const BenchTables tables(kAgv);
  const auto words = [&](const tables::MissedPulse& pulse) {
    return link_words(tables, tables::FindingKind::not_read, tables.symbol("AGV_I_P2"), pack(pulse));
  };
  CHECK(
      words({true, 50 * kMs, 200 * kMs}) ==
      "not read: PLC input %IX1, event P2 of L_P_AGV (symbols.csv:3), was on for 50 ms, between two reads of the PLC, "
      "which reads it about every 200 ms; check whether the PLC must read it more often, or whether the sensor is on "
      "for longer in the real plant");
  CHECK(contains(words({false, 0, 20 * kMs}), "was off for less than a cycle of the plant, between two reads"));
  CHECK(contains(words({true, kMs / 2, 0}), "was on for 0.5 ms"));
  CHECK(contains(words({true, kMs / 2, 0}), "which reads it in every cycle of the plant"));
}

TEST_CASE("An inverted symbol is missed by its meaning, with the bit of the PLC") {
  Reported reported;
  reported.description.inverted = {"L_P_AGV_I_P2"};
  const BenchTables tables(kAgv, reported);
  CHECK(contains(link_words(tables, tables::FindingKind::not_read, tables.symbol("AGV_I_P2"),
                            pack(tables::MissedPulse{false, 50 * kMs, 200 * kMs})),
                 "was on for 50 ms (bit 0)"));
}

TEST_CASE("An operation that is not sampled shows how long it was on") {
  const BenchTables tables(kAgv);
  CHECK(
      link_words(tables, tables::FindingKind::not_sampled, tables.symbol("AGV_O_P2"),
                 pack(tables::MissedPulse{true, 4 * kMs / 10, 0})) ==
      "not sampled: PLC output %QX2, operation P2 of L_P_AGV (symbols.csv:4), was on for 0.4 ms, between two cycles of "
      "the plant, so that it had no effect; check how long the program holds the output, or give a shorter "
      "`--cycle`");
}

TEST_CASE("Several writers are shown with their addresses, if they have any") {
  const BenchTables tables(kAgv);
  const auto words = [&](std::uint64_t clients) {
    return link_words(tables, tables::FindingKind::several_writers, tables.symbol("AGV_O_P2"), clients);
  };
  CHECK(
      words(0xC0A8'0005'C0A8'0006) ==
      "several writers: PLC output %QX2, operation P2 of L_P_AGV (symbols.csv:4), two clients, 192.168.0.5 and "
      "192.168.0.6, wrote different values to it within a cycle; check which of them is the PLC, and let no other one "
      "write this number");
  CHECK(contains(words(0x7F00'0001'7F00'0001), ", two connections of 127.0.0.1 wrote different values"));
  CHECK(contains(words(0), ", two clients wrote different values"));
}

TEST_CASE("A refused request shows its function, its number and the exception") {
  const BenchTables tables(kAgv);
  const auto words = [&](std::uint8_t function, std::uint16_t code, std::uint32_t address) {
    const tables::Refusal refusal{tables::Refusal::Side::modbus_server, function, code, address};
    return link_words(tables, tables::FindingKind::request_refused, 0, pack(refusal));
  };
  CHECK(
      words(15, 2, 3000) ==
      "request refused: modbus-tcp-server://127.0.0.1:1502 answered function 15 (write coils) from number 3000 on with "
      "exception 02: the request goes beyond the end of the map; compare its numbers with those of `symplant map`");
  CHECK(contains(words(17, 1, 0), "answered function 17 with exception 01: the plant does not have this function"));
  CHECK(
      contains(words(3, 3, 7), "function 3 (read holding registers) from number 7 on with exception 03: the quantity"));
  CHECK(contains(words(2, 6, 0), "exception 06: the client does not read its answers"));
}

}  // namespace
}  // namespace symplant::test
