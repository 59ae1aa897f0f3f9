// Reads members of objects, and durations.
#include "description/json_entry.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "symplant/tables/duration.hpp"

namespace symplant::description {
namespace {

using Json = nlohmann::json;

std::string why_no_duration(const std::string& text) {
  // It is a duration without its fraction, so the fraction is at fault.
  const std::size_t point = text.find('.');
  if (point != std::string::npos) {
    const std::size_t unit = text.find_first_not_of("0123456789", point + 1);
    if (unit != std::string::npos && unit > point + 1 &&
        tables::parse_duration(text.substr(0, point) + text.substr(unit))) {
      return ticked(text) + " has a part below 1 ns; give it fewer decimals";
    }
  }
  const std::size_t unit = text.find_first_not_of("0123456789");
  if (unit != std::string::npos && unit > 0 && tables::parse_duration("1" + text.substr(unit))) {
    return ticked(text) + " is longer than the maximum of 292 years; write a shorter duration";
  }
  return ticked(text) + " is not a duration; write a number and ns, us, ms, s, min or h, such as `500ms`";
}

std::optional<tables::Time> time_of(const std::string& text, const Pointer& here, ShapeFaults& faults) {
  const auto time = tables::parse_duration(text);
  if (!time) faults.add(here, why_no_duration(text));
  return time;
}

}  // namespace

const Json* member(const Json& object, std::string_view key) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

const std::string* text_member(const Json& object, std::string_view key) {
  const Json* value = member(object, key);
  return value == nullptr ? nullptr : value->get_ptr<const std::string*>();
}

std::string text_or_empty(const Json& object, std::string_view key) {
  const std::string* text = text_member(object, key);
  return text == nullptr ? std::string() : *text;
}

std::vector<std::string> texts_member(const Json& object, std::string_view key) {
  std::vector<std::string> texts;
  const Json* array = member(object, key);
  if (array == nullptr || !array->is_array()) return texts;
  for (const Json& one : *array) {
    if (one.is_string()) texts.push_back(one.get<std::string>());
  }
  return texts;
}

std::string formula_text(const Json& formula) {
  if (formula.is_number()) return formula.dump();
  return formula.is_string() ? formula.get<std::string>() : std::string();
}

std::string formula_member(const Json& object, std::string_view key) {
  const Json* value = member(object, key);
  return value == nullptr ? std::string() : formula_text(*value);
}

bool flag_member(const Json& object, std::string_view key) {
  const Json* value = member(object, key);
  return value != nullptr && value->is_boolean() && value->get<bool>();
}

void check_text(std::string_view text, const Pointer& here, ShapeFaults& faults) {
  const bool control = std::any_of(text.begin(), text.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7F;
  });
  if (control) faults.add(here, "this name contains a control character, such as a line end; remove it");
}

std::optional<tables::Time> time_member(const Json& object, std::string_view key, const Pointer& here,
                                        ShapeFaults& faults) {
  const std::string* text = text_member(object, key);
  if (text == nullptr || text->empty()) return std::nullopt;
  return time_of(*text, here / key, faults);
}

std::optional<tables::Time> step_member(const Json& object, std::string_view key, const Pointer& here,
                                        ShapeFaults& faults) {
  const auto step = time_member(object, key, here, faults);
  if (!step || (*step >= 100 * tables::kMicrosecond && *step <= 3600 * tables::kSecond)) return step;
  faults.add(here / key, ticked(key) + " is from 100 us to 1 h", FaultKind::contradiction);
  return std::nullopt;
}

std::optional<Duration> duration_member(const Json& object, std::string_view key, const Pointer& here,
                                        ShapeFaults& faults) {
  const Json* value = member(object, key);
  if (value == nullptr) return std::nullopt;
  if (value->is_string()) {
    const auto time = time_member(object, key, here, faults);
    return time ? std::optional(Duration::fixed(*time)) : std::nullopt;
  }
  const Pointer inside = here / key;
  const auto min = time_member(*value, "min", inside, faults);
  const auto max = time_member(*value, "max", inside, faults);
  if (min && max) {
    if (*min <= *max) return Duration{Duration::Kind::uniform, *min, *max};
    faults.add(inside / "max",
               "`max` (" + ticked(text_or_empty(*value, "max")) + ") is less than `min`; exchange the two",
               FaultKind::contradiction);
    return std::nullopt;
  }
  const auto mean = time_member(*value, "mean", inside, faults);
  const auto sigma = time_member(*value, "sigma", inside, faults);
  if (mean && sigma) return Duration{Duration::Kind::normal, *mean, *sigma};
  return std::nullopt;
}

std::optional<Duration> computed_duration_member(const Json& object, std::string_view key, const Pointer& here,
                                                 ShapeFaults& faults) {
  const Json* written = member(object, key);
  std::string formula = written == nullptr ? std::string() : formula_member(*written, "seconds");
  if (formula.empty()) return duration_member(object, key, here, faults);
  return Duration::seconds(std::move(formula));
}

std::optional<Sequence> sequence_member(const Json& object) {
  const std::string* text = text_member(object, "sequence");
  if (text == nullptr) return std::nullopt;
  for (const Sequence sequence : {Sequence::free, Sequence::neighbours, Sequence::cycle}) {
    if (sequence_name(sequence) == *text) return sequence;
  }
  return std::nullopt;
}

std::optional<tables::Time> overrun_member(const Json& object, const Pointer& here, ShapeFaults& faults) {
  const std::string* text = text_member(object, "overrun");
  if (text != nullptr && *text == "never") return tables::kNever;
  return time_member(object, "overrun", here, faults);
}

std::optional<tables::Actuation> actuation_member(const Json& object) {
  const std::string* text = text_member(object, "actuation");
  if (text == nullptr) return std::nullopt;
  for (const tables::Actuation actuation :
       {tables::Actuation::latched, tables::Actuation::bistable, tables::Actuation::held, tables::Actuation::spring}) {
    if (actuation_name(actuation) == *text) return actuation;
  }
  return std::nullopt;
}

}  // namespace symplant::description
