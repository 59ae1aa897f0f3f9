// Reads traces as JSON lines, as symplant writes them.
#include "recording/read_json_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "symplant/trace/trace_lines.hpp"

namespace symplant::recording {
namespace {

using Json = nlohmann::json;

/// A number, or one as text: `nan`, and whole numbers that JSON readers would round.
std::optional<double> number_of(const Json& value) {
  if (value.is_boolean()) return value.get<bool>() ? 1 : 0;
  if (value.is_number()) return value.get<double>();
  if (!value.is_string()) return std::nullopt;
  const auto& text = value.get_ref<const std::string&>();
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && at == end ? std::optional(number) : std::nullopt;
}

class Reader {
 public:
  Reader(std::istream& file, const std::string& name) : lines_(file) { read_.recording.name = name; }

  ReadRecording run() {
    std::string wrong;
    Json json;
    while (wrong.empty() && lines_.next(json)) wrong = take(json);
    if (wrong.empty()) wrong = lines_.error();
    if (!wrong.empty()) read_.error = at_line(wrong);
    put_operations_first();
    if (lines_.cut_off()) read_.warnings.push_back(at_line("the last line is cut off, and is left out"));
    return std::move(read_);
  }

 private:
  std::string at_line(std::string_view text) const {
    return fmt::format("{}:{}: {}", read_.recording.name, lines_.number(), text);
  }

  std::string take(const Json& json) {
    if (lines_.is_header()) return header(json);
    if (lines_.is_set_back()) set_back();
    if (lines_.time() > kLatestTime)
      return fmt::format("the time {} is out of range: at most {} ns", lines_.time(), kLatestTime);
    read_.recording.end = std::max(read_.recording.end, lines_.time());
    if (lines_.is_set_back()) return values(json);
    if (json.contains("symbol")) return symbol(json);
    return json.contains("part") ? part(json) : std::string();
  }

  std::string header(const Json& json) {
    if (json.contains("part")) {
      return "this is a later part of a trace: record it without `--trace-limit`, so that it has its beginning";
    }
    Recording& recording = read_.recording;
    recording.of_plant = json.value("recorded", Json()) != true;
    for (const char* const key : {"every", "cycle", "end"}) {
      const auto found = json.find(key);
      if (found == json.end()) continue;
      if (!found->is_number_unsigned() || found->get<std::uint64_t>() > kLatestTime) {
        return fmt::format("the key `{}` is no time in ns up to {}", key, kLatestTime);
      }
      (key == std::string_view("end") ? recording.end : recording.resolution) = found->get<tables::Time>();
    }
    const auto programs = json.find("programs");
    if (programs == json.end()) return "";
    for (const Json& program : *programs) {
      const auto writes = program.is_object() ? program.find("writes") : program.end();
      if (!program.is_object() || writes == program.end() || !writes->is_array()) {
        return "an entry of `programs` is no object with an array `writes`";
      }
      for (const Json& symbol : *writes) {
        if (symbol.is_string()) written_.insert(symbol.get<std::string>());
      }
    }
    return "";
  }

  /// What was before the plant was reset or restored does not count.
  void set_back() {
    Recording& recording = read_.recording;
    if (!recording.order.empty()) {
      read_.warnings.push_back(at_line("the plant was set back here: only what follows counts"));
    }
    recording.series.clear();
    recording.index.clear();
    recording.order.clear();
    recording.has_parts = false;
    times_.clear();
  }

  std::string values(const Json& json) {
    const auto found = json.find("values");
    if (found == json.end() || !found->is_object()) return "";
    for (const auto& [name, value] : found->items()) {
      if (std::string wrong = change(name, value); !wrong.empty()) return wrong;
    }
    return "";
  }

  std::string symbol(const Json& json) {
    if (!json["symbol"].is_string() || !json.contains("value")) return "a change has `symbol` and `value`";
    return change(json["symbol"].get_ref<const std::string&>(), json["value"]);
  }

  std::string change(const std::string& name, const Json& value) {
    const auto number = number_of(value);
    if (!number) return fmt::format("`{}` cannot have the value {}", name, value.dump());
    const auto kind = value.is_boolean() ? Series::Kind::boolean : Series::Kind::number;
    Series& series = series_of({name, kind, {}, {}, {}});
    if (series.kind != kind) return fmt::format("`{}` is a BOOL and a number", name);
    add(series, *number);
    return "";
  }

  std::string part(const Json& json) {
    read_.recording.has_parts = true;
    const auto kind = json.find("kind");
    if (kind == json.end() || !kind->is_string()) return "a part has a `kind`";
    const auto to = json.find("to");
    if (to == json.end() || !to->is_string()) return "";
    add(series_of({to->get<std::string>(), Series::Kind::parts, kind->get<std::string>(), {}, {}}), 1);
    return "";
  }

  Series& series_of(Series wanted) {
    Recording& recording = read_.recording;
    const auto [found, added] = recording.index.emplace(wanted.key(), recording.series.size());
    if (added) {
      wanted.is_operation = wanted.name.find("_O_") != wanted.name.npos || written_.contains(wanted.name);
      recording.series.push_back(std::move(wanted));
    }
    return recording.series[found->second];
  }

  void add(Series& series, double value) {
    series.changes.push_back({lines_.time(), value});
    read_.recording.order.push_back(static_cast<std::uint32_t>(&series - read_.recording.series.data()));
    if (times_.empty() || times_.back().first != lines_.time()) {
      times_.push_back({lines_.time(), read_.recording.order.size() - 1});
    }
  }

  void put_operations_first() {
    std::vector<std::uint32_t>& order = read_.recording.order;
    for (std::size_t i = 0; i < times_.size(); ++i) {
      const auto begin = order.begin() + static_cast<std::ptrdiff_t>(times_[i].second);
      const auto end =
          i + 1 < times_.size() ? order.begin() + static_cast<std::ptrdiff_t>(times_[i + 1].second) : order.end();
      std::stable_partition(begin, end, [&](std::uint32_t s) { return read_.recording.series[s].is_operation; });
    }
  }

  trace::TraceLines lines_;
  ReadRecording read_;
  std::unordered_set<std::string> written_;                  ///< by programs
  std::vector<std::pair<tables::Time, std::size_t>> times_;  ///< each, with its first change in the order
};

}  // namespace

ReadRecording read_json_lines(std::istream& file, const std::string& name, const ReadOptions&) {
  return Reader(file, name).run();
}

}  // namespace symplant::recording
