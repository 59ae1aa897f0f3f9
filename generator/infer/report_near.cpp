// Unpaired operations with the unpaired events that are closest to them.
#include <algorithm>
#include <bit>
#include <map>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "infer/report_parts.hpp"
#include "infer/words.hpp"
#include "name/vocabulary.hpp"

namespace symplant::infer {
namespace {

constexpr std::size_t kMostNearMisses = 20;
constexpr std::size_t kMostEvents = 3;       ///< of an operation
constexpr std::size_t kMostVisited = 5'000;  ///< events that are compared with an operation
constexpr std::size_t kLeastShared = 2;      ///< words, and at least half of the operation's
constexpr std::size_t kLeastOfSeries = 3;
constexpr std::size_t kMostOpenLinks = 200;
constexpr std::size_t kMostOtherWords = 2;  ///< words of an operation of a series that its event lacks

/// Unpaired events by their words and motions, and by their words without digits.
class EventIndex {
 public:
  explicit EventIndex(const ReportInput& input) : input_(input) {
    for (std::uint32_t i = 0; i < input.samples.size(); ++i) {
      if (input.is_operation(i) || !input.is_left_over(i)) continue;
      ++count_;
      for (const std::string& key : keys_of(i)) events_[key].push_back(i);
    }
  }

  /// At most `kMostEvents`, the closest first. O(kMostVisited).
  std::vector<std::uint32_t> closest(std::uint32_t operation) const {
    std::vector<std::pair<const std::vector<std::uint32_t>*, bool>> postings;  // and whether it is a word
    std::size_t words = 0;
    for (const std::string& key : keys_of(operation)) {
      const bool word = key.front() != kStem;
      words += word ? 1 : 0;
      const auto found = events_.find(key);
      if (found != events_.end()) postings.emplace_back(&found->second, word);
    }
    std::stable_sort(postings.begin(), postings.end(),
                     [](const auto& a, const auto& b) { return a.first->size() < b.first->size(); });
    std::unordered_map<std::uint32_t, Rank> ranks;
    std::size_t visited = 0;
    for (const auto& [events, word] : postings) {
      visited += events->size();
      if (visited > kMostVisited && !ranks.empty()) break;
      const auto weight = static_cast<std::size_t>(std::bit_width(count_ / events->size()));
      const std::size_t end = std::min(events->size(), kMostVisited);
      for (std::size_t i = 0; i < end; ++i) {
        Rank& rank = ranks[(*events)[i]];
        rank.shared += word ? 1 : 0;
        rank.weight += weight * (word ? 2 : 1);
      }
    }
    return best(ranks, std::max(kLeastShared, (words + 1) / 2), input_.samples[operation].controller);
  }

  /// Words, of which a motion is its canonical word, and words without their digits after a mark.
  std::vector<std::string> keys_of(std::uint32_t sample) const {
    std::vector<std::string> keys;
    for (std::string& word : input_.texts.words(sample)) {
      if (const auto motion = input_.naming.vocabulary().motion(word)) {
        keys.emplace_back(motion->canonical);
        continue;
      }
      const std::string stem = word.substr(0, word.find_last_not_of("0123456789") + 1);
      if (!stem.empty() && stem != word) keys.push_back(kStem + stem);
      keys.push_back(std::move(word));
    }
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    return keys;
  }

 private:
  static constexpr char kStem = '\x01';

  struct Rank {
    std::size_t shared = 0;
    std::size_t weight = 0;
  };

  std::vector<std::uint32_t> best(const std::unordered_map<std::uint32_t, Rank>& ranks, std::size_t least,
                                  std::uint32_t controller) const {
    std::vector<std::pair<std::size_t, std::uint32_t>> order;
    for (const auto& [event, rank] : ranks) {
      if (rank.shared < least || input_.samples[event].controller != controller) continue;
      order.emplace_back(rank.weight, event);
    }
    const auto first = [&](const auto& a, const auto& b) {
      if (a.first != b.first) return a.first > b.first;
      return std::tie(input_.samples[a.second].text.name, a.second) <
             std::tie(input_.samples[b.second].text.name, b.second);
    };
    const auto end = order.begin() + static_cast<std::ptrdiff_t>(std::min(order.size(), kMostEvents));
    std::partial_sort(order.begin(), end, order.end(), first);
    std::vector<std::uint32_t> events;
    for (auto event = order.begin(); event != end; ++event) events.push_back(event->second);
    return events;
  }

  const ReportInput& input_;
  std::size_t count_ = 0;
  std::unordered_map<std::string, std::vector<std::uint32_t>> events_;
};

class NearMisses {
 public:
  NearMisses(const ReportInput& input, Report& report) : input_(input), report_(report), index_(input) {}

  void run() {
    using Operations = std::vector<std::uint32_t>;
    std::map<std::string, Operations> shapes;
    for (std::uint32_t i = 0; i < input_.samples.size(); ++i) {
      if (input_.is_operation(i) && input_.is_left_over(i)) shapes[shape_of(input_.texts.normal(i))].push_back(i);
    }
    std::vector<const Operations*> order;
    for (auto& [shape, operations] : shapes) {
      std::sort(operations.begin(), operations.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::tie(input_.samples[a].text.name, a) < std::tie(input_.samples[b].text.name, b);
      });
      order.push_back(&operations);
    }
    std::stable_sort(order.begin(), order.end(),
                     [](const Operations* a, const Operations* b) { return a->size() > b->size(); });
    std::size_t looked_at = 0;
    for (const Operations* operations : order) {
      if (++looked_at > kMostOpenLinks) break;
      add(*operations);
    }
  }

 private:
  void add(const std::vector<std::uint32_t>& operations) {
    const std::vector<std::uint32_t> events = index_.closest(operations.front());
    if (events.empty()) return;
    if (report_.near_misses.size() < kMostNearMisses) {
      report_.near_misses.push_back({input_.texts.shown(operations.front()), operations.size(), shown(events)});
    }
    if (operations.size() < kLeastOfSeries || !is_series(operations.front(), events.front())) return;
    for (const std::uint32_t operation : operations) {
      if (report_.open_links.size() == kMostOpenLinks) return;
      report_.open_links.push_back(
          {name(operation), motion_of(operation), comment(operation), named(index_.closest(operation))});
    }
  }

  std::string name(std::uint32_t sample) const { return std::string(input_.samples[sample].text.name); }
  std::string comment(std::uint32_t sample) const {
    return input_.texts.source(sample) == name::Source::name ? std::string() : input_.texts.shown(sample);
  }

  std::vector<std::string> shown(const std::vector<std::uint32_t>& samples) const {
    std::vector<std::string> texts;
    texts.reserve(samples.size());
    for (const std::uint32_t sample : samples) texts.push_back(input_.texts.shown(sample));
    return texts;
  }

  /// Names with their comments if these are what the rule reads.
  std::vector<std::string> named(const std::vector<std::uint32_t>& samples) const {
    std::vector<std::string> texts;
    for (const std::uint32_t sample : samples) {
      const std::string text = comment(sample);
      texts.push_back(text.empty() ? name(sample) : name(sample) + " " + text);
    }
    return texts;
  }

  /// The last motion in a text; empty without one.
  std::string motion_of(std::uint32_t sample) const {
    std::string state;
    for (const std::string& word : input_.texts.words(sample)) {
      if (const auto motion = input_.naming.vocabulary().motion(word)) state = motion->canonical;
    }
    return state;
  }

  /// Whether an operation moves something numbered, and an event of a motion has nearly the same words with other
  /// numbers.
  bool is_series(std::uint32_t operation, std::uint32_t event) const {
    if (motion_of(operation).empty() || motion_of(event).empty()) return false;
    std::vector<std::string> others;
    for (const std::string& word : input_.texts.words(event)) others.push_back(shape_of(word));
    std::size_t missing = 0;
    bool numbered = false;
    for (const std::string& word : input_.texts.words(operation)) {
      const std::string shape = shape_of(word);
      numbered = numbered || shape != word;
      if (std::find(others.begin(), others.end(), shape) == others.end()) ++missing;
    }
    return numbered && missing <= kMostOtherWords;
  }

  const ReportInput& input_;
  Report& report_;
  EventIndex index_;
};

}  // namespace

void add_near_misses(const ReportInput& input, Report& report) { NearMisses(input, report).run(); }

}  // namespace symplant::infer
