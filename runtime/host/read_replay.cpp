// Reads from a trace what a replay needs.
#include "symplant/host/read_replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "symplant/host/words.hpp"
#include "symplant/json/location.hpp"
#include "symplant/scenario/read_scenario.hpp"
#include "symplant/scenario/table_names.hpp"
#include "symplant/scenario/value.hpp"
#include "symplant/trace/trace_lines.hpp"

namespace symplant::host {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostFaults = 20;
constexpr std::array<std::string_view, 9> kActKeys{"set",     "state", "put",   "take",   "force",
                                                   "release", "stop",  "start", "restart"};
/// What a person did with alarms does not touch the plant.
constexpr std::array<std::string_view, 4> kAlarmKeys{"acknowledge", "shelve", "unshelve", "silence"};

/// The act of a line as the line has it.
std::string act_text(const std::string& line, const Json& act) {
  constexpr std::string_view kKey = "\"act\":";
  const std::size_t begin = line.find(kKey);
  const std::size_t end = line.rfind(",\"by\":");
  if (begin != line.npos && end != line.npos && begin < end) {
    std::string text = line.substr(begin + kKey.size(), end - begin - kKey.size());
    if (Json::parse(text, nullptr, false) == act) return text;
  }
  return act.dump();
}

constexpr std::string_view kZero = "\":-0";

/// JSON reads the value `-0` as a whole number, without the sign: it becomes `-0.0`.
std::string with_signed_zeros(std::string json) {
  for (std::size_t at = 0; (at = json.find(kZero, at)) != json.npos; at += kZero.size()) {
    const std::size_t end = at + kZero.size();
    if (end < json.size() && (json[end] == ',' || json[end] == '}')) json.insert(end, ".0");
  }
  return json;
}

/// The act without the restart of programs: a replay has none, and what they write is in the trace.
std::string without_restart(const std::string& act) {
  if (act.find("\"restart\"") == act.npos) return act;
  Json json = Json::parse(act);
  json.erase("restart");
  return json.dump();
}

class ReplayReader {
 public:
  ReplayReader(const std::string& path, const trace::PlantNames& names, std::ostream& err)
      : path_(path), names_(names), by_name_(names), err_(err) {
    for (std::uint32_t i = 0; i < names.tables().symbols.size(); ++i) symbols_.emplace(names.symbol(i), i);
  }

  std::optional<Replay> run(std::istream& file) {
    trace::TraceLines lines(file);
    std::string wrong;
    Json json;
    while (wrong.empty() && errors_ < kMostFaults && lines.next(json)) {
      number_ = lines.number();
      if (lines.text().find(kZero) != std::string::npos) json = Json::parse(with_signed_zeros(lines.text()));
      wrong = lines.is_header() ? header(json) : body(json, lines);
    }
    if (wrong.empty()) wrong = lines.error();
    if (!wrong.empty()) fail(lines.number(), wrong);
    if (lines.cut_off()) {
      err_ << fmt::format("{}:{}: warning: the last line is cut off, and is left out\n", shown(path_), lines.number());
    }
    if (wrong.empty()) read_acts();
    if (errors_ != 0) return std::nullopt;
    return std::move(replay_);
  }

 private:
  void fail(const std::string& message) { fail(number_, message); }
  void fail(std::size_t line, const std::string& message) {
    ++errors_;
    err_ << fmt::format("{}:{}: error: {}\n", shown(path_), line, shown(message));
  }

  std::string header(const Json& json) {
    if (json.contains("part")) {
      return "this is a later part of a trace, and a replay needs its beginning: record it without `--trace-limit`";
    }
    if (!json.contains("clock")) {
      return "this trace has no `clock`: an older symplant wrote it, without what a replay needs; record it again";
    }
    if (json.contains("recorded")) {
      return "this is a recording of a real plant: it has only what the PLC shows, and cannot be replayed";
    }
    const auto seed = json.find("seed");
    const auto hash = json.find("model_hash");
    if (seed == json.end() || !seed->is_number_unsigned() || hash == json.end() || !hash->is_string()) {
      return "the header has no `seed` or no `model_hash`";
    }
    replay_.seed = seed->get<std::uint64_t>();
    replay_.model_hash = hash->get<std::string>();
    return "";
  }

  std::string body(const Json& json, const trace::TraceLines& lines) {
    if (json.contains("reset")) return "the plant was reset by hand here: such a trace cannot be replayed";
    if (json.contains("restored")) return "the plant was set to a saved state here: such a trace cannot be replayed";
    if (json.contains("lost")) return "changes are missing in this trace: it cannot be replayed";
    if (lines.time() > replay_.end) instant_ = 1;
    replay_.end = lines.time();
    if (const auto instant = json.find("instant"); instant != json.end()) {
      if (!instant->is_number_unsigned() || instant->get<std::uint64_t>() <= instant_) {
        return "the key `instant` is not a number above that of the lines before";
      }
      instant_ = instant->get<std::uint64_t>();
    }
    if (json.contains("symbol")) return change(json);
    if (json.contains("act")) return act(json, lines.text());
    return json.contains("quality") ? quality(json["quality"]) : "";
  }

  void add(std::uint32_t of, std::uint64_t value, Replay::Deed::Kind kind) {
    replay_.deeds.push_back({replay_.end, instant_, value, of, kind});
  }

  std::string change(const Json& json) {
    if (!json["symbol"].is_string() || !json.contains("value")) return "a change has `symbol` and `value`";
    const auto& name = json["symbol"].get_ref<const std::string&>();
    const auto found = symbols_.find(name);
    if (found == symbols_.end()) {
      unknown(name);
      return "";
    }
    const tables::SymbolRow& row = names_.tables().symbols[found->second];
    if (row.direction() != tables::Direction::operation) return "";
    const auto value = scenario::read_value(row.type(), json["value"]);
    if (const auto* wrong = std::get_if<std::string>(&value)) return fmt::format("`{}`: {}", name, *wrong);
    add(found->second, std::get<std::uint64_t>(value), Replay::Deed::Kind::operation);
    return "";
  }

  /// Each name once.
  void unknown(const std::string& name) {
    if (!unknown_.insert(name).second) return;
    const std::string nearest = by_name_.nearest_symbol(name);
    fail(fmt::format("symbol `{}` not found{}", name, nearest.empty() ? "" : "; did you mean `" + nearest + "`?"));
  }

  std::string act(const Json& json, const std::string& line) {
    const Json& act = json["act"];
    const Json by = json.value("by", Json());
    if (!act.is_object()) return "`act` is not an object";
    if (by != "hand" && by != "scenario") return "an act has `by`: `hand` or `scenario`";
    const auto is_in = [&](std::string_view key) { return act.contains(key); };
    if (std::any_of(kAlarmKeys.begin(), kAlarmKeys.end(), is_in)) return "";
    for (const auto& [key, value] : act.items()) {
      if (std::find(kActKeys.begin(), kActKeys.end(), key) == kActKeys.end()) {
        return fmt::format("this symplant cannot replay the act `{}`", key);
      }
    }
    add(static_cast<std::uint32_t>(replay_.texts.size()), 0, Replay::Deed::Kind::act);
    replay_.texts.push_back(act_text(line, act));
    replay_.by_hand.push_back(by == "hand");
    lines_.push_back(number_);
    return "";
  }

  std::string quality(const Json& quality) {
    if (!quality.is_object()) return "`quality` is not an object";
    const auto& units = names_.tables().behaviour_units;
    for (const auto& member : quality.items()) {
      const std::string& name = member.key();
      const Json& well = member.value();
      const auto found =
          std::find_if(units.begin(), units.end(), [&](const auto& unit) { return names_.unit(unit.unit) == name; });
      if (found == units.end() || !well.is_boolean()) {
        return fmt::format("the plant has no device `{}` with a behavior", name);
      }
      add(static_cast<std::uint32_t>(found - units.begin()), well.get<bool>() ? 1 : 0, Replay::Deed::Kind::quality);
    }
    return "";
  }

  /// All acts as one scenario, an act on each line, so that they are checked as those of a scenario are.
  void read_acts() {
    if (replay_.texts.empty()) return;
    std::string text = "{\"symplant-scenario\":1,\"steps\":[";
    for (const std::string& act : replay_.texts) {
      const std::string done = with_signed_zeros(without_restart(act));
      const std::size_t open = done.find('{');
      const bool none = done.find('"') == done.npos;
      text +=
          fmt::format("{}{{\"at\":\"0s\"{}{}\n", text.back() == '[' ? "" : ",", none ? "" : ",", done.substr(open + 1));
    }
    text += "]}";
    scenario::ReadScenario read = scenario::read_scenario(text, names_, {});
    for (const scenario::FileFaults& found : read.faults) {
      for (const json::Placed& fault : found.faults) {
        const std::size_t line = json::line_and_column(text, fault.span.begin).line;
        if (errors_ < kMostFaults) fail(lines_[std::min(line, lines_.size()) - 1], fault.message);
      }
    }
    if (read.scenario) replay_.acts = std::move(*read.scenario);
  }

  const std::string& path_;
  const trace::PlantNames& names_;
  const scenario::TableNames by_name_;
  std::ostream& err_;
  std::unordered_map<std::string_view, std::uint32_t> symbols_;
  std::set<std::string> unknown_;
  std::vector<std::size_t> lines_;  ///< of the acts
  Replay replay_;
  std::uint64_t instant_ = 1;
  std::size_t number_ = 0;
  std::size_t errors_ = 0;
};

}  // namespace

std::optional<Replay> load_replay(const std::string& path, const trace::PlantNames& names, std::ostream& err) {
  std::error_code unknown;
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path, unknown)) {
    err << fmt::format("error: cannot read the trace `{}`: {}\n", path,
                       file ? "it is a directory" : std::strerror(errno));
    return std::nullopt;
  }
  return ReplayReader(path, names, err).run(file);
}

std::string replay_summary(const std::string& path, const Replay& replay) {
  const auto operations = std::count_if(replay.deeds.begin(), replay.deeds.end(), [](const Replay::Deed& deed) {
    return deed.kind == Replay::Deed::Kind::operation;
  });
  return fmt::format("replay {}: {}, {}\n", shown(path),
                     plural(static_cast<std::size_t>(operations), "change") +
                         (operations == 1 ? " of an operation" : " of operations"),
                     plural(replay.texts.size(), "act"));
}

}  // namespace symplant::host
