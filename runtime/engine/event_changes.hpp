// The words of events that change: in one instant, and since the link last forgot them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "symplant/engine/arena.hpp"
#include "symplant/engine/bit_words.hpp"
#include "symplant/engine/dirty_set.hpp"
#include "symplant/engine/instant.hpp"

namespace symplant::engine {

class EventChanges {
 public:
  void take(Arena& arena, std::size_t words) noexcept {
    words_ = arena.take<Word>(words);
    since_forgotten_.take(arena, words);
    of_instant_.take(arena, words);
    instant_ = first_kept_ = 1;
    flickered_ = false;
  }

  /// Called before a word changes; `bits` is the word as it is.
  void note(std::uint32_t number, std::uint64_t bits) noexcept {
    Word& word = words_[number];
    if (word.instant != instant_) {
      add(number, bits);
    } else {
      word.flickered |= word.before ^ bits;
      flickered_ = flickered_ || word.flickered != 0;
    }
  }

  /// As note(), while every event has changed at most once in this instant.
  void note_first(std::uint32_t number, std::uint64_t bits) noexcept {
    if (words_[number].instant != instant_) add(number, bits);
  }

  /// The words noted in this instant, with their net changes `bits`; words without a net change are left out. Calls
  /// `function(change, flickered)` for each word, before it is left out: `flickered` are the bits that changed and
  /// changed back.
  template <class Function>
  std::span<const WordChange> close(const std::uint64_t* bits, Function function) noexcept {
    std::uint32_t kept = 0;
    for (const WordChange& noted : of_instant_.view()) {
      const Word& word = words_[noted.word];
      const WordChange change{noted.word, word.before ^ bits[noted.word]};
      function(change, word.flickered & ~change.bits);
      of_instant_.items[kept] = change;
      kept += change.bits != 0 ? 1 : 0;
    }
    return {of_instant_.items, kept};
  }
  /// To be called after close(), to replace its result by all events that are on.
  std::span<const WordChange> all_on(const BitWords& bits) noexcept {
    of_instant_.size = 0;
    for (std::uint32_t word = 0; word < bits.size(); ++word) {
      if (bits[word] != 0) of_instant_.add({word, bits[word]});
    }
    return of_instant_.view();
  }
  void next_instant() noexcept {
    of_instant_.size = 0;
    flickered_ = false;
    ++instant_;
  }
  /// Whether an event may have changed and changed back in this instant.
  bool flickered() const noexcept { return flickered_; }

  std::span<const std::uint32_t> since_forgotten() const noexcept { return since_forgotten_.view(); }
  void forget() noexcept {
    since_forgotten_.size = 0;
    first_kept_ = instant_;
  }
  /// Notes all words as changed. Only between instants.
  void note_all(std::uint32_t words) noexcept {
    for (std::uint32_t word = 0; word < words; ++word) note(word, 0);
    next_instant();
  }

 private:
  struct Word {
    std::uint64_t instant;  ///< the last one in which it changed
    std::uint64_t before;   ///< as that instant began
    std::uint64_t flickered;
  };
  void add(std::uint32_t number, std::uint64_t bits) noexcept {
    if (words_[number].instant < first_kept_) since_forgotten_.add(number);
    words_[number] = {instant_, bits, 0};
    of_instant_.add({number, 0});
  }

  Word* words_;
  List<std::uint32_t> since_forgotten_;
  List<WordChange> of_instant_;
  std::uint64_t instant_;     ///< number of this instant
  std::uint64_t first_kept_;  ///< number of the first instant that is not forgotten
  bool flickered_;
};

}  // namespace symplant::engine
