// Reads traces as JSON lines, as symplant writes them.
#include "recording/read_json_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <utility>

#include "recording/collector.hpp"
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
    std::optional<trace::PlainChange> plain;
    while (wrong.empty() && lines_.next(json, plain)) wrong = plain ? take(*plain) : take(json);
    if (wrong.empty()) wrong = lines_.error();
    if (!wrong.empty()) read_.error = at_line(wrong);
    changes_.finish();
    if (lines_.cut_off()) read_.warnings.push_back(at_line("the last line is cut off, and is left out"));
    return std::move(read_);
  }

 private:
  std::string at_line(std::string_view text) const {
    return fmt::format("{}:{}: {}", read_.recording.name, lines_.number(), text);
  }

  std::string take_time() {
    if (lines_.time() > kLatestTime) {
      return fmt::format("the time {} is out of range: at most {} ns", lines_.time(), kLatestTime);
    }
    read_.recording.end = std::max(read_.recording.end, lines_.time());
    return "";
  }

  std::string take(const trace::PlainChange& plain) {
    std::string wrong = take_time();
    return wrong.empty() ? change(plain.symbol, plain.is_boolean, plain.value) : wrong;
  }

  std::string take(const Json& json) {
    if (lines_.is_header()) return header(json);
    if (lines_.is_set_back()) set_back();
    if (std::string wrong = take_time(); !wrong.empty()) return wrong;
    if (lines_.is_set_back()) return values(json);
    if (json.contains("every")) return slower(json["every"]);
    if (json.contains("symbol")) return symbol(json);
    if (json.contains("gap")) return gap(json);
    return json.contains("part") ? part(json) : std::string();
  }

  static std::string text_of(const Json& json, const char* key) {
    const auto found = json.find(key);
    return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
  }

  std::string header(const Json& json) {
    const bool is_recorded = json.value("recorded", Json()) == true;
    const bool is_part = json.contains("part");
    if (is_part && !is_recorded) {
      return "this is a later part of a trace: record it without `--trace-limit`, so that it has its beginning";
    }
    Recording& recording = read_.recording;
    recording.of_plant = !is_recorded;
    is_begun_ = is_begun_ || !is_part;
    recording.plant = text_of(json, "plant");
    recording.model_hash = text_of(json, "model_hash");
    for (const char* const key : {"every", "cycle", "end"}) {
      const auto found = json.find(key);
      if (found == json.end()) continue;
      if (!found->is_number_unsigned() || found->get<std::uint64_t>() > kLatestTime) {
        return fmt::format("the key `{}` is not a time in ns up to {}", key, kLatestTime);
      }
      (key == std::string_view("end") ? recording.end : recording.resolution) = found->get<tables::Time>();
    }
    if (std::string wrong = take_programs(json); !wrong.empty()) return wrong;
    return is_part ? part_of_recording(json) : std::string();
  }

  /// A later part of a recording has what all symbols are at its time.
  std::string part_of_recording(const Json& json) {
    Recording& recording = read_.recording;
    const auto number = json["part"].is_number_unsigned() ? json["part"].get<std::uint64_t>() : 0;
    if (is_begun_ && number != part_ + 1 && lines_.time() > recording.end) {  // a part is missing before it
      recording.gaps.push_back({recording.end, lines_.time() - recording.end});
    }
    part_ = number;
    is_begun_ = true;
    if (std::string wrong = take_time(); !wrong.empty()) return wrong;
    return values(json);
  }

  std::string take_programs(const Json& json) {
    const auto programs = json.find("programs");
    if (programs == json.end()) return "";
    for (const Json& program : *programs) {
      const auto writes = program.is_object() ? program.find("writes") : program.end();
      if (!program.is_object() || writes == program.end() || !writes->is_array()) {
        return "an entry of `programs` is not an object with an array `writes`";
      }
      for (const Json& symbol : *writes) {
        if (symbol.is_string()) changes_.add_written(symbol.get<std::string>());
      }
    }
    return "";
  }

  /// The PLC was slower than the header says.
  std::string slower(const Json& every) {
    if (!every.is_number_unsigned() || every.get<std::uint64_t>() > kLatestTime) {
      return fmt::format("the key `every` is not a time in ns up to {}", kLatestTime);
    }
    read_.recording.resolution = std::max(read_.recording.resolution, every.get<tables::Time>());
    return "";
  }

  /// What was before the plant was reset or restored does not count.
  void set_back() {
    if (!read_.recording.order.empty()) {
      read_.warnings.push_back(at_line("the plant was set back here: only what follows counts"));
    }
    changes_.clear();
    read_.recording.gaps.clear();
  }

  std::string values(const Json& json) {
    const auto found = json.find("values");
    if (found == json.end() || !found->is_object()) return "";
    for (const auto& [name, value] : found->items()) {
      const auto known = read_.recording.index.find(name);
      if (known != read_.recording.index.end()) {
        const auto& changes = read_.recording.series[known->second].changes;
        if (!changes.empty() && number_of(value) == changes.back().value) continue;
      }
      if (std::string wrong = change(name, value); !wrong.empty()) return wrong;
    }
    return "";
  }

  std::string symbol(const Json& json) {
    if (!json["symbol"].is_string() || !json.contains("value")) {
      return "a change needs a text `symbol` and a `value`; correct or delete the line";
    }
    return change(json["symbol"].get_ref<const std::string&>(), json["value"]);
  }

  std::string change(const std::string& name, const Json& value) {
    const auto number = number_of(value);
    if (!number) return fmt::format("`{}` cannot have the value {}", name, value.dump());
    return change(name, value.is_boolean(), *number);
  }

  std::string change(std::string_view name, bool is_boolean, double value) {
    const auto kind = is_boolean ? Series::Kind::boolean : Series::Kind::number;
    const std::uint32_t series = changes_.symbol(kind, name);
    if (read_.recording.series[series].kind != kind) {
      return fmt::format("the value of `{}` is {}, but {} in the lines above; write one kind of values", name,
                         is_boolean ? "TRUE or FALSE" : "a number", is_boolean ? "a number" : "TRUE or FALSE");
    }
    changes_.add(series, lines_.time(), value);
    return "";
  }

  /// Nothing was read from the time of the line on.
  std::string gap(const Json& json) {
    const Json& length = json["gap"];
    if (!length.is_number_unsigned() || length.get<std::uint64_t>() > static_cast<std::uint64_t>(kLatestTime)) {
      return fmt::format("the key `gap` is not a time in ns up to {}", kLatestTime);
    }
    read_.recording.gaps.push_back({lines_.time(), length.get<tables::Time>()});
    return "";
  }

  std::string part(const Json& json) {
    read_.recording.has_parts = true;
    const auto kind = json.find("kind");
    if (kind == json.end() || !kind->is_string()) return "a part needs a text `kind`; correct or delete the line";
    const auto to = json.find("to");
    if (to == json.end() || !to->is_string()) return "";
    const auto& at = to->get_ref<const std::string&>();
    changes_.add(changes_.series_of(Series::Kind::parts, at, kind->get_ref<const std::string&>()), lines_.time(), 1);
    return "";
  }

  trace::TraceLines lines_;
  ReadRecording read_;
  Collector changes_{read_.recording};
  bool is_begun_ = false;   ///< a header was read
  std::uint64_t part_ = 1;  ///< the number of the last one
};

}  // namespace

ReadRecording read_json_lines(std::istream& file, const std::string& name, const ReadOptions&) {
  return Reader(file, name).run();
}

}  // namespace symplant::recording
