// A plant of the reference with material flow that a test gives by names and texts of conditions.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "bench.hpp"
#include "support/reference/lines.hpp"
#include "symplant/condition/resolve.hpp"

namespace symplant::test {

inline constexpr tables::Time kS = tables::kSecond;
inline constexpr std::int64_t kMm = 1000;  ///< in um

/// Symbols by their names without `L_P_`, states of units, tracks, places and kinds.
class MaterialNames : public condition::Names {
 public:
  explicit MaterialNames(const model::PlantModel& model) : model_(model) {}

  std::optional<std::uint32_t> unit(std::string_view device, std::string_view) const override {
    return index_of(model_.units, [&](const model::Unit& unit) { return unit.path.substr(4) == device; });
  }
  std::vector<std::uint32_t> facets(std::string_view) const override { return {}; }
  std::string path(std::uint32_t unit) const override { return std::string(model_.units[unit].path); }
  std::optional<std::uint8_t> state(std::uint32_t unit, std::string_view name) const override {
    const auto found =
        index_of(model_.units[unit].states, [&](const model::State& state) { return state.name == name; });
    return found ? std::optional<std::uint8_t>(static_cast<std::uint8_t>(*found)) : std::nullopt;
  }
  std::optional<Symbol> symbol(std::string_view name) const override {
    const auto found =
        index_of(model_.symbols, [&](const model::Symbol& symbol) { return symbol.name().substr(4) == name; });
    return found ? std::optional<Symbol>({*found, model_.symbols[*found].type}) : std::nullopt;
  }
  std::optional<std::uint32_t> location(std::string_view name) const override {
    const model::Material& material = model_.material;
    const auto track = index_of(material.tracks, [&](const model::Track& it) { return it.name == name; });
    if (track) return track;
    const auto place = index_of(material.places, [&](const model::Place& it) { return it.name == name; });
    return place ? std::optional<std::uint32_t>(*place + static_cast<std::uint32_t>(material.tracks.size()))
                 : std::nullopt;
  }
  std::optional<std::uint32_t> part_kind(std::string_view name) const override {
    return index_of(model_.material.kinds, [&](const model::PartKind& kind) { return kind.name == name; });
  }
  std::string nearest_device(std::string_view, std::string_view) const override { return {}; }
  std::string nearest_state(std::uint32_t, std::string_view) const override { return {}; }
  std::string nearest_symbol(std::string_view) const override { return {}; }
  std::string why_no_state(std::uint32_t, std::string_view) const override { return {}; }

 private:
  template <class List, class Is>
  static std::optional<std::uint32_t> index_of(const List& list, Is is) {
    for (std::uint32_t i = 0; i < list.size(); ++i) {
      if (is(list[i])) return i;
    }
    return {};
  }

  const model::PlantModel& model_;
};

/// Two kinds, `raw` (code 1) and `done` (code 2), 200 mm long; then what a test adds. `when` and the like name
/// locations that the material already has.
class Flow {
 public:
  /// Names as for Bench; those with `_N_` are of type UDINT.
  explicit Flow(const std::vector<std::string>& names, Said said = {})
      : analysed_(analyse_described(rows_of(names), at_once(std::move(said)).description)), model(analysed_.model()) {
    for (const description::DescriptionFault& fault : analysed_.evidence().faults) FAIL(fault.message);
    model.material.kinds = {{"raw", 200 * kMm, 1}, {"done", 200 * kMm, 2}};
  }

  condition::Tree when(const std::string& text) const {
    auto tree = condition::parse_and_resolve(text, MaterialNames(model));
    if (const auto* fault = std::get_if<condition::Fault>(&tree)) FAIL(text << ": " << fault->message);
    return std::get<condition::Tree>(tree);
  }
  std::uint32_t symbol(const std::string& name) const { return MaterialNames(model).symbol(name).value().index; }
  std::uint32_t at(const std::string& name) const { return MaterialNames(model).location(name).value(); }

  model::Track& track(const std::string& name, std::int64_t length) {
    model::Track& track = model.material.tracks.emplace_back();
    track.name = name;
    track.length = length;
    return track;
  }
  /// A drive with a constant speed in um/s. An empty condition never holds.
  model::Drive drive(std::int64_t until, const std::string& forward, const std::string& backward,
                     std::int64_t speed) const {
    model::Drive drive;
    drive.until = until;
    if (!forward.empty()) drive.forward = when(forward);
    if (!backward.empty()) drive.backward = when(backward);
    drive.speed = speed;
    return drive;
  }
  model::PartSensor sensor(const std::string& name, std::int64_t at = 0) const {
    model::PartSensor sensor;
    sensor.symbol = symbol(name);
    sensor.at = at;
    return sensor;
  }
  void place(const std::string& name, std::uint32_t holds = 1) {
    model.material.places.emplace_back().name = name;
    model.material.places.back().holds = holds;
  }
  model::Transfer& transfer(tables::PartLocation from, tables::PartLocation to, const std::string& condition = "") {
    model::Transfer& transfer = model.material.transfers.emplace_back();
    transfer.name = "T" + std::to_string(model.material.transfers.size());
    transfer.from = from;
    transfer.to = to;
    if (!condition.empty()) transfer.condition = when(condition);
    return transfer;
  }
  model::Source& source(tables::PartLocation to) {
    model::Source& source = model.material.sources.emplace_back();
    source.name = "infeed";
    source.to = to;
    source.kinds = {0};
    return source;
  }

  /// Ends the description; the plant is reset.
  reference::Plant& plant() {
    if (!plant_) plant_ = std::make_unique<reference::Plant>(model);
    return *plant_;
  }
  Flow& set(const std::string& name, std::uint64_t value) {
    plant().set_operation(symbol(name), value);
    return *this;
  }
  Flow& run(tables::Time to) {
    plant().advance_to(to);
    return *this;
  }
  bool put(const std::string& location, std::int64_t at = tables::kWhole, std::uint32_t kind = 0) {
    return plant().put({this->at(location), at}, kind);
  }

  /// The fronts in um, and speeds, from the front: "1400000/0 900000/400000".
  std::string parts(std::uint32_t track = 0) {
    const reference::World& world = plant().save();
    std::string text;
    for (const reference::PartWorld& part : world.material.tracks[track].parts) {
      const std::int64_t x = part.x(world.time);
      text += (text.empty() ? "" : " ") + std::to_string(x / reference::kMicrometer);
      if (x % reference::kMicrometer != 0) text += "+" + std::to_string(x % reference::kMicrometer);
      text += "/" + std::to_string(part.v);
    }
    return text;
  }
  std::size_t count(const std::string& location) { return plant().save().material.at(at(location)).size(); }
  /// The lines of trace and findings since the last call, without their braces and quotes, one per line.
  std::string lines() {
    std::string text;
    const auto add = [&](const std::vector<std::string>& lines) {
      for (const std::string& line : lines) {
        for (const char c : line) text += c == '"' || c == '{' || c == '}' ? "" : std::string(1, c);
        text += '\n';
      }
    };
    add(reference::trace_lines(model, plant().instants()));
    add(reference::finding_lines(model, plant().instants()));
    plant().clear_instants();
    return text;
  }

 private:
  /// Devices move in no time.
  static Said at_once(Said said) {
    said.description.defaults.travel = 0;
    return said;
  }
  static std::vector<Row> rows_of(std::vector<std::string> names) {
    for (std::string& name : names) name.insert(0, "L_P_");
    std::vector<Row> rows = bits(names);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (rows[i].name.find("_N_") == std::string::npos) continue;
      rows[i].type = "UDINT";
      rows[i].iec = (rows[i].name.find("_O_") != std::string::npos ? "%QD" : "%ID") + std::to_string(100 + i);
    }
    return rows;
  }

  Analysed analysed_;

 public:
  model::PlantModel model;

 private:
  std::unique_ptr<reference::Plant> plant_;
};

}  // namespace symplant::test
