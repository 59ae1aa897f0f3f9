// Describes the actions of a step in words.
#include "symplant/scenario/step_words.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>
#include <vector>

#include "symplant/tables/names.hpp"
#include "symplant/trace/value_text.hpp"

namespace symplant::scenario {
namespace {

/// A length up to its third digit: "300 mm", "1.5 m".
std::string length_words(std::int64_t um) {
  const bool meters = um >= 1'000'000;
  std::string text = fmt::format("{:.{}f}", static_cast<double>(um) / (meters ? 1e6 : 1e3), meters ? 3 : 1);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text + (meters ? " m" : " mm");
}

/// "BELT", or "BELT at 300 mm".
std::string location_words(const tables::PartLocation& at, const trace::PlantNames& names) {
  std::string text(names.location(at.location));
  return at.at == tables::kWhole ? text : text + " at " + length_words(at.at);
}

/// Adds actions of one kind after those of other kinds.
class Words {
 public:
  /// Without a verb they go on with the actions before.
  template <class Row, class Text>
  void add(std::string_view verb, const std::vector<Row>& rows, Text text_of) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      text_ += text_.empty() ? "" : ", ";
      if (i == 0 && !verb.empty()) text_.append(verb).append(" ");
      text_ += text_of(rows[i]);
    }
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

}  // namespace

std::string actions_words(const Step& step, const trace::PlantNames& names) {
  const auto controllers = tables::split_names(names.tables().controller_names);
  const auto symbol_text = [&](const SymbolValue& value) {
    return fmt::format("{} {}", names.symbol(value.symbol),
                       trace::value_text(names.tables().symbols[value.symbol], value.value));
  };
  const auto malfunction_text = [&](std::uint32_t number) { return fmt::format("`{}`", names.malfunction(number)); };
  const auto with_count = [](const char* verb, std::size_t count) {
    return fmt::format("{} {}", verb, count == 1 ? "malfunction" : "malfunctions");
  };
  Words words;
  words.add("restart", step.restart, [&](std::uint32_t controller) {
    const bool named = controller < controllers.size() && !controllers[controller].empty();
    return "the program" + (named ? fmt::format(" of {}", controllers[controller]) : "");
  });
  words.add("set", step.set, symbol_text);
  words.add(step.set.empty() ? "set" : "", step.set_values, [&](const ValueSetting& setting) {
    return fmt::format("{} {}", names.value(setting.value), setting.number);
  });
  words.add("put", step.states, [&](const UnitState& unit) {
    return fmt::format("{} into {}", names.unit(unit.unit), names.state(unit.unit, unit.state));
  });
  words.add("put", step.put, [&](const NewPart& part) {
    return fmt::format("`{}` {} {}", names.part_kind(part.kind), part.at.at == tables::kWhole ? "at" : "on",
                       location_words(part.at, names));
  });
  words.add("take a part from", step.take,
            [&](const tables::PartLocation& from) { return location_words(from, names); });
  words.add("force", step.force, symbol_text);
  words.add("release", step.release, [&](std::uint32_t symbol) { return std::string(names.symbol(symbol)); });
  words.add(with_count("stop", step.stop.size()), step.stop, malfunction_text);
  words.add(with_count("start", step.start.size()), step.start, malfunction_text);
  return words.take();
}

}  // namespace symplant::scenario
