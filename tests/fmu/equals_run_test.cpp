// FMUs of the examples equal `symplant run` at each communication point: two instances at a time, steps of random
// sizes, random inputs and malfunctions, states that are saved and restored.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "fmu/importer.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

namespace symplant::test {
namespace {

using Json = nlohmann::json;
using Outputs = std::map<std::string, double>;

constexpr std::int64_t kSecond = 1'000'000'000;

/// What is set at a communication point, and the duration of the step that follows, in ns.
struct Point {
  std::int64_t time = 0;
  std::map<std::string, double> inputs;
  std::map<std::string, bool> malfunctions;
};

struct Play {
  std::string fmu;  ///< its file
  std::string run;  ///< the command that runs the same plant
  bool on_grid;     ///< steps are multiples of 10 ms, so that much happens at communication points
};

void execute(const std::string& command) {
  INFO(command);
  REQUIRE(std::system(command.c_str()) == 0);
}

/// Random points, from time 0 to 60 s.
std::vector<Point> random_points(const Fmu& fmu, bool on_grid, std::mt19937_64& random) {
  std::vector<std::string> inputs;
  std::vector<std::string> malfunctions;
  for (const auto& [name, variable] : fmu.variables()) {
    if (variable.causality == "input") inputs.push_back(name);
    if (variable.causality == "parameter" && variable.type == "Boolean") malfunctions.push_back(name);
  }
  const auto chance = [&](int of) { return random() % static_cast<std::uint64_t>(of) == 0; };
  const auto number = [&](const FmuVariable& variable) {
    if (variable.type == "Boolean") return chance(2) ? 1.0 : 0.0;
    const double least = variable.least < variable.greatest ? variable.least : -1000;
    const double greatest = variable.least < variable.greatest ? variable.greatest : 1000;
    return std::round(least + (greatest - least) * static_cast<double>(random() % 1001) / 1000);
  };
  std::vector<Point> points;
  for (std::int64_t time = 0; time < 60 * kSecond;) {
    Point point{time, {}, {}};
    for (const std::string& name : inputs) {
      if (chance(30)) point.inputs[name] = number(fmu.variables().at(name));
    }
    if (!malfunctions.empty() && chance(20))
      point.malfunctions[malfunctions[random() % malfunctions.size()]] = !chance(4);
    points.push_back(std::move(point));
    const std::int64_t most = chance(3) ? 5 * kSecond : kSecond / 5;  // long ones hide pulses
    const std::int64_t unit = on_grid ? 10'000'000 : 1;
    time += unit * (1 + static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(most / unit)));
  }
  return points;
}

/// The same as a scenario. What is set after an expectation of its time acts in a further instant, as in a step.
void write_scenario(const Fmu& fmu, const std::vector<Point>& points, const std::string& path) {
  const auto is_bool = [&](const std::string& name) { return fmu.variables().at(name).type == "Boolean"; };
  std::string always;
  for (const auto& [name, variable] : fmu.variables()) {
    if (variable.causality == "output" && is_bool(name)) always = name + " or not " + name;
  }
  Json steps = Json::array();
  for (const Point& point : points) {
    Json step = {{"at", std::to_string(point.time) + "ns"}};
    if (point.time != 0) {
      step["expect"] = always;
      steps.push_back(step);
      step = {{"plus", "0s"}};
    }
    for (const auto& [name, value] : point.inputs) {
      const bool is_event = name.size() > 4 && name.substr(name.size() - 4) == ".set";
      step["set"][is_event ? name.substr(0, name.size() - 4) : name] = is_bool(name) ? Json(value != 0) : Json(value);
    }
    for (const auto& [name, on] : point.malfunctions) step[on ? "start" : "stop"].push_back(name);
    if (step.size() > 1) steps.push_back(step);
  }
  std::ofstream(path) << Json{{"symplant-scenario", 1}, {"steps", steps}}.dump(1);
}

/// The numeric value of a line of a trace; integers beyond 2^53 and numbers that are not finite are texts there.
double number_of(const Json& value) {
  if (value.is_boolean()) return value.get<bool>() ? 1 : 0;
  return value.is_string() ? std::stod(value.get<std::string>()) : value.get<double>();
}

/// What an importer must see at the end of each step, by the trace of a run: an event that differed in the step from
/// what was shown before it shows the opposite, also if it is back.
class Expected {
 public:
  Expected(const Fmu& fmu, const std::string& trace) : fmu_(fmu), lines_(trace) {
    std::string head;
    std::getline(lines_, head);
    for (const auto& [name, variable] : fmu.variables()) {
      if (variable.causality == "output") real_[name] = shown_[name] = 0;
    }
    next_line();
    next_instant();
  }

  /// What the plant shows before its first step.
  void begin(const Outputs& outputs) { shown_ = outputs; }
  /// The outputs at `time`, the end of the step that began at the last call's time.
  const Outputs& at(std::int64_t time) {
    if (!begun_) read_first_instant();
    Outputs seen;
    for (const auto& [name, value] : real_) {
      if (value != shown_[name]) seen[name] = value;
    }
    for (; !instant_.empty() && time_ <= time && !(time_ == time && has_set()); next_instant()) {
      for (const auto& [name, value] : changes()) {
        if (is_bool(name) && value == shown_[name] && real_[name] != value) ++short_pulses_;
        real_[name] = value;
        if (value != shown_[name]) seen[name] = value;
      }
    }
    for (const auto& [name, value] : real_) {
      shown_[name] = is_bool(name) && seen.count(name) != 0 ? 1 - shown_[name] : value;
    }
    return shown_;
  }
  int short_pulses() const { return short_pulses_; }

 private:
  void next_line() {
    std::string text;
    line_ = std::getline(lines_, text) ? Json::parse(text) : Json();
  }
  /// Reads the lines of an instant.
  void next_instant() {
    instant_.clear();
    if (line_.is_null()) return;
    time_ = line_["t"];
    do {
      instant_.push_back(line_);
      next_line();
    } while (!line_.is_null() && line_["t"] == time_ && !line_.contains("instant"));
  }
  /// The changes of outputs in the instant.
  Outputs changes() const {
    Outputs changes;
    for (const Json& line : instant_) {
      if (!line.contains("symbol")) continue;
      const std::string name = line["symbol"];
      if (real_.count(name) != 0) changes[name] = number_of(line["value"]);
    }
    return changes;
  }
  /// Whether something was set in the instant.
  bool has_set() const {
    return std::any_of(instant_.begin(), instant_.end(), [this](const Json& line) {
      return line.contains("instant") || line.contains("act") ||
             (line.contains("symbol") && real_.count(line["symbol"].get<std::string>()) == 0);
    });
  }
  /// A trace begins with what is not off or 0 after the first instant.
  void read_first_instant() {
    begun_ = true;
    if (time_ != 0) return;
    for (const auto& [name, value] : changes()) real_[name] = value;
    next_instant();
  }
  bool is_bool(const std::string& name) const { return fmu_.variables().at(name).type == "Boolean"; }

  const Fmu& fmu_;
  std::ifstream lines_;
  Json line_;
  std::vector<Json> instant_;
  std::int64_t time_ = 0;
  bool begun_ = false;
  Outputs real_;
  Outputs shown_;
  int short_pulses_ = 0;
};

/// One instance of a play and what it must show.
struct Side {
  FmuInstance instance;
  std::vector<Point> points;
  Expected expected;
  double start;
  std::size_t next = 0;
};

Outputs outputs_of(const Fmu& fmu, const FmuInstance& instance) {
  Outputs outputs;
  for (const auto& [name, variable] : fmu.variables()) {
    if (variable.causality == "output") outputs[name] = instance.get(name);
  }
  return outputs;
}

/// One step, and the comparison at its end.
void advance(const Fmu& fmu, Side& side) {
  const Point& point = side.points[side.next];
  const std::int64_t end = side.points[side.next + 1].time;
  for (const auto& [name, value] : point.inputs) side.instance.set(name, value);
  for (const auto& [name, on] : point.malfunctions) side.instance.set(name, on ? 1 : 0);
  const double from = side.start + static_cast<double>(point.time) / 1e9;
  side.instance.step(from, side.start + static_cast<double>(end) / 1e9 - from);
  ++side.next;
  const Outputs& expected = side.expected.at(end);
  for (const auto& [name, value] : outputs_of(fmu, side.instance)) {
    const double shown = expected.at(name);
    // A trace has the shortest text of a REAL, which is a float.
    if (value == shown || value == static_cast<double>(static_cast<float>(shown))) continue;
    if (std::isnan(value) && std::isnan(shown)) continue;
    FAIL_CHECK(name << " is " << value << " instead of " << shown << " at " << end << " ns");
  }
}

/// `play` with two instances whose steps alternate at random. Returns the number of short pulses.
int play(const Play& play, std::uint64_t seed) {
  INFO(play.fmu << ", " << play.run << ", seed " << seed);
  const TemporaryFolder folder;
  const Fmu fmu(play.fmu, folder / "fmu");
  std::mt19937_64 random(seed);
  std::vector<std::unique_ptr<Side>> sides;
  for (int i = 0; i < 2; ++i) {
    const std::string name = std::to_string(i);
    std::vector<Point> points = random_points(fmu, play.on_grid, random);
    write_scenario(fmu, points, folder / (name + ".json"));
    const int plant_seed = static_cast<int>(random() % 1000);
    execute(play.run + " --seed " + std::to_string(plant_seed) + " --scenario '" + (folder / (name + ".json")) +
            "' --trace '" + (folder / (name + ".jsonl")) + "' > /dev/null 2>&1 || [ $? = 1 ]");
    sides.push_back(std::unique_ptr<Side>(
        new Side{{fmu, name}, std::move(points), {fmu, folder / (name + ".jsonl")}, i == 0 ? 0 : 12.5}));
    Side& side = *sides.back();
    side.instance.initialize(plant_seed, side.start);
    side.expected.begin(outputs_of(fmu, side.instance));
  }
  const auto left = [](const Side& side) { return side.next + 1 < side.points.size(); };
  while (left(*sides[0]) || left(*sides[1])) {
    Side& side = *sides[random() % 2];
    if (!left(side)) continue;
    if (random() % 20 == 0) {  // a rejected step: another one from here leaves no trace
      const std::vector<char> state = side.instance.save();
      side.instance.step(side.start + static_cast<double>(side.points[side.next].time) / 1e9, 0.7);
      side.instance.restore(state);
    }
    advance(fmu, side);
  }
  int pulses = 0;
  for (const auto& side : sides) {
    CHECK(side->instance.get("short pulses") == side->expected.short_pulses());
    pulses += side->expected.short_pulses();
  }
  return pulses;
}

}  // namespace

TEST_CASE("FMUs of the examples equal `symplant run` at each communication point") {
  const auto seed = GENERATE(range<std::uint64_t>(1, SYMPLANT_FMU_SEEDS + 1));
  int pulses = 0;
  for (const char* const example :
       {"cell/plant.json", "excell/excell.csv", "body-shop/plant.json", "dosing/plant.json", "oven/plant.json",
        "sorting/plant.json", "harbour-crane/plant.json", "training-line/plant.json", "two-plcs/plant.json"}) {
    const std::string plant = std::string("'" SYMPLANT_SOURCE "/examples/") + example + "'";
    const TemporaryFolder folder;
    const std::string fmu = folder / "plant.fmu";
    execute("'" SYMPLANT_TOOL "' generate " + plant + " --fmu '" + fmu + "' > /dev/null");
    for (const bool on_grid : {false, true}) pulses += play({fmu, "'" SYMPLANT_TOOL "' run " + plant, on_grid}, seed);
  }
  CHECK(pulses > 0);
}

TEST_CASE("The FMU of a plant with the user's C++ equals its program") {
  const auto seed = GENERATE(range<std::uint64_t>(1, SYMPLANT_FMU_SEEDS + 1));
  for (const bool on_grid : {false, true}) play({SYMPLANT_SCALE_FMU, "'" SYMPLANT_SCALE "'", on_grid}, seed);
}

}  // namespace symplant::test
