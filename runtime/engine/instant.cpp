// Lists of changed words.
#include "symplant/engine/instant.hpp"

#include <algorithm>

namespace symplant::engine {

std::uint32_t toggle(std::span<WordChange> all, std::uint32_t size, const std::uint64_t* masks) noexcept {
  const std::span<WordChange> listed = all.first(size);
  std::sort(listed.begin(), listed.end(), [](const WordChange& a, const WordChange& b) { return a.word < b.word; });
  const std::uint32_t before = size;
  std::uint32_t next = 0;  // in `listed`
  for (std::uint32_t word = 0; word < all.size(); ++word) {
    while (next < before && all[next].word < word) ++next;
    if (masks[word] == 0) continue;
    if (next < before && all[next].word == word) {
      all[next].bits ^= masks[word];
    } else {
      all[size++] = {word, masks[word]};
    }
  }
  WordChange* const end =
      std::remove_if(all.data(), all.data() + size, [](const WordChange& change) { return change.bits == 0; });
  return static_cast<std::uint32_t>(end - all.data());
}

}  // namespace symplant::engine
