// Wait-free transfer of an image: updates a slot with the changed words, then publishes it.
#include "symplant/share/shared_words.hpp"

namespace symplant::share {

SharedWords::SharedWords(const std::vector<std::uint64_t>& initial)
    : current_(initial), slots_(initial), missing_in_(initial.size(), 0) {
  for (auto& words : missing_) words.reserve(initial.size());
}

void SharedWords::touch(std::size_t word) noexcept {
  for (std::size_t slot = 0; slot < kSlots; ++slot) {
    const auto bit = static_cast<std::uint8_t>(1U << slot);
    if ((missing_in_[word] & bit) != 0) continue;
    missing_in_[word] = static_cast<std::uint8_t>(missing_in_[word] | bit);
    missing_[slot].push_back(word);  // never exceeds the reserved capacity: a slot lists a word once
  }
}

void SharedWords::publish() noexcept {
  const std::size_t slot = slots_.back_index();
  const auto bit = static_cast<std::uint8_t>(1U << slot);
  Words& target = slots_.back();
  for (const std::size_t word : missing_[slot]) {
    target[word] = current_[word];
    missing_in_[word] = static_cast<std::uint8_t>(missing_in_[word] & ~bit);
  }
  missing_[slot].clear();
  slots_.publish();
}

}  // namespace symplant::share
