// Anomalies as JSON lines, as JUnit XML, and as counts.
#include "watch/report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "symplant/trace/junit_xml.hpp"
#include "symplant/trace/value_text.hpp"
#include "watch/words.hpp"

namespace symplant::watch {
namespace {

using trace::json_string;

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

/// `,"from":"OPEN"`; empty if there is no state.
std::string state_member(const model::Unit& unit, const char* key, std::uint32_t state) {
  return state == kNone ? "" : fmt::format(R"(,"{}":{})", key, json_string(unit.states[state].name));
}

std::string time_member(const char* key, Time time) {
  return time == kUnknown ? "" : fmt::format(R"(,"{}":{})", key, time);
}

std::string symbols_json(const model::PlantModel& plant, const std::vector<std::uint32_t>& symbols) {
  std::string text;
  for (const std::uint32_t index : symbols) {
    const model::Symbol& symbol = plant.symbols[index];
    text += fmt::format(R"({}{{"symbol":{},"address":{},"list":{},"row":{}}})", text.empty() ? "" : ",",
                        json_string(symbol.name()), json_string(symbol.written_address()),
                        json_string(plant.list_of(symbol).name()), symbol.row->line);
  }
  return text;
}

std::string unit_members(const model::PlantModel& plant, const Anomaly& anomaly) {
  const model::Unit& unit = plant.units[anomaly.unit];
  const observe::Move& move = anomaly.move;
  std::string text = state_member(unit, "from", move.from) + state_member(unit, "to", move.to) +
                     time_member("cause", move.cause) + time_member("left", move.left) +
                     time_member("arrived", move.arrived);
  using Kind = Anomaly::Kind;
  const bool is_timed = anomaly.kind == Kind::late || anomaly.kind == Kind::early || anomaly.kind == Kind::missing;
  if (is_timed || anomaly.kind == Kind::drift) {
    text += fmt::format(R"(,"part":"{}","took":{},"min":{},"max":{},"margin":{})",
                        anomaly.part == Anomaly::Part::leaving ? "leaving" : "arriving", anomaly.took,
                        anomaly.allowed.least, anomaly.allowed.most, anomaly.margin);
  }
  if (anomaly.kind == Kind::drift) {
    text += fmt::format(R"(,"learned":{},"moves":{})", anomaly.learned, anomaly.learned_moves);
  }
  if (anomaly.failed > 1) text += fmt::format(R"(,"failed":{})", anomaly.failed);
  if (!anomaly.on.empty()) text += fmt::format(R"(,"on":[{}])", symbols_json(plant, anomaly.on));
  return text + fmt::format(R"(,"symbols":[{}])", symbols_json(plant, anomaly.symbols));
}

}  // namespace

std::string json_line(const model::PlantModel& plant, const Anomaly& anomaly, Time resolution) {
  std::string line = fmt::format(R"({{"t":{},"finding":"{}","of":{},"number":{})", anomaly.time,
                                 kind_name(anomaly.kind), json_string(name_of(plant, anomaly)), anomaly.number);
  if (!anomaly.is_first()) line += fmt::format(R"(,"follows":{})", anomaly.follows);
  line += anomaly.unit == kNone ? fmt::format(R"(,"length":{})", anomaly.took) : unit_members(plant, anomaly);
  return line +
         fmt::format(R"(,"resolution":{},"words":{}}})", resolution, json_string(words(plant, anomaly, resolution)));
}

std::string not_watched(const model::PlantModel& plant, const std::vector<bool>& recorded) {
  std::size_t dark = 0;
  std::size_t custom = 0;
  for (const model::Unit& unit : plant.units) {
    const bool shown =
        std::any_of(unit.events.begin(), unit.events.end(), [&](std::uint32_t event) { return recorded[event]; });
    if (unit.moves() && !shown) ++dark;
    if (shown && unit.has_behaviour()) ++custom;
  }
  std::vector<std::string> parts;
  if (dark != 0) parts.push_back(counted(dark, "device", "devices") + " that no recorded event shows");
  if (custom != 0) parts.push_back("the times of " + counted(custom, "device", "devices") + " with custom behavior");
  if (!plant.material.empty()) parts.emplace_back("parts and their sensors");
  if (!plant.follows.empty()) parts.emplace_back("inputs that follow a condition");
  if (!plant.signals.empty()) parts.emplace_back("numeric inputs");
  return fmt::format("{}", fmt::join(parts, "; "));
}

void Tally::add(const model::PlantModel& plant, const Anomaly& anomaly, Time resolution) {
  Of& of = units_[anomaly.unit];
  if (of.all == 0) of.first = anomaly.time;
  ++of.counts[static_cast<std::size_t>(anomaly.kind)];
  ++(anomaly.is_first() ? firsts_ : following_);
  if (++of.all > kMostTexts) return;
  of.texts += fmt::format("{}{}: {}", of.texts.empty() ? "" : "\n", kind_name(anomaly.kind),
                          sentence(plant, anomaly, resolution));
}

std::size_t Tally::count(std::uint32_t unit, Anomaly::Kind kind) const {
  const auto found = units_.find(unit);
  return found == units_.end() ? 0 : found->second.counts[static_cast<std::size_t>(kind)];
}

std::string Tally::counts_words(const Of& of) const {
  std::string text;
  for (std::size_t kind = 0; kind < of.counts.size(); ++kind) {
    if (of.counts[kind] == 0) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", of.counts[kind], kKindNames[kind]);
  }
  return text;
}

std::vector<std::string> Tally::rows(const model::PlantModel& plant, Time resolution) const {
  std::vector<std::pair<std::uint32_t, const Of*>> sorted;
  for (const auto& [unit, of] : units_) sorted.emplace_back(unit, &of);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.second->all > b.second->all; });
  std::vector<std::string> rows;
  std::size_t width = 0;
  Anomaly named;
  const auto name = [&](std::uint32_t unit) {
    named.unit = unit;
    return name_of(plant, named);
  };
  rows.reserve(sorted.size());
  for (const auto& [unit, of] : sorted) width = std::max(width, name(unit).size());
  for (const auto& [unit, of] : sorted) {
    rows.push_back(
        fmt::format("{:{}}  {}, first at {}", name(unit), width, counts_words(*of), seconds(of->first, resolution)));
  }
  return rows;
}

std::string Tally::summary(const Counts& counts) const {
  const auto moved = std::count_if(counts.of_unit.begin(), counts.of_unit.end(), [](std::size_t n) { return n != 0; });
  std::size_t moves = 0;
  for (const std::size_t of_unit : counts.of_unit) moves += of_unit;
  const std::string all = fmt::format("in {} of {}", counted(moves, "move", "moves"),
                                      counted(static_cast<std::size_t>(moved), "device", "devices"));
  if (firsts_ + following_ == 0) return "no anomaly " + all;
  const std::size_t devices = units_.size() - units_.count(kNone);
  std::string text = counted(firsts_, "anomaly", "anomalies");
  if (devices != 0) text += " of " + counted(devices, "device", "devices");
  if (following_ != 0) text += fmt::format(" ({} more follow{} from them)", following_, following_ == 1 ? "s" : "");
  return text + ", " + all;
}

std::string Tally::junit(const model::PlantModel& plant, const Counts& counts, Time end) const {
  std::vector<trace::TestCase> cases;
  const auto add = [&](std::string name, std::uint32_t unit) {
    const auto found = units_.find(unit);
    trace::TestCase test{std::move(name), end, {}, {}};
    if (found != units_.end()) {
      test.failure = found->second.texts;
      const std::size_t more = found->second.all - std::min(found->second.all, kMostTexts);
      if (more != 0) test.failure += fmt::format("\nand {} more", more);
    }
    cases.push_back(std::move(test));
  };
  add("readings", kNone);
  for (std::uint32_t u = 0; u < plant.units.size(); ++u) {
    if (counts.of_unit[u] != 0 || units_.count(u) != 0) add(std::string(plant.units[u].path), u);
  }
  return trace::junit_xml("symplant watch " + plant.name, cases, end);
}

}  // namespace symplant::watch
