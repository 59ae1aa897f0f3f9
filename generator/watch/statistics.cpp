// What moves took on average when the plant was learned.
#include "watch/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <unordered_map>
#include <utility>

#include "symplant/json/document.hpp"
#include "symplant/tables/ascii.hpp"
#include "symplant/tables/duration.hpp"

namespace symplant::watch {
namespace {

using Json = nlohmann::json;

constexpr std::array<std::pair<const char*, Span>, 3> kSpans{
    {{"after", Span::after}, {"takes", Span::takes}, {"total", Span::total}}};

std::optional<double> duration_of(const Json& entry, const char* key) {
  const auto found = entry.find(key);
  if (found == entry.end() || !found->is_string()) return std::nullopt;
  const auto time = tables::parse_duration(found->get<std::string>());
  return time ? std::optional(static_cast<double>(*time)) : std::nullopt;
}

std::optional<std::uint32_t> state_of(const model::Unit& unit, std::string_view name) {
  for (std::uint32_t s = 0; s < unit.states.size(); ++s) {
    if (tables::equal_ignoring_case(unit.states[s].name, name)) return s;
  }
  return std::nullopt;
}

/// `OPEN->CLOSED`, `CLOSED->OPEN on RELEASE`.
std::optional<Statistic> move_of(const model::PlantModel& plant, std::uint32_t u, std::string_view key) {
  const model::Unit& unit = plant.units[u];
  const std::size_t arrow = key.find("->");
  if (arrow == key.npos) return std::nullopt;
  const std::size_t on = key.find(" on ", arrow);
  const auto from = state_of(unit, key.substr(0, arrow));
  const auto to = state_of(unit, key.substr(arrow + 2, on == key.npos ? on : on - arrow - 2));
  if (!from || !to) return std::nullopt;
  Statistic statistic;
  statistic.unit = u;
  statistic.from = *from;
  statistic.to = *to;
  if (on == key.npos) return statistic;
  for (std::uint32_t o = 0; o < unit.operations.size(); ++o) {
    const std::string_view task = plant.symbols[unit.operations[o]].reading.task();
    if (!tables::equal_ignoring_case(task, key.substr(on + 4))) continue;
    statistic.on = o;
    return statistic;
  }
  return std::nullopt;
}

/// Whether every value has its form.
bool add_move(const Json& spans, const Statistic& move, std::vector<Statistic>& statistics) {
  if (!spans.is_object()) return false;
  for (const auto& [key, span] : kSpans) {
    const auto found = spans.find(key);
    if (found == spans.end()) continue;
    if (!found->is_object() || !found->contains("n") || !found->at("n").is_number_unsigned()) return false;
    const auto mean = duration_of(*found, "mean");
    const auto deviation = duration_of(*found, "sd");
    if (!mean || !deviation) return false;
    Statistic statistic = move;
    statistic.span = span;
    statistic.n = found->at("n").get<std::uint64_t>();
    statistic.mean = *mean;
    statistic.deviation = *deviation;
    statistics.push_back(statistic);
  }
  return true;
}

}  // namespace

ReadStatistics read_statistics(std::string_view text, const std::string& name, const model::PlantModel& plant) {
  ReadStatistics read;
  const json::Document document = json::parse(text);
  if (!document.faults.empty()) {
    const json::Placed& fault = document.faults.front();
    const std::string_view before = text.substr(0, fault.span.begin);
    read.error = fmt::format("{}:{}: {}", name, 1 + std::count(before.begin(), before.end(), '\n'), fault.message);
    return read;
  }
  if (!document.root->is_object() || !document.root->contains("learned")) return read;
  const Json& learned = document.root->at("learned");
  const auto fail = [&](const std::string& where) {
    read.error = fmt::format(
        "{}: `learned` has no statistics as `symplant learn` writes them{}: learn again, or leave `learned` out", name,
        where);
    return read;
  };
  if (!learned.is_object() || !learned.contains("devices") || !learned.at("devices").is_object()) return fail("");
  std::unordered_map<std::string_view, std::uint32_t> units;
  for (std::uint32_t u = 0; u < plant.units.size(); ++u) units.emplace(plant.units[u].path, u);
  for (const auto& [path, moves] : learned.at("devices").items()) {
    const auto unit = units.find(path);
    if (unit == units.end()) continue;
    if (!moves.is_object()) return fail(fmt::format(", in `{}`", path));
    for (const auto& [key, spans] : moves.items()) {
      const auto move = move_of(plant, unit->second, key);
      if (move && !add_move(spans, *move, read.statistics)) return fail(fmt::format(", in `{}`, `{}`", path, key));
    }
  }
  return read;
}

}  // namespace symplant::watch
