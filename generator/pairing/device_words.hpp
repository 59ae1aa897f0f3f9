// The words of device levels.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "pairing/work.hpp"

namespace symplant::pairing {

/// Calls `take(word)` for each word of a device level.
template <class Take>
void for_each_word(std::string_view device, Take&& take) {
  while (!device.empty()) {
    const std::size_t end = std::min(device.find('_'), device.size());
    if (end != 0) take(device.substr(0, end));
    device.remove_prefix(std::min(end + 1, device.size()));
  }
}

bool has_word(std::string_view device, std::string_view word);

/// The number of words of `part` if `whole` has all of them, else 0.
std::size_t count_contained(std::string_view part, std::string_view whole);

/// Whether two devices are of one process of one controller.
bool same_process(const Work& work, std::uint32_t a, std::uint32_t b);

}  // namespace symplant::pairing
