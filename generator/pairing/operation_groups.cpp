// Operations by device, group of tasks and index.
#include "pairing/operation_groups.hpp"

#include "text/ascii.hpp"

namespace symplant::pairing {
namespace {

/// All tasks with a sequence number exclude each other. No group of words has this text.
constexpr std::string_view kNumbered = "#";

std::uint64_t hash_of_kind(std::uint32_t device, std::string_view group) {
  return text::hash_ignoring_case(group) ^ (device * 0x9E37'79B9'7F4A'7C15U);
}

std::uint64_t hash_of(const GroupKey& key) {
  const std::uint64_t kind = hash_of_kind(key.device, key.group);
  return key.index.empty() ? kind : kind ^ text::hash_ignoring_case(key.index) * 0xC2B2'AE3D'27D4'EB4FU;
}

}  // namespace

bool operator==(const GroupKey& a, const GroupKey& b) {
  return a.device == b.device && a.index == b.index && text::equal_ignoring_case(a.group, b.group);
}

OperationGroups::OperationGroups(const Work& work) : work_(work), by_key_(work.devices.size()) {
  for (std::uint32_t i = 0; i < work.inputs.size(); ++i) {
    if (!work.is_free(i) || !work.is_operation(i)) continue;
    const GroupKey key = key_of(i);
    const auto next = static_cast<std::uint32_t>(groups_.size());
    const std::uint32_t index =
        by_key_.find_or_add(hash_of(key), next, [&](std::uint32_t other) { return groups_[other].key == key; });
    if (index == next) {
      OperationGroup& added = groups_.emplace_back();
      added.key = key;
      added.first = i;
      added.numbered = key.group == kNumbered;
      const std::uint32_t kind =
          by_kind_.find_or_add(hash_of_kind(key.device, key.group), next, [&](std::uint32_t other) {
            const GroupKey& known = groups_[other].key;
            return known.device == key.device && text::equal_ignoring_case(known.group, key.group);
          });
      if (kind != next) groups_[kind].alone = false;
    }
    if (work.naming.rules[work.reading(i).rule].fan_out) groups_[index].fan_out = true;
  }
}

bool OperationGroups::is_numbered(std::uint32_t input) const {
  const std::string_view task = work_.reading(input).task.canonical;
  return work_.naming.tasks.sequence && !task.empty() && text::is_digit(task.back());
}

std::string_view OperationGroups::kind_of(std::uint32_t input) const {
  return is_numbered(input) ? kNumbered : work_.reading(input).task.group;
}

GroupKey OperationGroups::key_of(std::uint32_t input) const {
  const bool numbered = is_numbered(input);
  const name::TaskReading& task = work_.reading(input).task;
  return {work_.device[input], numbered ? kNumbered : task.group, numbered ? std::string_view() : task.index};
}

std::uint32_t OperationGroups::of_operation(std::uint32_t operation) const { return find(key_of(operation)); }

std::uint32_t OperationGroups::find(const GroupKey& key) const {
  return by_key_.find(hash_of(key), [&](std::uint32_t other) { return groups_[other].key == key; });
}

std::uint32_t OperationGroups::find_kind(std::uint32_t device, std::string_view group) const {
  return by_kind_.find(hash_of_kind(device, group), [&](std::uint32_t other) {
    const GroupKey& key = groups_[other].key;
    return key.device == device && text::equal_ignoring_case(key.group, group);
  });
}

std::uint32_t OperationGroups::find(std::uint32_t device, std::uint32_t event) const {
  GroupKey key = key_of(event);
  key.device = device;
  std::uint32_t found = find(key);
  if (found != kNone) return found;
  if (!key.index.empty()) {
    if (work_.naming.tasks.sensor_index == name::SensorIndex::appended) {
      key.index.remove_suffix(1);
      found = find(key);
      if (found != kNone) return found;
    }
    key.index = {};
    return find(key);
  }
  found = find_kind(device, key.group);
  return found != kNone && groups_[found].alone ? found : kNone;
}

bool OperationGroups::has_kind(std::uint32_t device, std::uint32_t event) const {
  return find_kind(device, kind_of(event)) != kNone;
}

}  // namespace symplant::pairing
