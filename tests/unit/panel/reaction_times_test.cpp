// Reaction times: from the first effect of a malfunction to the first act of each trainee, by hand-computed times.
#include <optional>

#include "support/malfunction_bench.hpp"
#include "symplant/panel/training/malfunction_runs.hpp"
#include "symplant/trace/recorder.hpp"

namespace symplant::test {
namespace {

using panel::MalfunctionRun;

const std::vector<std::string> kNames = {"AGV_I_P1",     "AGV_I_P2",     "AGV_O_P2", "AGV_O_P1",
                                         "DOOR_I_SHUT1", "DOOR_I_OPEN2", "EYE_I_ON"};

/// The vehicle moves in 1 s.
Reported slow_vehicle() {
  Reported reported;
  reported.on_command("AGV", "P1", "P2", fixed(1000 * kMs));
  reported.on_command("AGV", "P2", "P1", fixed(1000 * kMs));
  return reported;
}

/// A plant whose records a MalfunctionRuns follows. Times are in ms.
class Followed {
 public:
  explicit Followed(const BenchTables& tables)
      : tables_(tables),
        plant(tables.rows),
        recorder_(tables.rows, std::size_t{1} << 14, trace::Recorder::Detail::motions),
        names_(tables.rows),
        history(names_),
        runs(names_, history) {
    recorder_.attach(plant);
    to(0);
  }

  Followed& to(tables::Time milliseconds) {
    plant.advance_to(milliseconds * kMs, &recorder_);
    recorder_.drain([this](const trace::Record& record) {
      history.apply(record);
      runs.apply(record);
    });
    return *this;
  }
  Followed& set(const std::string& operation, bool on) {
    plant.set_operation(tables_.rows.symbols[tables_.symbol(operation)].index, on);
    return *this;
  }
  Followed& event(const std::string& name, bool on) {
    plant.set_input(tables_.symbol(name), on ? 1 : 0);
    return *this;
  }
  Followed& start(const std::string& name) {
    plant.start_malfunction(tables_.malfunction(name));
    return *this;
  }
  Followed& stop(const std::string& name) {
    plant.stop_malfunction(tables_.malfunction(name));
    return *this;
  }
  Followed& acts(std::uint32_t trainee, tables::Time milliseconds) {
    runs.acted(trainee, milliseconds * kMs);
    return *this;
  }
  /// "jam 1000 3000-: 0 4000": start, first effect and end; then each reaction's trainee and the time of its act, in
  /// ms.
  std::string text() const {
    std::string all;
    const auto ms = [](tables::Time time) { return time < 0 ? std::string("-") : std::to_string(time / kMs); };
    for (const MalfunctionRun& run : runs.runs()) {
      all += (all.empty() ? "" : "; ") + names_.malfunction(run.malfunction) + " " + ms(run.start) + " " +
             ms(run.effect) + " " + ms(run.end);
      for (const MalfunctionRun::Reaction& one : run.reactions) {
        all += ", " + std::to_string(one.trainee) + " at " + ms(one.at);
      }
    }
    return all;
  }

 private:
  const BenchTables& tables_;

 public:
  plant::OwnedPlant plant;

 private:
  trace::Recorder recorder_;
  trace::PlantNames names_;

 public:
  trace::History history;
  panel::MalfunctionRuns runs;
};

const std::string kJam = R"({"name":"jam","of":"L_P_AGV","stuck":true})";

TEST_CASE("A stuck device shows it at the first command to another state") {
  const FaultyTables tables(kNames, kJam, slow_vehicle());
  Followed plant(tables);
  plant.to(1000).start("jam").to(2000);
  CHECK(plant.text() == "jam 1000 - -");
  plant.set("AGV_O_P1", true).to(2500);  // it is in P1
  CHECK(plant.text() == "jam 1000 - -");
  plant.set("AGV_O_P1", false).set("AGV_O_P2", true).to(3000);
  CHECK(plant.text() == "jam 1000 3000 -");
  plant.acts(0, 4500).to(5000).stop("jam").to(5001);
  CHECK(plant.text() == "jam 1000 3000 5000, 0 at 4500");
}

TEST_CASE("A device that is commanded elsewhere or moves when it gets stuck shows it at once") {
  const FaultyTables tables(kNames, kJam, slow_vehicle());
  Followed moving(tables);
  moving.set("AGV_O_P2", true).to(100).start("jam").to(400).start("jam").to(401);
  CHECK(moving.text() == "jam 100 100 -");
  Followed instant(tables);  // the command is written in the instant of the start
  instant.to(100).set("AGV_O_P2", true).start("jam").to(200);
  CHECK(instant.text() == "jam 100 200 -");
}

TEST_CASE("A device that gets stuck in a state that it was not in shows it at once") {
  const FaultyTables tables(kNames, R"({"name":"fell open","of":"L_P_DOOR","stuck":"OPEN2"})");
  Followed plant(tables);
  plant.to(100).start("fell open").to(300);
  CHECK(plant.text() == "fell open 100 100 -");
  Followed open(tables);
  open.to(50).start("fell open").to(60).stop("fell open").to(70).start("fell open").to(100);
  CHECK(open.text() == "fell open 50 50 60; fell open 70 - -");  // it is open already
}

TEST_CASE("A slow device shows it when it moves") {
  const FaultyTables tables(kNames, R"({"name":"worn","of":"L_P_AGV","slower":3})", slow_vehicle());
  Followed plant(tables);
  plant.to(10).start("worn").to(700).set("AGV_O_P2", true).to(701).acts(1, 750).to(800);
  CHECK(plant.text() == "worn 10 701 -, 1 at 750");
}

TEST_CASE("A forced symbol shows it when it changes, a sensor also when its device would switch it") {
  const FaultyTables tables(kNames, R"({"name":"eye blind","force":{"L_P_EYE_I_ON":true}},
                                       {"name":"no arrival","force":{"L_P_AGV_I_P2":false}},
                                       {"name":"no start","force":{"L_P_AGV_I_P1":true}})",
                            slow_vehicle());
  Followed plant(tables);
  plant.to(5).start("eye blind").to(6);
  CHECK(plant.text() == "eye blind 5 5 -");
  Followed masked(tables);
  masked.to(100).start("no arrival").start("no start").to(200);
  CHECK(masked.text() == "no arrival 100 - -; no start 100 - -");
  masked.set("AGV_O_P2", true).to(300).to(1299);
  CHECK(masked.text() == "no arrival 100 - -; no start 100 300 -");  // it leaves P1, whose sensor stays on
  masked.to(1400);
  CHECK(masked.text() == "no arrival 100 1300 -; no start 100 300 -");  // it arrives in P2, whose sensor stays off
}

TEST_CASE("What changes because a malfunction ends is not its effect") {
  const FaultyTables tables(kNames, R"({"name":"eye blind","force":{"L_P_EYE_I_ON":false}})");
  Followed plant(tables);
  plant.to(5).start("eye blind").to(10).event("EYE_I_ON", true).to(20);
  plant.stop("eye blind").to(30);
  CHECK(plant.history.value(tables.symbol("EYE_I_ON")) == 1);
  CHECK(plant.text() == "eye blind 5 - 20");
}

TEST_CASE("A loose contact shows it when its symbol changes") {
  const FaultyTables tables(kNames,
                            R"({"name":"contact","flicker":{"symbol":"L_P_EYE_I_ON","every":"250ms","for":"80ms"}})");
  Followed plant(tables);
  plant.to(100).start("contact").to(349);
  CHECK(plant.text() == "contact 100 - -");
  plant.to(600);
  CHECK(plant.text() == "contact 100 350 -");
}

TEST_CASE("A lost link shows it at its start, and so does a malfunction with several effects of which one does") {
  const FaultyTables tables(kNames, R"({"name":"cable","lose":true},
                                       {"name":"both","effects":[{"of":"L_P_AGV","stuck":true},{"lose":true}]})");
  Followed plant(tables);
  plant.to(7).start("cable").to(8).start("both").to(9);
  CHECK(plant.text() == "cable 7 7 -; both 8 8 -");
}

TEST_CASE("Of several effects the earliest counts") {
  const FaultyTables tables(
      kNames, R"({"name":"both","effects":[{"of":"L_P_AGV","stuck":true},{"force":{"L_P_EYE_I_ON":false}}]})");
  Followed plant(tables);
  plant.to(7).start("both").to(20).set("AGV_O_P2", true).to(30);
  CHECK(plant.text() == "both 7 30 -");
}

TEST_CASE("Ordinary malfunctions have effects as written ones") {
  const FaultyTables tables(kNames, kJam, slow_vehicle());
  Followed plant(tables);
  plant.to(7).start("L_P_EYE_I_ON stuck on").start("L_P_AGV slow").to(20).set("AGV_O_P2", true).to(30);
  CHECK(plant.text() == "L_P_EYE_I_ON stuck on 7 7 -; L_P_AGV slow 7 30 -");
}

TEST_CASE("Each trainee has one reaction, after the effect and before the end") {
  const FaultyTables tables(kNames, R"({"name":"eye blind","force":{"L_P_EYE_I_ON":true}})");
  Followed plant(tables);
  plant.acts(0, 1).to(5).start("eye blind").acts(1, 5).to(6);  // that act may be the cause
  plant.acts(0, 8).acts(0, 9).acts(1, 10).to(20).stop("eye blind").to(21).acts(2, 22);
  CHECK(plant.text() == "eye blind 5 5 20, 0 at 8, 1 at 10");
}

TEST_CASE("A plant that is set back forgets what was later, and waits for the effect again") {
  const FaultyTables tables(kNames, kJam, slow_vehicle());
  Followed plant(tables);
  plant.to(100).start("jam").to(200);
  std::vector<std::byte> state(plant.plant.save().begin(), plant.plant.save().end());
  plant.set("AGV_O_P2", true).to(300).acts(0, 400).to(500).stop("jam").to(600).start("jam").to(700);
  CHECK(plant.text() == "jam 100 300 500, 0 at 400; jam 600 600 -");
  REQUIRE(plant.plant.restore(state));
  plant.history.load(plant.plant);
  plant.runs.set_back(200 * kMs);
  CHECK(plant.text() == "jam 100 - -");
  plant.to(250).set("AGV_O_P2", true).to(260).acts(0, 300);
  CHECK(plant.text() == "jam 100 260 -, 0 at 300");
  plant.plant.reset(0, 0);
  plant.history.load(plant.plant);
  plant.runs.set_back(-1);
  CHECK(plant.text().empty());
}

TEST_CASE("A restored malfunction that was not followed is followed from then on") {
  const FaultyTables tables(kNames, kJam, slow_vehicle());
  Followed other(tables);
  other.to(100).start("jam").to(200);
  Followed plant(tables);
  REQUIRE(plant.plant.restore(other.plant.save()));
  plant.history.load(plant.plant);
  plant.runs.set_back(200 * kMs);
  CHECK(plant.text() == "jam 100 - -");
  plant.set("AGV_O_P2", true).to(300);
  CHECK(plant.text() == "jam 100 300 -");
}

TEST_CASE("The last 200 malfunctions are kept") {
  const FaultyTables tables(kNames, kJam);
  Followed plant(tables);
  for (tables::Time i = 1; i <= 203; ++i) plant.start("jam").to(2 * i).stop("jam").to(2 * i + 1);
  CHECK(plant.runs.runs().size() == panel::MalfunctionRuns::kMostRuns);
  CHECK(plant.runs.runs().front().n == 3);
  CHECK(plant.runs.runs().back().n == 202);
}

}  // namespace
}  // namespace symplant::test
