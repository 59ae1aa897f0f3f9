// Why a value has its number: its formula with the numbers in it.
#include <fmt/format.h>

#include "symplant/tables/names.hpp"
#include "symplant/trace/finding_words.hpp"
#include "symplant/trace/influences.hpp"
#include "symplant/why/formula_words.hpp"
#include "symplant/why/walk.hpp"

namespace symplant::why {

/// What a value is computed from, with the numbers of now.
std::string Walk::formula_of(const tables::ValueRow& row) const {
  const auto texts = tables::split_names(tables_.values.formula_texts);
  const auto formula = [&](std::uint32_t i) {
    return formula_words(row.formula + i, texts[row.formula + i], index_, view_);
  };
  using Kind = tables::ValueKind;
  switch (row.kind) {
    case Kind::parameter:
      return "a parameter";
    case Kind::integral:
      return "integral of " + formula(0);
    case Kind::lag:
      return "lag of " + formula(0);
    case Kind::ramp:
      return fmt::format("ramp toward {}, up {}{} per second", formula(0), formula(1),
                         row.formulas > 2 ? " and down " + formula(2) : "");
    case Kind::delay:
      return fmt::format("delay by {} of {}", trace::seconds(row.step * row.steps), formula(0));
    case Kind::derivative:
      return "derivative of " + formula(0);
    case Kind::is:
      return formula(0);
    case Kind::position:
      return fmt::format("position of {}", names_.unit(row.unit));
    case Kind::noise:
      return "noise with the standard deviation " + number_words(row.factor);
    case Kind::pid:
      return fmt::format("pid of {} to {}", formula(0), formula(1));
    case Kind::linear:
      break;
  }
  std::string words = "linear in ";
  for (std::uint32_t i = 0; i < row.formulas; ++i) words += (i == 0 ? "" : ", ") + formula(i);
  return words;
}

/// `level is 21.98 l: integral of 2 * L_S1_PUMP.RUN (1) - outflow (0.02)`.
Explanation Walk::asked_value(std::uint32_t output) {
  const Reference self{Reference::Kind::value, output};
  const std::uint32_t value = names_.value_of(output);
  const tables::ValueRow& row = tables_.values.rows[value];
  const std::string_view unit = names_.unit_of_value(value);
  Explanation result{name_of(self, names_), {self}, {}};
  const std::optional<double> now = view_.output(output);
  if (now) result.sentence += fmt::format(" is {}{}{}", number_words(*now), unit.empty() ? "" : " ", unit);
  const std::string holds = trace::holding_malfunction(value, names_, view_.malfunctions());
  if (!holds.empty()) {
    result.sentence += ": " + holds + " holds it";
    return result;
  }
  result.sentence += ": " + formula_of(row);
  if (row.kind != tables::ValueKind::parameter && now == row.max) result.sentence += "; it is at its `max`";
  if (row.kind != tables::ValueKind::parameter && now == row.min) result.sentence += "; it is at its `min`";
  if (row.kind == tables::ValueKind::position) {
    result.about.push_back({Reference::Kind::unit, row.unit});
    append(result.because, causes(std::vector{row.unit}, [this](std::uint32_t of) { return this->unit(of); }));
  }
  return result;
}

}  // namespace symplant::why
