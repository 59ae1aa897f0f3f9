// Pairs as JSON, for programs.
#include "learn/pairs_formats.hpp"

namespace symplant::learn {
namespace {

using model::PlantModel;

void write_follows(const Follows& follows, view::JsonWriter& json) {
  json.begin_object();
  json.member("changes", follows.changes);
  json.member("hits", follows.hits);
  json.member("event_changes", follows.effects);
  json.member("median", follows.median);
  json.member("min", follows.least);
  json.member("max", follows.most);
  json.end_object();
}

void write_chance(const Chance& chance, view::JsonWriter& json) {
  json.begin_object();
  json.member("trials", kTrials);
  json.member("changes", chance.changes);
  json.member("hits", chance.hits);
  json.member("most", chance.most);
  json.member("mean", chance.mean);
  json.end_object();
}

void write_pair(const Pair& pair, const PlantModel& plant, view::JsonWriter& json) {
  json.begin_object();
  json.member("operation", plant.symbols[pair.operation].name());
  json.member("event", plant.symbols[pair.event].name());
  json.member("inverted", pair.inverted);
  json.member("operation_is_named", pair.named);
  json.key("on");
  write_follows(pair.on, json);
  json.member("follows_off", pair.follows_off());
  json.key("off");
  write_follows(pair.off, json);
  json.key("chance");
  write_chance(pair.chance, json);
  json.end_object();
}

void write_names(std::string_view key, const std::vector<std::uint32_t>& symbols, const PlantModel& plant,
                 view::JsonWriter& json) {
  json.key(key);
  json.array(symbols, [&](std::uint32_t symbol) { json.value(plant.symbols[symbol].name()); });
}

}  // namespace

void write_pairs(const Pairs& pairs, const PlantModel& plant, view::JsonWriter& json) {
  json.begin_object();
  json.member("length", pairs.length);
  json.member("resolution", pairs.resolution);
  json.member("seed", pairs.seed);
  json.member("operations", pairs.operations);
  json.member("events", pairs.events);
  json.key("pairs");
  json.array(pairs.pairs, [&](const Pair& pair) { write_pair(pair, plant, json); });
  json.key("fan_outs");
  json.array(pairs.fan_outs, [&](const FanOut& fan_out) {
    json.begin_object();
    json.member("operation", plant.symbols[fan_out.operation].name());
    write_names("events", fan_out.events, plant, json);
    json.end_object();
  });
  json.key("interlocks");
  json.array(pairs.interlocks, [&](const Interlock& interlock) {
    json.begin_object();
    json.member("event", plant.symbols[interlock.event].name());
    json.member("kind", interlock.kind == Interlock::Kind::together ? "together" : "alternate");
    write_names("operations", interlock.operations, plant, json);
    json.end_object();
  });
  json.end_object();
}

}  // namespace symplant::learn
