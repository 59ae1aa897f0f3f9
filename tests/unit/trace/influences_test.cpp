// Findings name the malfunction or force that explains them, and say what an inverted symbol means.
#include "symplant/trace/influences.hpp"

#include <optional>

#include "support/described_plant.hpp"
#include "support/strings.hpp"
#include "symplant/plant/owned_plant.hpp"
#include "symplant/tables/malfunction_numbers.hpp"
#include "symplant/trace/finding_words.hpp"
#include "symplant/trace/recorder.hpp"

namespace symplant::test {
namespace {

constexpr tables::Time kMs = tables::kMillisecond;

/// A plant whose findings become sentences, one per line. Names omit `L_P_`; times are in ms.
class Found {
 public:
  /// `cycle`: as for Plant::reset().
  explicit Found(const DescribedPlant& described, tables::Time cycle = 0)
      : described_(described),
        names_(described.rows),
        history_(names_),
        recorder_(described.rows, 1024),
        plant_(described.rows) {
    plant_.reset(0, cycle);
    recorder_.attach(plant_);
    to(0);
  }
  Found& set(const std::string& name, bool on) {
    plant_.set_operation(described_.rows.symbols[described_.symbol("L_P_" + name)].index, on);
    return *this;
  }
  Found& force(const std::string& name, std::uint64_t value) {
    plant_.force(described_.symbol("L_P_" + name), value);
    history_.force(described_.symbol("L_P_" + name), true, plant_.now());
    return *this;
  }
  Found& state(const std::string& device, const std::string& state) {
    plant_.set_state(described_.unit("L_P_" + device), described_.state("L_P_" + device, state));
    return *this;
  }
  Found& start(std::uint32_t malfunction) {
    REQUIRE(plant_.start_malfunction(malfunction, engine::MalfunctionChange::By::hand));
    return *this;
  }
  Found& put(const std::string& place) {
    REQUIRE(plant_.put({described_.location(place), tables::kWhole}, 0));
    return *this;
  }
  Found& to(tables::Time milliseconds) {
    plant_.advance_to(milliseconds * kMs, &recorder_);
    recorder_.drain([this](const trace::Record& record) {
      history_.apply(record);
      if (record.kind == trace::Record::Kind::finding) {
        now_.push_back({record.time, record.finding, {record.of}, record.value});
      }
      if (!record.last) return;
      for (const trace::FoundThing& thing : now_) words += trace::finding_words(thing, names_, history_) + "\n";
      now_.clear();
    });
    return *this;
  }
  /// The words of a loss of the link with this index.
  std::string loss(std::uint32_t link) {
    names_.name_links({{"link 1", "no request; check whether the PLC runs", "", 0}});
    return trace::finding_words({0, tables::FindingKind::link_lost, {link}}, names_, history_);
  }

  std::string words;

 private:
  const DescribedPlant& described_;
  trace::PlantNames names_;
  trace::History history_;
  trace::Recorder recorder_;
  plant::OwnedPlant plant_;
  std::vector<trace::FoundThing> now_;
};

std::vector<Row> list(std::vector<std::string> names) {
  for (std::string& name : names) name.insert(0, "L_P_");
  return bits(names);
}

const std::vector<std::string> kNames = {"AGV_I_P1", "AGV_I_P2",     "AGV_O_P1",
                                         "AGV_O_P2", "DOOR_I_OPEN1", "DOOR_I_SHUT2"};

constexpr std::uint32_t kJam = 0;
constexpr std::uint32_t kRust = 1;
constexpr std::uint32_t kWire = 2;
constexpr std::uint32_t kLatch = 3;
constexpr std::uint32_t kCable = 4;

/// A vehicle that moves only while the door is shut; `more` are members of the vehicle.
DescribedPlant vehicle(const std::string& more = "") {
  return {list(kNames),
          R"("devices": {"L_P_AGV": {"only": false)" + more + R"(}, "L_P_DOOR": {"disables": {"OPEN1": ["L_P_AGV"]}}},
    "malfunctions": [
      {"name": "jam", "of": "L_P_AGV", "stuck": true},
      {"name": "rust", "of": "L_P_AGV", "slower": 3},
      {"name": "wire", "force": {"L_P_AGV_I_P2": false}},
      {"name": "latch", "force": {"L_P_DOOR_I_SHUT2": true}},
      {"name": "cable", "lose": true}])"};
}

TEST_CASE("A command to a device that a malfunction holds names the malfunction, not an interlock") {
  const DescribedPlant plant = vehicle();
  Found found(plant);
  found.state("DOOR", "SHUT2").to(50).start(kJam).set("AGV_O_P2", true).to(100);
  CHECK(found.words ==
        "command to a disabled unit: PLC output %QX3, operation P2 of L_P_AGV (symbols.csv:5), came on while L_P_AGV "
        "(P1, disabled) cannot move, disabled by malfunction `jam`; check how the program reacts to it\n");
}

TEST_CASE("A device that another device disables, too, lacks an interlock") {
  const DescribedPlant plant = vehicle();
  Found found(plant);
  found.state("DOOR", "OPEN1").to(50).start(kJam).set("AGV_O_P2", true).to(100);
  CHECK(contains(found.words,
                 "cannot move, disabled by L_P_DOOR in OPEN1, malfunction `jam`; check for a missing interlock"));
}

TEST_CASE("A malfunction or a force that hides the other device's state explains the command") {
  const DescribedPlant plant = vehicle();
  Found found(plant);
  found.state("DOOR", "OPEN1").to(50).start(kLatch).set("AGV_O_P2", true).to(100);
  CHECK(contains(found.words,
                 "disabled by L_P_DOOR in OPEN1; malfunction `latch` forces event SHUT2 (%IX5): check how the program "
                 "reacts\n"));
  found.words.clear();
  found.force("DOOR_I_SHUT2", 1).set("AGV_O_P2", false).to(150).set("AGV_O_P2", true).to(200);
  CHECK(contains(found.words, "event SHUT2 (%IX5) is forced since 0.1 s: check how the program reacts\n"));
}

TEST_CASE("A command that is lost, or without effect, during a malfunction names it") {
  const DescribedPlant plant = vehicle(R"(, "transitions": [{"from": "P1", "to": "P2", "on": "P2", "after": "1s"}])");
  Found found(plant);
  found.state("DOOR", "SHUT2").to(50).set("AGV_O_P2", true).to(100).start(kJam).to(150).set("AGV_O_P2", false).to(200);
  CHECK(contains(found.words,
                 "lost command: PLC output %QX3, operation P2 of L_P_AGV (symbols.csv:5), on since 0.1 s, "
                 "went off before L_P_AGV (P1, disabled) moved; malfunction `jam` holds L_P_AGV: check"));
}

TEST_CASE("Conflicting commands while a malfunction slows a device or forces its event name the malfunction") {
  const DescribedPlant plant = vehicle();
  Found found(plant);
  found.state("DOOR", "SHUT2").to(50).start(kRust).start(kWire);
  found.set("AGV_O_P2", true).set("AGV_O_P1", true).to(100);
  CHECK(contains(found.words,
                 "; malfunction `rust` slows L_P_AGV, malfunction `wire` forces event P2 (%IX1): check how "
                 "the program reacts\n"));
  CHECK_FALSE(contains(found.words, "interlock"));
}

TEST_CASE("A motor that runs against its end since a malfunction hides the end names the malfunction") {
  const DescribedPlant plant = vehicle(R"(, "actuation": "held")");
  Found found(plant);
  found.state("DOOR", "SHUT2").to(50).start(kWire).set("AGV_O_P2", true).to(100).to(9000);
  CHECK(contains(found.words,
                 "runs against the end; operations: %QX3 (P2 of L_P_AGV) on since 0.1 s; malfunction "
                 "`wire` forces event P2 (%IX1): check how the program reacts\n"));
}

TEST_CASE("A link that a malfunction cuts is lost by it") {
  const DescribedPlant plant = vehicle();
  Found found(plant);
  CHECK(found.loss(0) == "link lost: link 1, no request; check whether the PLC runs");
  found.start(kCable).to(100);
  CHECK(found.loss(0) == "link lost: link 1, malfunction `cable` cuts it: check how the program reacts");
}

TEST_CASE("An event that a malfunction switches too quickly asks for a longer malfunction") {
  const DescribedPlant plant(
      list({"A_I_P1", "A_I_P2", "A_O_P2"}),
      R"("malfunctions": [{"name": "contact", "flicker": {"symbol": "L_P_A_I_P2", "every": "1s", "for": "1ms"}}])");
  Found found(plant, 10 * kMs);
  found.to(100).start(0).to(1500);
  CHECK(
      contains(found.words, "event too short: PLC input %IX1, event P2 of L_P_A (symbols.csv:3), changed and changed"));
  CHECK(contains(found.words,
                 "; malfunction `contact` forces event P2 (%IX1): give it a longer time than a cycle of the "
                 "PLC\n"));
}

TEST_CASE("A part that a hidden part blocks names the malfunction of the sensor") {
  const DescribedPlant plant(list({"RBT_O_PICK", "RBT_I_PART"}), R"("material": {
      "kinds": {"raw": {"length": "200 mm"}},
      "places": {"FROM": {}, "TO": {"sensors": [{"symbol": "L_P_RBT_I_PART"}]}},
      "transfers": [{"name": "pick", "from": "FROM", "to": "TO", "when": "L_P_RBT_O_PICK"}]},
      "malfunctions": [{"name": "blind", "force": {"L_P_RBT_I_PART": false}}])");
  Found found(plant);
  found.put("FROM").put("TO").start(0).set("RBT_O_PICK", true).to(100);
  CHECK(contains(found.words, "part blocked: pick cannot move part 1 (raw) from FROM to TO: part 2 is there since"));
  CHECK(contains(found.words, "; malfunction `blind` forces event PART (%IX1): check how the program reacts\n"));
}

TEST_CASE("Findings of inverted operations say what they mean, with the bit in brackets") {
  const DescribedPlant plant(list(kNames), R"("inverted": ["L_P_AGV_O_*"])");
  Found found(plant);
  found.set("AGV_O_P2", false).set("AGV_O_P1", false).to(100).set("AGV_O_P2", true).to(200);
  CHECK(contains(found.words,
                 "operations: %QX2 (inverted, P1 of L_P_AGV) on (bit 0) since 0.1 s, %QX3 (inverted, P2 of "
                 "L_P_AGV) on (bit 0) since 0.1 s; check"));
  CHECK(contains(found.words,
                 "lost command: PLC output %QX3 (inverted), operation P2 of L_P_AGV (symbols.csv:5), on "
                 "(bit 0) since 0.1 s, went off (bit 1) before L_P_AGV (P1) moved; check"));
}

}  // namespace
}  // namespace symplant::test
