// The BOOL events that an importer sees.
#include "symplant/fmi/shown_events.hpp"

#include <bit>

namespace symplant::fmi {

void ShownEvents::restart(const plant::Plant& plant) {
  const std::size_t words = plant.tables().event_bits / 64;
  shown_.resize(words);
  for (std::uint32_t w = 0; w < words; ++w) shown_[w] = plant.events()[w];
  seen_.assign(words, 0);
  touched_.clear();
  touched_.reserve(words);  // see() allocates nothing
  held_.clear();
  short_pulses_ = 0;
}

void ShownEvents::differ(std::uint32_t word, std::uint64_t bits) noexcept {
  if (bits == 0) return;
  if (seen_[word] == 0) touched_.push_back(word);
  seen_[word] |= bits;
}

void ShownEvents::begin(const plant::Plant& plant) {
  for (const std::uint32_t word : held_) differ(word, plant.events()[word] ^ shown_[word]);
  held_.clear();
}

void ShownEvents::see(const plant::Plant& plant, const engine::Instant& instant) noexcept {
  for (const engine::WordChange& change : instant.events) {
    const std::uint64_t differing = plant.events()[change.word] ^ shown_[change.word];
    short_pulses_ += static_cast<std::uint64_t>(std::popcount(change.bits & seen_[change.word] & ~differing));
    differ(change.word, differing);
  }
}

void ShownEvents::end(const plant::Plant& plant) {
  for (const std::uint32_t word : touched_) {
    shown_[word] ^= seen_[word];
    seen_[word] = 0;
    if (shown_[word] != plant.events()[word]) held_.push_back(word);
  }
  touched_.clear();
}

std::vector<std::uint32_t> ShownEvents::held(const plant::Plant& plant) const {
  std::vector<std::uint32_t> bits;
  for (const std::uint32_t word : held_) {
    for (std::uint64_t rest = shown_[word] ^ plant.events()[word]; rest != 0; rest &= rest - 1) {
      bits.push_back(64 * word + static_cast<std::uint32_t>(std::countr_zero(rest)));
    }
  }
  return bits;
}

std::vector<std::uint64_t> ShownEvents::save() const {
  std::vector<std::uint64_t> numbers = shown_;
  numbers.push_back(short_pulses_);
  return numbers;
}

bool ShownEvents::restore(const std::vector<std::uint64_t>& numbers, const plant::Plant& plant) {
  if (numbers.size() != shown_.size() + 1) return false;
  restart(plant);
  short_pulses_ = numbers.back();
  for (std::uint32_t w = 0; w < shown_.size(); ++w) {
    if (shown_[w] != numbers[w]) held_.push_back(w);
    shown_[w] = numbers[w];
  }
  return true;
}

}  // namespace symplant::fmi
