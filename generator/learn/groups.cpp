// Devices that agree in their times.
#include "learn/groups.hpp"

#include <algorithm>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "elements/times/key.hpp"
#include "learn/clusters.hpp"
#include "learn/patterns.hpp"
#include "learn/proposal.hpp"
#include "text/ascii.hpp"
#include "text/name_words.hpp"

namespace symplant::learn {
namespace {

/// A bound of a proposed time, and how far it may be from that of another device.
struct Bound {
  Time time = 0;
  Time tolerance = 0;
};

/// A device, as it is compared with others.
struct Compared {
  std::size_t device = 0;
  std::size_t shape = 0;      ///< equal for devices that may agree
  std::vector<Bound> bounds;  ///< of all times, in their order
  bool is_single = false;     ///< has two groups of durations
};

/// Calls `take(time)` for each time of a device, in a fixed order.
template <class Device, class Take>
void each_time(Device& device, Take take) {
  for (auto& transition : device.transitions) {
    if (transition.after) take(*transition.after);
    if (transition.takes) take(*transition.takes);
  }
  if (device.overrun) take(*device.overrun);
}

/// What devices must have in common to share an entry.
std::string keys_text(const model::PlantModel& plant, const LearnedDevice& device) {
  std::string text;
  for (const LearnedTransition& transition : device.transitions) {
    text += text::to_upper(key_of(plant, plant.units[device.unit], transition));
    text += transition.after || transition.resets_after ? ":after" : "";
    text += transition.takes || transition.resets_takes ? ":takes" : "";
    text += '\n';
  }
  return text + (device.overrun ? "overrun" : "");
}

/// Also which times are resets and constants, and the name.
std::string shape_text(const model::PlantModel& plant, const LearnedDevice& device, const std::string& keys) {
  const model::Unit& unit = plant.units[device.unit];
  std::string text = text::to_upper(kind_of(unit)) + '\n' + keys + '\n';
  for (const LearnedTransition& transition : device.transitions) {
    text += transition.resets_after ? 'r' : '-';
    text += transition.resets_takes ? 'r' : '-';
  }
  each_time(device, [&](const LearnedTime& time) { text += time.is_constant() ? 'c' : 'u'; });
  return text;
}

std::size_t number_of(std::unordered_map<std::string, std::size_t>& numbers, std::string text) {
  return numbers.try_emplace(std::move(text), numbers.size()).first->second;
}

/// The moves of several devices as one time. They agree: what is an outlier of one is one of all.
LearnedTime joined(const std::vector<const LearnedTime*>& times, bool is_overrun) {
  LearnedTime all;
  std::vector<Time> kept;
  for (const LearnedTime* time : times) {
    all.samples.insert(all.samples.end(), time->samples.begin(), time->samples.end());
    all.resolution = std::max(all.resolution, time->resolution);
    const std::vector<Time> durations = kept_durations(time->samples, time->clusters);
    kept.insert(kept.end(), durations.begin(), durations.end());
  }
  std::sort(kept.begin(), kept.end());
  std::sort(all.samples.begin(), all.samples.end(), [](const Sample& a, const Sample& b) {
    return std::tie(a.duration, a.input, a.at) < std::tie(b.duration, b.input, b.at);
  });
  Cluster cluster;
  for (std::size_t i = 0; i < all.samples.size(); ++i) {
    const Time duration = all.samples[i].duration;
    if (duration < kept.front() || duration > kept.back()) {
      all.clusters.outliers.push_back(i);
      continue;
    }
    if (cluster.end == 0) cluster.begin = i;
    cluster.end = i + 1;
  }
  all.clusters.kept.push_back(cluster);
  all.statistics = statistics_of(kept, all.resolution);
  all.proposed = is_overrun ? overrun_of(kept, all.resolution) : proposal_of(kept, all.resolution);
  return all;
}

LearnedDevice joined(const std::vector<LearnedDevice>& devices, const std::vector<std::size_t>& members) {
  LearnedDevice first = devices[members.front()];
  if (members.size() == 1) return first;
  std::vector<std::vector<const LearnedTime*>> times;  // by time: those of all devices
  for (const std::size_t member : members) {
    std::size_t next = 0;
    each_time(devices[member], [&](const LearnedTime& time) {
      if (next == times.size()) times.emplace_back();
      times[next++].push_back(&time);
    });
  }
  std::size_t next = 0;
  each_time(first, [&](LearnedTime& time) {
    const bool is_overrun = first.overrun && &time == &*first.overrun;
    time = joined(times[next++], is_overrun);
  });
  return first;
}

Compared compared(const LearnedDevice& device, std::size_t index, std::size_t shape) {
  Compared result{index, shape, {}};
  each_time(device, [&](const LearnedTime& time) {
    result.is_single = result.is_single || time.clusters.kept.size() > 1;
    result.bounds.push_back({time.proposed.a, time.resolution / 2});
    if (!time.is_constant()) result.bounds.push_back({time.proposed.b, time.resolution / 2});
  });
  return result;
}

/// Collects neighbors in a sorted row as long as all bounds are within their tolerance.
class Row {
 public:
  bool takes(const Compared& device) const {
    if (device.shape != shape_ || device.is_single || is_single_) return false;
    for (std::size_t i = 0; i < device.bounds.size(); ++i) {
      const Bound& bound = device.bounds[i];
      const Time least = std::min(least_[i].time, bound.time);
      const Time most = std::max(most_[i].time, bound.time);
      if (most - least > std::min(least_[i].tolerance, bound.tolerance)) return false;
    }
    return true;
  }

  void begin(const Compared& device) {
    shape_ = device.shape;
    is_single_ = device.is_single;
    least_ = most_ = device.bounds;
  }

  void add(const Compared& device) {
    for (std::size_t i = 0; i < device.bounds.size(); ++i) {
      const Bound& bound = device.bounds[i];
      least_[i] = {std::min(least_[i].time, bound.time), std::min(least_[i].tolerance, bound.tolerance)};
      most_[i].time = std::max(most_[i].time, bound.time);
    }
  }

 private:
  std::size_t shape_ = 0;
  bool is_single_ = true;
  std::vector<Bound> least_;
  std::vector<Bound> most_;
};

bool is_before(const Compared& a, const Compared& b) {
  if (a.shape != b.shape) return a.shape < b.shape;
  if (a.is_single != b.is_single) return a.is_single;
  const auto less = [](const Bound& x, const Bound& y) { return x.time < y.time; };
  if (std::lexicographical_compare(a.bounds.begin(), a.bounds.end(), b.bounds.begin(), b.bounds.end(), less))
    return true;
  if (std::lexicographical_compare(b.bounds.begin(), b.bounds.end(), a.bounds.begin(), a.bounds.end(), less))
    return false;
  return a.device < b.device;
}

}  // namespace

std::string key_of(const model::PlantModel& plant, const model::Unit& unit, const LearnedTransition& transition) {
  description::TimesKey key{unit.states[transition.from].name, unit.states[transition.to].name};
  const std::uint32_t on = transition.transition == kNone ? kNone : unit.transitions[transition.transition].on;
  const bool others = std::any_of(unit.transitions.begin(), unit.transitions.end(), [&](const model::Transition& one) {
    return one.from == transition.from && one.to == transition.to && one.on != on && !one.spring_return;
  });
  if (others && on != kNone) key.on = plant.symbols[unit.operations[on]].reading.task();
  return description::times_key_text(key);
}

std::string kind_of(const model::Unit& unit) {
  return text::without_numbers(unit.path.substr(unit.path.rfind('_') + 1), '#');
}

std::vector<LearnedGroup> groups_of(const model::PlantModel& plant, std::vector<LearnedDevice> devices) {
  std::unordered_map<std::string, std::size_t> keys;
  std::unordered_map<std::string, std::size_t> shapes;
  std::vector<std::size_t> keys_of(devices.size());
  std::vector<Compared> all;
  for (std::size_t d = 0; d < devices.size(); ++d) {
    const std::string text = keys_text(plant, devices[d]);
    keys_of[d] = number_of(keys, text);
    all.push_back(compared(devices[d], d, number_of(shapes, shape_text(plant, devices[d], text))));
  }
  std::sort(all.begin(), all.end(), is_before);
  std::vector<std::vector<std::size_t>> members;
  Row row;
  for (const Compared& device : all) {
    if (!members.empty() && row.takes(device)) {
      row.add(device);
      members.back().push_back(device.device);
      continue;
    }
    row.begin(device);
    members.push_back({device.device});
  }
  for (std::vector<std::size_t>& some : members) std::sort(some.begin(), some.end());
  std::sort(members.begin(), members.end());
  std::vector<NamedGroup> named;
  std::unordered_map<std::uint32_t, std::size_t> device_of;  // by unit
  for (const std::vector<std::size_t>& some : members) {
    NamedGroup names{{}, keys_of[some.front()], {}};
    for (const std::size_t d : some) {
      names.units.push_back(devices[d].unit);
      device_of.emplace(devices[d].unit, d);
    }
    named.push_back(std::move(names));
  }
  name_groups(plant, named);
  std::vector<LearnedGroup> groups;
  for (NamedGroup& group : named) {
    for (DevicesName& name : group.names) {
      std::vector<std::size_t> some;
      for (const std::uint32_t unit : name.units) some.push_back(device_of.at(unit));
      groups.push_back({std::move(name.name), std::move(name.units), joined(devices, some)});
    }
  }
  std::sort(groups.begin(), groups.end(),
            [](const LearnedGroup& a, const LearnedGroup& b) { return a.units.front() < b.units.front(); });
  return groups;
}

}  // namespace symplant::learn
