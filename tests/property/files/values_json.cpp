// Values, signals and `plain` of a plant.json.
#include "property/files/values_json.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "property/files/json_printer.hpp"

namespace symplant::property::files {
namespace {

using description::GivenSignal;
using description::GivenValue;
using nlohmann::json;
using tables::ValueKind;

class ValueWriter {
 public:
  ValueWriter(Sayer& sayer, Counts& counts) : sayer_(sayer), counts_(counts) {}

  json value(const GivenValue& given) {
    json said = json::object();
    kind(said, given);
    if (!given.unit.empty()) said["unit"] = given.unit;
    if (given.min) said["min"] = *given.min;
    if (given.max) said["max"] = *given.max;
    if (given.start) said["start"] = *given.start;
    if (!given.start_states.empty()) said["start"] = given.start_states;
    if (given.time) said["time"] = sayer_.time(*given.time);
    if (given.step) said[given.kind == ValueKind::noise ? "every" : "step"] = sayer_.time(*given.step);
    if (given.trace) said["trace"] = *given.trace == 0 ? json(false) : json(sayer_.time(*given.trace));
    for (const description::GivenChange& change : given.changes) {
      said["changes"].push_back({{"when", sayer_.condition(change.when)}, {"to", change.to}});
      ++counts_[Seen::jumps];
    }
    ++counts_[Seen::values];
    return said;
  }

  json signal(const GivenSignal& given) {
    ++counts_[Seen::signals];
    const bool alone = !given.from && !given.to && !given.limit && given.noise == 0 && !given.every;
    if (alone && sayer_.dice.percent(60)) return given.of;
    json said = {{"of", given.of}};
    if (given.from) said["from"] = *given.from;
    if (given.to) said["to"] = *given.to;
    if (given.limit) said["limit"] = *given.limit;
    if (given.noise != 0) said["noise"] = given.noise;
    if (given.every) said["every"] = sayer_.time(*given.every);
    return said;
  }

 private:
  void kind(json& said, const GivenValue& given) {
    const std::string key(tables::value_kind_name(given.kind));
    switch (given.kind) {
      case ValueKind::parameter:
        return;
      case ValueKind::position:
        said[key] = sayer_.name(given.formula);
        for (const auto& [state, at] : given.at) said["at"][state] = at;
        return;
      case ValueKind::noise:
        said[key] = given.noise;
        return;
      case ValueKind::pid:
        said[key] = {{"of", given.of}, {"to", given.to}, {"kp", given.kp}};
        if (given.ti) said[key]["ti"] = sayer_.time(*given.ti);
        if (given.td != 0 || sayer_.dice.percent(20)) said[key]["td"] = sayer_.time(given.td);
        return;
      case ValueKind::linear:
        said[key] = {{"a", given.a}, {"b", given.b}, {"c", given.c}, {"u", given.u}};
        if (!given.d.empty()) said[key]["d"] = given.d;
        return;
      case ValueKind::ramp:
        said["up"] = given.up;
        if (!given.down.empty()) said["down"] = given.down;
        [[fallthrough]];
      default:
        said[key] = given.formula;
    }
  }

  Sayer& sayer_;
  Counts& counts_;
};

}  // namespace

void add_values(json& said, const description::Description& description, Sayer& sayer, Counts& counts) {
  ValueWriter writer(sayer, counts);
  for (const GivenValue& given : description.values) {
    said["values"][given.name] = writer.value(given);
    said["values"][kOrder].push_back(given.name);
  }
  for (const GivenSignal& given : description.signals) said["signals"][sayer.name(given.symbol)] = writer.signal(given);
  for (const std::string& symbol : description.plain) said["plain"].push_back(sayer.name(symbol));
}

}  // namespace symplant::property::files
