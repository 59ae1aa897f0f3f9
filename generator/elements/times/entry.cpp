// Reads `times` of a plant.json.
#include "elements/times/entry.hpp"

#include <nlohmann/json.hpp>
#include <utility>

namespace symplant::description {
namespace {

using Json = nlohmann::json;

constexpr std::string_view kOverrun = "overrun";

std::optional<GivenTime> time_entry(const std::string& key, const Json& value, const Pointer& here,
                                    ShapeFaults& faults) {
  auto of = times_key_of(key);
  if (!of) {
    faults.add_at_key(here, ticked(key) + " is not a transition; write `FROM->TO` or `FROM->TO on OPERATION`");
    return std::nullopt;
  }
  return GivenTime{key, std::move(*of), computed_duration_member(value, "after", here, faults),
                   computed_duration_member(value, "takes", here, faults), value.dump()};
}

}  // namespace

std::vector<GivenTimes> times_entries(const Json& object, ShapeFaults& faults) {
  std::vector<GivenTimes> all;
  if (!object.is_object()) return all;
  const Pointer times("/times");
  for (const auto& [device, entry] : object.items()) {
    if (!entry.is_object()) continue;
    const Pointer here = times / std::string_view(device);
    GivenTimes given{device, {}, overrun_member(entry, here, faults)};
    for (const auto& [key, value] : entry.items()) {
      if (key == kOverrun) continue;
      auto time = time_entry(key, value, here / std::string_view(key), faults);
      if (time) given.transitions.push_back(std::move(*time));
    }
    all.push_back(std::move(given));
  }
  return all;
}

}  // namespace symplant::description
