// The utilization of a plant as JSON.
#include <fmt/format.h>

#include <array>
#include <string_view>

#include "symplant/trace/json_text.hpp"
#include "symplant/trace/utilization_text.hpp"
#include "symplant/trace/value_text.hpp"

namespace symplant::trace {
namespace {

void put_name(std::string& json, std::string_view name) {
  put_comma(json);
  json += json_string(name) + ":";
}

/// `{"moving":1,"blocked":2}`
template <std::size_t N>
void put_times(std::string& json, const std::array<std::string_view, N>& names,
               const std::array<tables::Time, N>& times) {
  json += '{';
  for (std::size_t i = 0; i < N; ++i) put(json, "{}\"{}\":{}", i == 0 ? "" : ",", names[i], times[i]);
  json += '}';
}

/// `"count":2,"least":1,"mean":1,"greatest":1,"last":1`
void put_members(std::string& json, const Durations& of) {
  put(json, R"("count":{},"least":{},"mean":{},"greatest":{},"last":{})", of.count, of.least, of.mean(), of.greatest,
      of.last);
}

/// `[2,1,1,1,1]`
void put_row(std::string& json, const Durations& of) {
  put(json, "[{},{},{},{},{}]", of.count, of.least, of.mean(), of.greatest, of.last);
}

/// The numbers of parts that left, and the times between them.
void put_exit(std::string& json, const Intervals& exits) {
  put(json, R"({{"parts":{},"cycle":)", exits.events);
  if (exits.between.count == 0) {
    json += "null}";
    return;
  }
  json += '{';
  put_members(json, exits.between);
  json += "}}";
}

void put_device(std::string& json, const PlantNames& names, std::uint32_t unit, const DeviceUse& use,
                bool with_malfunctions) {
  json += "{\"times\":";
  put_times(json, kActivityNames, use.times);
  if (with_malfunctions) put(json, ",\"malfunction\":{}", use.malfunction);
  json += ",\"states\":{";
  for (std::size_t state = 0; state < use.states.size(); ++state) {
    put_name(json, names.state(unit, static_cast<std::uint8_t>(state)));
    put(json, "{}", use.states[state]);
  }
  json += "},\"moves\":[";
  for (const MoveUse& move : use.moves) {
    put_comma(json);
    put(json, R"({{"from":{},"to":{},"time":{},)", json_string(names.state(unit, move.from)),
        json_string(names.state(unit, move.to)), move.time);
    put_members(json, move.whole);
    json += '}';
  }
  json += "],\"cycle\":";
  if (use.cycle) {
    put(json, "{{\"state\":{},", json_string(names.state(unit, use.cycle->state)));
    put_members(json, use.cycle->times);
    json += "}}";
  } else {
    json += "null}";
  }
}

void put_begin(std::string& json, const Utilization& utilization, tables::Time now) {
  put(json, R"({{"from":{},"to":{},"devices":)", utilization.from(), now);
}

std::uint32_t count(std::size_t size) { return static_cast<std::uint32_t>(size); }

}  // namespace

std::string device_use_json(const Utilization& utilization, std::uint32_t unit, tables::Time now,
                            bool with_malfunctions) {
  std::string json;
  put_device(json, utilization.names(), unit, utilization.device(unit, now), with_malfunctions);
  return json;
}

std::string utilization_json(const Utilization& utilization, tables::Time now) {
  const PlantNames& names = utilization.names();
  std::string json;
  put_begin(json, utilization, now);
  json += '{';
  for (std::uint32_t unit = 0; unit < count(names.tables().units.size()); ++unit) {
    put_name(json, names.unit(unit));
    put_device(json, names, unit, utilization.device(unit, now), true);
  }
  json += "},\"locations\":{";
  for (std::uint32_t location = 0; location < names.tables().material.locations(); ++location) {
    const LocationUse use = utilization.parts().location(location, now);
    put_name(json, names.location(location));
    json += "{\"times\":";
    put_times(json, kOccupationNames, use.times);
    put(json, R"(,"starves":{},"came":{},"left":{},"exit":)", use.starves, use.came, use.left);
    put_exit(json, use.exits);
    json += '}';
  }
  json += "},\"exits\":";
  put_exit(json, utilization.parts().exits());
  return json + "}";
}

std::string utilization_table_json(const Utilization& utilization, tables::Time now, bool with_malfunctions) {
  const tables::PlantTables& tables = utilization.names().tables();
  const Durations none;
  std::string json;
  put_begin(json, utilization, now);
  json += '[';
  for (std::uint32_t unit = 0; unit < count(tables.units.size()); ++unit) {
    const DeviceUse use = utilization.device(unit, now);
    put_comma(json);
    put(json, "[[{}],{},{},", fmt::join(use.times, ","), with_malfunctions ? use.malfunction : 0, use.arrivals());
    put_row(json, use.cycle ? use.cycle->times : none);
    json += ']';
  }
  json += "],\"locations\":[";
  for (std::uint32_t location = 0; location < tables.material.locations(); ++location) {
    const LocationUse use = utilization.parts().location(location, now);
    put_comma(json);
    put(json, "[[{}],{},{},{},{},", fmt::join(use.times, ","), use.starves, use.came, use.left, use.exits.events);
    put_row(json, use.exits.between);
    json += ']';
  }
  put(json, "],\"exits\":[{},", utilization.parts().exits().events);
  put_row(json, utilization.parts().exits().between);
  return json + "]}";
}

}  // namespace symplant::trace
