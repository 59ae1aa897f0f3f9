// Makes archetypes of the differences of tasks within devices.
#include "infer/archetypes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "infer/causes.hpp"
#include "infer/task_links.hpp"
#include "name/prepared_text.hpp"
#include "name/vocabulary.hpp"

namespace symplant::infer {
namespace {

constexpr std::size_t kMostArchetypes = 40;

using Tokens = std::vector<TaskToken>;

std::vector<Task> unpaired_tasks(const Applied& applied, std::span<const Sample> samples,
                                 const name::Separators& separators) {
  name::PreparedText text;
  std::vector<Task> all;
  for (std::uint32_t i = 0; i < samples.size(); ++i) {
    const name::Reading& reading = applied.readings[i];
    const name::Account account = applied.pairing.accounts[i];
    if (!is_unpaired(account) && account != name::Account::data) continue;
    if (!reading.is_read() || reading.role != name::Role::io || !samples[i].boolean) continue;
    Task& task = all.emplace_back();
    task.sample = i;
    task.device = reading.levels->device_id;
    task.operation = reading.direction == name::Direction::operation;
    text.prepare(reading.levels->path, separators);
    task.path_words = text.words().size();
    text.prepare(reading.task->text, separators);
    std::vector<std::string> words;
    for (const name::Word& word : text.words()) {
      words.emplace_back(text.folded().substr(word.begin, word.end - word.begin));
    }
    task.tokens = tokens_of(words);
  }
  return all;
}

/// The text of tokens of which [begin, end) are `{x}`.
std::string text_with_x(const Tokens& tokens, std::size_t begin, std::size_t end) {
  std::string text;
  const auto add = [&](std::string_view word, bool glued) {
    if (!text.empty() && !glued) text += ' ';
    text += word;
  };
  for (std::size_t i = 0; i < begin; ++i) add(tokens[i].word, tokens[i].glued);
  if (begin != end) add("{x}", begin < tokens.size() && tokens[begin].glued);
  for (std::size_t i = end; i < tokens.size(); ++i) add(tokens[i].word, tokens[i].glued);
  return text;
}

/// Texts of an operation and an event with one run that both have as `{x}`, and texts without one.
struct Skeleton {
  std::string operation;
  std::string event;

  friend bool operator<(const Skeleton& a, const Skeleton& b) {
    return std::tie(a.operation, a.event) < std::tie(b.operation, b.event);
  }
};

std::vector<Skeleton> skeletons_of(const Tokens& operation, const Tokens& event) {
  std::vector<Skeleton> all{{text_with_x(operation, 0, 0), text_with_x(event, 0, 0)}};
  for (std::size_t begin = 0; begin < operation.size(); ++begin) {
    for (std::size_t end = begin + 1; end <= operation.size(); ++end) {
      const std::size_t length = end - begin;
      if (length == operation.size()) continue;
      for (std::size_t at = 0; at + length <= event.size(); ++at) {
        const auto same = [](const TaskToken& a, const TaskToken& b) { return a.word == b.word; };
        if (!std::equal(operation.begin() + static_cast<std::ptrdiff_t>(begin),
                        operation.begin() + static_cast<std::ptrdiff_t>(end),
                        event.begin() + static_cast<std::ptrdiff_t>(at), same)) {
          continue;
        }
        if (length == event.size()) continue;
        all.push_back({text_with_x(operation, begin, end), text_with_x(event, at, at + length)});
      }
    }
  }
  return all;
}

/// Words of a text that are not `{x}`; digits in it count against it, since they belong to `{x}`.
std::ptrdiff_t literal_words(std::string_view text) {
  std::ptrdiff_t words = 0;
  bool in_word = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text.substr(i).starts_with("{x}")) {
      i += 2;
      in_word = false;
    } else if (text[i] == ' ') {
      in_word = false;
    } else if (!in_word) {
      words += text[i] >= '0' && text[i] <= '9' ? -1 : 1;
      in_word = true;
    }
  }
  return words;
}

/// A pair of texts, and the operations that it explains.
struct FoundTexts {
  Skeleton texts;
  std::vector<std::string> operation_words;  ///< that only the operation has
  std::vector<std::string> event_words;
  std::size_t support = 0;
};

class ArchetypeFinder {
 public:
  explicit ArchetypeFinder(const std::vector<Task>& tasks) : tasks_(tasks) {}

  std::vector<FoundTexts> run(const name::Vocabulary& vocabulary) {
    for (const TaskDifference& difference : task_differences(tasks_, vocabulary)) take(difference);
    return std::move(found_);
  }

 private:
  bool is_ack(const TaskDifference& difference) const {
    const name::BuiltInWords& known = name::built_in_words();
    if (difference.event.empty()) return true;
    if (difference.operation.empty()) return false;
    return is_one_of(difference.operation.back(), known.echo) || is_one_of(difference.operation.back(), known.reset);
  }

  /// Texts that explain the most of the difference's links, again and again. An event is used once, acknowledges apart.
  void take(const TaskDifference& difference) {
    const bool ack = is_ack(difference);
    std::map<std::uint32_t, std::uint32_t> open;  // operation, event
    std::map<Skeleton, std::set<std::uint32_t>> by_texts;
    for (const TaskLink& link : difference.links) {
      if (used_operations_.contains(link.operation) || (!ack && used_events_.contains(link.event))) continue;
      if (!open.emplace(link.operation, link.event).second) continue;
      for (Skeleton& texts : skeletons_of(tasks_[link.operation].tokens, tasks_[link.event].tokens)) {
        by_texts[std::move(texts)].insert(link.operation);
      }
    }
    const std::size_t least = difference.causal ? 2 : 3;
    while (!open.empty()) {
      const auto best = best_of(by_texts, open);
      if (best.second < least) break;
      found_.push_back({best.first->first, difference.operation, difference.event, best.second});
      for (const std::uint32_t operation : best.first->second) {
        const auto link = open.find(operation);
        if (link == open.end()) continue;
        used_operations_.insert(operation);
        if (!ack) used_events_.insert(link->second);
        open.erase(link);
      }
    }
  }

  using ByTexts = std::map<Skeleton, std::set<std::uint32_t>>;

  static std::pair<ByTexts::const_iterator, std::size_t> best_of(const ByTexts& by_texts,
                                                                 const std::map<std::uint32_t, std::uint32_t>& open) {
    std::pair<ByTexts::const_iterator, std::size_t> best{by_texts.end(), 0};
    std::ptrdiff_t best_words = 0;
    for (auto texts = by_texts.begin(); texts != by_texts.end(); ++texts) {
      const std::ptrdiff_t operation_words = literal_words(texts->first.operation);
      const std::ptrdiff_t event_words = literal_words(texts->first.event);
      if (operation_words < 1 || event_words < 1) continue;
      const auto count =
          static_cast<std::size_t>(std::count_if(texts->second.begin(), texts->second.end(),
                                                 [&](std::uint32_t operation) { return open.contains(operation); }));
      const std::ptrdiff_t words = operation_words + event_words;
      if (count < best.second || (count == best.second && words <= best_words)) continue;
      best = {texts, count};
      best_words = words;
    }
    return best;
  }

  const std::vector<Task>& tasks_;
  std::set<std::uint32_t> used_operations_;
  std::set<std::uint32_t> used_events_;
  std::vector<FoundTexts> found_;
};

std::string name_of(std::string_view text) {
  std::string name;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text.substr(i).starts_with("{x}")) {
      i += 2;
    } else if (text[i] == ' ') {
      if (!name.empty() && name.back() != '-') name += '-';
    } else {
      name += text[i];
    }
  }
  while (!name.empty() && name.back() == '-') name.pop_back();
  return name;
}

std::string without_x(std::string_view text) {
  std::string words = name_of(text);
  std::replace(words.begin(), words.end(), '-', ' ');
  return words;
}

using Role = name::ArchetypeRole;

FoundArchetype mirror_of(const FoundTexts& found) {
  FoundArchetype mirror;
  mirror.archetype.name = name_of(found.texts.operation);
  mirror.archetype.delay = 50'000'000;
  mirror.archetype.texts = {{Role::operation, found.texts.operation}, {Role::event, found.texts.event}};
  mirror.support = found.support;
  return mirror;
}

/// The role of an operation whose event reports work as done; nothing if it only follows.
std::optional<Role> work_role(const FoundTexts& found) {
  const name::BuiltInWords& known = name::built_in_words();
  if (!found.operation_words.empty()) {
    if (is_one_of(found.operation_words.back(), known.echo)) return Role::ack;
    if (is_one_of(found.operation_words.back(), known.reset) && !ends_in(without_x(found.texts.event), known.reset)) {
      return Role::reset;
    }
  }
  const bool work =
      ends_in(without_x(found.texts.event), known.done) && ends_in(without_x(found.texts.operation), known.start);
  return work ? std::optional(Role::start) : std::nullopt;
}

std::vector<FoundArchetype> archetypes_from(const std::vector<FoundTexts>& all) {
  std::vector<FoundArchetype> archetypes;
  std::map<std::string, std::size_t> handshakes;  // text of `done` -> index
  for (const FoundTexts& found : all) {
    const std::optional<Role> role = work_role(found);
    if (!role) {
      archetypes.push_back(mirror_of(found));
      continue;
    }
    const auto [known, added] = handshakes.emplace(found.texts.event, archetypes.size());
    if (added) {
      FoundArchetype& handshake = archetypes.emplace_back();
      handshake.archetype.name = name_of(found.texts.event);
      handshake.archetype.model = name::ArchetypeModel::handshake;
      handshake.archetype.takes = 3'000'000'000;
      handshake.archetype.texts = {{Role::done, found.texts.event}};
    }
    FoundArchetype& handshake = archetypes[known->second];
    const auto same_role = [&](const auto& text) { return text.first == *role; };
    if (std::any_of(handshake.archetype.texts.begin(), handshake.archetype.texts.end(), same_role)) {
      archetypes.push_back(mirror_of(found));
    } else {
      handshake.archetype.texts.emplace_back(*role, found.texts.operation);
      handshake.support += found.support;
    }
  }
  // More literal texts first: an open {x} must not take what belongs to another archetype.
  const auto literal = [](const FoundArchetype& found) {
    std::ptrdiff_t words = 0;
    for (const auto& [role, text] : found.archetype.texts) words += literal_words(text);
    return words * 12 / static_cast<std::ptrdiff_t>(found.archetype.texts.size());
  };
  std::stable_sort(archetypes.begin(), archetypes.end(), [&](const FoundArchetype& a, const FoundArchetype& b) {
    return literal(a) != literal(b) ? literal(a) > literal(b) : a.support > b.support;
  });
  return archetypes;
}

/// Adds an archetype; a name that is taken gets a number.
void add_named(name::Archetype archetype, std::vector<name::Archetype>& all) {
  const std::string wanted = archetype.name;
  const auto taken = [&](const name::Archetype& other) { return other.name == archetype.name; };
  for (int number = 2; std::any_of(all.begin(), all.end(), taken); ++number) {
    archetype.name = fmt::format("{}-{}", wanted, number);
  }
  all.push_back(std::move(archetype));
}

std::shared_ptr<const name::CompiledNaming> compiled(const name::Naming& naming) {
  std::vector<name::NamingFault> faults;
  return name::CompiledNaming::compile(naming, faults);
}

}  // namespace

std::vector<FoundArchetype> archetypes_of(const Applied& applied, std::span<const Sample> samples,
                                          const name::CompiledNaming& naming) {
  const std::vector<Task> tasks = unpaired_tasks(applied, samples, name::Separators(naming.naming().separators));
  return archetypes_from(ArchetypeFinder(tasks).run(naming.vocabulary()));
}

name::Naming with_archetypes(const name::Naming& naming, std::span<const Sample> samples,
                             std::vector<std::string>& steps) {
  const auto before = compiled(naming);
  const Applied applied = apply_rule(before, samples);
  std::vector<FoundArchetype> found = archetypes_of(applied, samples, *before);
  if (found.size() > kMostArchetypes) found.resize(kMostArchetypes);
  name::Naming all = naming;
  for (const FoundArchetype& one : found) add_named(one.archetype, all.archetypes);
  const auto with = compiled(all);
  if (with == nullptr) return naming;
  const Applied after = apply_rule(with, samples);
  std::vector<std::size_t> used(all.archetypes.size());
  for (const pairing::Facet& facet : after.pairing.facets) {
    if (facet.by == pairing::FacetBy::archetype) used[facet.archetype] += facet.members.size();
  }
  name::Naming result = naming;
  for (std::size_t i = naming.archetypes.size(); i < all.archetypes.size(); ++i) {
    if (used[i] == 0) continue;
    steps.push_back(fmt::format("archetype `{}`: {} symbols", all.archetypes[i].name, used[i]));
    result.archetypes.push_back(all.archetypes[i]);
  }
  return result;
}

}  // namespace symplant::infer
