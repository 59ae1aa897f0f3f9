// Finds the device whose operation moves an event of another device.
#include "pairing/other_devices.hpp"

#include <algorithm>
#include <bit>

#include "pairing/device_words.hpp"
#include "text/ascii.hpp"

namespace symplant::pairing {

NumberedDevices::NumberedDevices(const Work& work, const OperationGroups& groups) : work_(work), groups_(groups) {
  for (const OperationGroup& group : groups.all()) {
    const std::uint32_t device = group.device;
    const std::string_view name = work_.reading(work_.devices[device]).levels->device;
    by_name_.find_or_add(hash_of(device, name), device,
                         [&](std::uint32_t known) { return is_at(known, device, name); });
  }
}

std::uint64_t NumberedDevices::hash_of(std::uint32_t device, std::string_view name) const {
  const std::uint32_t process = work_.reading(work_.devices[device]).levels->process_id;
  return text::hash_ignoring_case(name) ^ (process * 0x9E37'79B9'7F4A'7C15U);
}

bool NumberedDevices::is_at(std::uint32_t known, std::uint32_t device, std::string_view name) const {
  return same_process(work_, known, device) &&
         text::equal_ignoring_case(work_.reading(work_.devices[known]).levels->device, name);
}

std::uint32_t NumberedDevices::find(std::uint32_t event, const EventKinds& kinds) const {
  const std::uint32_t device = work_.device[event];
  std::string_view name = work_.reading(event).levels->device;
  const std::size_t last = name.find_last_not_of("0123456789");
  if (last == name.npos || last + 1 == name.size()) return kNone;
  name = name.substr(0, name.find_last_not_of('_', last) + 1);
  if (name.empty()) return kNone;
  const std::uint32_t found =
      by_name_.find(hash_of(device, name), [&](std::uint32_t known) { return is_at(known, device, name); });
  return found == kNone ? kNone : groups_.find(found, kinds);
}

FanOut::FanOut(const Work& work, const OperationGroups& groups) : work_(work), groups_(groups) {
  const auto fans_out = [](const OperationGroup& group) { return group.fan_out; };
  if (std::none_of(groups.all().begin(), groups.all().end(), fans_out)) return;
  count_words();
  for (std::uint32_t g = 0; g < groups.all().size(); ++g) {
    if (groups.all()[g].fan_out) add(g);
  }
}

std::uint64_t FanOut::hash_of_word(std::uint32_t device, std::string_view word) const {
  const std::uint32_t process = work_.reading(work_.devices[device]).levels->process_id;
  return text::hash_ignoring_case(word) ^ (process * 0x9E37'79B9'7F4A'7C15U);
}

std::uint32_t FanOut::find_word(std::uint32_t device, std::string_view word) const {
  return by_word_.find(hash_of_word(device, word), [&](std::uint32_t known) {
    return same_process(work_, words_[known].device, device) && text::equal_ignoring_case(words_[known].text, word);
  });
}

void FanOut::count_words() {
  for (std::uint32_t device = 0; device < work_.devices.size(); ++device) {
    for_each_word(work_.reading(work_.devices[device]).levels->device, [&](std::string_view word) {
      const auto next = static_cast<std::uint32_t>(words_.size());
      const std::uint32_t index = by_word_.find_or_add(hash_of_word(device, word), next, [&](std::uint32_t known) {
        return same_process(work_, words_[known].device, device) && text::equal_ignoring_case(words_[known].text, word);
      });
      if (index == next) words_.push_back({device, word, 0});
      ++words_[index].devices;
    });
  }
}

/// Enters a group under the rarest word of its device.
void FanOut::add(std::uint32_t group) {
  const OperationGroup& key = groups_.all()[group];
  std::uint32_t rarest = kNone;
  for_each_word(work_.reading(work_.devices[key.device]).levels->device, [&](std::string_view word) {
    const std::uint32_t index = find_word(key.device, word);
    if (rarest == kNone || words_[index].devices < words_[rarest].devices) rarest = index;
  });
  if (rarest == kNone) return;
  const auto next = static_cast<std::uint32_t>(entries_.size());
  entries_.push_back({group, rarest, kNone});
  const std::uint32_t first = first_entry(rarest, key.kind);
  if (first == kNone) {
    by_entry_.find_or_add(text::hash_ignoring_case(key.kind) ^ (rarest * 0x9E37'79B9'7F4A'7C15U), next,
                          [](std::uint32_t) { return false; });
  } else {
    entries_[next].next = entries_[first].next;
    entries_[first].next = next;
  }
}

std::uint32_t FanOut::first_entry(std::uint32_t word, std::string_view kind) const {
  return by_entry_.find(text::hash_ignoring_case(kind) ^ (word * 0x9E37'79B9'7F4A'7C15U), [&](std::uint32_t known) {
    const Entry& entry = entries_[known];
    return entry.word == word && groups_.all()[entry.group].kind == kind;
  });
}

std::uint32_t FanOut::find(std::uint32_t event, const EventKinds& kinds) const {
  std::uint32_t best = kNone;
  for (const std::string_view kind : kinds) {
    if (!entries_.empty() && best == kNone) find(event, kind, best);
  }
  return best;
}

void FanOut::find(std::uint32_t event, std::string_view kind, std::uint32_t& best) const {
  const std::string_view name = work_.reading(event).levels->device;
  std::size_t most = 0;
  for_each_word(name, [&](std::string_view word) {
    const std::uint32_t index = find_word(work_.device[event], word);
    for (std::uint32_t e = first_entry(index, kind); e != kNone; e = entries_[e].next) {
      const OperationGroup& group = groups_.all()[entries_[e].group];
      const std::size_t words = count_contained(work_.reading(group.first).levels->device, name);
      if (words == 0 || words < most) continue;
      if (words == most && group.first >= groups_.all()[best].first) continue;
      best = entries_[e].group;
      most = words;
    }
  });
}

}  // namespace symplant::pairing
