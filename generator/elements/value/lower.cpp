// Lowers values and signals: rows, formulas and what they read.
#include "elements/value/lower.hpp"

#include "elements/value/resolve.hpp"
#include "symplant/condition/type_info.hpp"

namespace symplant::lower {
namespace {

std::uint32_t size_of(const auto& rows) { return static_cast<std::uint32_t>(rows.size()); }

class ValueLowering {
 public:
  ValueLowering(const model::PlantModel& plant, const AddCondition& add_condition, EngineTables& tables)
      : plant_(plant), add_condition_(add_condition), tables_(tables), values_(tables.values) {}

  void run() {
    for (const model::Value& value : plant_.values) add(value);
    values_.order = model::value_order(plant_, nullptr);
    for (const model::Signal& signal : plant_.signals) {
      values_.signals.push_back(signal.row);
      values_.signals.back().formula = add(signal.formula);
    }
    for (tables::RandomTime& time : tables_.random_times) {
      if (time.kind != tables::RandomTime::Kind::seconds) continue;
      time.a = add(plant_.time_formulas[static_cast<std::size_t>(time.a)]);
    }
  }

 private:
  void add(const model::Value& value) {
    tables::ValueRow row = value.row;
    row.formula = size_of(values_.formulas);
    row.formulas = size_of(value.formulas);
    for (const condition::Formula& formula : value.formulas) add(formula);
    row.numbers = size_of(values_.numbers);
    values_.numbers.insert(values_.numbers.end(), value.numbers.begin(), value.numbers.end());
    row.changes = {size_of(values_.changes), size_of(value.changes)};
    for (const model::Change& change : value.changes) {
      const std::uint32_t formula = add(change.to);
      const std::uint32_t index = size_of(values_.changes);
      values_.changes.push_back({add_condition_(change.when, tables::ReaderKind::change, index, 0), formula});
    }
    values_.outputs += row.outputs;
    values_.rows.push_back(row);
    values_.names.append(value.name).push_back('\0');
    values_.names.append(value.unit).push_back('\0');
  }

  std::uint32_t add(const condition::Formula& formula) {
    tables::FormulaRow row;
    row.steps = {size_of(values_.steps), size_of(formula.steps)};
    row.inputs = {size_of(values_.inputs), size_of(formula.inputs)};
    const std::uint32_t numbers = size_of(values_.numbers);
    values_.numbers.insert(values_.numbers.end(), formula.numbers.begin(), formula.numbers.end());
    for (tables::FormulaStep step : formula.steps) {
      if (step.op == tables::FormulaOp::curve) step.of += numbers;
      values_.steps.push_back(step);
    }
    for (const condition::FormulaInput& input : formula.inputs) add(input);
    values_.formulas.push_back(row);
    values_.sources.push_back(&formula);
    values_.formula_texts.append(formula.text).push_back('\0');
    return size_of(values_.formulas) - 1;
  }

  void add(const condition::FormulaInput& input) {
    using Kind = condition::FormulaInput::Kind;
    const std::uint32_t index = size_of(values_.inputs);
    switch (input.kind) {
      case Kind::output:
        values_.inputs.push_back({tables::FormulaInputKind::output, {}, input.of});
        return;
      case Kind::atom: {
        values_.inputs.push_back({tables::FormulaInputKind::truth, {}, 0});
        condition::Tree tree;
        tree.kind = condition::Tree::Kind::atom;
        tree.atom = input.atom;
        add_condition_(tree, tables::ReaderKind::formula_input, index, 0);
        return;
      }
      case Kind::number: {
        const tables::SymbolRow& symbol = tables_.symbols[input.of];
        const bool operation = symbol.direction() == tables::Direction::operation;
        values_.inputs.push_back(
            {operation ? tables::FormulaInputKind::operation_value : tables::FormulaInputKind::event_value,
             condition::info_of(symbol.type()).kind, symbol.index});
        return;
      }
      case Kind::parts:
        values_.inputs.push_back({tables::FormulaInputKind::parts, {}, counter_of(input.of, input.part)});
        return;
      case Kind::weight:
        values_.inputs.push_back({tables::FormulaInputKind::weight, {}, input.of});
        return;
      case Kind::time:
        values_.inputs.push_back({tables::FormulaInputKind::time, {}, 0});
        return;
    }
  }

  /// The counter of the parts at a location, of a kind or of all.
  std::uint32_t counter_of(std::uint32_t location, std::uint32_t kind) {
    auto& counters = tables_.material.counters;
    for (std::uint32_t c = 0; c < counters.size(); ++c) {
      if (counters[c].location == location && counters[c].kind == kind) return c;
    }
    counters.push_back({location, kind});
    return size_of(counters) - 1;
  }

  const model::PlantModel& plant_;
  const AddCondition& add_condition_;
  EngineTables& tables_;
  Values& values_;
};

}  // namespace

void lower_values(const model::PlantModel& plant, const AddCondition& add_condition, EngineTables& tables) {
  ValueLowering(plant, add_condition, tables).run();
}

}  // namespace symplant::lower
