// Pieces of files.
#include "property/files/said.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <nlohmann/json.hpp>

#include "property/words.hpp"
#include "symplant/engine/wide.hpp"
#include "symplant/tables/digest.hpp"
#include "symplant/tables/material.hpp"

namespace symplant::property::files {
namespace {

using nlohmann::json;

struct Unit {
  const char* name;
  std::int64_t size;
};
constexpr std::array<Unit, 6> kTimes{{{"ns", 1},
                                      {"us", 1000},
                                      {"ms", tables::kMillisecond},
                                      {"s", tables::kSecond},
                                      {"min", 60 * tables::kSecond},
                                      {"h", 3600 * tables::kSecond}}};
constexpr std::array<Unit, 4> kLengths{{{"um", 1}, {"mm", 1'000}, {"cm", 10'000}, {"m", 1'000'000}}};
constexpr std::array<Unit, 2> kSpeeds{{{"mm/s", 1'000}, {"m/s", 1'000'000}}};
constexpr std::array<Unit, 1> kSpeedsPerMinute{{{"m/min", 1'000'000}}};

std::uint64_t seed_of(const Style& style, std::string_view of) {
  tables::Fnv1a64 hash;
  hash.u64(style.seed);
  hash.text(of);
  return hash.value();
}

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

/// An amount of the smallest unit as a number and a unit.
template <std::size_t N>
std::string quantity(Dice& dice, bool decorated, std::int64_t amount, const std::array<Unit, N>& units) {
  const Unit& unit = units[decorated ? dice.below(N) : 0];
  for (int decimals = 0; decimals <= 9; ++decimals) {
    engine::SignedWide scaled = amount;
    for (int i = 0; i < decimals; ++i) scaled *= 10;
    if (scaled % unit.size != 0) continue;
    std::string digits = std::to_string(static_cast<std::int64_t>(scaled / unit.size));
    if (decimals > 0) {
      const auto least = static_cast<std::size_t>(decimals) + 1;
      if (digits.size() < least) digits.insert(0, least - digits.size(), '0');
      digits.insert(digits.size() - static_cast<std::size_t>(decimals), ".");
      if (dice.percent(20)) digits += "00";
    }
    if (decorated && decimals == 0 && dice.percent(5)) digits += ".0";
    return digits + (decorated && dice.percent(30) ? " " : "") + unit.name;
  }
  return {};
}

}  // namespace

Sayer::Sayer(const Style& style, std::string_view of, Counts& counts)
    : dice(seed_of(style, of)), decorated_(style.decorated), counts_(counts) {}

std::string Sayer::time(tables::Time time) {
  const std::string text = quantity(dice, decorated_, time, kTimes);
  return text.empty() ? std::to_string(time) + "ns" : text;
}

std::string Sayer::length(std::int64_t length) { return quantity(dice, decorated_, length, kLengths); }

std::string Sayer::speed(std::int64_t speed) {
  if (!decorated_ || !dice.percent(30)) return quantity(dice, decorated_, speed, kSpeeds);
  const auto rounded = speed < tables::kMaxSpeed ? static_cast<std::int64_t>(dice.below(60)) : 0;
  ++counts_[Seen::speeds_per_minute];
  return quantity(dice, decorated_, 60 * speed + rounded, kSpeedsPerMinute);
}

std::string Sayer::location(const std::string& location) {
  const std::size_t at = location.find('@');
  if (at == location.npos || location.find('{', at) != location.npos) return name(location);
  const std::string position = length(std::stoll(location.substr(at + 1)));
  return name(location.substr(0, at)) + (decorated_ && dice.percent(10) ? " @ " : "@") + position;
}

std::string Sayer::sequence(description::Sequence sequence) {
  ++counts_[Seen::sequences];
  return std::string(description::sequence_name(sequence));
}

std::string Sayer::overrun(tables::Time overrun) {
  ++counts_[Seen::overruns];
  return overrun == tables::kNever ? "never" : time(overrun);
}

json Sayer::duration(const description::Duration& duration) {
  using Kind = description::Duration::Kind;
  if (duration.kind == Kind::fixed) return time(duration.a);
  if (duration.kind == Kind::seconds) {
    ++counts_[Seen::computed_times];
    return {{"seconds", *duration.formula}};
  }
  ++counts_[Seen::random_times];
  if (duration.kind == Kind::uniform) return {{"min", time(duration.a)}, {"max", time(duration.b)}};
  return {{"mean", time(duration.a)}, {"sigma", time(duration.b)}};
}

std::string Sayer::name(const std::string& name) {
  if (!decorated_ || !dice.percent(8)) return name;
  ++counts_[Seen::lower_case];
  std::string changed = name;
  std::transform(changed.begin(), changed.end(), changed.begin(), lower);
  return changed;
}

std::string Sayer::condition(const std::string& text) {
  if (text.find('\'') != text.npos) ++counts_[Seen::quoted_names];
  return text;
}

json Sayer::transition(const description::GivenTransition& given) {
  json said = {{"from", name(given.from)}, {"to", name(given.to)}};
  if (given.from == "*") ++counts_[Seen::stars];
  if (!given.on.empty()) said["on"] = name(given.on);
  if (!given.when.empty()) said["when"] = condition(given.when);
  if (!given.during.empty()) said["while"] = condition(given.during);
  if (!given.during.empty()) ++counts_[Seen::whiles];
  if (given.numbers.weight != 0) said["weight"] = given.numbers.weight;
  if (given.numbers.weight != 0) ++counts_[Seen::weights];
  if (given.automatic || (decorated_ && dice.percent(3))) said["automatic"] = given.automatic;
  if (given.once) said["once"] = true;
  if (given.after) said["after"] = duration(*given.after);
  if (given.takes) said["takes"] = duration(*given.takes);
  return said;
}

// Members of an object are found by name, so all names of one object change their case together.
json Sayer::switched(const std::vector<std::pair<std::string, bool>>& events) {
  json said = json::object();
  const bool changed = decorated_ && dice.percent(8);
  for (const auto& [event, on] : events) {
    std::string task = event;
    if (changed) std::transform(task.begin(), task.end(), task.begin(), lower);
    said[task] = on;
  }
  return said;
}

json Sayer::disabled(const std::string& own, const std::vector<std::string>& devices,
                     const std::vector<std::string>& units) {
  json said = json::array();
  std::vector<std::string> left = devices;
  for (int tries = 0; tries < 6 && !left.empty() && decorated_; ++tries) {
    const std::string pattern = random_pattern(dice, dice.pick(left));
    const auto wanted = [&](const std::string& unit) {
      return unit == own || !fits(unit, pattern) || std::find(devices.begin(), devices.end(), unit) != devices.end();
    };
    if (pattern.find_first_of("*?") == pattern.npos || !std::all_of(units.begin(), units.end(), wanted)) continue;
    said.push_back(name(pattern));
    ++counts_[Seen::disabled_by];
    std::erase_if(left, [&](const std::string& unit) { return fits(unit, pattern); });
  }
  for (const std::string& unit : left) said.push_back(name(unit));
  return said;
}

Keys Sayer::keys(const description::DeviceDescription& device, const std::vector<std::string>& units) {
  Keys keys;
  if (!device.states.empty()) keys["states"] = device.states;
  if (device.initial) keys["initial"] = name(*device.initial);
  if (device.rest) keys["rest"] = name(*device.rest);
  if (device.actuation) keys["actuation"] = word_of(*device.actuation);
  if (device.only) keys["only"] = true;
  if (device.sequence) keys["sequence"] = sequence(*device.sequence);
  if (device.overrun) keys["overrun"] = overrun(*device.overrun);
  for (const description::GivenTransition& given : device.transitions) keys["transitions"].push_back(transition(given));
  for (const description::GivenOutputs& given : device.outputs) {
    json said = json::object();
    if (!given.enter.empty()) said["enter"] = switched(given.enter);
    if (!given.leave.empty()) said["leave"] = switched(given.leave);
    keys["outputs"][name(given.state)] = said;
  }
  for (const description::GivenDisables& given : device.disables) {
    keys["disables"][name(given.state)] = disabled(device.path, given.devices, units);
  }
  if (!device.type.empty()) keys["type"] = device.type;
  if (!device.behaviour.empty()) keys["behaviour"] = device.behaviour;
  if (!device.behaviour.empty()) ++counts_[Seen::behaviours];
  for (const auto& [input, text] : device.inputs) keys["inputs"][input] = condition(text);
  return keys;
}

json Sayer::requirement(const description::GivenRequirement& given) {
  json said = {{"name", given.name}};
  if (!given.of.empty()) said["for"] = name(given.of);
  if (!given.never.empty()) {
    said["never"] = condition(given.never);
  } else {
    said["after"] = condition(given.after);
    said["expect"] = condition(given.expect);
    if (given.earliest == 0) {
      said["within"] = time(given.within);
    } else {
      said["within"] = {{"min", time(given.earliest)}, {"max", time(given.within)}};
    }
  }
  return said;
}

std::string random_pattern(Dice& dice, const std::string& path) {
  std::string pattern = path;
  const std::size_t kind = dice.below(100);
  if (kind < 25) {
    for (std::size_t i = 1 + dice.below(3); i > 0; --i) pattern[dice.below(pattern.size())] = '?';
  } else if (kind < 55) {
    pattern = pattern.substr(0, dice.below(pattern.size())) + "*";
  } else if (kind < 80) {
    const std::size_t begin = dice.below(pattern.size());
    pattern.replace(begin, 1 + dice.below(pattern.size() - begin), dice.percent(15) ? "**" : "*");
  } else if (kind < 90) {
    pattern = "*" + pattern.substr(dice.below(pattern.size() + 1));
  } else if (kind < 95) {
    pattern = "*";
  } else {
    pattern[dice.below(pattern.size())] = '?';
    pattern = "*" + pattern;
  }
  return pattern;
}

}  // namespace symplant::property::files
