// Adds to each device what nothing links, so that a device exists as soon as one symbol names it.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "pairing/facet_builder.hpp"
#include "pairing/operation_groups.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::pairing {
namespace {

/// The default facet of a device has its name, and takes the events and numbers that nothing links. It is the only
/// linked facet other than those of archetypes; without one the operations that nothing links, if they exclude each
/// other; else one more facet.
class Unlinked {
 public:
  explicit Unlinked(Work& work) : work_(work), defaults_(work.devices.size(), kNone), builder_(work) {}

  void run() {
    find_linked();
    add_operations();
    for (std::uint32_t i = 0; i < work_.inputs.size(); ++i) {
      if (!work_.is_read(i)) continue;
      if (work_.result.accounts[i] == Account::no_operation) add_event(i);
      if (work_.result.accounts[i] == Account::numeric) default_of(work_.device[i]).numbers.push_back(i);
    }
  }

 private:
  static constexpr std::uint32_t kSeveral = kNone - 1;

  /// The first facet of a device is its default one, as long as it is the only one.
  void offer(std::uint32_t device, std::uint32_t draft) {
    std::uint32_t& of_device = defaults_[device];
    of_device = of_device == kNone ? draft : kSeveral;
  }

  void find_linked() {
    for (std::uint32_t d = 0; d < work_.drafts.size(); ++d) {
      const Draft& draft = work_.drafts[d];
      if (draft.device != kNone && draft.facet.by != FacetBy::archetype) offer(draft.device, d);
    }
  }

  void add_operations() {
    const OperationGroups groups(work_);
    std::vector<std::vector<std::uint32_t>> members(groups.all().size());
    for (std::uint32_t i = 0; i < work_.inputs.size(); ++i) {
      if (work_.is_free(i) && work_.is_operation(i)) members[groups.of_operation(i)].push_back(i);
    }
    const std::vector<std::uint32_t> linked = defaults_;
    for (std::uint32_t g = 0; g < members.size(); ++g) {
      const OperationGroup& group = groups.all()[g];
      for (const std::uint32_t i : members[g]) {
        builder_.add(i, joined_words(work_.reading(i).task->canonical), work_.reading(i).task->rest);
      }
      Facet facet = builder_.take(group.first, group.numbered);
      facet.linked = false;
      if (linked[group.device] == kNone) offer(group.device, static_cast<std::uint32_t>(work_.drafts.size()));
      work_.add(std::move(facet), group.device);
    }
  }

  Facet& default_of(std::uint32_t device) {
    std::uint32_t& draft = defaults_[device];
    if (draft >= kSeveral) {
      draft = static_cast<std::uint32_t>(work_.drafts.size());
      Facet facet;
      facet.linked = false;
      facet.is_default = true;
      work_.add(std::move(facet), device);
    }
    return work_.drafts[draft].facet;
  }

  /// A unit that has as many events as it may have gets no more.
  void add_event(std::uint32_t event) {
    Facet& facet = default_of(work_.device[event]);
    std::size_t events = 0;
    bool taken = false;
    std::string task = joined_words(work_.reading(event).task->text);
    for (const Member& member : facet.members) {
      if (work_.is_operation(member.input)) continue;
      ++events;
      taken = taken || text::equal_ignoring_case(member.task, task);
    }
    if (events == tables::kMaxEvents || taken) return;
    const bool makes_state = work_.naming.rules[work_.reading(event).rule].unlinked_states;
    const auto after = std::upper_bound(facet.members.begin(), facet.members.end(), event,
                                        [](std::uint32_t input, const Member& member) { return input < member.input; });
    facet.members.insert(after, {event, std::move(task), makes_state});
  }

  Work& work_;
  std::vector<std::uint32_t> defaults_;  ///< of each device: index in the drafts, kNone without one, or kSeveral
  FacetBuilder builder_;
};

}  // namespace

void add_unlinked(Work& work) { Unlinked(work).run(); }

}  // namespace symplant::pairing
