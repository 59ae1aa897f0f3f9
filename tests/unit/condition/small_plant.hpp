// A plant of a few names, for the tests of conditions and formulas.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "symplant/condition/resolve.hpp"
#include "symplant/tables/nearest.hpp"

namespace symplant::test {

/// Devices AGV (0), DOOR (1) with a state `moving`, and a facet DOOR.LOCK (2); some symbols; a track CV1 (0) and a
/// place BOX (1) with parts of the kinds raw (0) and done (1). Values TANK.level (0), flow (1) and BOOM (2 to 4).
class SmallPlant final : public condition::Names {
 public:
  std::optional<std::uint32_t> unit(std::string_view device, std::string_view facet) const override {
    if (device == "AGV" && facet.empty()) return 0;
    if (device == "DOOR" && facet.empty()) return 1;
    if (device == "DOOR" && facet == "LOCK") return 2;
    return std::nullopt;
  }
  std::vector<std::uint32_t> facets(std::string_view device) const override {
    if (device == "DOOR") return {2};
    if (device == "LIFT") return {3, 4};
    return {};
  }
  std::string path(std::uint32_t unit) const override { return unit == 3 ? "LIFT.A" : unit == 4 ? "LIFT.B" : "?"; }
  std::optional<std::uint8_t> state(std::uint32_t unit, std::string_view name) const override {
    for (std::size_t s = 0; s < states_[unit].size(); ++s) {
      if (states_[unit][s] == name) return static_cast<std::uint8_t>(s);
    }
    return std::nullopt;
  }
  std::optional<Symbol> symbol(std::string_view name) const override {
    const auto found = symbols_.find(name);
    return found == symbols_.end() ? std::nullopt : std::optional(found->second);
  }
  std::optional<std::uint32_t> location(std::string_view name) const override {
    return name == "CV1" ? std::optional(0U) : name == "BOX" ? std::optional(1U) : std::nullopt;
  }
  std::optional<std::uint32_t> part_kind(std::string_view name) const override {
    return name == "raw" ? std::optional(0U) : name == "done" ? std::optional(1U) : std::nullopt;
  }
  std::optional<Value> value(std::string_view name) const override {
    if (name == "TANK.level") return Value{0, 1};
    if (name == "flow") return Value{1, 1};
    return name == "BOOM" ? std::optional(Value{2, 3}) : std::nullopt;
  }
  std::string nearest_value(std::string_view name) const override { return near(name, {"TANK.level", "flow", "BOOM"}); }
  std::string nearest_part_kind(std::string_view name) const override { return near(name, {"raw", "done"}); }
  std::string nearest_device(std::string_view device, std::string_view) const override {
    return near(device, {"AGV", "DOOR", "CV1"});
  }
  std::string nearest_state(std::uint32_t unit, std::string_view name) const override {
    return near(name, states_[unit]);
  }
  std::string nearest_symbol(std::string_view name) const override { return near(name, {"START", "LEVEL"}); }
  std::string why_no_state(std::uint32_t, std::string_view name) const override {
    return name == "BUSY" ? "`BUSY` is only an event" : "";
  }

 private:
  static std::string near(std::string_view wanted, const std::vector<std::string_view>& names) {
    tables::NearestName nearest(wanted);
    for (const std::string_view name : names) nearest.offer(name);
    return std::string(nearest.name());
  }

  std::vector<std::vector<std::string_view>> states_{
      {"P1", "P2"}, {"OPEN", "moving"}, {"SHUT"}, {"UP"}, {"UP", "DOWN"}};
  std::map<std::string_view, Symbol> symbols_{{"START", {7, tables::DataType::boolean}},
                                              {"LEVEL", {8, tables::DataType::int_}},
                                              {"SPEED", {9, tables::DataType::real}}};
};

}  // namespace symplant::test
