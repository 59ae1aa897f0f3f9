// Values and signals as JSON, for programs.
#include "elements/value/json.hpp"

#include <cmath>

#include "elements/value/entry.hpp"
#include "model/condition_text.hpp"

namespace symplant::view {
namespace {

using tables::ValueKind;

class ValueJson {
 public:
  ValueJson(const model::PlantModel& plant, JsonWriter& json) : plant_(plant), json_(json) {}

  void write(const model::Value& value) {
    const tables::ValueRow& row = value.row;
    json_.begin_object();
    json_.member("name", value.name);
    if (!value.unit.empty()) json_.member("unit", value.unit);
    json_.member("kind",
                 row.kind == ValueKind::parameter ? std::string_view("parameter") : tables::value_kind_name(row.kind));
    if (row.kind == ValueKind::position) {
      write_positions(value);
    } else if (!value.formulas.empty()) {
      json_.key("formulas");
      json_.array(value.formulas, [&](const condition::Formula& formula) { json_.value(formula.text); });
    }
    json_.member("start", row.start);
    if (std::isfinite(row.min)) json_.member("min", row.min);
    if (std::isfinite(row.max)) json_.member("max", row.max);
    if (row.step != 0) json_.member("step", row.step);
    json_.member("trace", row.trace);
    write_numbers(value);
    write_changes(value);
    json_.end_object();
  }

  void write(const model::Signal& signal) {
    const tables::SignalRow& row = signal.row;
    json_.begin_object();
    json_.member("symbol", plant_.symbols[row.symbol].name());
    json_.member("of", signal.formula.text);
    if (row.scaled) {
      pair("from", row.a, row.b);
      pair("to", row.c, row.d);
    }
    if (std::isfinite(row.low) && std::isfinite(row.high)) pair("limit", row.low, row.high);
    if (row.noise != 0) json_.member("noise", row.noise);
    json_.member("every", row.every);
    json_.end_object();
  }

 private:
  void pair(std::string_view key, double a, double b) {
    json_.key(key);
    json_.begin_array();
    json_.value(a);
    json_.value(b);
    json_.end_array();
  }

  void write_positions(const model::Value& value) {
    const model::Unit& unit = plant_.units[value.row.unit];
    json_.member("of", unit.path);
    json_.key("at");
    json_.begin_object();
    for (std::size_t s = 0; s < value.numbers.size(); ++s) json_.member(unit.states[s].name, value.numbers[s]);
    json_.end_object();
  }

  void write_numbers(const model::Value& value) {
    const description::GivenValue& given = plant_.description->values[value.given];
    if (given.time) json_.member("time", *given.time);
    if (value.row.kind == ValueKind::noise) json_.member("noise", value.row.factor);
    if (value.row.kind == ValueKind::pid) {
      json_.member("kp", value.row.factor);
      if (given.ti) json_.member("ti", *given.ti);
      json_.member("td", given.td);
    }
    if (value.row.kind != ValueKind::linear) return;
    matrix("a", given.a);
    matrix("b", given.b);
    matrix("c", given.c);
    if (!given.d.empty()) matrix("d", given.d);
  }

  void matrix(std::string_view key, const description::Matrix& rows) {
    json_.key(key);
    json_.array(rows,
                [&](const std::vector<double>& row) { json_.array(row, [&](double number) { json_.value(number); }); });
  }

  void write_changes(const model::Value& value) {
    if (value.changes.empty()) return;
    json_.key("changes");
    json_.array(value.changes, [&](const model::Change& change) {
      json_.begin_object();
      json_.member("when", model::condition_text(change.when, plant_));
      json_.member("to", change.to.text);
      json_.end_object();
    });
  }

  const model::PlantModel& plant_;
  JsonWriter& json_;
};

}  // namespace

void write_values(const model::PlantModel& plant, JsonWriter& json) {
  ValueJson writer(plant, json);
  if (!plant.values.empty()) {
    json.key("values");
    json.array(plant.values, [&](const model::Value& value) { writer.write(value); });
  }
  if (!plant.signals.empty()) {
    json.key("signals");
    json.array(plant.signals, [&](const model::Signal& signal) { writer.write(signal); });
  }
}

}  // namespace symplant::view
