// The words of device levels.
#include "pairing/device_words.hpp"

#include "text/ascii.hpp"

namespace symplant::pairing {

bool has_word(std::string_view device, std::string_view word) {
  bool found = false;
  for_each_word(device, [&](std::string_view one) { found = found || text::equal_ignoring_case(one, word); });
  return found;
}

std::size_t count_contained(std::string_view part, std::string_view whole) {
  std::size_t words = 0;
  bool all = true;
  for_each_word(part, [&](std::string_view word) {
    ++words;
    all = all && has_word(whole, word);
  });
  return all ? words : 0;
}

bool same_process(const Work& work, std::uint32_t a, std::uint32_t b) {
  const std::uint32_t first = work.devices[a];
  const std::uint32_t second = work.devices[b];
  return work.inputs[first].controller == work.inputs[second].controller &&
         work.reading(first).levels->process_id == work.reading(second).levels->process_id;
}

}  // namespace symplant::pairing
