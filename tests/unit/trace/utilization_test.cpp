// Utilization: times, moves and cycles computed by hand, and shares that add up.
#include "symplant/trace/utilization.hpp"

#include <numeric>
#include <random>
#include <sstream>

#include "support/described_plant.hpp"
#include "support/strings.hpp"
#include "symplant/plant/owned_plant.hpp"
#include "symplant/trace/recorder.hpp"
#include "symplant/trace/utilization_text.hpp"
#include "symplant/trace/value_text.hpp"

namespace symplant::test {
namespace {

using tables::kMillisecond;
using tables::kSecond;
using tables::Time;
using trace::Activity;
using trace::Occupation;

/// A plant that runs, and its utilization.
class Bench {
 public:
  Bench(const std::vector<std::string>& names, const std::string& members)
      : described_(bits(names), members),
        names_(described_.rows),
        plant_(described_.rows),
        recorder_(described_.rows, 1 << 14, trace::Recorder::Detail::motions),
        history_(names_),
        use(names_, history_) {
    recorder_.attach(plant_);
    to(0);
  }

  /// Advances to a time, instant by instant.
  void to(Time time) {
    while (plant_.next_due() < time) step(plant_.next_due());
    step(time);
  }
  void set(const std::string& symbol, bool on) {
    plant_.set_operation(described_.rows.symbols[described_.symbol(symbol)].index, on);
    step(plant_.now());
  }
  void set_state(const std::string& unit, const std::string& state) {
    plant_.set_state(described_.unit(unit), described_.state(unit, state));
    step(plant_.now());
  }
  void malfunction(std::uint32_t number, bool active) {
    active ? plant_.start_malfunction(number) : plant_.stop_malfunction(number);
    step(plant_.now());
  }
  bool put(const std::string& location) {
    const bool done = plant_.put({described_.location(location), tables::kWhole}, 0);
    step(plant_.now());
    return done;
  }
  bool take(const std::string& location) {
    const bool done = plant_.take({described_.location(location), tables::kWhole});
    step(plant_.now());
    return done;
  }

  trace::DeviceUse device(const std::string& name) const { return use.device(described_.unit(name), plant_.now()); }
  trace::LocationUse location(const std::string& name) const {
    return use.parts().location(described_.location(name), plant_.now());
  }
  const plant::Plant& plant() const { return plant_; }
  const tables::PlantTables& rows() const { return described_.rows; }

 private:
  void step(Time time) {
    plant_.advance_to(time, &recorder_);
    recorder_.drain([&](const trace::Record& record) {
      if (record.kind == trace::Record::Kind::note) return;
      history_.apply(record);
      use.apply(record);
    });
  }

  DescribedPlant described_;
  trace::PlantNames names_;
  plant::OwnedPlant plant_;
  trace::Recorder recorder_;
  trace::History history_;

 public:
  trace::Utilization use;
};

/// "moving 2000 blocked 500": the activities in ms, without those of 0.
std::string activities(const trace::DeviceUse& use) {
  std::string text;
  for (std::size_t i = 0; i < trace::kActivities; ++i) {
    if (use.times[i] == 0) continue;
    text += (text.empty() ? "" : " ") + std::string(trace::kActivityNames[i]) + " " +
            std::to_string(use.times[i] / kMillisecond);
  }
  return text;
}

/// "used 2000 blocked 500" in ms.
std::string occupations(const trace::LocationUse& use) {
  std::string text;
  for (std::size_t i = 0; i < trace::kOccupations; ++i) {
    if (use.times[i] == 0) continue;
    text += (text.empty() ? "" : " ") + std::string(trace::kOccupationNames[i]) + " " +
            std::to_string(use.times[i] / kMillisecond);
  }
  return text;
}

/// "3: 500 600 700": their number, the least, mean and greatest in ms.
std::string words(const trace::Durations& of) {
  return std::to_string(of.count) + ": " + std::to_string(of.least / kMillisecond) + " " +
         std::to_string(of.mean() / kMillisecond) + " " + std::to_string(of.greatest / kMillisecond);
}

const std::vector<std::string> kVehicle = {"L_P_AGV_I_P1", "L_P_AGV_I_P2",     "L_P_AGV_O_P1",
                                           "L_P_AGV_O_P2", "L_P_DOOR_I_SHUT1", "L_P_DOOR_I_OPEN2"};
const std::string kDoor = R"("times": { "L_P_AGV": { "*->P1": { "takes": "2s" }, "*->P2": { "takes": "2s" } } },
  "devices": { "L_P_DOOR": { "disables": { "OPEN2": ["L_P_AGV"] } } })";

TEST_CASE("Times in each state and activity, moves and cycles are exact") {
  Bench bench(kVehicle, kDoor);
  bench.to(1 * kSecond);
  bench.set("L_P_AGV_O_P2", true);  // 1 s waiting, then 2 s of move
  bench.to(4 * kSecond);            // 1 s commanded
  bench.set("L_P_AGV_O_P2", false);
  bench.to(4500 * kMillisecond);  // 0.5 s waiting
  bench.set("L_P_AGV_O_P1", true);
  bench.to(7 * kSecond);  // 2 s of move, 0.5 s commanded: in P1 since 6.5 s
  bench.set("L_P_AGV_O_P1", false);
  bench.set("L_P_AGV_O_P2", true);
  bench.to(10 * kSecond);  // 2 s of move, 1 s commanded
  bench.set("L_P_AGV_O_P2", false);
  bench.set("L_P_AGV_O_P1", true);
  bench.to(14 * kSecond);  // 2 s of move, 2 s commanded: in P1 since 12 s
  const trace::DeviceUse use = bench.device("L_P_AGV");
  CHECK(activities(use) == "moving 8000 waiting 1500 commanded 4500");
  CHECK(use.states == std::vector<Time>{1 * kSecond + 500 * kMillisecond + 2 * kSecond, 1500 * kMillisecond + kSecond});
  REQUIRE(use.moves.size() == 2);
  CHECK(use.moves[0].time == 4 * kSecond);
  CHECK(words(use.moves[0].whole) == "2: 2000 2000 2000");
  CHECK(words(use.moves[1].whole) == "2: 2000 2000 2000");
  REQUIRE(use.cycle);
  CHECK(use.cycle->state == 0);
  CHECK(words(use.cycle->times) == "1: 5500 5500 5500");  // from 6.5 s to 12 s
  CHECK(activities(bench.device("L_P_DOOR")) == "rest 14000");
}

TEST_CASE("A device that is disabled is blocked while it has a command, and a move that was held up takes longer") {
  Bench bench(kVehicle, kDoor);
  bench.set_state("L_P_DOOR", "OPEN2");
  bench.to(1 * kSecond);  // disabled, without a command
  bench.set("L_P_AGV_O_P2", true);
  bench.to(3 * kSecond);  // blocked
  bench.set_state("L_P_DOOR", "SHUT1");
  bench.to(4 * kSecond);  // 1 s of the move
  bench.set_state("L_P_DOOR", "OPEN2");
  bench.to(7 * kSecond);  // it has a command and does not move
  bench.set_state("L_P_DOOR", "SHUT1");
  bench.to(10 * kSecond);  // 1 s of the move, then commanded
  const trace::DeviceUse use = bench.device("L_P_AGV");
  CHECK(activities(use) == "moving 2000 blocked 5000 commanded 2000 disabled 1000");
  REQUIRE(use.moves.size() == 1);
  CHECK(use.moves[0].time == 5 * kSecond);
  CHECK(words(use.moves[0].whole) == "1: 5000 5000 5000");
}

TEST_CASE("A move that turns round is not counted, and a change at once takes 0 s") {
  Bench bench(kVehicle, R"("devices": { "L_P_AGV": { "actuation": "held" } },
    "times": { "L_P_AGV": { "*->P1": { "takes": "2s" }, "*->P2": { "takes": "2s" } } })");
  bench.set("L_P_AGV_O_P2", true);
  bench.to(1 * kSecond);
  bench.set("L_P_AGV_O_P2", false);
  bench.set("L_P_AGV_O_P1", true);  // back to P1, in which it is at 2 s
  bench.to(3 * kSecond);
  bench.set_state("L_P_DOOR", "OPEN2");
  const trace::DeviceUse use = bench.device("L_P_AGV");
  CHECK(use.arrivals() == 0);
  CHECK(activities(use) == "moving 2000 commanded 1000");
  CHECK(std::accumulate(use.states.begin(), use.states.end(), Time{0}) == kSecond);
  const trace::DeviceUse door = bench.device("L_P_DOOR");
  REQUIRE(door.moves.size() == 1);
  CHECK(words(door.moves[0].whole) == "1: 0 0 0");
}

TEST_CASE("The time under a malfunction is counted next to what the device does") {
  Bench bench(kVehicle, kDoor + R"(, "malfunctions": [{ "name": "jam", "of": "L_P_AGV", "slower": 2 }])");
  bench.to(1 * kSecond);
  bench.malfunction(0, true);
  bench.set("L_P_AGV_O_P2", true);
  bench.to(5500 * kMillisecond);
  bench.malfunction(0, false);
  bench.to(6 * kSecond);
  const trace::DeviceUse use = bench.device("L_P_AGV");
  CHECK(use.malfunction == 4500 * kMillisecond);
  CHECK(activities(use) == "moving 4000 waiting 1000 commanded 1000");
}

TEST_CASE("Counting can begin again during a move, which is not counted then") {
  Bench bench(kVehicle, kDoor);
  bench.set("L_P_AGV_O_P2", true);
  bench.to(1 * kSecond);
  bench.use.begin(1 * kSecond);
  bench.to(4 * kSecond);
  const trace::DeviceUse use = bench.device("L_P_AGV");
  CHECK(activities(use) == "moving 1000 commanded 2000");
  CHECK(use.arrivals() == 0);
  CHECK(use.states == std::vector<Time>{0, 2 * kSecond});
  CHECK(bench.use.from() == kSecond);
}

/// A belt of 1 m with a part each 4 s, a fixture with work of 3 s by a timer, and a robot that takes parts out.
const std::vector<std::string> kCell = {"L_P_BELT_I_RUN", "L_P_BELT_O_RUN", "L_P_MC_I_IDLE1", "L_P_MC_I_DONE2",
                                        "L_P_MC_O_DONE2", "L_P_MC_O_IDLE1", "L_P_OUT_I_OFF1", "L_P_OUT_I_ON2",
                                        "L_P_OUT_O_ON2",  "L_P_OUT_O_OFF1"};
const std::string kCellMembers =
    R"("times": { "L_P_MC": { "*->DONE2": { "takes": "3s" } }, "L_P_OUT": { "*->ON2": { "takes": "1ms" } } },
  "material": {
    "kinds": { "raw": { "length": "200 mm" }, "done": { "length": "200 mm" } },
    "tracks": { "BELT": { "length": "1 m", "drives": [{ "forward": "L_P_BELT_O_RUN", "speed": "0.5 m/s" }], "end": "FIXTURE" } },
    "places": { "FIXTURE": {}, "SHELF": {} },
    "transfers": [{ "name": "unload", "from": "FIXTURE", "to": "out", "when": "L_P_OUT.ON2 and FIXTURE.done" }],
    "work": [{ "name": "mill", "at": "FIXTURE", "when": "L_P_MC.DONE2", "from": "raw", "to": "done" }] })";

TEST_CASE(
    "A place is empty, used until its work is done, and blocked until the part leaves; a track is blocked at its end") {
  Bench bench(kCell, kCellMembers);
  bench.set("L_P_BELT_O_RUN", true);
  bench.to(1 * kSecond);
  REQUIRE(bench.put("BELT"));  // its front is at 0.2 m, it is in the fixture at 1 + 0.8 / 0.5 = 2.6 s
  bench.to(3 * kSecond);
  REQUIRE(bench.put("BELT"));  // at the end of the belt at 4.6 s, and waits there
  bench.set("L_P_MC_O_DONE2", true);
  bench.to(9 * kSecond);  // the work is done at 6 s
  bench.set("L_P_OUT_O_ON2", true);
  bench.to(10 * kSecond);  // it leaves at 9.001 s, and the next one comes
  CHECK(occupations(bench.location("BELT")) == "used 3200 blocked 4401 empty 2399");
  CHECK(occupations(bench.location("FIXTURE")) == "used 4399 blocked 3001 empty 2600");
  CHECK(occupations(bench.location("SHELF")) == "empty 10000");
  CHECK(bench.location("FIXTURE").starves);
  CHECK(bench.location("BELT").starves);
  CHECK_FALSE(bench.location("SHELF").starves);
  CHECK(bench.location("BELT").came == 2);
  CHECK(bench.location("BELT").left == 2);
  CHECK(bench.use.parts().exits().events == 1);
}

TEST_CASE("The cycle time of an exit is the time between two parts, and what a person takes is not counted") {
  Bench bench(kCell, kCellMembers);
  bench.set("L_P_OUT_O_ON2", true);
  for (int part = 0; part < 3; ++part) {
    bench.to((1 + 10 * part + part * part) * kSecond);  // 1 s, 12 s, 25 s
    REQUIRE(bench.put("FIXTURE"));
    bench.set("L_P_MC_O_IDLE1", false);
    bench.set("L_P_MC_O_DONE2", true);
    bench.to(bench.plant().now() + 4 * kSecond);  // the part leaves when its work is done
    bench.set("L_P_MC_O_DONE2", false);
    bench.set("L_P_MC_O_IDLE1", true);
  }
  bench.to(40 * kSecond);
  REQUIRE(bench.put("FIXTURE"));
  REQUIRE(bench.take("FIXTURE"));
  const trace::Intervals exit = bench.location("FIXTURE").exits;
  CHECK(exit.events == 3);
  CHECK(words(exit.between) == "2: 11000 12000 13000");
  CHECK(bench.use.parts().exits().events == 3);
}

/// The sums of all shares are the time since the counting began.
void check_sums(const Bench& bench) {
  const Time now = bench.plant().now();
  const Time whole = now - bench.use.from();
  for (std::uint32_t unit = 0; unit < bench.rows().units.size(); ++unit) {
    const trace::DeviceUse use = bench.use.device(unit, now);
    CHECK(std::accumulate(use.times.begin(), use.times.end(), Time{0}) == whole);
    Time states = std::accumulate(use.states.begin(), use.states.end(), Time{0});
    for (const trace::MoveUse& move : use.moves) states += move.time;
    CHECK(states == whole);
    CHECK(use.malfunction <= whole);
  }
  for (std::uint32_t location = 0; location < bench.rows().material.locations(); ++location) {
    const trace::LocationUse use = bench.use.parts().location(location, now);
    CHECK(std::accumulate(use.times.begin(), use.times.end(), Time{0}) == whole);
  }
}

TEST_CASE("Whatever happens, the shares of a device, track and place add up to the whole time") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    INFO(seed);
    Bench bench(kCell, kCellMembers + R"(, "malfunctions": [{ "name": "jam", "of": "L_P_MC", "stuck": true }])");
    std::mt19937 random(seed);
    const auto up_to = [&](unsigned most) { return static_cast<unsigned>(random() % most); };
    for (int act = 0; act < 150; ++act) {
      bench.to(bench.plant().now() + Time{up_to(2'000'000'000)});
      const std::vector<std::string> operations = {"L_P_BELT_O_RUN", "L_P_MC_O_DONE2", "L_P_MC_O_IDLE1",
                                                   "L_P_OUT_O_ON2", "L_P_OUT_O_OFF1"};
      bench.set(operations[up_to(5)], up_to(2) == 0);
      if (up_to(4) == 0) bench.put("BELT");
      if (up_to(10) == 0) bench.take("FIXTURE");
      if (up_to(10) == 0) bench.malfunction(0, up_to(2) == 0);
      if (up_to(20) == 0) bench.set_state("L_P_MC", "IDLE1");
      if (up_to(40) == 0) bench.use.begin(bench.plant().now());
      check_sums(bench);
    }
  }
}

TEST_CASE("As a table each number is in a line, with times in seconds and shares in percent") {
  Bench bench(kCell, kCellMembers);
  bench.set("L_P_OUT_O_ON2", true);
  bench.to(2 * kSecond);
  const std::string csv = trace::utilization_csv(bench.use, bench.plant().now());
  CHECK(csv.starts_with("kind,name,measure,of,time [s],share [%],count,least [s],mean [s],greatest [s],last [s]\n"));
  CHECK(contains(csv, "\ndevice,L_P_MC,activity,waiting,2,100.000,,,,,\n"));
  CHECK(contains(csv, "\ndevice,L_P_OUT,activity,moving,0.001,0.050,,,,,\n"));
  CHECK(contains(csv, "\ndevice,L_P_OUT,move,OFF1 to ON2,0.001,0.050,1,0.001,0.001,0.001,0.001\n"));
  CHECK(contains(csv, "\ntrack,BELT,occupation,starved,2,100.000,,,,,\n"));
  CHECK(contains(csv, "\nplace,SHELF,occupation,empty,2,100.000,,,,,\n"));
  CHECK(contains(csv, ",parts,left the plant,,,0,,,,\n"));
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) CHECK(std::count(line.begin(), line.end(), ',') == 10);
}

TEST_CASE("As JSON the devices, tracks and places are named") {
  Bench bench(kVehicle, kDoor);
  bench.to(2 * kSecond);
  const std::string json = trace::utilization_json(bench.use, bench.plant().now());
  CHECK(contains(
      json,
      R"({"from":0,"to":2000000000,"devices":{"L_P_AGV":{"times":{"moving":0,"blocked":0,"waiting":2000000000,)"));
  CHECK(contains(json, R"("states":{"P1":2000000000,"P2":0},"moves":[],"cycle":null})"));
  CHECK(json.ends_with(R"("locations":{},"exits":{"parts":0,"cycle":null}})"));
  CHECK(trace::utilization_table_json(bench.use, bench.plant().now()) ==
        R"({"from":0,"to":2000000000,"devices":[[[0,0,2000000000,0,0,0,0,0],0,0,[0,0,0,0,0]],)"
        R"([[0,0,0,0,2000000000,0,0,0],0,0,[0,0,0,0,0]]],"locations":[],"exits":[0,[0,0,0,0,0]]})");
}

}  // namespace
}  // namespace symplant::test
