// Reads the words of a task.
#include "name/task_reader.hpp"

#include <algorithm>

#include "text/ascii.hpp"
#include "text/folding.hpp"

namespace symplant::name {
namespace {

struct TaskWord {
  std::string shown;
  std::string folded;
};

bool is_number(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return text::is_digit(c); });
}

std::vector<std::string> split(std::string_view words) {
  std::vector<std::string> parts;
  while (!words.empty()) {
    const std::size_t blank = words.find(' ');
    parts.emplace_back(words.substr(0, blank));
    words.remove_prefix(blank == words.npos ? words.size() : blank + 1);
  }
  return parts;
}

/// Replaces synonyms, the longest first.
void replace_synonyms(std::vector<TaskWord>& words, const Vocabulary& vocabulary) {
  for (std::size_t at = 0; at < words.size(); ++at) {
    for (std::size_t count = std::min(vocabulary.longest_synonym(), words.size() - at); count > 0; --count) {
      std::string joined = words[at].folded;
      for (std::size_t i = 1; i < count; ++i) joined.append(" ").append(words[at + i].folded);
      const std::string_view canonical = vocabulary.synonym(joined);
      if (canonical.empty()) continue;
      std::vector<TaskWord> replaced;
      for (std::string& word : split(canonical)) {
        std::string folded = text::folded(word);
        replaced.push_back({std::move(word), std::move(folded)});
      }
      const auto first = words.begin() + static_cast<std::ptrdiff_t>(at);
      const std::size_t length = replaced.size();
      words.insert(words.erase(first, first + static_cast<std::ptrdiff_t>(count)),
                   std::make_move_iterator(replaced.begin()), std::make_move_iterator(replaced.end()));
      at += length == 0 ? 0 : length - 1;
      break;
    }
  }
}

/// The index of the word that is the motion: the last one, words that also name things only without others.
std::size_t motion_of(const std::vector<TaskWord>& words, const Vocabulary& vocabulary) {
  std::size_t found = words.size();
  bool found_noun = false;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto motion = vocabulary.motion(words[i].folded);
    if (!motion || (motion->noun && found != words.size() && !found_noun)) continue;
    found = i;
    found_noun = motion->noun;
  }
  return found;
}

std::string join(const std::vector<TaskWord>& words, std::string TaskWord::*text) {
  std::string all;
  for (const TaskWord& word : words) {
    if (!all.empty()) all += ' ';
    all += word.*text;
  }
  return all;
}

}  // namespace

ReadTask read_task(const std::vector<std::string_view>& shown, const std::vector<std::string_view>& folded,
                   Direction side, const TaskRules& rules, const Vocabulary& vocabulary) {
  std::vector<TaskWord> words;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if (!vocabulary.is_affix(folded[i], side)) words.push_back({std::string(shown[i]), std::string(folded[i])});
  }
  if (words.empty()) {  // affixes alone
    for (std::size_t i = 0; i < shown.size(); ++i) words.push_back({std::string(shown[i]), std::string(folded[i])});
  }
  replace_synonyms(words, vocabulary);

  ReadTask task;
  const std::size_t at = motion_of(words, vocabulary);
  if (at == words.size()) {
    task.canonical = join(words, &TaskWord::shown);
    task.group = task.numbered_group = join(words, &TaskWord::folded);
    return task;
  }
  const Motion motion = *vocabulary.motion(words[at].folded);
  task.pair = motion.pair;
  task.rest = motion.rest;
  task.index = motion.index;
  const bool counted = side == Direction::event && rules.sensor_index != SensorIndex::off && !rules.sequence;
  const std::string canonical(motion.canonical);
  const std::string rest_word = text::folded(motion.rest_word);
  const std::string number(motion.index);
  words[at] = {canonical + number, rest_word + number};
  task.numbered_group = join(words, &TaskWord::folded);
  if (counted) {
    words[at] = {canonical, rest_word};
    if (at + 1 < words.size() && number.empty() && is_number(words[at + 1].folded)) {
      task.index = words[at + 1].folded;
      words.erase(words.begin() + static_cast<std::ptrdiff_t>(at) + 1);
    }
  }
  task.canonical = join(words, &TaskWord::shown);
  task.group = join(words, &TaskWord::folded);
  return task;
}

}  // namespace symplant::name
