// Joins symbols by their tasks.
#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/large_memory.hpp"
#include "pairing/facet_builder.hpp"
#include "pairing/other_devices.hpp"
#include "text/ascii.hpp"

namespace symplant::pairing {
namespace {

class WordPairing {
 public:
  explicit WordPairing(Work& work) : work_(work), groups_(work), builder_(work) {}

  void run() {
    base::reserve_large(group_of_, work_.inputs.size());
    group_of_.resize(work_.inputs.size(), kNone);
    find_groups();
    merge_ends();
    const std::vector<std::uint32_t> order = sort_by_group();
    work_.drafts.reserve(work_.drafts.size() + groups_.all().size());
    for (std::size_t begin = 0; begin < order.size();) {
      std::size_t end = begin;
      while (end < order.size() && group_of_[order[end]] == group_of_[order[begin]]) ++end;
      add_facet({order.data() + begin, end - begin});
      begin = end;
    }
  }

 private:
  void find_groups() {
    std::optional<NumberedDevices> numbered;
    std::optional<FanOut> fan_out;
    for (std::uint32_t i = 0; i < work_.inputs.size(); ++i) {
      if (!work_.is_free(i)) continue;
      if (work_.is_operation(i)) {
        group_of_[i] = groups_.of_operation(i);
        continue;
      }
      std::uint32_t& group = group_of_[i];
      const EventKinds kinds(work_, i);
      group = groups_.find(work_.device[i], kinds);
      if (group == kNone && work_.naming.tasks.sensor_index != name::SensorIndex::off) {
        if (!numbered) numbered.emplace(work_, groups_);
        group = numbered->find(i, kinds);
      }
      if (group == kNone) {
        if (!fan_out) fan_out.emplace(work_, groups_);
        group = fan_out->find(i, kinds);
      }
      if (group != kNone) groups_.at(group).linked = true;
    }
  }

  /// The symbols of a group that has one operation and one event.
  struct End {
    std::uint32_t group = kNone;
    std::uint32_t operations = 0;
    std::uint32_t events = 0;
    std::uint32_t operation = kNone;
  };

  /// Two ends of one motion that differ by a number, each with its operation and its event, are one unit: LEFT0 and
  /// RIGHT90 of a turntable.
  void merge_ends() {
    std::vector<End> ends(groups_.all().size());
    for (std::uint32_t i = 0; i < group_of_.size(); ++i) {
      if (group_of_[i] == kNone) continue;
      End& end = ends[group_of_[i]];
      end.group = group_of_[i];
      ++(work_.is_operation(i) ? end.operations : end.events);
      if (work_.is_operation(i)) end.operation = i;
    }
    std::map<std::pair<std::uint32_t, std::string>, std::vector<End>> motions;  // by device and words without digits
    for (const End& end : ends) {
      if (end.operations != 1 || end.events != 1 || work_.reading(end.operation).task->pair == name::kNoPair) continue;
      std::string words(groups_.all()[end.group].kind);
      if (std::erase_if(words, text::is_digit) == 0) continue;
      motions[{groups_.all()[end.group].device, std::move(words)}].push_back(end);
    }
    std::vector<std::uint32_t> merged(groups_.all().size(), kNone);
    for (const auto& [motion, of_motion] : motions) {
      if (of_motion.size() != 2) continue;
      const name::TaskReading& one = *work_.reading(of_motion[0].operation).task;
      const name::TaskReading& other = *work_.reading(of_motion[1].operation).task;
      if (one.pair == other.pair && one.rest != other.rest) merged[of_motion[1].group] = of_motion[0].group;
    }
    for (std::uint32_t& group : group_of_) {
      if (group != kNone && merged[group] != kNone) group = merged[group];
    }
  }

  /// The symbols of linked groups, by group, then in list order.
  std::vector<std::uint32_t> sort_by_group() const {
    std::vector<std::uint32_t> begins(groups_.all().size() + 1);
    const auto is_linked = [&](std::uint32_t input) {
      return group_of_[input] != kNone && groups_.all()[group_of_[input]].linked;
    };
    for (std::uint32_t i = 0; i < group_of_.size(); ++i) {
      if (is_linked(i)) ++begins[group_of_[i] + 1];
    }
    for (std::size_t g = 1; g < begins.size(); ++g) begins[g] += begins[g - 1];
    std::vector<std::uint32_t> order;
    base::reserve_large(order, begins.back());
    order.resize(begins.back());
    for (std::uint32_t i = 0; i < group_of_.size(); ++i) {
      if (is_linked(i)) order[begins[group_of_[i]]++] = i;
    }
    return order;
  }

  void add_facet(std::span<const std::uint32_t> inputs) {
    const OperationGroup& group = groups_.all()[group_of_[inputs.front()]];
    for (const std::uint32_t input : inputs)
      builder_.add(input, state_of(input, inputs), work_.reading(input).task->rest);
    work_.add(builder_.take(group.first, group.numbered), group.device);
  }

  /// An event reports the state that an operation of its position leads to: CLAMP is CLAMP1 where the operation is.
  const std::string& state_of(std::uint32_t input, std::span<const std::uint32_t> inputs) {
    const name::TaskReading& task = *work_.reading(input).task;
    std::string_view state = task.canonical;
    std::string_view number;
    if (!work_.is_operation(input) && task.pair != name::kNoPair) {
      for (const std::uint32_t other : inputs) {
        const name::TaskReading& of = *work_.reading(other).task;
        if (!work_.is_operation(other)) continue;
        number = of.index;
        if (of.rest != task.rest || (!task.rest && of.pair != task.pair)) continue;
        state = of.canonical;
        number = {};
        break;
      }
    }
    state_.assign(state).append(number);
    std::replace(state_.begin(), state_.end(), ' ', '_');
    return state_;
  }

  Work& work_;
  OperationGroups groups_;
  FacetBuilder builder_;
  std::string state_;
  std::vector<std::uint32_t> group_of_;  ///< of each symbol
};

}  // namespace

void pair_by_words(Work& work) { WordPairing(work).run(); }

}  // namespace symplant::pairing
