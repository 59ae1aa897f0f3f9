// Writes the actions of a step as JSON.
#include "symplant/scenario/step_text.hpp"

#include <fmt/format.h>

#include <bit>
#include <string_view>
#include <vector>

#include "symplant/tables/names.hpp"
#include "symplant/trace/value_text.hpp"

namespace symplant::scenario {
namespace {

using trace::json_string;

/// Appends `"key":` and the texts in the brackets, with commas; nothing for no texts.
void put_member(std::string& json, std::string_view key, std::string_view brackets,
                const std::vector<std::string>& texts) {
  if (texts.empty()) return;
  json += fmt::format("{}\"{}\":{}{}{}", json.empty() ? "" : ",", key, brackets[0], fmt::join(texts, ","), brackets[1]);
}

template <class Row, class Text>
std::vector<std::string> texts_of(const std::vector<Row>& rows, Text text) {
  std::vector<std::string> texts;
  texts.reserve(rows.size());
  for (const Row& row : rows) texts.push_back(text(row));
  return texts;
}

std::string location_json(const tables::PartLocation& at, const trace::PlantNames& names) {
  const std::string name(names.location(at.location));
  if (at.at == tables::kWhole) return json_string(name);
  return json_string(fmt::format("{}@{}.{:03} mm", name, at.at / 1000, at.at % 1000));
}

}  // namespace

std::string actions_json(const Step& step, const trace::PlantNames& names) {
  const auto value_text = [&](const SymbolValue& value) {
    return fmt::format("{}:{}", json_string(names.symbol(value.symbol)),
                       trace::json_value(names.tables().symbols[value.symbol].type(), value.value));
  };
  std::string json;
  const auto controllers = tables::split_names(names.tables().controller_names);
  for (const std::uint32_t controller : step.restart) {
    const bool named = controller < controllers.size() && !controllers[controller].empty();
    json += (json.empty() ? "\"restart\":" : ",\"restart\":") + (named ? json_string(controllers[controller]) : "true");
  }
  std::vector<std::string> settings = texts_of(step.set, value_text);
  for (const ValueSetting& setting : step.set_values) {
    settings.push_back(
        fmt::format("{}:{}", json_string(names.value(setting.value)),
                    trace::json_value(tables::DataType::lreal, std::bit_cast<std::uint64_t>(setting.number))));
  }
  put_member(json, "set", "{}", settings);
  put_member(json, "state", "{}", texts_of(step.states, [&](const UnitState& unit) {
               return fmt::format("{}:{}", json_string(names.unit(unit.unit)),
                                  json_string(names.state(unit.unit, unit.state)));
             }));
  put_member(json, "put", "[]", texts_of(step.put, [&](const NewPart& part) {
               return fmt::format(R"({{"at":{},"kind":{}}})", location_json(part.at, names),
                                  json_string(names.part_kind(part.kind)));
             }));
  put_member(json, "take", "[]",
             texts_of(step.take, [&](const tables::PartLocation& from) { return location_json(from, names); }));
  put_member(json, "force", "{}", texts_of(step.force, value_text));
  put_member(json, "release", "[]",
             texts_of(step.release, [&](std::uint32_t symbol) { return json_string(names.symbol(symbol)); }));
  const auto name_text = [&](std::uint32_t malfunction) { return json_string(names.malfunction(malfunction)); };
  put_member(json, "stop", "[]", texts_of(step.stop, name_text));
  put_member(json, "start", "[]", texts_of(step.start, name_text));
  return json;
}

std::string act_json(const Step& step, const trace::PlantNames& names) {
  Step act = step;
  std::erase_if(act.set, [&](const SymbolValue& value) {
    return names.tables().symbols[value.symbol].direction() == tables::Direction::operation;
  });
  const std::string members = actions_json(act, names);
  return members.empty() ? "" : "{" + members + "}";
}

}  // namespace symplant::scenario
