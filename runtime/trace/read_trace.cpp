// Reads a trace file back into records.
#include "symplant/trace/read_trace.hpp"

#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <istream>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "symplant/tables/malfunction_numbers.hpp"
#include "symplant/trace/malfunction_text.hpp"
#include "symplant/trace/trace_lines.hpp"
#include "symplant/trace/value_text.hpp"

namespace symplant::trace {
namespace {

using Json = nlohmann::json;

class TraceReader {
 public:
  explicit TraceReader(const PlantNames& names) : names_(names) {
    const tables::PlantTables& tables = names.tables();
    for (std::uint32_t s = 0; s < tables.symbols.size(); ++s) symbols_.emplace(names.symbol(s), s);
    for (std::uint32_t l = 0; l < tables.material.locations(); ++l) locations_.emplace(names.location(l), l);
    for (std::uint32_t k = 0; k < tables.material.kinds.size(); ++k) kinds_.emplace(names.part_kind(k), k);
    locations_.emplace("out", tables::kOut);
    for (std::uint32_t m = 0; m < tables.malfunctions.size(); ++m) malfunctions_.emplace(names.malfunction(m), m);
    for (std::uint32_t o = 0; o < tables.values.outputs; ++o) outputs_.emplace(names.output(o), o);
    for (std::uint32_t u = 0; u < tables.units.size(); ++u) units_.emplace(names.unit(u), u);
  }

  ReadTrace run(std::istream& file) {
    TraceLines lines(file);
    std::string wrong;
    Json json;
    while (wrong.empty() && lines.next(json)) wrong = take(json, lines);
    if (wrong.empty()) wrong = lines.error();
    if (!wrong.empty()) read_.error = fmt::format("line {}: {}", lines.number(), wrong);
    read_.cut_off = lines.cut_off();
    if (!read_.records.empty()) read_.records.back().last = true;
    return std::move(read_);
  }

 private:
  /// What is wrong with a line; empty: nothing.
  std::string take(const Json& json, const TraceLines& lines) {
    if (lines.is_header()) return take_header(json, lines.time());
    const tables::Time at = lines.time();
    if (at > read_.end && !read_.records.empty()) read_.records.back().last = true;
    read_.end = at;
    if (lines.is_set_back()) return set_back(json, at);
    if (json.contains("symbol")) return take_change(json, at);
    if (json.contains("malfunction")) return take_malfunction(json, at);
    if (json.contains("value")) return take_output(json, at);
    return json.contains("part") ? take_part(json, at) : std::string();  // other lines say nothing about the state
  }

  std::string take_header(const Json& json, tables::Time at) {
    if (const auto hash = json.find("model_hash"); hash != json.end() && hash->is_string()) {
      read_.model_hash = hash->get<std::string>();
    }
    read_.begin = read_.end = at;
    return take_state(json, at);
  }

  std::string set_back(const Json& json, tables::Time at) {
    ++read_.set_back;
    read_.records.clear();
    read_.begin = at;
    return take_state(json, at);
  }

  /// The values and malfunctions with which a trace begins, or goes on from another state.
  std::string take_state(const Json& json, tables::Time at) {
    if (const auto values = json.find("values"); values != json.end()) {
      if (std::string wrong = take_values(*values, at); !wrong.empty()) return wrong;
    }
    const auto malfunctions = json.find("malfunctions");
    if (malfunctions == json.end()) return "";
    for (const Json& one : *malfunctions) {
      if (!one.is_array() || one.size() != 2 || !one[0].is_string()) return "`malfunctions` is not an array of pairs";
      if (std::string wrong = add_malfunction(one[0].get<std::string>(), true, one[1], at); !wrong.empty())
        return wrong;
    }
    return "";
  }

  std::string take_values(const Json& values, tables::Time at) {
    if (!values.is_object()) return "`values` is not an object";
    for (const auto& [name, value] : values.items()) {
      if (std::string wrong = add_change(name, value, at); !wrong.empty()) return wrong;
    }
    return "";
  }

  std::string take_change(const Json& json, tables::Time at) {
    if (!json["symbol"].is_string() || !json.contains("value")) return "a change has `symbol` and `value`";
    return add_change(json["symbol"].get<std::string>(), json["value"], at);
  }

  std::string add_change(const std::string& name, const Json& value, tables::Time at) {
    const auto found = symbols_.find(name);
    if (found == symbols_.end()) return unknown(name);
    const auto bits = value_of(names_.tables().symbols[found->second].type(), value);
    if (!bits) return fmt::format("`{}` cannot have the value {}", name, value.dump());
    read_.records.push_back({at, *bits, found->second});
    return "";
  }

  std::string unknown(const std::string& name) {
    if (read_.unknown++ == 0) read_.first_unknown = name;
    return "";
  }

  static std::optional<std::uint64_t> value_of(tables::DataType type, const Json& value) {
    if (type == tables::DataType::boolean) {
      return value.is_boolean() ? std::optional<std::uint64_t>(value.get<bool>() ? 1 : 0) : std::nullopt;
    }
    if (is_real(type)) return real_of(value);
    if (value.is_number_unsigned()) return value.get<std::uint64_t>();
    if (value.is_number_integer()) return static_cast<std::uint64_t>(value.get<std::int64_t>());
    if (!value.is_string()) return std::nullopt;
    const std::string text = value.get<std::string>();
    const char* const end = text.data() + text.size();
    std::int64_t number = 0;
    if (const auto [at, error] = std::from_chars(text.data(), end, number); error == std::errc() && at == end) {
      return static_cast<std::uint64_t>(number);
    }
    std::uint64_t large = 0;
    const auto [at, error] = std::from_chars(text.data(), end, large);
    return error == std::errc() && at == end ? std::optional(large) : std::nullopt;
  }

  static std::optional<std::uint64_t> real_of(const Json& value) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    if (value.is_number()) return std::bit_cast<std::uint64_t>(value.get<double>());
    if (value == "nan") return std::bit_cast<std::uint64_t>(std::numeric_limits<double>::quiet_NaN());
    if (value == "inf") return std::bit_cast<std::uint64_t>(kInfinity);
    return value == "-inf" ? std::optional(std::bit_cast<std::uint64_t>(-kInfinity)) : std::nullopt;
  }

  std::string take_output(const Json& json, tables::Time at) {
    const auto number = json.find("is");
    if (!json["value"].is_string() || number == json.end() || !number->is_number()) {
      return "a value has a name and a number `is`";
    }
    const auto name = json["value"].get<std::string>();
    const auto found = outputs_.find(name);
    if (found == outputs_.end()) return unknown(name);
    const auto bits = std::bit_cast<std::uint64_t>(number->get<double>());
    read_.records.push_back({at, bits, found->second, Record::Kind::value});
    return "";
  }

  std::string take_part(const Json& json, tables::Time at) {
    const auto kind = find(kinds_, json, "kind");
    if (!json["part"].is_number_unsigned() || !json.contains("kind")) return "a part has a number and a `kind`";
    if (!kind) return unknown(json["kind"].dump());
    const bool moved = json.contains("from");
    const bool arrived = json.contains("to");
    const auto from = moved ? find(locations_, json, "from") : std::optional(tables::kNone);
    const auto to = arrived ? find(locations_, json, "to") : std::optional(tables::kNone);
    if (!from || !to) return unknown(json[from ? "to" : "from"].dump());
    const auto x = json.find("x");
    const bool by_hand = json.value("by", Json()) == "hand";
    read_.records.push_back({at, json["part"].get<std::uint64_t>(), *kind, Record::Kind::part, {}, by_hand});
    read_.records.push_back({at, pack_move(*from, *to),
                             x != json.end() && x->is_number_unsigned() ? x->get<std::uint32_t>() : 0,
                             Record::Kind::part_move});
    return "";
  }

  std::string take_malfunction(const Json& json, tables::Time at) {
    const auto active = json.find("active");
    if (!json["malfunction"].is_string() || active == json.end() || !active->is_boolean()) {
      return "a malfunction has a name and `active`";
    }
    return add_malfunction(json["malfunction"].get<std::string>(), active->get<bool>(), json.value("by", Json()), at);
  }

  std::string add_malfunction(const std::string& name, bool active, const Json& by, tables::Time at) {
    const auto number = malfunction(name);
    if (!number) return unknown(name);
    const auto known = by.is_string() ? malfunction_by_named(by.get<std::string>()) : std::nullopt;
    if (!known) return fmt::format("malfunction `{}` has no `by`, or an unknown one", name);
    read_.records.push_back({at, static_cast<std::uint64_t>(*known), *number, Record::Kind::malfunction, {}, active});
    return "";
  }

  /// The number of a malfunction by its exact name, written or ordinary.
  std::optional<std::uint32_t> malfunction(std::string_view name) const {
    const auto of = [name](const auto& index, std::string_view ending) -> std::optional<std::uint32_t> {
      if (!name.ends_with(ending)) return std::nullopt;
      const auto found = index.find(name.substr(0, name.size() - ending.size()));
      return found == index.end() ? std::nullopt : std::optional(found->second);
    };
    if (const auto found = malfunctions_.find(std::string(name)); found != malfunctions_.end()) return found->second;
    const tables::MalfunctionNumbers numbers(names_.tables());
    for (const bool on : {true, false}) {
      const auto symbol = of(symbols_, on ? " stuck on" : " stuck off");
      if (symbol && numbers.is_bool_event(*symbol)) return numbers.stuck(*symbol, on);
    }
    if (const auto unit = of(units_, " stuck")) return numbers.stuck(*unit);
    const auto unit = of(units_, " slow");
    return unit ? std::optional(numbers.slow(*unit)) : std::nullopt;
  }

  using Index = std::unordered_map<std::string_view, std::uint32_t>;
  static std::optional<std::uint32_t> find(const Index& index, const Json& json, const char* key) {
    const auto value = json.find(key);
    if (value == json.end() || !value->is_string()) return std::nullopt;
    const auto found = index.find(value->get_ref<const std::string&>());
    return found == index.end() ? std::nullopt : std::optional(found->second);
  }

  const PlantNames& names_;
  Index symbols_;
  Index locations_;
  Index kinds_;
  Index units_;
  std::unordered_map<std::string, std::uint32_t> malfunctions_;  ///< those of the description
  std::unordered_map<std::string, std::uint32_t> outputs_;       ///< of values
  ReadTrace read_;
};

}  // namespace

ReadTrace read_trace(std::istream& file, const PlantNames& names) { return TraceReader(names).run(file); }

}  // namespace symplant::trace
