// Names the facets, and puts them in order.
#include <algorithm>
#include <numeric>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "base/index_table.hpp"
#include "pairing/work.hpp"
#include "text/ascii.hpp"

namespace symplant::pairing {
namespace {

constexpr std::size_t kMostNamed = 4;  ///< a facet of more states is named by the first and the last one

std::string name_of(const Facet& facet) {
  std::vector<std::string> states = facet.states;
  if (facet.numbered) {
    for (const Member& member : facet.members) {
      const auto same = [&](const std::string& one) { return text::equal_ignoring_case(one, member.task); };
      if (states.size() <= kMostNamed && std::none_of(states.begin(), states.end(), same)) {
        states.push_back(member.task);
      }
    }
  }
  if (states.size() > kMostNamed) states = {states.front(), states.back()};
  std::string name;
  for (const std::string& state : states) name.append(name.empty() ? "" : "_").append(joined_words(state));
  std::replace(name.begin(), name.end(), '.', '_');  // `DEVICE.FACET` has one dot for the facet
  return name;
}

class Names {
 public:
  explicit Names(Work& work) : drafts_(work.drafts), devices_(work.devices.size()), before_(work.drafts.size(), kNone) {
    for (const Draft& draft : drafts_) {
      if (draft.device == kNone || draft.facet.by == FacetBy::archetype) continue;
      Device& device = devices_[draft.device];
      ++(draft.facet.linked ? device.linked : device.unlinked);
    }
  }

  void give(std::uint32_t index) {
    Draft& draft = drafts_[index];
    if (draft.device == kNone) return;
    Device& device = devices_[draft.device];
    if (draft.facet.by != FacetBy::archetype && !has_name_of_device(draft.facet, device)) {
      draft.facet.name = name_of(draft.facet);
    }
    if (draft.facet.name.empty()) return;
    make_unique(draft, device);
    before_[index] = std::exchange(device.last, index);
    ++device.named;
    draft.facet.full_path.reserve(draft.facet.path.size() + 1 + draft.facet.name.size());
    draft.facet.full_path.append(draft.facet.path).append(".").append(draft.facet.name);
  }

 private:
  struct Device {
    std::uint32_t linked = 0;    ///< facets other than those of archetypes
    std::uint32_t unlinked = 0;  ///< facets
    std::uint32_t named = 0;     ///< facets with a name so far
    std::uint32_t last = kNone;  ///< of these
  };

  /// The only one of its device does; links come first.
  static bool has_name_of_device(const Facet& facet, const Device& device) {
    if (facet.is_default) return true;
    return facet.linked ? device.linked == 1 : device.linked == 0 && device.unlinked == 1;
  }

  void make_unique(Draft& draft, const Device& device) {
    const std::string name = draft.facet.name;
    for (std::size_t n = 2; is_taken(draft, device); ++n) draft.facet.name = name + "_" + std::to_string(n);
  }

  /// Most devices have so few facets that a linear search is fastest.
  bool is_taken(const Draft& draft, const Device& device) {
    constexpr std::uint32_t kFew = 16;
    if (device.named >= kFew) {
      const auto key = [&](const Facet& facet) {
        return std::to_string(draft.device) + "." + text::to_upper(facet.name);
      };
      if (device.named == kFew) {
        for (std::uint32_t d = device.last; d != kNone; d = before_[d]) taken_.insert(key(drafts_[d].facet));
      }
      return !taken_.insert(key(draft.facet)).second;
    }
    for (std::uint32_t d = device.last; d != kNone; d = before_[d]) {
      if (text::equal_ignoring_case(drafts_[d].facet.name, draft.facet.name)) return true;
    }
    return false;
  }

  std::vector<Draft>& drafts_;
  std::vector<Device> devices_;
  std::vector<std::uint32_t> before_;      ///< of each facet: the one named before it in its device
  std::unordered_set<std::string> taken_;  ///< of devices with many facets: number of the device and name
};

/// Reports devices whose path another device has.
void check_paths(Work& work, const std::vector<std::uint32_t>& order) {
  base::IndexTable by_path(order.size());
  for (const std::uint32_t d : order) {
    const Draft& draft = work.drafts[d];
    const std::uint32_t first =
        by_path.find_or_add(text::hash_ignoring_case(draft.facet.path), d, [&](std::uint32_t other) {
          return text::equal_ignoring_case(work.drafts[other].facet.path, draft.facet.path);
        });
    const Draft& known = work.drafts[first];
    if (first == d || (known.device == draft.device && draft.device != kNone)) continue;
    work.result.remarks.push_back(
        {Remark::Kind::path_ambiguous, draft.facet.first_input(), known.facet.first_input(), 0});
  }
}

}  // namespace

void account_for_rest(Work& work) {
  for (std::uint32_t i = 0; i < work.inputs.size(); ++i) {
    Account& account = work.result.accounts[i];
    const name::Reading& reading = work.reading(i);
    if (account == Account::modelled || account == Account::ignored || reading.rest == name::Role::io) continue;
    account = account_of(work.inputs[i], reading.rest);
    if (account == Account::constant && reading.rest_value) work.result.constant_on[i] = true;
  }
}

void finish(Work& work) {
  std::vector<std::uint32_t> order(work.drafts.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return work.drafts[a].facet.first_input() < work.drafts[b].facet.first_input();
  });
  Names names(work);
  for (const std::uint32_t d : order) names.give(d);
  check_paths(work, order);
  work.result.facets.reserve(order.size());
  for (const std::uint32_t d : order) work.result.facets.push_back(std::move(work.drafts[d].facet));
}

}  // namespace symplant::pairing
