// Resolves the names, locations and conditions in entries of the material flow, and reports those that are invalid.
#include "elements/material/lookup.hpp"

#include <utility>
#include <variant>

#include "symplant/tables/length.hpp"
#include "text/ascii.hpp"

namespace symplant::model {

using description::FaultKind;
using description::Pointer;
using description::ticked;

bool is_out(std::string_view text) { return text::equal_ignoring_case(tables::split_location(text).name, "out"); }

void check_position(const Track& track, std::int64_t at, const Pointer& here, description::Faults& faults) {
  if (track.length == 0 || at <= track.length) return;
  faults.add(here, "this position is beyond the end of track " + ticked(track.name));
}

MaterialLookup::MaterialLookup(const PlantModel& plant, const text::ByName<bool>& rejected, description::Faults& faults)
    : plant_(plant), rejected_(rejected), faults_(faults), names_(plant, faults) {}

Pointer MaterialLookup::begin(std::string_view list, const MadeBy& by) {
  made_for_device_ = !by.pattern.empty();
  lacking_ = by.lacking;
  return material_pointer(list, by);
}

void MaterialLookup::unknown(const Pointer& here, std::string message) {
  if (!made_for_device_) {
    faults_.add(here, std::move(message), FaultKind::unknown_name);
  } else if (lacking_.empty()) {
    lacking_ = std::move(message);
  }
}

bool MaterialLookup::condition(const std::string& text, const Pointer& here, condition::Tree& tree) {
  if (text.empty()) return false;
  auto parsed = condition::parse(text);
  if (auto* fault = std::get_if<condition::Fault>(&parsed)) {
    faults_.add(here, (made_for_device_ ? ticked(text) + ": " : std::string()) + fault->message, FaultKind::condition,
                made_for_device_ ? 0 : fault->index.offset);
    return false;
  }
  auto resolved = condition::resolve(std::get<condition::Expression>(parsed), names_);
  if (auto* found = std::get_if<condition::Tree>(&resolved)) {
    tree = std::move(*found);
    return true;
  }
  auto& fault = std::get<condition::Fault>(resolved);
  if (!made_for_device_) {
    faults_.add(here, std::move(fault.message), FaultKind::condition, fault.index.offset);
  } else if (lacking_.empty()) {
    lacking_ = std::move(fault.message);
  }
  return false;
}

std::optional<condition::Tree> MaterialLookup::condition(const std::string& text, const Pointer& here) {
  condition::Tree tree;
  if (!condition(text, here, tree)) return std::nullopt;
  return tree;
}

void MaterialLookup::number(const std::string& name, const Pointer& here, Drive& drive) {
  if (const auto value = names_.value(name)) {
    drive.output = value->output;
    if (value->outputs > 1)
      faults_.add(here, ticked(name) + " has several outputs; name an `is` value with one of them");
    return;
  }
  const auto symbol = names_.symbol(name);
  if (!symbol) {
    const std::string value = names_.nearest_value(name);
    const std::string what = plant_.values.empty() ? "symbol " : "symbol or value ";
    unknown(here, description::missing(what + ticked(name), value.empty() ? names_.nearest_symbol(name) : value));
  } else if (symbol->type == tables::DataType::boolean) {
    faults_.add(here, ticked(name) + " is BOOL; name a numeric symbol or a value");
  } else {
    drive.symbol = symbol->index;
  }
}

std::uint32_t MaterialLookup::sensor_symbol(const std::string& name) const {
  const auto symbol = names_.symbol(name);
  const bool marked = symbol && plant_.symbols[symbol->index].account == Account::senses_parts;
  return marked ? symbol->index : kNone;
}

std::uint32_t MaterialLookup::kind(const std::string& name, const Pointer& here) {
  if (const auto found = names_.part_kind(name)) return *found;
  if (name.empty()) return kNone;
  unknown(here, description::missing("kind of part " + ticked(name), names_.nearest_part_kind(name)));
  return kNone;
}

tables::PartLocation MaterialLookup::location(const std::string& text, const Pointer& here) {
  if (text.empty()) return {};
  const tables::LocationText parts = tables::split_location(text);
  if (const auto found = names_.location(parts.name)) {
    return parts.has_position ? position(*found, parts.position, here) : tables::PartLocation{*found, tables::kWhole};
  }
  if (is_out(text)) {
    faults_.add(here, "`out` is only a target of transfers and of the ends of tracks; name a track or a place");
  } else if (!rejected_.contains(parts.name)) {
    unknown(here, description::missing("track or place " + ticked(parts.name), nearest_location(parts.name)));
  }
  return {};
}

tables::PartLocation MaterialLookup::position(std::uint32_t location, std::string_view text, const Pointer& here) {
  const std::string& name = plant_.material.location_name(location);
  const auto length = tables::parse_length(text);
  if (!plant_.material.is_track(location)) {
    faults_.add(here, ticked(name) + " is a place and has no positions; remove `@` and the position");
  } else if (!length) {
    faults_.add(here, "the position of " + ticked(name) +
                          " is not a length in whole micrometers; write a number and um, mm, cm or m, such as " +
                          ticked(name + "@300 mm"));
  } else {
    check_position(plant_.material.tracks[location], *length, here, faults_);
    return {location, *length};
  }
  return {};
}

tables::PartLocation MaterialLookup::target(const std::string& text, const Pointer& here) {
  if (!is_out(text)) return location(text, here);
  if (tables::split_location(text).has_position)
    faults_.add(here, "`out` has no positions; remove `@` and the position");
  return {};
}

std::uint32_t MaterialLookup::end(const std::string& text, const Pointer& here) {
  const tables::LocationText parts = tables::split_location(text);
  if (!parts.has_position) return target(text, here).location;
  faults_.add(here, "parts arrive at the start of a track, not at a position; write " + ticked(parts.name));
  return tables::kOut;
}

std::string MaterialLookup::nearest_location(std::string_view name) const {
  return std::string(faults_.nearest(name, plant_.material.locations(), [&](std::size_t i) -> std::string_view {
    return plant_.material.location_name(static_cast<std::uint32_t>(i));
  }));
}

}  // namespace symplant::model
