// Compares outputs of values bit by bit.
#include "property/value_differences.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <string_view>

#include "text/ascii.hpp"

namespace symplant::property {
namespace {

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

/// Outputs that a formula or a condition names.
std::vector<bool> named_outputs(const tables::ValueTables& values) {
  std::vector<bool> named(values.outputs);
  for (const tables::FormulaInput& input : values.inputs) {
    if (input.kind == tables::FormulaInputKind::output) named[input.of] = true;
  }
  for (const tables::ComparisonRow& row : values.comparisons) {
    for (const tables::Operand& operand : {row.left, row.right}) {
      if (operand.kind == tables::Operand::Kind::output) named[operand.of] = true;
    }
  }
  return named;
}

}  // namespace

std::optional<std::uint32_t> value_number(const model::PlantModel& model, const std::string& name) {
  for (std::uint32_t i = 0; i < model.values.size(); ++i) {
    if (text::equal_ignoring_case(model.values[i].name, name)) return i;
  }
  return std::nullopt;
}

std::string number_text(double number) {
  std::array<char, 64> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
}

std::string values_difference(const plant::Plant& engine, const reference::Plant& reference,
                              const model::PlantModel& plant) {
  const std::vector<reference::ValueWorld>& worlds = reference.save().values;
  for (std::size_t v = 0; v < plant.values.size(); ++v) {
    const tables::ValueRow& row = engine.tables().values.rows[v];
    for (std::uint32_t o = 0; o < row.outputs; ++o) {
      const double one = engine.output(row.output + o);
      const double other = worlds[v].outputs[o];
      if (same_bits(one, other)) continue;
      return "output " + std::to_string(o + 1) + " of " + plant.values[v].name + "\n  engine:    " + number_text(one) +
             "\n  reference: " + number_text(other);
    }
  }
  return {};
}

ValueTrace::ValueTrace(const tables::ValueTables& values) : outputs_(values.outputs) {
  const std::vector<bool> named = named_outputs(values);
  std::string_view rest = values.names;
  const auto next = [&rest] {
    const std::string_view text = rest.substr(0, rest.find('\0'));
    rest.remove_prefix(std::min(text.size() + 1, rest.size()));
    return std::string(text);
  };
  for (const tables::ValueRow& row : values.rows) {
    const std::string name = next();
    next();  // its unit
    const auto begin = named.begin() + row.output;
    const bool any = std::find(begin, begin + row.outputs, true) != begin + row.outputs;
    for (std::uint32_t o = 0; o < row.outputs; ++o) {
      Output& output = outputs_[row.output + o];
      output.name = row.outputs == 1 ? name : name + "[" + std::to_string(o + 1) + "]";
      if (row.outputs == 1 || (any ? begin[o] : o == 0)) output.trace = row.trace;
    }
  }
}

void ValueTrace::clear() {
  for (Output& output : outputs_) output.written.reset();
}

std::vector<std::pair<std::string, double>> ValueTrace::lines_at(tables::Time time, const plant::Plant& plant) {
  std::vector<std::pair<std::string, double>> lines;
  for (std::uint32_t o = 0; o < outputs_.size(); ++o) {
    Output& output = outputs_[o];
    if (output.trace == 0 || time % output.trace != 0) continue;
    const double now = plant.output(o);
    if (output.written && same_bits(*output.written, now)) continue;
    output.written = now;
    lines.emplace_back(output.name, now);
  }
  return lines;
}

}  // namespace symplant::property
