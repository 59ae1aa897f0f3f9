// Small single edits of malfunctions.
#include <algorithm>
#include <functional>

#include "property/simpler.hpp"

namespace symplant::property {
namespace {

using description::GivenEffect;
using description::GivenMalfunction;

std::size_t time_size(const std::optional<description::Duration>& given) {
  return !given ? 0 : given->kind == description::Duration::Kind::fixed ? 1 : 2;
}

void fix(std::optional<description::Duration>& given) {
  given = description::Duration::fixed(10 * tables::kMillisecond);
}

bool is_random(const std::optional<description::Duration>& given) {
  return given && given->kind != description::Duration::Kind::fixed;
}

std::size_t effect_size(const GivenEffect& given) {
  return 2 * given.of.size() + 2 * given.force.size() + 2 * given.set.size() + (given.state.empty() ? 0 : 1) +
         time_size(given.flicker.every) + (given.factor > 2000 ? 1 : 0) + (given.distort.drift != 0 ? 1 : 0);
}

/// Removes what names things that are gone; true if nothing is left.
bool remove_from_effect(GivenEffect& given, bool has_other_devices,
                        const std::function<bool(const std::string&)>& is_of) {
  std::erase_if(given.of, [&](const std::string& device) { return is_of(device + "_"); });
  std::erase_if(given.force, [&](const auto& force) { return is_of(force.first); });
  if (given.kinds.empty()) return false;
  const tables::MalfunctionKind kind = given.kinds.front();
  const bool of_units = kind == tables::MalfunctionKind::slower || kind == tables::MalfunctionKind::stuck;
  return (of_units && given.of.empty() && !has_other_devices) ||
         (kind == tables::MalfunctionKind::force && given.force.empty()) || is_of(given.flicker.symbol) ||
         is_of(given.distort.symbol);
}

/// Reports each effect that can be simpler.
void each_edit(GivenEffect& given, const std::function<void(const std::function<void()>&)>& visit) {
  if (!given.state.empty()) visit([&] { given.state.clear(); });
  if (given.factor > 2000) visit([&] { given.factor = 2000; });
  if (given.distort.drift != 0) visit([&] { given.distort.drift = 0; });
  if (is_random(given.flicker.every)) visit([&] { fix(given.flicker.every); });
  const auto erase_one_of = [&visit](auto& list) {
    for (std::size_t i = 0; list.size() > 1 && i < list.size(); ++i) {
      visit([&list, i] { list.erase(list.begin() + static_cast<std::ptrdiff_t>(i)); });
    }
  };
  erase_one_of(given.of);
  erase_one_of(given.force);
  erase_one_of(given.set);
}

}  // namespace

std::size_t malfunctions_size(const std::vector<GivenMalfunction>& malfunctions) {
  std::size_t size = 0;
  for (const GivenMalfunction& given : malfunctions) {
    size += 10 + effect_size(given.one) + given.when.size() + time_size(given.chance) + time_size(given.lasts);
    for (const GivenEffect& effect : given.effects) size += 4 + effect_size(effect);
    if (given.becomes) size += 5 + given.becomes->unless.size();
  }
  return size;
}

void remove_malfunction(PlantText& plant, const std::string& name) {
  std::erase_if(plant.description.malfunctions, [&](const GivenMalfunction& given) { return given.name == name; });
  for (GivenMalfunction& given : plant.description.malfunctions) {
    if (given.becomes && given.becomes->start == name) given.becomes.reset();
  }
}

void remove_from_malfunctions(PlantText& plant, const std::function<bool(const std::string&)>& is_of,
                              const std::function<bool(const std::string&)>& reads) {
  std::vector<std::string> empty;
  for (GivenMalfunction& given : plant.description.malfunctions) {
    const bool is_empty = remove_from_effect(given.one, false, is_of);
    const bool several = !given.effects.empty();
    std::erase_if(given.effects,
                  [&](GivenEffect& effect) { return remove_from_effect(effect, !given.one.of.empty(), is_of); });
    if (reads(given.when)) given.when.clear();
    if (given.when.empty()) given.during = false;
    if (given.becomes && reads(given.becomes->unless)) given.becomes->unless.clear();
    if (is_empty || (several && given.effects.empty())) empty.push_back(given.name);
  }
  for (const std::string& name : empty) remove_malfunction(plant, name);
}

void each_condition(std::vector<GivenMalfunction>& malfunctions, const std::function<void(std::string&, bool)>& visit) {
  for (GivenMalfunction& given : malfunctions) {
    visit(given.when, true);
    if (given.becomes) visit(given.becomes->unless, true);
  }
}

void each_edit(std::vector<GivenMalfunction>& malfunctions,
               const std::function<void(const std::function<void()>&)>& visit) {
  for (GivenMalfunction& given : malfunctions) {
    each_edit(given.one, visit);
    for (GivenEffect& effect : given.effects) each_edit(effect, visit);
    for (std::size_t i = 0; given.effects.size() > 1 && i < given.effects.size(); ++i) {
      visit([&given, i] { given.effects.erase(given.effects.begin() + static_cast<std::ptrdiff_t>(i)); });
    }
    if (given.during) visit([&] { given.during = false; });
    if (given.chance) visit([&] { given.chance.reset(); });
    if (is_random(given.chance)) visit([&] { fix(given.chance); });
    if (given.lasts) visit([&] { given.lasts.reset(); });
    if (is_random(given.lasts)) visit([&] { fix(given.lasts); });
    if (given.becomes) visit([&] { given.becomes.reset(); });
  }
}

}  // namespace symplant::property
