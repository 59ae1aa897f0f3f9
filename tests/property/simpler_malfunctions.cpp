// Small single edits of malfunctions.
#include <algorithm>
#include <functional>

#include "property/simpler.hpp"

namespace symplant::property {
namespace {

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

}  // namespace

std::size_t malfunctions_size(const std::vector<GivenMalfunction>& malfunctions) {
  std::size_t size = 0;
  for (const GivenMalfunction& given : malfunctions) {
    size += 10 + 2 * given.of.size() + 2 * given.force.size() + (given.state.empty() ? 0 : 1) + given.when.size() +
            time_size(given.chance) + time_size(given.lasts) + time_size(given.flicker.every) +
            (given.factor > 2000 ? 1 : 0);
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
    std::erase_if(given.of, [&](const std::string& device) { return is_of(device + "_"); });
    std::erase_if(given.force, [&](const auto& force) { return is_of(force.first); });
    if (reads(given.when)) given.when.clear();
    if (given.becomes && reads(given.becomes->unless)) given.becomes->unless.clear();
    const bool lacks_units = given.of.empty() && (given.kinds.front() == tables::MalfunctionKind::slower ||
                                                  given.kinds.front() == tables::MalfunctionKind::stuck);
    const bool lacks_symbols = given.force.empty() && given.kinds.front() == tables::MalfunctionKind::force;
    if (lacks_units || lacks_symbols || is_of(given.flicker.symbol)) empty.push_back(given.name);
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
    if (!given.state.empty()) visit([&] { given.state.clear(); });
    if (given.factor > 2000) visit([&] { given.factor = 2000; });
    if (given.chance) visit([&] { given.chance.reset(); });
    if (is_random(given.chance)) visit([&] { fix(given.chance); });
    if (given.lasts) visit([&] { given.lasts.reset(); });
    if (is_random(given.lasts)) visit([&] { fix(given.lasts); });
    if (is_random(given.flicker.every)) visit([&] { fix(given.flicker.every); });
    if (given.becomes) visit([&] { given.becomes.reset(); });
    for (std::size_t i = 0; given.of.size() > 1 && i < given.of.size(); ++i) {
      visit([&given, i] { given.of.erase(given.of.begin() + static_cast<std::ptrdiff_t>(i)); });
    }
    for (std::size_t i = 0; given.force.size() > 1 && i < given.force.size(); ++i) {
      visit([&given, i] { given.force.erase(given.force.begin() + static_cast<std::ptrdiff_t>(i)); });
    }
  }
}

}  // namespace symplant::property
