// Simulates random plants with their programs.
#include "unit/learn/pairs_plant.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <utility>

namespace symplant::test {
namespace {

using tables::Time;

/// Uniform numbers that are equal with every library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double between(double a, double b) { return a + (b - a) * static_cast<double>(engine_() >> 11U) * 0x1p-53; }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }
  bool happens(double probability) { return between(0, 1) < probability; }
  template <typename T>
  void shuffle(std::vector<T>& items) {
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[below(i)]);
  }

 private:
  std::mt19937_64 engine_;
};

/// Sets symbols at times, and makes a recording of them.
class Changes {
 public:
  void set(const std::string& symbol, double time, bool on) { changes_[symbol].push_back({time, on}); }
  void add(const std::string& symbol) { changes_[symbol]; }

  recording::Recording recorded(double end, double resolution) {
    const Time step = to_time(resolution);
    recording::Recording recording;
    recording.name = "made.jsonl";
    recording.of_plant = false;
    recording.resolution = step;
    recording.end = to_time(end);
    for (auto& [symbol, changes] : changes_) {
      std::stable_sort(changes.begin(), changes.end(),
                       [](const Change& a, const Change& b) { return a.time < b.time; });
      recording::Series series;
      series.name = symbol;
      series.changes.push_back({0, 0.0});
      for (std::size_t i = 0; i < changes.size(); ++i) {
        const Time reading = reading_of(changes[i].time, step);
        if (i + 1 < changes.size() && reading_of(changes[i + 1].time, step) == reading) continue;
        const double value = changes[i].on ? 1 : 0;
        if (value == series.changes.back().value || reading > recording.end) continue;
        if (reading == 0) {
          series.changes.back().value = value;
        } else {
          series.changes.push_back({reading, value});
        }
      }
      recording.index.emplace(symbol, recording.series.size());
      recording.series.push_back(std::move(series));
    }
    fill_order(recording);
    return recording;
  }

 private:
  struct Change {
    double time;
    bool on;
  };

  static Time to_time(double seconds) { return static_cast<Time>(seconds * 1e9 + 0.5); }
  /// The first reading at or after a time.
  static Time reading_of(double seconds, Time step) { return (to_time(seconds) + step - 1) / step * step; }

  static void fill_order(recording::Recording& recording) {
    std::vector<std::pair<Time, std::uint32_t>> all;
    for (std::uint32_t s = 0; s < recording.series.size(); ++s) {
      for (const auto& change : recording.series[s].changes) all.push_back({change.time, s});
    }
    std::sort(all.begin(), all.end());
    for (const auto& change : all) recording.order.push_back(change.second);
  }

  std::map<std::string, std::vector<Change>> changes_;
};

struct Device {
  enum class Kind { double_solenoid, single_solenoid, motor, fan_out, lamp, sensor } kind{};
  std::vector<std::string> operations;
  std::vector<std::string> out_events;   ///< of the end that it moves to
  std::vector<std::string> back_events;  ///< of the other end
  double out = 1;                        ///< travel times, in s
  double back = 1;
  double leave = 0.1;
  bool holds = false;             ///< a double solenoid: the operation is on until the other one; else until the event
  std::vector<double> of_events;  ///< how much later each event comes, as a share
};

/// A move of a device, or of two that always move together.
struct Action {
  std::vector<std::size_t> devices;
  bool out = true;
};
/// Actions that begin in one scan.
using Step = std::vector<Action>;

class Maker {
 public:
  Maker(std::uint64_t seed, const PlantProfile& profile) : random_(seed), profile_(profile) {}

  PairsPlant run() {
    const std::size_t devices =
        profile_.least_devices + random_.below(profile_.most_devices - profile_.least_devices + 1);
    for (std::size_t d = 0; d < devices; ++d) devices_.push_back(make_device());
    const std::size_t stations = 1 + random_.below(profile_.most_stations);
    for (std::size_t s = 0; s < stations; ++s) {
      std::vector<std::size_t> own;
      for (std::size_t d = s; d < devices; d += stations) own.push_back(d);
      run_station(own);
    }
    for (int i = 0; i < 3; ++i) free_event();
    free_pump();
    // Of the last move everything is recorded.
    plant_.recording = changes_.recorded(end_ + 1, profile_.resolution);
    return std::move(plant_);
  }

 private:
  std::string operation() {
    plant_.operations.push_back("Y" + std::to_string(100 + plant_.operations.size()));
    changes_.add(plant_.operations.back());
    return plant_.operations.back();
  }
  std::string event() {
    plant_.events.push_back("X" + std::to_string(100 + plant_.events.size()));
    changes_.add(plant_.events.back());
    return plant_.events.back();
  }

  double travel() { return 0.3 * std::pow(5 / 0.3, random_.between(0, 1)); }

  Device make_device() {
    using Kind = Device::Kind;
    Device device;
    const double kind = random_.between(0, 1);
    device.kind = kind < 0.3    ? Kind::double_solenoid
                  : kind < 0.55 ? Kind::single_solenoid
                  : kind < 0.72 ? Kind::motor
                  : kind < 0.80 ? Kind::fan_out
                  : kind < 0.90 ? Kind::lamp
                                : Kind::sensor;
    device.out = travel();
    device.back = travel();
    device.leave = random_.between(0.03, 0.15) * device.out;
    device.holds = random_.happens(0.5);
    const std::size_t operations = device.kind == Kind::sensor ? 0 : device.kind == Kind::double_solenoid ? 2 : 1;
    for (std::size_t i = 0; i < operations; ++i) device.operations.push_back(operation());
    const std::size_t outs = device.kind == Kind::lamp ? 0 : device.kind == Kind::fan_out ? 2 : 1;
    for (std::size_t i = 0; i < outs; ++i) device.out_events.push_back(event());
    const bool has_back = device.kind == Kind::double_solenoid || device.kind == Kind::fan_out ||
                          (device.kind == Kind::single_solenoid && random_.happens(0.7));
    for (std::size_t i = 0; has_back && i < outs; ++i) device.back_events.push_back(event());
    for (std::size_t i = 0; i < outs; ++i) device.of_events.push_back(random_.between(0.85, 1));
    if (device.kind == Kind::motor) device.out = random_.between(0.1, 1);
    if (device.kind == Kind::motor) device.back = random_.between(0.05, 0.5);
    add_truth(device);
    for (const std::string& name : device.back_events) changes_.set(name, 0, true);
    return device;
  }

  void add_truth(const Device& device) {
    if (device.operations.empty()) return;
    const bool two = device.operations.size() == 2;
    for (const std::string& name : device.out_events) plant_.pairs.insert({device.operations[0], name, false});
    for (const std::string& name : device.back_events) plant_.pairs.insert({device.operations.back(), name, !two});
  }

  /// Some order in which each device moves out before it moves back.
  std::vector<Step> sequence(const std::vector<std::vector<std::size_t>>& groups) {
    std::vector<std::size_t> order;
    for (std::size_t g = 0; g < groups.size(); ++g) order.insert(order.end(), 2, g);
    random_.shuffle(order);
    std::vector<bool> is_out(groups.size(), false);
    std::vector<Step> steps;
    for (const std::size_t g : order) {
      const bool joins = !steps.empty() && steps.back().size() == 1 && steps.back()[0].devices != groups[g] &&
                         random_.happens(profile_.forks);
      if (!joins) steps.emplace_back();
      steps.back().push_back({groups[g], !is_out[g]});
      is_out[g] = !is_out[g];
    }
    return steps;
  }

  void run_station(const std::vector<std::size_t>& own) {
    std::vector<std::vector<std::size_t>> groups;
    for (const std::size_t d : own) {
      if (!groups.empty() && groups.back().size() == 1 && random_.happens(profile_.always_together)) {
        groups.back().push_back(d);
      } else {
        groups.push_back({d});
      }
    }
    std::vector<Step> steps = sequence(groups);
    double time = random_.between(1, 5);
    for (std::size_t cycle = 0; cycle < profile_.cycles; ++cycle) {
      if (!profile_.fixed_sequence) steps = sequence(groups);
      for (const Step& step : steps) time = run_step(step, time);
      time += random_.between(0.2, 2);
    }
    end_ = std::max(end_, time);
  }

  /// A PLC that reads an event writes the next operations this much later.
  double reaction() { return random_.between(0.004, 0.02); }

  double run_step(const Step& step, double begin) {
    double end = begin;
    for (const Action& action : step) {
      for (const std::size_t d : action.devices) end = std::max(end, move(devices_[d], action.out, begin));
    }
    return end + reaction();
  }

  double about(double time) { return time * random_.between(1 - profile_.jitter, 1 + profile_.jitter); }

  /// Returns when the PLC has seen the end of the move.
  double move(const Device& device, bool out, double begin) {
    using Kind = Device::Kind;
    switch (device.kind) {
      case Kind::sensor: {  // a part comes or goes some time later
        const double time = begin + random_.between(0.3, 4);
        changes_.set(device.out_events[0], time, out);
        return time;
      }
      case Kind::lamp:
        changes_.set(device.operations[0], begin, out);
        return begin + (random_.happens(0.5) ? 0 : random_.between(0.5, 1.5));
      case Kind::double_solenoid:
        return move_double(device, out, begin);
      default:
        changes_.set(device.operations[0], begin, out);
        return travel_of(device, out, begin);
    }
  }

  double move_double(const Device& device, bool out, double begin) {
    const std::string& operation = device.operations[out ? 0 : 1];
    changes_.set(operation, begin, true);
    const double end = travel_of(device, out, begin);
    if (device.holds) {
      changes_.set(device.operations[out ? 1 : 0], begin, false);
    } else {
      changes_.set(operation, end + reaction(), false);
    }
    return end;
  }

  double travel_of(const Device& device, bool out, double begin) {
    const double time = about(out ? device.out : device.back);
    double end = begin;
    for (std::size_t i = 0; i < device.out_events.size(); ++i) {
      const double arrival = begin + time * device.of_events[i];
      const double leaving = begin + std::min(about(device.leave), time / 2);
      const bool is_motor = device.kind == Device::Kind::motor;
      changes_.set(device.out_events[i], out || is_motor ? arrival : leaving, out);
      if (!device.back_events.empty()) changes_.set(device.back_events[i], out ? leaving : arrival, !out);
      end = std::max(end, arrival);
    }
    return end;
  }

  /// Something that comes and goes at any time.
  void free_event() {
    const std::string name = event();
    double time = random_.between(0, 60);
    for (bool on = true; time < end_; on = !on) {
      changes_.set(name, time, on);
      time += random_.between(1, 60);
    }
  }

  /// A pump that runs at its own times.
  void free_pump() {
    const Device pump{Device::Kind::motor, {operation()}, {event()}, {}, 0.4, 0.2, 0, false, {1}};
    add_truth(pump);
    double time = random_.between(5, 30);
    for (bool on = true; time < end_; on = !on) {
      move(pump, on, time);
      time += random_.between(10, 40);
    }
  }

  Random random_;
  const PlantProfile& profile_;
  PairsPlant plant_;
  Changes changes_;
  std::vector<Device> devices_;
  double end_ = 0;
};

}  // namespace

PairsPlant random_pairs_plant(std::uint64_t seed, const PlantProfile& profile) { return Maker(seed, profile).run(); }

}  // namespace symplant::test
