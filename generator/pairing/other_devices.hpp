// Finds the device whose operation moves an event of another device.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "base/index_table.hpp"
#include "pairing/operation_groups.hpp"

namespace symplant::pairing {

/// Devices by name, for sensors that number their device: LOCK_CLAMP1 senses LOCK_CLAMP.
class NumberedDevices {
 public:
  NumberedDevices(const Work& work, const OperationGroups& groups);

  /// The group of the device without the digits at its end; kNone without one.
  std::uint32_t find(std::uint32_t event, const EventKinds& kinds) const;

 private:
  std::uint64_t hash_of(std::uint32_t device, std::string_view name) const;
  bool is_at(std::uint32_t known, std::uint32_t device, std::string_view name) const;

  const Work& work_;
  const OperationGroups& groups_;
  base::IndexTable by_name_;  ///< controller, process and device level -> a device with operations
};

/// Operations that drive several devices: that of CLAMP moves CLAMP_LH and CLAMP_RH.
class FanOut {
 public:
  FanOut(const Work& work, const OperationGroups& groups);

  /// The group of the device whose words the event's device contains, the most words first; kNone without one.
  std::uint32_t find(std::uint32_t event, const EventKinds& kinds) const;

 private:
  struct Word {
    std::uint32_t device;  ///< a device whose name has the word
    std::string_view text;
    std::uint32_t devices = 0;  ///< how many devices of the process have the word
  };
  /// Operations of one kind, found by one word of their device.
  struct Entry {
    std::uint32_t group;
    std::uint32_t word;
    std::uint32_t next;  ///< the next entry of the same word and kind
  };

  void find(std::uint32_t event, std::string_view kind, std::uint32_t& best) const;
  std::uint32_t find_word(std::uint32_t device, std::string_view word) const;
  std::uint64_t hash_of_word(std::uint32_t device, std::string_view word) const;
  void count_words();
  void add(std::uint32_t group);
  std::uint32_t first_entry(std::uint32_t word, std::string_view kind) const;

  const Work& work_;
  const OperationGroups& groups_;
  std::vector<Word> words_;
  base::IndexTable by_word_;
  std::vector<Entry> entries_;
  base::IndexTable by_entry_;  ///< word and kind -> the first entry
};

}  // namespace symplant::pairing
