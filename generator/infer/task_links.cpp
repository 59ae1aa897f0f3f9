// Joins tasks on the words that they have in common.
#include "infer/task_links.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

#include "infer/causes.hpp"
#include "infer/words.hpp"
#include "text/ascii.hpp"

namespace symplant::infer {
namespace {

constexpr std::size_t kMostTokens = 9;
constexpr std::size_t kMostTasks = 4'000;  ///< of one device: beyond, its level is probably wrong

/// 1, 2ND, 3차: a word that counts.
bool counts(std::string_view word) {
  const std::size_t digits = word.find_first_not_of("0123456789");
  if (digits == std::string_view::npos) return !word.empty();
  if (digits == 0) return false;
  constexpr std::array<std::string_view, 6> kEnds = {"st", "nd", "rd", "th", "차", "호"};
  return is_one_of(word.substr(digits), kEnds);
}

/// RUNNING as RUNN, so that it meets RUN... only for comparison.
std::string_view stem(std::string_view word) {
  return word.size() > 6 && word.ends_with("ing") ? word.substr(0, word.size() - 3) : word;
}

/// Tokens without those at up to two indexes.
struct TaskCut {
  std::uint32_t task;
  std::array<std::uint8_t, 2> removed{};
  std::uint8_t count = 0;
};

class TaskMiner {
 public:
  TaskMiner(std::span<const Task> tasks, const name::Vocabulary& vocabulary)
      : tasks_(tasks), vocabulary_(vocabulary), known_(name::built_in_words()) {}

  std::vector<TaskDifference> run() {
    std::map<std::uint32_t, std::vector<std::uint32_t>> devices;
    for (std::uint32_t i = 0; i < tasks_.size(); ++i) devices[tasks_[i].device].push_back(i);
    for (const auto& [device, tasks] : devices) mine(tasks);
    std::vector<TaskDifference> found;
    for (auto& [key, difference] : tally_) {
      if (is_supported(difference)) found.push_back(std::move(difference));
    }
    std::stable_sort(found.begin(), found.end(), [](const TaskDifference& a, const TaskDifference& b) {
      return rank(a) != rank(b) ? rank(a) < rank(b) : operations(a) > operations(b);
    });
    return found;
  }

 private:
  static std::ptrdiff_t rank(const TaskDifference& difference) {
    return static_cast<std::ptrdiff_t>(difference.operation.size() + difference.event.size()) -
           (difference.causal ? 3 : 0);
  }
  static std::size_t operations(const TaskDifference& difference) {
    std::set<std::uint32_t> all;
    for (const TaskLink& link : difference.links) all.insert(link.operation);
    return all.size();
  }
  static bool is_supported(const TaskDifference& difference) {
    const std::size_t words = difference.operation.size() + difference.event.size();
    return operations(difference) >= (difference.causal ? 2U : words <= 2 ? 3U : 5U);
  }

  void mine(const std::vector<std::uint32_t>& tasks) {
    if (tasks.size() > kMostTasks) return;
    std::unordered_map<std::string, std::vector<TaskCut>> operations;
    std::unordered_map<std::string, std::vector<TaskCut>> events;
    for (const std::uint32_t index : tasks) {
      const Task& task = tasks_[index];
      if (task.tokens.size() > kMostTokens || task.tokens.empty()) continue;
      if (!task.operation && has_word(words_of(task), known_.alarm, vocabulary_)) continue;
      add_cuts(index, task.operation ? operations : events);
    }
    std::vector<std::pair<std::string_view, const std::vector<TaskCut>*>> ordered;
    ordered.reserve(operations.size());
    for (const auto& [key, cuts] : operations) ordered.emplace_back(key, &cuts);
    std::sort(ordered.begin(), ordered.end());
    for (const auto& [key, cuts] : ordered) {
      const auto found = events.find(std::string(key));
      if (found == events.end()) continue;
      const bool common = cuts->size() > 2 || found->second.size() > 2;
      for (const TaskCut& operation : *cuts) {
        for (const TaskCut& event : found->second) add(key, operation, event, common);
      }
    }
  }

  void add_cuts(std::uint32_t index, std::unordered_map<std::string, std::vector<TaskCut>>& cuts) const {
    const std::vector<TaskToken>& tokens = tasks_[index].tokens;
    std::vector<std::uint8_t> removable;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
      if (counts(tokens[i].word) || vocabulary_.motion(tokens[i].word)) continue;
      removable.push_back(static_cast<std::uint8_t>(i));
    }
    const auto add_cut = [&](TaskCut cut) { cuts[key_of(tokens, cut)].push_back(cut); };
    add_cut({index, {}, 0});
    for (std::size_t a = 0; a < removable.size(); ++a) {
      add_cut({index, {removable[a]}, 1});
      for (std::size_t b = a + 1; b < removable.size(); ++b) add_cut({index, {removable[a], removable[b]}, 2});
    }
  }

  static bool is_removed(const TaskCut& cut, std::size_t token) {
    return (cut.count > 0 && cut.removed[0] == token) || (cut.count > 1 && cut.removed[1] == token);
  }

  /// The kept words in whatever order, then the numbers in theirs: program 1 of robot 4 is not program 4 of robot 1.
  static std::string key_of(const std::vector<TaskToken>& tokens, const TaskCut& cut) {
    std::vector<std::string_view> kept;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
      if (!is_removed(cut, i)) kept.push_back(stem(tokens[i].word));
    }
    const auto numbers =
        std::stable_partition(kept.begin(), kept.end(), [](std::string_view word) { return !counts(word); });
    std::sort(kept.begin(), numbers);
    std::string key;
    for (const std::string_view word : kept) key.append(word).append(1, '\x1f');
    return key;
  }

  static std::vector<std::string> words_of(const Task& task) {
    std::vector<std::string> words;
    for (const TaskToken& token : task.tokens) words.push_back(token.word);
    return words;
  }

  std::vector<std::string> removed_words(const TaskCut& cut) const {
    std::vector<std::string> words;
    for (std::uint8_t i = 0; i < cut.count; ++i) {
      words.emplace_back(stem(tasks_[cut.task].tokens[cut.removed[i]].word));
    }
    return words;
  }

  /// Whether the words say that the operation causes the event.
  bool is_causal(const std::vector<std::string>& operation, const std::vector<std::string>& event) const {
    const std::string a = joined_words(operation);
    const std::string b = joined_words(event);
    for (const BuiltIn::Cause& cause : known_.causes) {
      if (cause.operation == a && (cause.event == b || b == std::string(cause.event) + " on")) return true;
    }
    return (!event.empty() && ends_in(b, known_.echo)) || (ends_in(a, known_.start) && ends_in(b, known_.done));
  }

  bool is_specific(std::string_view key, const Task& operation, bool causal) const {
    std::size_t solid = 0;
    bool motion = false;
    std::size_t words = 0;
    while (!key.empty()) {
      const std::string_view word = key.substr(0, key.find('\x1f'));
      key.remove_prefix(word.size() + 1);
      ++words;
      if (!counts(word)) ++solid;
      motion = motion || vocabulary_.motion(word).has_value();
    }
    if (causal) return words >= 1 || operation.path_words >= 1;
    return solid >= 1 && solid + operation.path_words + (motion ? 1 : 0) >= 3;
  }

  void add(std::string_view key, const TaskCut& operation_cut, const TaskCut& event_cut, bool common) {
    if (operation_cut.count == 0 && event_cut.count == 0) return;
    const std::vector<std::string> operation = removed_words(operation_cut);
    const std::vector<std::string> event = removed_words(event_cut);
    const auto in_both = [&](const std::string& word) {
      return std::find(event.begin(), event.end(), word) != event.end();
    };
    if (std::any_of(operation.begin(), operation.end(), in_both)) return;
    const Task& commanding = tasks_[operation_cut.task];
    if (!may_answer(words_of(tasks_[event_cut.task]), commanding)) return;
    if (resets(operation, tasks_[event_cut.task]) && !may_be_reset(event)) return;
    const bool causal = is_causal(operation, event);
    if ((!causal && common) || !is_specific(key, commanding, causal)) return;
    TaskDifference& difference = tally_[{operation, event}];
    difference.operation = operation;
    difference.event = event;
    difference.causal = causal;
    difference.links.push_back({operation_cut.task, event_cut.task});
  }

  /// Whether an operation resets what the event shows: it switches it off.
  bool resets(const std::vector<std::string>& operation, const Task& event) const {
    return has_word(operation, known_.reset, vocabulary_) && !has_word(words_of(event), known_.reset, vocabulary_);
  }

  /// Whether words that only the event has name what a reset of the same text ends: an alarm, or the last work.
  bool may_be_reset(const std::vector<std::string>& event) const {
    return std::all_of(event.begin(), event.end(), [&](const std::string& word) {
      return has_word({word}, known_.alarm, vocabulary_) || has_word({word}, known_.done, vocabulary_) ||
             word == "last";
    });
  }

  /// Whether an event may answer an operation: an interlock answers a permission of the other side. A permission and
  /// `non intf` are two interlocks: neither follows the other.
  bool may_answer(const std::vector<std::string>& event, const Task& operation) const {
    const std::vector<std::string> words = words_of(operation);
    if (has_word(event, known_.mutual, vocabulary_)) return has_word(words, known_.mutual, vocabulary_);
    return !has_word(event, known_.interlock, vocabulary_) || ends_in(joined_words(words), known_.start) ||
           has_word(words, known_.interlock, vocabulary_);
  }

  using BuiltIn = name::BuiltInWords;

  std::span<const Task> tasks_;
  const name::Vocabulary& vocabulary_;
  const BuiltIn& known_;
  std::map<std::pair<std::vector<std::string>, std::vector<std::string>>, TaskDifference> tally_;
};

}  // namespace

std::vector<TaskToken> tokens_of(const std::vector<std::string>& words) {
  std::vector<TaskToken> tokens;
  for (const std::string& word : words) {
    const std::size_t stem_end = word.find_last_not_of("0123456789") + 1;
    if (stem_end != 0) tokens.push_back({word.substr(0, stem_end), false});
    if (stem_end < word.size()) tokens.push_back({word.substr(stem_end), stem_end != 0});
  }
  return tokens;
}

bool is_one_of(std::string_view word, std::span<const std::string_view> list) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

bool ends_in(std::string_view words, std::span<const std::string_view> phrases) {
  return std::any_of(phrases.begin(), phrases.end(), [&](std::string_view phrase) {
    return words.ends_with(phrase) && (words.size() == phrase.size() || words[words.size() - phrase.size() - 1] == ' ');
  });
}

std::vector<TaskDifference> task_differences(std::span<const Task> tasks, const name::Vocabulary& vocabulary) {
  return TaskMiner(tasks, vocabulary).run();
}

}  // namespace symplant::infer
