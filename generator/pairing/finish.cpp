// Names the facets, and puts them in order.
#include <algorithm>
#include <numeric>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

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
  explicit Names(const Work& work) : facets_(work.devices.size()), unnamed_(work.devices.size()) {
    for (const Draft& draft : work.drafts) {
      if (draft.device == kNone) continue;
      ++facets_[draft.device];
      if (draft.facet.by != FacetBy::archetype) ++unnamed_[draft.device];
    }
  }

  void give(Draft& draft) {
    Facet& facet = draft.facet;
    if (draft.device == kNone) return;
    if (facet.by != FacetBy::archetype && unnamed_[draft.device] > 1) facet.name = name_of(facet);
    if (facet.name.empty()) return;
    facet.full_path = std::string(facet.path) + "." + facet.name;
    if (facets_[draft.device] == 1) return;
    const std::string name = facet.name;
    for (std::size_t n = 2; !taken_.insert(std::to_string(draft.device) + "." + text::to_upper(facet.name)).second;
         ++n) {
      facet.name = name + "_" + std::to_string(n);
      facet.full_path = std::string(facet.path) + "." + facet.name;
    }
  }

 private:
  std::vector<std::uint32_t> facets_;      ///< of each device
  std::vector<std::uint32_t> unnamed_;     ///< of each device: facets other than those of archetypes
  std::unordered_set<std::string> taken_;  ///< number of the device and name
};

/// Reports devices whose path another device has.
void check_paths(Work& work, const std::vector<std::uint32_t>& order) {
  text::ByName<std::uint32_t> by_path;
  by_path.reserve(work.drafts.size());
  for (const std::uint32_t d : order) {
    const Draft& draft = work.drafts[d];
    const auto [first, added] = by_path.try_emplace(draft.facet.path, d);
    const Draft& known = work.drafts[first->second];
    if (added || (known.device == draft.device && draft.device != kNone)) continue;
    work.result.remarks.push_back(
        {Remark::Kind::path_ambiguous, draft.facet.members.front().input, known.facet.members.front().input, 0});
  }
}

}  // namespace

void finish(Work& work) {
  std::vector<std::uint32_t> order(work.drafts.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return work.drafts[a].facet.members.front().input < work.drafts[b].facet.members.front().input;
  });
  Names names(work);
  for (const std::uint32_t d : order) names.give(work.drafts[d]);
  check_paths(work, order);
  work.result.facets.reserve(order.size());
  for (const std::uint32_t d : order) work.result.facets.push_back(std::move(work.drafts[d].facet));
}

}  // namespace symplant::pairing
