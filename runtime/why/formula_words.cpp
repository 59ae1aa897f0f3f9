// A formula with the numbers of what it reads.
#include "symplant/why/formula_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "symplant/condition/formula_tokens.hpp"
#include "symplant/tables/compare.hpp"
#include "symplant/why/needs.hpp"

namespace symplant::why {
namespace {

using condition::Token;
using tables::FormulaInputKind;

/// A name in a formula: where it ends, in the order of the text.
std::vector<std::size_t> ends_of_names(std::string_view text) {
  std::vector<std::size_t> ends;
  condition::Tokens tokens(text);
  Token token = tokens.next(false);
  while (token.kind != Token::Kind::end) {
    const bool is_word = token.is_name("pi") || token.is_name("not") || token.is_name("and") || token.is_name("or");
    if ((token.kind != Token::Kind::name && token.kind != Token::Kind::quoted) || is_word) {
      token = tokens.next(false);
      continue;
    }
    std::size_t end = token.offset + token.text.size();
    token = tokens.next(false);
    const bool is_function = token.is_sign("(");
    while (token.is_sign(".") || token.is_sign("[")) {
      const bool is_output = token.is_sign("[");
      token = tokens.next(true);
      end = token.offset + token.text.size();
      token = tokens.next(false);
      if (!is_output) continue;
      end = token.offset + token.text.size();  // `]`
      token = tokens.next(false);
    }
    if (!is_function) ends.push_back(end);
  }
  return ends;
}

/// Whether the condition of a truth in a formula holds; nothing if it is not found.
std::optional<double> number_of_truth(std::uint32_t input, const PlantIndex& index, const StateView& view) {
  const auto& conditions = index.tables.conditions;
  const auto found = std::find_if(conditions.begin(), conditions.end(), [&](const tables::ConditionRow& row) {
    return row.reader_kind == tables::ReaderKind::formula_input && row.reader == input;
  });
  if (found == conditions.end()) return {};
  const auto condition = static_cast<std::uint32_t>(found - conditions.begin());
  return holds(index.conditions.network(condition), view) ? 1 : 0;
}

/// A numeric symbol by its slot.
std::optional<double> number_of_symbol(const tables::FormulaInput& input, const PlantIndex& index,
                                       const StateView& view) {
  const auto direction =
      input.kind == FormulaInputKind::operation_value ? tables::Direction::operation : tables::Direction::event;
  const auto& symbols = index.tables.symbols;
  const auto found = std::find_if(symbols.begin(), symbols.end(), [&](const tables::SymbolRow& row) {
    return row.type() != tables::DataType::boolean && row.direction() == direction && row.index == input.of;
  });
  if (found == symbols.end()) return {};
  return tables::number_of(input.number, view.value(static_cast<std::uint32_t>(found - symbols.begin())));
}

double number_of_parts(const tables::PartCounterRow& counter, const StateView& view) {
  const std::vector<PartState> all = view.parts(counter.location);
  const auto counts = [&](const PartState& part) { return counter.kind == tables::kNone || part.kind == counter.kind; };
  return static_cast<double>(std::count_if(all.begin(), all.end(), counts));
}

std::optional<double> number_of_input(std::uint32_t input, const PlantIndex& index, const StateView& view) {
  const tables::FormulaInput& row = index.tables.values.inputs[input];
  switch (row.kind) {
    case FormulaInputKind::output:
      return view.output(row.of);
    case FormulaInputKind::truth:
      return number_of_truth(input, index, view);
    case FormulaInputKind::operation_value:
    case FormulaInputKind::event_value:
      return number_of_symbol(row, index, view);
    case FormulaInputKind::parts:
      return number_of_parts(index.tables.material.counters[row.of], view);
    case FormulaInputKind::weight:
      return view.weight(row.of);
    case FormulaInputKind::time:
      break;
  }
  return static_cast<double>(view.now()) / 1e9;
}

}  // namespace

std::string number_words(double number) {
  const double size = std::abs(number);
  if (std::trunc(number) == number && size < 1e15) return fmt::format("{:.0f}", number);
  return size >= 1000 && size < 1e9 ? fmt::format("{:.1f}", number) : fmt::format("{:.4g}", number);
}

std::string formula_words(std::uint32_t formula, std::string_view text, const PlantIndex& index,
                          const StateView& view) {
  const tables::ValueTables& values = index.tables.values;
  const tables::FormulaRow& row = values.formulas[formula];
  std::vector<std::uint32_t> read;  // the inputs, in the order of the text
  for (const tables::FormulaStep& step : values.steps.subspan(row.steps.first, row.steps.count)) {
    if (step.op == tables::FormulaOp::input) read.push_back(step.of);
  }
  const std::vector<std::size_t> ends = ends_of_names(text);
  if (ends.size() != read.size()) return std::string(text);
  std::vector<bool> shown(row.inputs.count);
  std::string words;
  std::size_t at = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    words += text.substr(at, ends[i] - at);
    at = ends[i];
    if (shown[read[i]]) continue;
    shown[read[i]] = true;
    if (const auto number = number_of_input(row.inputs.first + read[i], index, view)) {
      words += " (" + number_words(*number) + ")";
    }
  }
  return words.append(text.substr(at));
}

}  // namespace symplant::why
