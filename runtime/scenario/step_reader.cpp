// Reads the steps of a scenario.
#include "symplant/scenario/step_reader.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "symplant/condition/resolve.hpp"
#include "symplant/scenario/value.hpp"
#include "symplant/tables/ascii.hpp"
#include "symplant/tables/duration.hpp"
#include "symplant/tables/length.hpp"
#include "symplant/tables/names.hpp"
#include "symplant/tables/nearest.hpp"
#include "symplant/trace/finding_words.hpp"

namespace symplant::scenario {
namespace {

using Json = nlohmann::json;

constexpr tables::Time kDefaultWithin = 10 * tables::kSecond;
// 100 years: far below the range of 64-bit nanoseconds, so that sums cannot overflow.
constexpr tables::Time kLatest = 876'000 * (3600 * tables::kSecond);

std::string ticked(std::string_view text) { return "`" + std::string(text) + "`"; }

std::string nearest_text(const std::string& nearest) {
  return nearest.empty() ? "" : "; did you mean " + ticked(nearest) + "?";
}

/// Marks the symbols that a unit drives or reads as commands, and all others on their addresses.
std::vector<bool> driven_symbols(const tables::PlantTables& tables) {
  std::vector<bool> moved(tables.symbols.size());
  for (std::size_t s = 0; s < moved.size(); ++s) moved[s] = tables.symbols[s].moved();
  for (int pass = 0; pass < 2; ++pass) {  // first to the leader, then from it
    for (const tables::SharedAddress& shared : tables.shared_addresses) {
      if (moved[shared.symbol] || moved[shared.leader]) moved[shared.symbol] = moved[shared.leader] = true;
    }
  }
  return moved;
}

}  // namespace

StepReader::StepReader(const trace::PlantNames& names, const std::vector<bool>& carried)
    : names_(names), carried_(carried), by_name_(names), moved_(driven_symbols(names.tables())) {}

void StepReader::add(const std::string& pointer, std::string message, bool at_key, std::size_t column) {
  faults.push_back({pointer, std::move(message), column, at_key});
}

void StepReader::begin_repeat() { repeats_.push_back(earliest_); }

void StepReader::end_repeat(std::uint32_t turns) {
  const tables::Time began = repeats_.back();
  repeats_.pop_back();
  const tables::Time each = earliest_ - began;
  const tables::Time further = kLatest / turns < each ? kLatest : each * (turns - 1);
  earliest_ = std::min(earliest_ + further, kLatest);
}

Step StepReader::read(const Json& step, const std::string& pointer) {
  Step result;
  read_when(step, pointer, result);
  const auto part = [&](const char* key, auto take) {
    if (const auto found = step.find(key); found != step.end()) take(*found, json::child(pointer, key));
  };
  part("restart", [&](const Json& value, const std::string& at) { read_restart(value, at, result); });
  part("set", [&](const Json& value, const std::string& at) { read_set(value, at, result); });
  part("state", [&](const Json& value, const std::string& at) { result.states = read_states(value, at); });
  part("put", [&](const Json& value, const std::string& at) { read_puts(value, at, result); });
  part("take", [&](const Json& value, const std::string& at) { read_takes(value, at, result); });
  part("force", [&](const Json& value, const std::string& at) { result.force = read_values(value, at, false); });
  part("release", [&](const Json& value, const std::string& at) { result.release = read_symbols(value, at); });
  part("stop", [&](const Json& value, const std::string& at) { result.stop = read_malfunctions(value, at); });
  part("start", [&](const Json& value, const std::string& at) { result.start = read_malfunctions(value, at); });
  const std::uint32_t written = names_.tables().malfunctions.size();
  result.starts_ordinary = std::any_of(result.start.begin(), result.start.end(),
                                       [written](std::uint32_t malfunction) { return malfunction >= written; });
  part("expect", [&](const Json& value, const std::string& at) { read_expect(value, at, result); });
  result.ends_instant = step.contains("instant");
  result.text = step.value("text", "");
  return result;
}

void StepReader::read_when(const Json& step, const std::string& pointer, Step& result) {
  constexpr std::array<std::pair<const char*, Step::When>, 3> kWhens{
      {{"at", Step::When::at}, {"plus", Step::When::plus}, {"wait", Step::When::wait}}};
  const char* given = nullptr;
  for (const auto& [key, when] : kWhens) {
    if (!step.contains(key)) continue;
    if (given != nullptr) {
      add(json::child(pointer, key), ticked(given) + " already sets the time of this step; remove one of them", true);
      continue;
    }
    given = key;
    result.when = when;
  }
  if (given == nullptr) {
    add(pointer, "this step has no time; add `at`, `plus` or `wait`");
  } else if (result.when == Step::When::wait) {
    read_wait(step, pointer, result);
    return;
  } else if (result.when == Step::When::at && !repeats_.empty()) {
    add(json::child(pointer, given), "`at` is not allowed in a repeat; write `plus`", true);
  } else if (const auto time = read_duration(step[given], json::child(pointer, given))) {
    result.time = *time;
    check_order(result, json::child(pointer, given));
  }
  if (step.contains("within")) {
    add(json::child(pointer, "within"), "`within` is allowed only with `wait`; remove it", true);
  }
}

void StepReader::read_wait(const Json& step, const std::string& pointer, Step& result) {
  result.time = kDefaultWithin;
  Expectation expectation;
  expectation.text = step["wait"].get<std::string>();
  expectation.condition = read_condition(expectation.text, json::child(pointer, "wait"));
  result.expect = std::move(expectation);
  if (const auto within = step.find("within"); within != step.end()) {
    result.time = read_duration(*within, json::child(pointer, "within")).value_or(kDefaultWithin);
  }
  for (const char* key :
       {"restart", "set", "state", "put", "take", "force", "release", "stop", "start", "expect", "instant"}) {
    if (!step.contains(key)) continue;
    add(json::child(pointer, key),
        ticked(key) + " is not allowed with `wait`; put it into a separate step after it, with `plus`: `0s`", true);
  }
}

void StepReader::check_order(const Step& step, const std::string& pointer) {
  if (step.when == Step::When::plus) {
    if (step.time > kLatest - earliest_) {
      add(pointer, "this is out of range, the latest time is 100 years");
      return;
    }
    if (step.time > 0) last_ = "plus";
    earliest_ += step.time;
    return;
  }
  if (step.time < earliest_) {
    add(pointer, "this time is before the " + ticked(last_) + " above, which comes at " + trace::seconds(earliest_) +
                     " or later; sort the steps by time");
    return;
  }
  earliest_ = step.time;
  last_ = "at";
}

void StepReader::read_expect(const Json& value, const std::string& pointer, Step& result) {
  if (result.when == Step::When::wait) return;  // reported already
  Expectation expectation;
  if (value.is_string()) {
    expectation.text = value.get<std::string>();
    expectation.condition = read_condition(expectation.text, pointer);
  } else {
    expectation.values = read_values(value, pointer, false);
  }
  result.expect = std::move(expectation);
}

std::optional<tables::Time> StepReader::read_duration(const Json& value, const std::string& pointer) {
  const auto& text = value.get_ref<const std::string&>();
  const auto time = tables::parse_duration(text);
  if (!time) {
    add(pointer, ticked(text) + " is not a duration; write a number and ns, us, ms, s, min or h, as in `1.5s`");
  } else if (*time > kLatest) {
    add(pointer, ticked(text) + " is out of range, the latest time is 100 years");
    return std::nullopt;
  }
  return time;
}

std::optional<condition::Tree> StepReader::read_condition(const std::string& text, const std::string& pointer) {
  auto read = condition::parse_and_resolve(text, by_name_);
  if (auto* tree = std::get_if<condition::Tree>(&read)) return std::move(*tree);
  auto& fault = std::get<condition::Fault>(read);
  add(pointer, std::move(fault.message), false, fault.index.offset);
  return std::nullopt;
}

std::optional<std::uint32_t> StepReader::symbol(const std::string& name, const std::string& pointer, bool at_key) {
  if (const auto found = by_name_.symbol(name)) return found->index;
  if (by_name_.unit(name, {})) {
    add(pointer, ticked(name) + " is a device; name one of its symbols, or set the state of the device with `state`",
        at_key);
  } else {
    add(pointer, "symbol " + ticked(name) + " not found" + nearest_text(by_name_.nearest_symbol(name)), at_key);
  }
  return std::nullopt;
}

/// Why a scenario cannot set a symbol; empty if it can.
std::string StepReader::why_not_set(std::uint32_t symbol) const {
  const std::string name = ticked(names_.symbol(symbol));
  if (names_.is_operation(symbol)) {
    if (symbol >= carried_.size() || !carried_[symbol]) return {};
    const auto programs = names_.programs();
    const auto program = std::find_if(programs.begin(), programs.end(),
                                      [&](const trace::PlantNames::Program& one) { return one.written[symbol]; });
    if (program != programs.end())
      return "program " + ticked(program->name) + " writes " + name + "; use `force` instead";
    return "the PLC writes " + name + " through the link; use `force` instead";
  }
  if (!moved_[symbol]) return {};
  const std::uint32_t unit = names_.tables().symbols[symbol].unit;
  for (const tables::FollowRow& row : names_.tables().follows) {
    if (row.symbol == symbol) return name + " follows a condition; use `force`";
  }
  for (const tables::SignalRow& row : names_.tables().values.signals) {
    if (row.symbol == symbol) return name + " shows a formula (`signals`); set what it reads, or use `force`";
  }
  for (const tables::SensorRow& row : names_.tables().material.sensors) {
    if (row.symbol != symbol) continue;
    return name + " is a sensor of parts at " + ticked(names_.location(row.location)) +
           "; put a part there with `put`, or use `force`";
  }
  return name + " is driven by " +
         (unit == tables::kNone ? "the device on its address" : "the device " + ticked(names_.unit(unit))) +
         "; set that device with `state`, or the symbol with `force`";
}

std::vector<SymbolValue> StepReader::read_values(const Json& object, const std::string& pointer, bool setting) {
  std::vector<SymbolValue> values;
  for (const auto& [name, value] : object.items()) {
    const std::string here = json::child(pointer, name);
    const auto found = symbol(name, here, true);
    if (!found) continue;
    if (const std::string why = setting ? why_not_set(*found) : ""; !why.empty()) add(here, why, true);
    for (const SymbolValue& other : values) {
      if (other.symbol == *found) add(here, ticked(name) + " is repeated in another letter case; remove one", true);
    }
    auto read = read_value(names_.tables().symbols[*found].type(), value);
    if (auto* message = std::get_if<std::string>(&read)) {
      add(here, std::move(*message));
    } else {
      values.push_back({*found, std::get<std::uint64_t>(read)});
    }
  }
  return values;
}

/// Symbols, and values by their names.
void StepReader::read_set(const Json& object, const std::string& pointer, Step& result) {
  Json symbols = Json::object();
  for (const auto& [name, number] : object.items()) {
    const auto value = by_name_.value_index(name);
    if (!value) {
      symbols[name] = number;
      continue;
    }
    const std::string here = json::child(pointer, name);
    if (!tables::keeps_its_output(names_.tables().values.rows[*value].kind)) {
      add(here, ticked(name) + " is computed from others and cannot be set; set what it reads", true);
    } else if (!number.is_number()) {
      add(here, ticked(name) + " is a value; write a number");
    } else {
      result.set_values.push_back({*value, number.get<double>()});
    }
  }
  result.set = read_values(symbols, pointer, true);
}

void StepReader::read_puts(const Json& value, const std::string& pointer, Step& result) {
  if (value.is_object()) {
    read_put(value, pointer, result);
    return;
  }
  for (std::size_t i = 0; i < value.size(); ++i) read_put(value[i], json::child(pointer, i), result);
}

void StepReader::read_put(const Json& value, const std::string& pointer, Step& result) {
  const auto at = read_location(value["at"], json::child(pointer, "at"));
  const auto& name = value["kind"].get_ref<const std::string&>();
  const auto kind = by_name_.part_kind(name);
  if (!kind) {
    add(json::child(pointer, "kind"),
        "kind of part " + ticked(name) + " not found" + nearest_text(by_name_.nearest_part_kind(name)));
  }
  if (at && kind) result.put.push_back({*at, *kind});
}

void StepReader::read_takes(const Json& value, const std::string& pointer, Step& result) {
  const auto take = [&](const Json& text, const std::string& here) {
    if (const auto at = read_location(text, here)) result.take.push_back(*at);
  };
  if (value.is_string()) {
    take(value, pointer);
    return;
  }
  for (std::size_t i = 0; i < value.size(); ++i) take(value[i], json::child(pointer, i));
}

std::optional<tables::PartLocation> StepReader::read_location(const Json& value, const std::string& pointer) {
  const tables::LocationText text = tables::split_location(value.get_ref<const std::string&>());
  const tables::MaterialTables& material = names_.tables().material;
  const auto location = by_name_.location(text.name);
  if (!location) {
    add(pointer, material.empty() ? "this plant has no tracks and places of parts"
                                  : "track or place " + ticked(text.name) + " not found" +
                                        nearest_text(by_name_.nearest_location(text.name)));
    return std::nullopt;
  }
  tables::PartLocation at{*location, tables::kWhole};
  if (!text.has_position) return at;
  const auto position = tables::parse_length(text.position);
  if (!material.is_track(*location)) {
    add(pointer, ticked(text.name) + " is a place and has no positions; remove `@` and what follows");
  } else if (!position) {
    add(pointer, ticked(text.position) + " is not a length; write a number and um, mm, cm or m, as in `300 mm`");
  } else if (*position > material.tracks[*location].length) {
    add(pointer, "this is beyond the end of track " + ticked(text.name));
  } else {
    at.at = *position;
    return at;
  }
  return std::nullopt;
}

std::vector<UnitState> StepReader::read_states(const Json& object, const std::string& pointer) {
  std::vector<UnitState> states;
  for (const auto& [name, value] : object.items()) {
    const std::string here = json::child(pointer, name);
    const auto unit = by_name_.unit(name, {});
    if (!unit) {
      const bool is_symbol = by_name_.symbol(name).has_value();
      add(here,
          is_symbol ? ticked(name) + " is a symbol and has no states; use `set` or `force`"
                    : "device " + ticked(name) + " not found" + nearest_text(by_name_.nearest_device(name, {})),
          true);
      continue;
    }
    const auto& wanted = value.get_ref<const std::string&>();
    if (const auto state = by_name_.state(*unit, wanted)) {
      states.push_back({*unit, *state});
      continue;
    }
    std::string why = by_name_.why_no_state(*unit, wanted);
    if (why.empty()) {
      why = "state " + ticked(wanted) + " of " + ticked(name) + " not found" +
            nearest_text(by_name_.nearest_state(*unit, wanted));
    }
    add(here, std::move(why));
  }
  return states;
}

void StepReader::read_restart(const Json& value, const std::string& pointer, Step& result) {
  const auto controllers = tables::split_names(names_.tables().controller_names);
  std::uint32_t controller = 0;
  if (value.is_string()) {
    const auto& name = value.get_ref<const std::string&>();
    while (controller < controllers.size() && !tables::equal_ignoring_case(controllers[controller], name)) ++controller;
    if (controller == controllers.size()) {
      tables::NearestName nearest(name);
      for (const std::string_view known : controllers) nearest.offer(known);
      return add(pointer, "controller " + ticked(name) + " not found" + nearest_text(std::string(nearest.name())));
    }
  } else if (controllers.size() > 1) {
    return add(pointer, "the plant has several controllers; name one, such as " + ticked(controllers.front()));
  }
  for (const trace::PlantNames::Program& program : names_.programs()) {
    if (program.controller == controller) return result.restart.push_back(controller);
  }
  add(pointer, "no program of this controller runs; give one with `--program`, or remove `restart`");
}

std::vector<std::uint32_t> StepReader::read_malfunctions(const Json& value, const std::string& pointer) {
  std::vector<std::uint32_t> malfunctions;
  const auto read = [&](const Json& text, const std::string& here) {
    const auto& name = text.get_ref<const std::string&>();
    if (const auto found = by_name_.malfunction(name)) {
      malfunctions.push_back(*found);
    } else {
      add(here, "malfunction " + ticked(name) + " not found" + nearest_text(by_name_.nearest_malfunction(name)));
    }
  };
  if (value.is_string()) {
    read(value, pointer);
    return malfunctions;
  }
  for (std::size_t i = 0; i < value.size(); ++i) read(value[i], json::child(pointer, i));
  return malfunctions;
}

std::vector<std::uint32_t> StepReader::read_symbols(const Json& array, const std::string& pointer) {
  std::vector<std::uint32_t> symbols;
  for (std::size_t i = 0; i < array.size(); ++i) {
    const auto found = symbol(array[i].get_ref<const std::string&>(), json::child(pointer, i), false);
    if (found) symbols.push_back(*found);
  }
  return symbols;
}

}  // namespace symplant::scenario
