// Finds differences of operations and events by joining them on the words that they have in common.
#include "infer/differences.hpp"

#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>

#include "text/folding.hpp"

namespace symplant::infer {
namespace {

/// A text without one run of words.
struct Cut {
  std::uint32_t text;  ///< index in the words
  std::uint32_t begin;
  std::uint32_t count;
};

struct Side {
  std::vector<Cut> operations;
  std::vector<Cut> events;
};

/// A word as it is compared: a motion as its pair, which both positions have.
std::string compared(const std::string& word, const name::Vocabulary& vocabulary) {
  if (const auto motion = vocabulary.motion(word)) return text::folded(motion->rest_word);
  return word;
}

class Miner {
 public:
  Miner(const std::vector<SampleWords>& words, const name::Vocabulary& vocabulary, DifferenceLimits limits)
      : words_(words), vocabulary_(vocabulary), limits_(limits) {}

  std::vector<Difference> run() {
    for (std::uint32_t i = 0; i < words_.size(); ++i) cut(i);
    tally();
    std::vector<Difference> found;
    for (auto& [key, difference] : tally_) {
      if (difference.support >= limits_.least_support) found.push_back(std::move(difference));
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Difference& a, const Difference& b) { return a.support > b.support; });
    return found;
  }

 private:
  bool may_be_cut(const std::string& word) const { return !is_number(word) && !vocabulary_.motion(word); }

  void cut(std::uint32_t text) {
    const std::vector<std::string>& words = words_[text].words;
    if (words.size() > 16) return;
    std::vector<std::string> keys;
    keys.reserve(words.size());
    for (const std::string& word : words) keys.push_back(compared(word, vocabulary_));
    const auto add = [&](std::size_t begin, std::size_t count) {
      if (words.size() - count < limits_.least_common) return;
      std::string key;
      for (std::size_t i = 0; i < words.size(); ++i) {
        if (i >= begin && i < begin + count) continue;
        key.append(keys[i]).append(1, '\x1f');
      }
      Side& side = joined_[key];
      auto& cuts = words_[text].operation ? side.operations : side.events;
      if (cuts.size() < 4) {
        cuts.push_back({text, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(count)});
      }
    };
    add(words.size(), 0);
    for (std::size_t begin = limits_.fixed; begin < words.size(); ++begin) {
      for (std::size_t count = 1; count <= limits_.most_words && begin + count <= words.size(); ++count) {
        if (!may_be_cut(words[begin + count - 1])) break;
        add(begin, count);
      }
    }
  }

  std::vector<std::string> cut_words(const Cut& cut) const {
    const auto first = words_[cut.text].words.begin() + static_cast<std::ptrdiff_t>(cut.begin);
    return {first, first + static_cast<std::ptrdiff_t>(cut.count)};
  }

  void tally() {
    for (const auto& [key, side] : joined_) {
      if (side.operations.empty() || side.events.empty()) continue;
      if (side.operations.size() > 2 || side.events.size() > 3) continue;  // the common words are not specific
      for (const Cut& operation : side.operations) {
        for (const Cut& event : side.events) add(operation, event);
      }
    }
  }

  void add(const Cut& operation, const Cut& event) {
    if (operation.count == 0 && event.count == 0) return;
    if (operation.count != 0 && event.count != 0 && operation.begin != event.begin) return;
    std::vector<std::string> operation_words = cut_words(operation);
    std::vector<std::string> event_words = cut_words(event);
    if (operation_words == event_words) return;
    if (!operation_words.empty() && !event_words.empty() &&
        (operation_words.front() == event_words.front() || operation_words.back() == event_words.back())) {
      return;  // a shorter difference says the same
    }
    std::string key;
    for (const std::string& word : operation_words) key.append(word).append(1, ' ');
    key += '\x1f';
    for (const std::string& word : event_words) key.append(word).append(1, ' ');
    if (!counted_[key].emplace(operation.text, true).second) return;
    Difference& difference = tally_[key];
    const Cut& placed = operation.count != 0 ? operation : event;
    const std::size_t size = words_[placed.text].words.size();
    std::string before = text_of(placed.text, limits_.fixed, placed.begin);
    std::string after = text_of(placed.text, placed.begin + placed.count, size);
    if (!before.empty()) ++difference.before;
    if (!after.empty()) ++difference.after;
    if (++difference.support == 1) {
      difference.operation = std::move(operation_words);
      difference.event = std::move(event_words);
      difference.before_text = std::move(before);
      difference.after_text = std::move(after);
      difference.example_operation = operation.text;
      difference.example_event = event.text;
      return;
    }
    if (difference.before_text != before) difference.before_text.reset();
    if (difference.after_text != after) difference.after_text.reset();
  }

  std::string text_of(std::uint32_t text, std::size_t begin, std::size_t end) const {
    std::string joined;
    for (std::size_t i = begin; i < end; ++i) joined.append(joined.empty() ? "" : " ").append(words_[text].words[i]);
    return joined;
  }

  const std::vector<SampleWords>& words_;
  const name::Vocabulary& vocabulary_;
  DifferenceLimits limits_;
  std::unordered_map<std::string, Side> joined_;
  std::map<std::string, Difference> tally_;
  std::unordered_map<std::string, std::map<std::uint32_t, bool>> counted_;
};

}  // namespace

std::vector<Difference> differences_of(const std::vector<SampleWords>& words, const name::Vocabulary& vocabulary,
                                       DifferenceLimits limits) {
  return Miner(words, vocabulary, limits).run();
}

}  // namespace symplant::infer
