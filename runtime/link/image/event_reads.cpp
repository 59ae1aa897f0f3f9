// Which bits of the events the clients of a server have read, and with which value.
#include "symplant/link/image/event_reads.hpp"

#include "symplant/link/image/position_set.hpp"
#include "symplant/link/image/words.hpp"

namespace symplant::link::image {

namespace {

/// Sets bits of a word; writes it only if one of them is new, so that steady reads share the cache line.
void add_bits(std::atomic<std::uint64_t>& word, std::uint64_t bits) noexcept {
  if ((bits & ~word.load(std::memory_order_relaxed)) != 0) word.fetch_or(bits, std::memory_order_relaxed);
}

}  // namespace

EventReads::EventReads(std::uint32_t positions) : read_{Words(bit_words(positions)), Words(bit_words(positions))} {}

void EventReads::read(std::span<const std::uint64_t> image, std::uint32_t first, std::uint32_t count) noexcept {
  for_words(first, count, [&](std::size_t word, std::uint64_t mask) {
    add_bits(read_[0][word], mask & ~image[word]);
    add_bits(read_[1][word], mask & image[word]);
  });
  ranges_.read(first, count, now_.load(std::memory_order_relaxed));
}

bool EventReads::was_read(std::uint32_t position, bool on) const noexcept {
  const std::uint64_t word = read_[on ? 1 : 0][position / kBitsPerWord].load(std::memory_order_relaxed);
  return (word >> (position % kBitsPerWord) & 1) != 0;
}

}  // namespace symplant::link::image
