// What active malfunctions and forces do to units, symbols and links, in words.
#include "symplant/trace/influences.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "symplant/tables/malfunction_numbers.hpp"
#include "symplant/trace/words.hpp"

namespace symplant::trace {
namespace {

using tables::MalfunctionKind;
using tables::MalfunctionNumbers;

constexpr std::size_t kInfluencesShown = 4;

/// The active malfunctions that `is_one(number)` selects.
template <class IsOne>
std::string malfunctions_that(const PlantNames& names, ActiveMalfunctions active, IsOne is_one) {
  std::string text;
  for (const History::Malfunction& one : active) {
    if (is_one(one.number)) text += (text.empty() ? "" : ", ") + malfunction_words(one.number, names);
  }
  return text;
}

/// Those of a kind that name a unit.
std::string of_kind(MalfunctionKind kind, std::uint32_t unit, const PlantNames& names, ActiveMalfunctions active) {
  const MalfunctionNumbers numbers(names.tables());
  return malfunctions_that(names, active, [&](std::uint32_t number) { return numbers.acts_on(number, kind, unit); });
}

bool overrides(std::uint32_t malfunction, std::uint32_t symbol, const tables::PlantTables& tables) {
  bool found = false;
  MalfunctionNumbers(tables).for_symbols(malfunction, [&](std::uint32_t other) { found = found || other == symbol; });
  return found;
}

}  // namespace

std::string malfunction_words(std::uint32_t malfunction, const PlantNames& names) {
  return fmt::format("malfunction `{}`", names.malfunction(malfunction));
}

std::string disabling_malfunctions(std::uint32_t unit, const PlantNames& names, ActiveMalfunctions active) {
  return of_kind(MalfunctionKind::stuck, unit, names, active);
}

std::string slowing_malfunctions(std::uint32_t unit, const PlantNames& names, ActiveMalfunctions active) {
  return of_kind(MalfunctionKind::slower, unit, names, active);
}

std::string stopping_malfunctions(std::uint32_t track, const PlantNames& names, ActiveMalfunctions active) {
  const MalfunctionNumbers numbers(names.tables());
  return malfunctions_that(names, active, [&](std::uint32_t number) {
    return numbers.acts_on_track(number, MalfunctionKind::stuck, track);
  });
}

std::string braking_malfunctions(std::uint32_t track, const PlantNames& names, ActiveMalfunctions active) {
  const MalfunctionNumbers numbers(names.tables());
  return malfunctions_that(names, active, [&](std::uint32_t number) {
    return numbers.acts_on_track(number, MalfunctionKind::slower, track);
  });
}

std::string holding_malfunction(std::uint32_t value, const PlantNames& names, ActiveMalfunctions active) {
  const tables::MalfunctionTables& all = names.tables().malfunctions;
  const MalfunctionNumbers numbers(names.tables());
  const auto holds = [&](const tables::EffectRow& effect) {
    return std::ranges::any_of(all.sets_of(effect), [&](const auto& set) { return set.value == value; });
  };
  const auto last = std::find_if(active.rbegin(), active.rend(), [&](const History::Malfunction& one) {
    return numbers.is_written(one.number) && std::ranges::any_of(all.effects_of(one.number), holds);
  });
  return last == active.rend() ? "" : malfunction_words(last->number, names);
}

std::string overriding_malfunction(std::uint32_t symbol, const PlantNames& names, ActiveMalfunctions active) {
  const auto last = std::find_if(active.rbegin(), active.rend(), [&](const History::Malfunction& one) {
    return overrides(one.number, symbol, names.tables());
  });
  return last == active.rend() ? "" : malfunction_words(last->number, names);
}

std::string cutting_malfunctions(std::uint32_t controller, const PlantNames& names, ActiveMalfunctions active) {
  const MalfunctionNumbers numbers(names.tables());
  return malfunctions_that(names, active, [&](std::uint32_t number) { return numbers.cuts(number, controller); });
}

Influences& Influences::holding(std::uint32_t unit) {
  const std::string by = disabling_malfunctions(unit, names_, history_.malfunctions());
  if (!by.empty()) found_.push_back(fmt::format("{} holds {}", by, names_.unit(unit)));
  return *this;
}

Influences& Influences::slowing(std::uint32_t unit) {
  const std::string by = slowing_malfunctions(unit, names_, history_.malfunctions());
  if (!by.empty()) found_.push_back(fmt::format("{} slows {}", by, names_.unit(unit)));
  return *this;
}

Influences& Influences::forcing(std::uint32_t symbol) {
  const auto name = [&] {
    return fmt::format("{} {} ({})", names_.is_operation(symbol) ? "operation" : "event", names_.task(symbol),
                       address_or_name(symbol, names_));
  };
  const tables::Time forced = history_.forced_since(symbol);
  if (forced >= 0) {
    found_.push_back(fmt::format("{} is forced {}", name(), since_words(forced)));
    return *this;
  }
  const std::string by = overriding_malfunction(symbol, names_, history_.malfunctions());
  if (!by.empty()) found_.push_back(fmt::format("{} forces {}", by, name()));
  return *this;
}

Influences& Influences::forcing_symbols_of(std::uint32_t unit) {
  for (const std::uint32_t symbol : names_.symbols_of(unit)) forcing(symbol);
  return *this;
}

Influences& Influences::cutting(std::uint32_t controller) {
  const std::string by = cutting_malfunctions(controller, names_, history_.malfunctions());
  if (!by.empty()) found_.push_back(by + " cuts it");
  return *this;
}

std::string Influences::words() const {
  std::string text;
  for (std::size_t i = 0; i < found_.size() && i < kInfluencesShown; ++i) {
    text += (i == 0 ? "" : ", ") + found_[i];
  }
  if (found_.size() > kInfluencesShown) text += fmt::format(" and {} more", found_.size() - kInfluencesShown);
  return text;
}

std::string Influences::advice(std::string_view usual) const {
  return empty() ? fmt::format("check {}", usual) : words() + ": check how the program reacts";
}

bool is_disabled_by_device(std::uint32_t unit, const PlantNames& names, const History& history) {
  const auto rows = names.tables().disables;
  return std::any_of(rows.begin(), rows.end(), [&](const tables::DisableRow& row) {
    if (row.unit != unit) return false;
    const plant::UnitView by = history.unit(row.by);
    return !by.moving && by.state == row.state;
  });
}

}  // namespace symplant::trace
