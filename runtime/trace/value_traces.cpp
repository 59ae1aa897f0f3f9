// Which outputs of values a trace shows, and how often.
#include "symplant/trace/value_traces.hpp"

#include <cstdint>

namespace symplant::trace {

std::vector<tables::Time> traces_of(const tables::ValueTables& values) {
  std::vector<tables::Time> traces(values.outputs, 0);
  std::vector<bool> named(values.outputs, false);
  for (const tables::FormulaInput& input : values.inputs) {
    if (input.kind == tables::FormulaInputKind::output) named[input.of] = true;
  }
  for (const tables::ComparisonRow& row : values.comparisons) {
    for (const tables::Operand& operand : {row.left, row.right}) {
      if (operand.kind == tables::Operand::Kind::output) named[operand.of] = true;
    }
  }
  for (const tables::ValueRow& row : values.rows) {
    bool any = false;
    for (std::uint32_t o = row.output; o < row.output + row.outputs; ++o) any = any || named[o];
    for (std::uint32_t o = row.output; o < row.output + row.outputs; ++o) {
      if (row.outputs == 1 || (any ? named[o] : o == row.output)) traces[o] = row.trace;
    }
  }
  return traces;
}

}  // namespace symplant::trace
