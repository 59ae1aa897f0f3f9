// Wait-free hand-over of an image: brings the slot to hand over up to date and gives it away.
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
    missing_[slot].push_back(word);  // never beyond the reserve: a word is named once
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
