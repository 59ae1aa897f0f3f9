// Compares parts, their changes, and what moves them.
#include "property/part_differences.hpp"

#include <algorithm>
#include <cstdlib>

#include "property/value_differences.hpp"
#include "support/reference/lines.hpp"

namespace symplant::property {
namespace {

std::string location_text(std::uint32_t location, const model::Material& material) {
  if (location == tables::kOut) return "out";
  if (location >= material.locations()) return "#" + std::to_string(location);
  return material.location_name(location);
}

std::string kind_text(std::uint32_t kind, const model::Material& material) {
  return kind < material.kinds.size() ? material.kinds[kind].name : "#" + std::to_string(kind);
}

std::string part_text(std::uint64_t number, std::uint32_t kind, std::int64_t x, const model::Material& material) {
  return std::to_string(number) + " " + kind_text(kind, material) + " at " + std::to_string(x) + " um";
}

std::string parts_of_engine(const plant::Plant& engine, std::uint32_t location, const model::Material& material) {
  std::string text;
  for (std::uint32_t i = 0; i < engine.parts(location); ++i) {
    const plant::PartView part = engine.part(location, i);
    text += "(" + part_text(part.number, part.kind, part.x, material) + ") ";
  }
  return text;
}

std::string parts_of_reference(const reference::Plant& reference, std::uint32_t location,
                               const model::Material& material) {
  const reference::World& world = reference.save();
  std::string text;
  for (const reference::PartWorld& part : world.material.at(location)) {
    const std::int64_t x = material.is_track(location) ? part.x(world.time) / reference::kMicrometer : 0;
    text += "(" + part_text(part.number, part.kind, x, material) + ") ";
  }
  return text;
}

std::string unequal_parts(const std::string& what, const std::string& engine, const std::string& reference) {
  return engine == reference ? "" : what + "\n  engine:    " + engine + "\n  reference: " + reference;
}

std::string instant_text(const reference::InstantRecord& record, const model::PlantModel& plant) {
  std::string text = "t=" + std::to_string(record.time);
  for (const auto& [symbol, value] : record.changes) {
    text.append(" ").append(plant.symbols[symbol].name()).append("=").append(std::to_string(value));
  }
  for (const tables::Finding& finding : record.findings) {
    text.append(" {").append(reference::finding_name(finding.kind)).append(" ").append(std::to_string(finding.of));
    text += "}";
  }
  for (const std::string& part : part_texts(record, plant)) text += " [" + part + "]";
  for (const auto& [name, number] : record.values) text += " " + name + " is " + number_text(number);
  return text;
}

}  // namespace

std::string disturbance(const reference::Plant& undisturbed, const reference::Plant& disturbed,
                        const model::PlantModel& plant) {
  const auto difference = [](const std::string& what, const std::string& with, const std::string& without) {
    return "a further instant changed the reference: " + what + "\n  with:    " + with + "\n  without: " + without;
  };
  const auto& with = disturbed.instants();
  const auto& without = undisturbed.instants();
  for (std::size_t i = 0; i < std::max(with.size(), without.size()); ++i) {
    const std::string one = i < with.size() ? instant_text(with[i], plant) : "nothing";
    const std::string other = i < without.size() ? instant_text(without[i], plant) : "nothing";
    if (one != other) return difference("instant", one, other);
  }
  if (disturbed.state_hash() != undisturbed.state_hash()) {
    return difference("state_hash at " + std::to_string(disturbed.now()), "", "");
  }
  return {};
}

std::optional<tables::PartLocation> part_location(const model::Material& material, const std::string& text) {
  const std::size_t end = std::min(text.find('@'), text.size());
  for (std::uint32_t i = 0; i < material.locations(); ++i) {
    if (material.location_name(i) != text.substr(0, end)) continue;
    if (end == text.size()) return tables::PartLocation{i, tables::kWhole};
    const std::int64_t at = std::strtoll(text.c_str() + end + 1, nullptr, 10);
    if (!material.is_track(i) || at < 0 || at > material.tracks[i].length) return {};
    return tables::PartLocation{i, at};
  }
  return {};
}

std::vector<std::string> part_texts(const reference::InstantRecord& record, const model::PlantModel& plant) {
  using What = engine::PartChange::What;
  const model::Material& material = plant.material;
  std::vector<std::string> texts;
  for (const engine::PartChange& change : record.parts) {
    std::string text = std::to_string(change.number) + " " + kind_text(change.kind, material);
    if (change.what == What::changed) text += " changed";
    if (change.what == What::moved) text += " from " + location_text(change.from, material);
    if (change.what != What::changed) text += " to " + location_text(change.to, material);
    const bool on_track = change.what != What::changed && material.is_track(change.to);
    if (on_track) text += " at " + std::to_string(change.x);
    texts.push_back(text + (change.by_hand ? " by hand" : ""));
  }
  return texts;
}

std::string parts_difference(const plant::Plant& engine, const reference::Plant& reference,
                             const model::PlantModel& plant) {
  const model::Material& material = plant.material;
  const reference::MaterialWorld& world = reference.save().material;
  std::string text;
  for (std::uint32_t i = 0; text.empty() && i < material.locations(); ++i) {
    text = unequal_parts("parts of " + material.location_name(i), parts_of_engine(engine, i, material),
                         parts_of_reference(reference, i, material));
  }
  for (std::uint32_t i = 0; text.empty() && i < material.kinds.size(); ++i) {
    if (engine.parts_made(i) != world.made[i]) text = "parts_made of " + material.kinds[i].name;
    if (engine.parts_gone(i) != world.gone[i]) text = "parts_gone of " + material.kinds[i].name;
  }
  for (std::uint32_t i = 0; text.empty() && i < material.tracks.size(); ++i) {
    if (engine.is_frozen_track(i) != world.tracks[i].frozen) text = "is_frozen_track of " + material.tracks[i].name;
  }
  for (std::uint32_t i = 0; text.empty() && i < material.transfers.size(); ++i) {
    const plant::TransferView view = engine.transfer(i);
    if (view.blocked != world.transfers[i].blocked) {
      text = unequal_parts("blocked of transfer " + material.transfers[i].name, view.blocked ? "yes" : "no",
                           world.transfers[i].blocked ? "yes" : "no");
    }
    if (view.frozen != world.transfers[i].frozen) text = "frozen of transfer " + material.transfers[i].name;
  }
  return text;
}

}  // namespace symplant::property
