// Tests of pairs, sentence by sentence of docs/learn-pairs.md.
#include "learn/pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "base/text_source.hpp"
#include "learn/pairs_formats.hpp"
#include "naming/links_file.hpp"
#include "support/catch.hpp"
#include "text/source_file.hpp"
#include "unit/learn/pairs_support.hpp"

namespace symplant::test {
namespace {

constexpr tables::Time kMs = 1'000'000;

/// Recordings that a test writes change by change. Symbols Y... are operations, X... are events.
class Bench {
 public:
  Bench(std::vector<std::string> operations, std::vector<std::string> events)
      : Bench(unnamed_plant(operations, events)) {}
  explicit Bench(Analysed plant) : plant_(std::move(plant)) {}

  void set(const std::string& symbol, tables::Time ms, bool on) {
    changes_[symbol].push_back({ms * kMs, on ? 1.0 : 0.0});
  }
  /// A pulse of the operation each 10 s, and one of the event `delay` later.
  void pulses(const std::string& operation, const std::string& event, std::size_t count, tables::Time delay = 1000) {
    for (std::size_t i = 0; i < count; ++i) {
      const auto time = static_cast<tables::Time>(10'000 * (i + 1));
      pulse(operation, time, 4000);
      pulse(event, time + delay, 4000);
    }
  }
  void pulse(const std::string& symbol, tables::Time ms, tables::Time length) {
    set(symbol, ms, true);
    set(symbol, ms + length, false);
  }

  /// Ends a recording; later changes are in the next one.
  void end_recording(tables::Time ms, std::vector<recording::Gap> gaps = {}) {
    recording::Recording recording;
    recording.of_plant = false;
    recording.resolution = resolution;
    recording.end = ms * kMs;
    recording.gaps = std::move(gaps);
    std::vector<std::pair<tables::Time, std::uint32_t>> order;
    for (auto& [name, changes] : changes_) {
      std::stable_sort(changes.begin(), changes.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
      if (changes.front().time != 0) changes.insert(changes.begin(), {0, 0.0});
      recording::Series series;
      series.name = name;
      series.changes = std::move(changes);
      for (const auto& change : series.changes) {
        order.push_back({change.time, static_cast<std::uint32_t>(recording.series.size())});
      }
      recording.series.push_back(std::move(series));
    }
    std::sort(order.begin(), order.end());
    for (const auto& change : order) recording.order.push_back(change.second);
    changes_.clear();
    inputs_.push_back(input_of(plant_.model(), std::move(recording)));
  }

  learn::Pairs learned(std::uint64_t seed = 0) {
    if (!changes_.empty()) end_recording(1'000'000);
    return learn::learn_pairs(plant_.model(), inputs_, seed);
  }

  /// "Y1 X1, Y1 !X2; fan-out Y1; X3 together Y1 Y2".
  std::string found() {
    const learn::Pairs pairs = learned();
    std::string text;
    for (const learn::Pair& pair : pairs.pairs) {
      text += fmt::format("{}{} {}{}", text.empty() ? "" : ", ", name(pair.operation), pair.inverted ? "!" : "",
                          name(pair.event));
    }
    for (const learn::FanOut& fan_out : pairs.fan_outs) text += fmt::format("; fan-out {}", name(fan_out.operation));
    for (const learn::Interlock& interlock : pairs.interlocks) {
      text += fmt::format("; {} {}", name(interlock.event),
                          interlock.kind == learn::Interlock::Kind::together ? "together" : "alternate");
      for (const std::uint32_t operation : interlock.operations) text += " " + std::string(name(operation));
    }
    return text;
  }

  std::string_view name(std::uint32_t symbol) const { return plant().symbols[symbol].name(); }
  const model::PlantModel& plant() const { return plant_.model(); }

  tables::Time resolution = 0;

 private:
  Analysed plant_;
  std::map<std::string, std::vector<recording::Series::Change>> changes_;
  std::vector<learn::Input> inputs_;
};

TEST_CASE("An event that changes in the same time after each change of an operation is a pair") {
  Bench bench({"Y1"}, {"X1"});
  bench.pulses("Y1", "X1", 6);
  const learn::Pairs pairs = bench.learned();
  REQUIRE(pairs.pairs.size() == 1);
  const learn::Pair& pair = pairs.pairs.front();
  CHECK(bench.name(pair.operation) == "Y1");
  CHECK(bench.name(pair.event) == "X1");
  CHECK(!pair.inverted);
  CHECK(pair.on.changes == 6);
  CHECK(pair.on.hits == 6);
  CHECK(pair.on.median == 1000 * kMs);
  CHECK(pair.follows_off());
  CHECK(pairs.operations == 1);
  CHECK(pairs.events == 1);
}

TEST_CASE("Four changes are too few") {
  Bench bench({"Y1"}, {"X1"});
  bench.pulses("Y1", "X1", 4);
  CHECK(bench.found().empty());
}

TEST_CASE("One miss in twenty changes is allowed, two are not") {
  const auto with_misses = [](std::size_t misses) {
    Bench bench({"Y1"}, {"X1"});
    bench.pulses("Y1", "X1", 20 - misses);
    for (std::size_t i = 0; i < misses; ++i) bench.pulse("Y1", static_cast<tables::Time>(400'000 + 10'000 * i), 4000);
    return bench.found();
  };
  CHECK(with_misses(1) == "Y1 X1");
  CHECK(with_misses(2).empty());
}

TEST_CASE("An event that also changes otherwise is no pair") {
  Bench bench({"Y1"}, {"X1"});
  bench.pulses("Y1", "X1", 10);
  for (int i = 0; i < 3; ++i) bench.pulse("X1", 300'000 + 10'000 * i, 1000);
  CHECK(bench.found().empty());
}

TEST_CASE("Delays differ by a quarter of their median at most, and by what the resolution makes of them") {
  const auto with_spread = [](tables::Time spread, tables::Time resolution) {
    Bench bench({"Y1"}, {"X1"});
    bench.resolution = resolution * kMs;
    for (int i = 0; i < 10; ++i) {
      bench.pulse("Y1", 10'000 * (i + 1), 5000);
      bench.pulse("X1", 10'000 * (i + 1) + 1000 + spread * i / 9, 3000);
    }
    return bench.found();
  };
  CHECK(with_spread(250, 0) == "Y1 X1");
  CHECK(with_spread(400, 0).empty());
  CHECK(with_spread(400, 100) == "Y1 X1");
  CHECK(with_spread(600, 100).empty());
}

TEST_CASE("An operation that changes in the same reading as an event is the PLC's answer, not the cause") {
  Bench bench({"Y1"}, {"X1"});
  bench.resolution = 50 * kMs;
  bench.pulses("Y1", "X1", 20, 0);
  CHECK(bench.found().empty());
}

TEST_CASE("An event follows the last operation of a sequence, not the one before it") {
  Bench bench({"Y1", "Y2"}, {"X1", "X2"});
  for (int i = 0; i < 12; ++i) {
    const tables::Time begin = 20'000 * (i + 1);
    const tables::Time first = begin + 1000 + 8 * (i * 5 % 12);
    const tables::Time second = first + 10 + 700 + 8 * (i * i % 11);
    bench.pulse("Y1", begin, 8000);
    bench.pulse("X1", first, 8000);
    bench.pulse("Y2", first + 10, 8000);
    bench.pulse("X2", second, 8000);
  }
  CHECK(bench.found() == "Y1 X1, Y2 X2");
}

TEST_CASE("The sensor of the other end of a valve with a spring is an inverted pair") {
  Bench bench({"Y1"}, {"X1", "X2"});
  bench.set("X2", 0, true);
  for (int i = 0; i < 8; ++i) {
    const tables::Time begin = 20'000 * (i + 1);
    bench.pulse("Y1", begin, 8000);
    bench.set("X2", begin + 100, false);
    bench.set("X1", begin + 1500, true);
    bench.set("X1", begin + 8150, false);
    bench.set("X2", begin + 9000, true);
  }
  CHECK(bench.found() == "Y1 X1, Y1 !X2");
}

TEST_CASE("The events of a valve with two coils may change to off by the other coil") {
  Bench bench({"Y1", "Y2"}, {"X1", "X2"});
  bench.set("X2", 0, true);
  for (int i = 0; i < 8; ++i) {
    const tables::Time begin = 20'000 * (i + 1);
    bench.set("Y2", begin, false);
    bench.set("Y1", begin, true);
    bench.set("X2", begin + 100, false);
    bench.set("X1", begin + 1500, true);
    bench.set("Y1", begin + 9000, false);
    bench.set("Y2", begin + 9000, true);
    bench.set("X1", begin + 9100, false);
    bench.set("X2", begin + 10'000, true);
  }
  CHECK(bench.found() == "Y1 X1, Y2 X2");
}

TEST_CASE("An operation that several events follow is a fan-out") {
  Bench bench({"Y1"}, {"X1", "X2"});
  bench.pulses("Y1", "X1", 8);
  for (int i = 0; i < 8; ++i) bench.pulse("X2", 10'000 * (i + 1) + 1300, 4000);
  CHECK(bench.found() == "Y1 X1, Y1 X2; fan-out Y1");
}

TEST_CASE("Operations that always change together are reported, not guessed") {
  Bench bench({"Y1", "Y2"}, {"X1"});
  bench.pulses("Y1", "X1", 8);
  for (int i = 0; i < 8; ++i) bench.pulse("Y2", 10'000 * (i + 1), 4000);
  CHECK(bench.found() == "; X1 together Y1 Y2");
}

TEST_CASE("An operation that ends when its event comes is preferred to one that changes together with it") {
  Bench bench({"Y1", "Y2"}, {"X1"});
  for (int i = 0; i < 8; ++i) {
    const tables::Time begin = 20'000 * (i + 1);
    bench.pulse("Y1", begin, 6000);
    bench.pulse("Y2", begin, 1500 + 20 * (i % 3) + 10);
    bench.pulse("X1", begin + 1500 + 20 * (i % 3), 9000);
  }
  CHECK(bench.found() == "Y2 X1");
}

TEST_CASE("An event that follows two operations at different times is reported with both") {
  Bench bench({"Y1", "Y2"}, {"X1"});
  for (int i = 0; i < 8; ++i) {
    for (int operation = 0; operation < 2; ++operation) {
      const tables::Time begin = 40'000 * (i + 1) + 9000 * operation * (1 + i % 2);
      bench.pulse(operation == 0 ? "Y1" : "Y2", begin, 3000);
      bench.pulse("X1", begin + 800, 3000);
    }
  }
  CHECK(bench.found() == "; X1 alternate Y1 Y2");
}

TEST_CASE("Changes during a gap, and those before its end, do not count") {
  Bench bench({"Y1"}, {"X1"});
  bench.pulses("Y1", "X1", 8);
  // Y1 and X1 changed in the gap, at times that are not known, and Y1 again at its end.
  bench.pulse("Y1", 200'000, 10'000);
  bench.set("X1", 201'000, true);
  bench.set("Y1", 230'000, true);
  bench.end_recording(300'000, {{200'500 * kMs, 29'500 * kMs}});
  const learn::Pairs pairs = bench.learned();
  REQUIRE(pairs.pairs.size() == 1);
  CHECK(pairs.pairs.front().on.changes == 8);
  CHECK(pairs.pairs.front().on.effects == 8);
}

TEST_CASE("An operation that changes just before the end of a recording is no miss") {
  Bench bench({"Y1"}, {"X1"});
  bench.pulses("Y1", "X1", 8);
  bench.set("Y1", 99'500, true);
  bench.end_recording(100'000);
  const learn::Pairs pairs = bench.learned();
  REQUIRE(pairs.pairs.size() == 1);
  CHECK(pairs.pairs.front().on.changes == 8);
}

TEST_CASE("A change of an operation does not count if the event has its value already") {
  Bench bench({"Y1"}, {"X1"});
  for (int i = 0; i < 8; ++i) {
    const tables::Time begin = 20'000 * (i + 1);
    bench.pulse("Y1", begin, 500);
    bench.pulse("Y1", begin + 3000, 500);
    bench.pulse("X1", begin + 1000, 8000);
  }
  const learn::Pairs pairs = bench.learned();
  REQUIRE(pairs.pairs.size() == 1);
  CHECK(pairs.pairs.front().on.changes == 8);
}

TEST_CASE("Several recordings count together") {
  Bench bench({"Y1"}, {"X1"});
  bench.pulses("Y1", "X1", 3);
  bench.end_recording(100'000);
  bench.pulses("Y1", "X1", 3);
  bench.end_recording(100'000);
  CHECK(bench.found() == "Y1 X1");
}

TEST_CASE("Few changes whose delays differ as much as they are apart follow by chance") {
  const auto found = [](tables::Time distance) {
    Bench bench({"Y1"}, {"X1"});
    bench.resolution = 200 * kMs;
    for (int i = 0; i < 5; ++i) {
      bench.pulse("Y1", 10'000 + distance * i, 200);
      bench.pulse("X1", 10'000 + distance * i + 200 * (i % 3), 100);
    }
    return bench.found();
  };
  CHECK(found(20'000) == "Y1 X1");
  CHECK(found(600).empty());
}

TEST_CASE("The score against chance depends on the seed only") {
  Bench bench({"Y1"}, {"X1"});
  for (int i = 0; i < 20; ++i) {
    bench.pulse("Y1", 10'000 * (i + 1), 5000);
    bench.pulse("X1", 10'000 * (i + 1) + 1000 + 10 * i, 3000);
  }
  const learn::Chance chance = bench.learned(7).pairs.at(0).chance;
  CHECK(chance.changes == 20);
  CHECK(chance.hits == 20);
  CHECK(chance.most < 20);
  CHECK(bench.learned(7).pairs.at(0).chance.mean == chance.mean);
  CHECK(bench.learned(8).pairs.at(0).chance.mean != chance.mean);
}

TEST_CASE("What names pair is no pair again, but its operations may drive other events") {
  Bench bench(analyse_rows({{"L_P_D_O_ADV", "", "BOOL", "FALSE", "%QX0"},
                            {"L_P_D_I_ADV", "", "BOOL", "FALSE", "%IX0"},
                            {"X1", "", "BOOL", "FALSE", "%IX1"}}));
  bench.pulses("L_P_D_O_ADV", "L_P_D_I_ADV", 8);
  for (int i = 0; i < 8; ++i) bench.pulse("X1", 10'000 * (i + 1) + 1300, 4000);
  const learn::Pairs pairs = bench.learned();
  CHECK(pairs.operations == 0);
  CHECK(pairs.events == 1);
  REQUIRE(pairs.pairs.size() == 1);
  CHECK(pairs.pairs.front().named);
  const std::string links = learn::pairs_links(pairs, bench.plant(), {});
  CHECK(links ==
        "operation,event,state\n# L_P_D_O_ADV -> X1: 8 of 8 changes, after 1.3 s; off: 8 of 8 changes, after 1.3 s; by "
        "chance at most " +
            std::to_string(pairs.pairs.front().chance.most) +
            " of 8 (names pair the operation, which a row would undo)\n");
}

/// A spring valve, a motor with two sensors, and a sensor that is on while its operation is off.
Bench mixed_bench() {
  Bench bench({"Y1", "Y2", "Y3"}, {"X1", "X2", "X3", "X4", "X5"});
  bench.set("X2", 0, true);
  bench.set("X5", 0, true);
  for (int i = 0; i < 8; ++i) {
    const tables::Time begin = 60'000 * (i + 1);
    bench.pulse("Y1", begin, 8000);
    bench.set("X2", begin + 100, false);
    bench.pulse("X1", begin + 1500, 6650);
    bench.set("X2", begin + 9000, true);
    bench.pulse("Y2", begin + 20'000 + 300 * (i % 4), 5000);
    bench.pulse("X3", begin + 20'400 + 300 * (i % 4), 5000);
    bench.pulse("X4", begin + 20'700 + 300 * (i % 4), 5000);
    bench.pulse("Y3", begin + 40'000 + 700 * (i % 3), 5000);
    bench.set("X5", begin + 40'300 + 700 * (i % 3), false);
    bench.set("X5", begin + 45'500 + 700 * (i % 3), true);
  }
  return bench;
}

TEST_CASE("Pairs are written as rows of links with their evidence, and refused ones are left out") {
  Bench bench = mixed_bench();
  const learn::Pairs pairs = bench.learned();
  const std::string text = learn::pairs_links(pairs, bench.plant(), {});
  std::string rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with('#')) rows += line + "\n";
  }
  CHECK(rows == "operation,event,state\nY1,X1,ON\n,X2,OFF\nY2,X3,ON\n,X4,ON\n");
  CHECK(text.find("# Y3 -> not X5: 8 of 8 changes, after 0.5 s") != std::string::npos);
  // Pairs are numbered from 0: Y1 X1, Y1 X2, Y2 X3.
  const std::string refused = learn::pairs_links(pairs, bench.plant(), {0, 1, 2, 4});
  CHECK(refused.find("Y2,X4,ON\n") != std::string::npos);
  CHECK(std::count(refused.begin(), refused.end(), '\n') == 3);
}

TEST_CASE("The rows pair the symbols when a naming rule has them") {
  Bench bench = mixed_bench();
  diag::Diagnostics diagnostics;
  const auto source =
      std::make_shared<text::SourceFile>("links.csv", learn::pairs_links(bench.learned(), bench.plant(), {}));
  name::Naming naming;
  naming.links = naming::read_links_file(source, diagnostics).links;
  CHECK(diagnostics.all().empty());
  std::vector<Row> rows;
  for (const model::Symbol& symbol : bench.plant().symbols) {
    const bool operation = symbol.direction == tables::Direction::operation;
    rows.push_back(
        {std::string(symbol.name()), "", "BOOL", "FALSE", (operation ? "%QX" : "%IX") + std::to_string(rows.size())});
  }
  const Analysed paired = analyse_by_rule(naming, {{"list.csv", list_text(rows)}});
  std::string units;
  for (const model::Unit& unit : paired.model().units) {
    units += std::string(unit.path) + ":";
    for (const model::State& state : unit.states) units += " " + state.name;
    units += fmt::format(" {}/{}\n", unit.operations.size(), unit.events.size());
  }
  CHECK(units == "Y1: ON OFF 1/2\nY2: NOT_ON ON 1/2\n");
}

TEST_CASE("The report numbers the pairs and shows what is not decided") {
  Bench bench = mixed_bench();
  const learn::Pairs pairs = bench.learned();
  const std::string text = learn::pairs_text(pairs, bench.plant());
  INFO(text);
  CHECK(
      text.starts_with("1000 s of recordings, resolution 0 s: 3 operations and 5 events that names do not pair\n"
                       "pairs (--refuse N,.. leaves some out):\n"
                       "   1  Y1 -> X1: 8 of 8 changes, after 1.5 s; off: 8 of 8 changes, after 0.15 s; by chance"));
  CHECK(text.find("   2  Y1 -> not X2: ") != std::string::npos);
  CHECK(text.ends_with("operations that drive several events:\n      Y2 -> X3 and X4\n"));
}

TEST_CASE("Programs read everything as JSON") {
  Bench bench({"Y1", "Y2"}, {"X1"});
  bench.pulses("Y1", "X1", 8);
  for (int i = 0; i < 8; ++i) bench.pulse("Y2", 10'000 * (i + 1), 4000);
  const learn::Pairs pairs = bench.learned();
  const std::string text = base::text_of([&](base::TextSink& sink) {
    view::JsonWriter json(sink, view::JsonWriter::Form::compact);
    learn::write_pairs(pairs, bench.plant(), json);
    json.finish();
  });
  CHECK(text == R"({"length":1000000000000,"resolution":0,"seed":0,"operations":2,"events":1,"pairs":[],"fan_outs":[],)"
                R"("interlocks":[{"event":"X1","kind":"together","operations":["Y1","Y2"]}]})");
}

}  // namespace
}  // namespace symplant::test
