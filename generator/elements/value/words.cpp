// Values and signals in words, for tables and differences.
#include "elements/value/words.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "elements/value/entry.hpp"
#include "model/condition_text.hpp"
#include "view/words.hpp"

namespace symplant::view {
namespace {

using tables::ValueKind;

std::string formulas_of(const model::Value& value) {
  std::string text;
  for (const condition::Formula& formula : value.formulas) {
    text.append(text.empty() ? "" : value.row.kind == ValueKind::ramp ? ", at most " : "; ").append(formula.text);
  }
  return text;
}

std::string positions_of(const model::Value& value, const model::Unit& unit) {
  std::string text(unit.path);
  for (std::size_t s = 0; s < value.numbers.size(); ++s) {
    text += fmt::format("{} {} {}", s == 0 ? ":" : ",", unit.states[s].name, value.numbers[s]);
  }
  return text;
}

std::string controller_of(const tables::ValueRow& row, const description::GivenValue& given) {
  std::string text = fmt::format(", kp {}", row.factor);
  if (given.ti) text += ", ti " + time_text(*given.ti);
  if (given.td != 0) text += ", td " + time_text(given.td);
  return text;
}

std::string range_of(const tables::ValueRow& row) {
  if (std::isfinite(row.min) && std::isfinite(row.max)) return fmt::format(", from {} to {}", row.min, row.max);
  if (std::isfinite(row.min)) return fmt::format(", at least {}", row.min);
  return std::isfinite(row.max) ? fmt::format(", at most {}", row.max) : "";
}

/// "integral, from 0 to 120", "lag, time 90 s".
std::string kind_line(const model::Value& value, const description::GivenValue& given) {
  const tables::ValueRow& row = value.row;
  std::string text(tables::value_kind_name(row.kind));
  if (row.kind == ValueKind::parameter) text += fmt::format(", starts at {}", row.start);
  if (row.kind == ValueKind::noise) text += fmt::format(" {}", row.factor);
  if (given.time) text += ", time " + time_text(*given.time);
  if (row.kind == ValueKind::pid) text += controller_of(row, given);
  return text + range_of(row);
}

bool has_start(ValueKind kind) { return tables::keeps_its_output(kind) || kind == ValueKind::delay; }

}  // namespace

std::string value_line(const model::Value& value, const model::PlantModel& plant) {
  const tables::ValueRow& row = value.row;
  const description::GivenValue& given = plant.description->values[value.given];
  std::string text(tables::value_kind_name(row.kind));
  if (row.kind == ValueKind::position) {
    text += " " + positions_of(value, plant.units[row.unit]);
  } else if (row.kind == ValueKind::noise) {
    text += fmt::format(" {}", row.factor);
  } else if (!value.formulas.empty()) {
    text += " " + formulas_of(value);
  }
  if (given.time) text += ", time " + time_text(*given.time);
  if (row.kind == ValueKind::pid) text += controller_of(row, given);
  text += range_of(row);
  if (!value.unit.empty()) text += " " + value.unit;
  if (has_start(row.kind)) text += fmt::format(", starts at {}", row.start);
  if (row.step != 0) text += ", each " + time_text(row.step);
  for (const model::Change& change : value.changes) {
    text += fmt::format(", when {} to {}", model::condition_text(change.when, plant), change.to.text);
  }
  return text;
}

std::string value_title(const model::Value& value) {
  return value.unit.empty() ? value.name : fmt::format("{} [{}]", value.name, value.unit);
}

std::vector<std::string> value_box(const model::Value& value, const model::PlantModel& plant) {
  std::vector<std::string> lines{kind_line(value, plant.description->values[value.given])};
  if (value.row.kind == ValueKind::position) {
    lines.push_back(positions_of(value, plant.units[value.row.unit]));
  } else if (value.row.kind == ValueKind::pid && value.formulas.size() == 2) {
    lines.push_back(fmt::format("of {} to {}", value.formulas[0].text, value.formulas[1].text));
  } else if (!value.formulas.empty()) {
    lines.push_back(formulas_of(value));
  }
  for (const model::Change& change : value.changes) {
    lines.push_back(fmt::format("when {} to {}", model::condition_text(change.when, plant), change.to.text));
  }
  return lines;
}

std::string signal_line(const model::Signal& signal, const model::PlantModel&) {
  const tables::SignalRow& row = signal.row;
  std::string text = signal.formula.text;
  if (row.scaled) text += fmt::format(", from {} to {} as {} to {}", row.a, row.b, row.c, row.d);
  if (std::isfinite(row.low)) text += fmt::format(", limited to {} to {}", row.low, row.high);
  if (row.noise != 0) text += fmt::format(", noise {}", row.noise);
  return text + ", each " + time_text(row.every);
}

}  // namespace symplant::view
