// Lines of traces and findings. Names of random plants need no escapes.
#include "support/reference/lines.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>

#include "support/reference/values.hpp"

namespace symplant::reference {
namespace {

/// With the fewest digits that read back; with an exponent below 1e-4 and from 1e16 on.
template <class Number>
std::string shortest(Number number) {
  std::array<char, 64> text;
  const Number size = std::abs(number);
  const bool plain = size == 0 || (size >= static_cast<Number>(1e-4) && size < static_cast<Number>(1e16));
  const auto format = plain ? std::chars_format::fixed : std::chars_format::scientific;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number, format).ptr;
  return {text.data(), end};
}

std::string real_text(tables::DataType type, double number) {
  if (std::isnan(number)) return "\"nan\"";
  if (std::isinf(number)) return number > 0 ? "\"inf\"" : "\"-inf\"";
  return type == tables::DataType::real ? shortest(static_cast<float>(number)) : shortest(number);
}

/// A value that a double cannot hold exactly is a string.
std::string whole_text(bool is_signed, std::uint64_t value) {
  constexpr std::uint64_t kExact = std::uint64_t{1} << 53;
  const bool negative = is_signed && static_cast<std::int64_t>(value) < 0;
  const std::uint64_t magnitude = negative ? 0 - value : value;
  const std::string text = (negative ? "-" : "") + std::to_string(magnitude);
  return magnitude > kExact ? '"' + text + '"' : text;
}

std::string value_text(tables::DataType type, std::uint64_t value) {
  using tables::DataType;
  if (type == DataType::boolean) return value != 0 ? "true" : "false";
  if (type == DataType::real || type == DataType::lreal) return real_text(type, std::bit_cast<double>(value));
  return whole_text(type >= DataType::sint && type <= DataType::lint, value);
}

/// A member of an instantaneous loop.
std::string member_name(const model::PlantModel& model, std::size_t of) {
  if (of < model.units.size()) return std::string(model.units[of].path);
  of -= model.units.size();
  if (of < model.follows.size()) return std::string(model.symbols[model.follows[of].symbol].name());
  of -= model.follows.size();
  const model::Material& material = model.material;
  if (of < material.tracks.size()) return material.tracks[of].name;
  of -= material.tracks.size();
  if (of < material.transfers.size()) return material.transfers[of].name;
  of -= material.transfers.size();
  if (of < material.work.size()) return material.work[of].name;
  of -= material.work.size();
  if (of < material.sources.size()) return material.sources[of].name;
  of -= material.sources.size();
  return of < model.malfunctions.size() ? model.malfunctions[of].name
                                        : value_names(model)[of - model.malfunctions.size()];
}

std::string name_of(const model::PlantModel& model, const tables::Finding& finding) {
  using tables::FindingKind;
  switch (finding.kind) {
    case FindingKind::conflicting_operations:
    case FindingKind::stopped_under_another_command:
    case FindingKind::started_on_enabling:
    case FindingKind::overrun:
      return std::string(model.units[finding.of].path);
    case FindingKind::instantaneous_loop:
      return member_name(model, finding.of);
    case FindingKind::part_blocked:
      return model.material.transfers[finding.of].name;
    case FindingKind::value_not_finite:
      return value_names(model)[finding.of];
    case FindingKind::requirement_violated:
      return model.requirements[finding.of].name;
    default:
      return std::string(model.symbols[finding.of].name());
  }
}

/// Names of malfunctions may contain blanks.
std::string separator(const model::PlantModel& model, const tables::Finding& finding) {
  const std::size_t malfunctions = model.units.size() + model.follows.size() + model.material.tracks.size() +
                                   model.material.transfers.size() + model.material.work.size() +
                                   model.material.sources.size();
  const bool of_malfunction = finding.of >= malfunctions && finding.of < malfunctions + model.malfunctions.size();
  return of_malfunction ? ", " : " ";
}

std::string part_line(const model::Material& material, Time time, const engine::PartChange& change) {
  using What = engine::PartChange::What;
  const auto location = [&](std::uint32_t of) { return of == tables::kOut ? "out" : material.location_name(of); };
  std::string line = "{\"t\":" + std::to_string(time) + ",\"part\":" + std::to_string(change.number) + ",\"kind\":\"" +
                     material.kinds[change.kind].name + "\"";
  if (change.what == What::moved) line += ",\"from\":\"" + location(change.from) + "\"";
  if (change.what != What::changed) {
    line += ",\"to\":\"" + location(change.to) + "\"";
    const bool on_track = change.to != tables::kOut && material.is_track(change.to);
    if (on_track) line += ",\"x\":" + std::to_string(change.x);
  }
  return line + (change.by_hand ? ",\"by\":\"hand\"}" : "}");
}

std::string malfunction_line(const model::PlantModel& model, Time time, const engine::MalfunctionChange& change) {
  static constexpr std::array<std::string_view, 6> kBy = {"scenario", "hand", "condition", "chance", "becomes", "end"};
  return "{\"t\":" + std::to_string(time) + ",\"malfunction\":\"" + malfunction_name(model, change.malfunction) +
         "\",\"active\":" + (change.active ? "true" : "false") + ",\"by\":\"" +
         std::string(kBy[static_cast<std::size_t>(change.by)]) + "\"}";
}

}  // namespace

std::string malfunction_name(const model::PlantModel& model, std::uint32_t number) {
  std::size_t rest = number;
  if (rest < model.malfunctions.size()) return model.malfunctions[rest].name;
  rest -= model.malfunctions.size();
  if (rest < 2 * model.units.size()) {
    return std::string(model.units[rest / 2].path) + (rest % 2 == 0 ? " stuck" : " slow");
  }
  rest -= 2 * model.units.size();
  return std::string(model.symbols[rest / 2].name()) + (rest % 2 == 0 ? " stuck off" : " stuck on");
}

std::string_view finding_name(tables::FindingKind kind) {
  static constexpr std::array<std::string_view, tables::kFindingKinds> kNames = {"conflicting operations",
                                                                                 "stopped under another command",
                                                                                 "command to a disabled unit",
                                                                                 "command without effect",
                                                                                 "overrun",
                                                                                 "lost command",
                                                                                 "started on enabling",
                                                                                 "event too short",
                                                                                 "instantaneous loop",
                                                                                 "requirement violated",
                                                                                 "part blocked",
                                                                                 "value not finite"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::vector<std::string> trace_lines(const model::PlantModel& model, const std::vector<InstantRecord>& instants) {
  std::vector<std::string> lines;
  for (const InstantRecord& instant : instants) {
    for (const auto& [symbol, value] : instant.changes) {
      const model::Symbol& it = model.symbols[symbol];
      lines.push_back("{\"t\":" + std::to_string(instant.time) + ",\"symbol\":\"" + std::string(it.name()) +
                      "\",\"value\":" + value_text(it.type, value) + "}");
    }
    for (const engine::PartChange& change : instant.parts) {
      lines.push_back(part_line(model.material, instant.time, change));
    }
    for (const engine::MalfunctionChange& change : instant.malfunctions) {
      lines.push_back(malfunction_line(model, instant.time, change));
    }
    for (const auto& [name, number] : instant.values) {
      lines.push_back("{\"t\":" + std::to_string(instant.time) + ",\"value\":\"" + name +
                      "\",\"is\":" + shortest(number) + "}");
    }
  }
  return lines;
}

std::vector<std::string> finding_lines(const model::PlantModel& model, const std::vector<InstantRecord>& instants) {
  std::vector<std::string> lines;
  for (const InstantRecord& instant : instants) {
    std::vector<std::string> names;
    for (const tables::Finding& finding : instant.findings) {
      names.push_back(name_of(model, finding));
      if (finding.more) continue;
      std::sort(names.begin(), names.end());
      std::string of;
      for (const std::string& name : names) of += (of.empty() ? "" : separator(model, finding)) + name;
      lines.push_back("{\"t\":" + std::to_string(instant.time) + ",\"finding\":\"" +
                      std::string(finding_name(finding.kind)) + "\",\"of\":\"" + of + "\"");
      names.clear();
    }
  }
  return lines;
}

}  // namespace symplant::reference
