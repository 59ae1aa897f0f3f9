// Operations by device and kind of task.
#include "pairing/operation_groups.hpp"

#include "text/ascii.hpp"

namespace symplant::pairing {
namespace {

/// All tasks with a sequence number exclude each other. No words have this text.
constexpr std::string_view kNumbered = "#";

std::uint64_t hash_of(std::uint32_t device, std::string_view kind) {
  return text::hash_ignoring_case(kind) ^ (device * 0x9E37'79B9'7F4A'7C15U);
}

bool is_numbered(const Work& work, std::uint32_t input) {
  const std::string_view task = work.reading(input).task->canonical;
  return work.naming.tasks.sequence && !task.empty() && text::is_digit(task.back());
}

std::string_view kind_of_operation(const Work& work, std::uint32_t operation) {
  return is_numbered(work, operation) ? kNumbered : work.reading(operation).task->group;
}

}  // namespace

EventKinds::EventKinds(const Work& work, std::uint32_t event) {
  const name::TaskReading& task = *work.reading(event).task;
  if (is_numbered(work, event)) {
    kinds_[count_++] = kNumbered;
    return;
  }
  if (task.numbered_group != task.group) {
    kinds_[count_++] = task.numbered_group;
    const bool appended = work.naming.tasks.sensor_index == name::SensorIndex::appended;
    if (appended && text::is_digit(task.numbered_group.back())) {
      kinds_[count_++] = task.numbered_group.substr(0, task.numbered_group.size() - 1);
    }
  }
  kinds_[count_++] = task.group;
}

OperationGroups::OperationGroups(const Work& work) : work_(work), by_kind_(work.devices.size()) {
  for (std::uint32_t i = 0; i < work.inputs.size(); ++i) {
    if (!work.is_free(i) || !work.is_operation(i)) continue;
    const std::uint32_t device = work.device[i];
    const std::string_view kind = kind_of_operation(work, i);
    const auto next = static_cast<std::uint32_t>(groups_.size());
    const std::uint32_t index = by_kind_.find_or_add(hash_of(device, kind), next, [&](std::uint32_t other) {
      return groups_[other].device == device && groups_[other].kind == kind;
    });
    if (index == next) groups_.push_back({device, kind, i, kind == kNumbered});
    if (work.naming.rules[work.reading(i).rule].fan_out) groups_[index].fan_out = true;
  }
}

std::uint32_t OperationGroups::find(std::uint32_t device, std::string_view kind) const {
  return by_kind_.find(hash_of(device, kind), [&](std::uint32_t other) {
    return groups_[other].device == device && groups_[other].kind == kind;
  });
}

std::uint32_t OperationGroups::find(std::uint32_t device, const EventKinds& kinds) const {
  for (const std::string_view kind : kinds) {
    const std::uint32_t found = find(device, kind);
    if (found != kNone) return found;
  }
  return kNone;
}

std::uint32_t OperationGroups::of_operation(std::uint32_t operation) const {
  return find(work_.device[operation], kind_of_operation(work_, operation));
}

}  // namespace symplant::pairing
