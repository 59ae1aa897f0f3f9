// Malfunctions in traces, in VCD files and in the words of findings.
#include <sstream>

#include "support/malfunction_bench.hpp"
#include "support/strings.hpp"
#include "support/vcd.hpp"
#include "symplant/trace/finding_file.hpp"
#include "symplant/trace/recorder.hpp"
#include "symplant/trace/trace_file.hpp"
#include "symplant/trace/vcd_file.hpp"

namespace symplant::test {
namespace {

/// A plant whose records go into the files of a run.
class FaultyRun {
 public:
  explicit FaultyRun(const BenchTables& tables)
      : tables_(tables),
        names_(tables.rows),
        history_(names_),
        recorder_(tables.rows, 1024),
        trace_({"trace", trace_text_}, tables.rows, 0, 0),
        vcd_({"VCD file", vcd_text_}, names_),
        found_({"findings", found_text_}, names_),
        plant(tables.rows) {
    recorder_.attach(plant);
    to(0);
    vcd_.begin(0, history_);
  }

  FaultyRun& to(tables::Time milliseconds) {
    plant.advance_to(milliseconds * kMs, &recorder_);
    recorder_.drain([this](const trace::Record& record) {
      history_.apply(record);
      trace_.write(record);
      vcd_.write(record);
      if (record.kind == trace::Record::Kind::finding) now_.push_back({record.time, record.finding, {record.of}});
      if (record.last) report();
    });
    return *this;
  }
  FaultyRun& start(const std::string& malfunction) {
    CHECK(plant.start_malfunction(tables_.malfunction(malfunction)));
    return *this;
  }
  /// The lines of the trace after its header.
  std::string lines() {
    trace_.flush();
    return trace_text_.str().substr(trace_text_.str().find('\n') + 1);
  }
  Vcd vcd() {
    vcd_.end(plant.now());
    vcd_.flush();
    return read_vcd(vcd_text_.str());
  }
  std::string found() {
    found_.flush();
    return found_text_.str();
  }
  std::string words;

 private:
  /// The findings of an instant, with the state at its end.
  void report() {
    for (const trace::FoundThing& thing : now_) {
      const bool violated = thing.kind == tables::FindingKind::requirement_violated;
      const std::string text = violated ? trace::requirement_words(thing.of.front(), false, names_)
                                        : trace::finding_words(thing, names_, history_);
      found_.write(thing, text, history_);
      words += text + "\n";
    }
    now_.clear();
  }

  const BenchTables& tables_;
  std::ostringstream trace_text_, vcd_text_, found_text_;
  trace::PlantNames names_;
  trace::History history_;
  trace::Recorder recorder_;
  trace::TraceFile trace_;
  trace::VcdFile vcd_;
  trace::FindingFile found_;
  std::vector<trace::FoundThing> now_;  ///< findings of the instant that is being drained

 public:
  plant::OwnedPlant plant;
};

const std::vector<std::string> kAgvAndEye = {"AGV_I_P1", "AGV_I_P2", "AGV_O_P2", "PE_I_PART"};

TEST_CASE("A trace has a line for each malfunction that starts or ends, after the changes of its instant") {
  const FaultyTables tables(kAgvAndEye, R"({"name":"eye \"blind\"","force":{"L_P_PE_I_PART":true},"lasts":"1s",
                                           "when":"L_P_AGV.P1"})");
  FaultyRun run(tables);
  run.start("L_P_AGV slow").to(1000);
  CHECK(run.lines() ==
        R"({"t":0,"symbol":"L_P_AGV_I_P1","value":true}
{"t":0,"symbol":"L_P_PE_I_PART","value":true}
{"t":0,"malfunction":"eye \"blind\"","active":true,"by":"condition"}
{"t":0,"malfunction":"L_P_AGV slow","active":true,"by":"hand"}
{"t":1000000000,"symbol":"L_P_PE_I_PART","value":false}
{"t":1000000000,"malfunction":"eye \"blind\"","active":false,"by":"end"}
)");
}

TEST_CASE("A VCD file has a bit for each malfunction of the description") {
  const FaultyTables tables(kAgvAndEye, R"({"name":"eye blind","force":{"L_P_PE_I_PART":true},"lasts":"1s"},
                                           {"name":"cable","lose":true,"when":"L_P_AGV.P1"})");
  FaultyRun run(tables);
  run.to(500).start("eye blind").start("L_P_AGV slow").to(2000);
  const Vcd vcd = run.vcd();
  CHECK(vcd.fault == "");
  CHECK(contains(vcd.initial, "malfunctions.eye_blind=0"));
  CHECK(contains(vcd.initial, "malfunctions.cable=1"));
  std::string changes;
  for (const std::string& change : vcd.changes) {
    if (contains(change, "malfunctions.")) changes += change + "\n";
  }
  CHECK(contains(changes, "500000000 "));
  CHECK(contains(changes, "malfunctions.eye_blind=1\n1500000000 "));
}

TEST_CASE("A command to a stuck device names the malfunction") {
  const FaultyTables tables(kAgvAndEye, R"({"name":"jam","of":"L_P_AGV","stuck":true})");
  FaultyRun run(tables);
  run.start("jam").plant.set_operation(tables.rows.symbols[tables.symbol("AGV_O_P2")].index, true);
  run.to(1000);
  CHECK(contains(run.words, "cannot move, disabled by malfunction `jam`"));
}

TEST_CASE("The finding of a violated requirement names the active malfunctions") {
  Reported reported;
  reported.description.requirements.push_back({"eye sees nothing", "L_P_PE_I_PART", "", "", 0});
  const FaultyTables tables(kAgvAndEye, R"({"name":"eye blind","force":{"L_P_PE_I_PART":true}})", reported);
  FaultyRun run(tables);
  run.start("L_P_AGV stuck").to(500).start("eye blind").to(1000);
  INFO(run.words << run.found());
  CHECK(contains(run.found(), R"("malfunctions":["L_P_AGV stuck","eye blind"])"));
  FaultyRun without(tables);
  without.plant.set_input(tables.symbol("PE_I_PART"), 1);
  without.to(1000);
  CHECK(contains(without.words, "eye sees nothing"));
  CHECK_FALSE(contains(without.found(), "malfunctions"));
}

TEST_CASE("A loop of malfunctions is one finding with their names, which may contain blanks") {
  const FaultyTables tables(kAgvAndEye, R"({"name":"loose contact","force":{"L_P_PE_I_PART":true},"chance":"1ns"},
                                           {"name":"calm","force":{"L_P_PE_I_PART":true}},
                                           {"name":"blind","force":{"L_P_PE_I_PART":false},"chance":"1ns"})");
  const trace::PlantNames names(tables.rows);
  const trace::History history(names);
  const std::uint32_t first = tables::first_malfunction_of_loop(tables.rows);
  const trace::FoundThing both{0, tables::FindingKind::instantaneous_loop, {first, first + 2}};
  CHECK(trace::name_of(both, names) == "blind, loose contact");
  CHECK(trace::units_of(both, tables.rows).empty());
  CHECK(trace::finding_words(both, names, history) ==
        "instantaneous loop: malfunctions blind, loose contact start and end again and again within a millisecond, and "
        "stay "
        "inactive until the run ends; check for times of almost 0, and for a `when` that names what the malfunction "
        "changes");
  const trace::FoundThing one{0, tables::FindingKind::instantaneous_loop, {first + 2}};
  CHECK(contains(trace::finding_words(one, names, history),
                 "malfunction blind starts and ends again and again within a millisecond, and stays inactive"));
}

}  // namespace
}  // namespace symplant::test
