// The correspondences of a report: what links operations with events.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "infer/report_parts.hpp"
#include "infer/words.hpp"
#include "pairing/archetypes.hpp"

namespace symplant::infer {
namespace {

constexpr std::size_t kMostNamedTasks = 4;  ///< that the text of a rule names

std::string_view model_name(name::ArchetypeModel model) {
  constexpr std::array<std::string_view, name::kArchetypeModels> kNames = {"mirror", "handshake", "constant",
                                                                           "two positions", "contactor"};
  return kNames[static_cast<std::size_t>(model)];
}

std::string archetype_text(const name::Archetype& archetype) {
  std::string operations;
  std::string events;
  for (const auto& [role, text] : archetype.texts) {
    std::string& side = pairing::is_operation_role(role) ? operations : events;
    side.append(side.empty() ? "" : ", ").append(text);
  }
  if (archetype.model == name::ArchetypeModel::constant) {
    return fmt::format("{}, always {}", events, archetype.value ? "on" : "off");
  }
  return fmt::format("{} -> {}, {}", operations, events, model_name(archetype.model));
}

std::string rule_text(const name::SymbolRule& rule) {
  std::string text = rule.name.empty() ? "" : rule.name + ": ";
  for (const name::SourcePattern& one : rule.patterns) {
    text.append(&one == &rule.patterns.front() ? "" : " and ").append(one.pattern);
  }
  for (const name::FieldRule& field : rule.fields) {
    if (!field.expression.empty()) text += fmt::format(", {} {}", field.field, field.expression);
  }
  return text;
}

/// Suspicions about pairs of one correspondence.
using Suspects = std::map<Suspicion, SuspiciousPairs>;

std::optional<Suspicion> suspicion_of(std::uint8_t operation, std::uint8_t event) {
  const auto both = static_cast<std::uint8_t>(operation & event);
  if ((both & kInterlockText) != 0) return Suspicion::interlock_both_ways;
  if ((both & kPanelText) != 0) return Suspicion::lamp_and_button;
  const bool completion = (operation & kDoneText) != 0 && (operation & kAnswerText) == 0;
  const bool request = (event & kStartText) != 0 && (event & kDoneText) == 0;
  if (completion && request) return Suspicion::completion_before_request;
  return std::nullopt;
}

class CorrespondenceFinder {
 public:
  explicit CorrespondenceFinder(const ReportInput& input)
      : input_(input), naming_(input.naming.naming()), group_(naming_.rules.size()), seen_(input.samples.size()) {
    std::iota(group_.begin(), group_.end(), std::size_t{0});
  }

  std::vector<Correspondence> run() {
    join_rules();
    for (const pairing::Facet& facet : facets()) {
      if (facet.by != pairing::FacetBy::links) add(facet);
    }
    add_constants();
    count_candidates();
    return sorted();
  }

 private:
  struct Draft {
    Correspondence found;
    Suspects suspects;
    std::map<std::string, std::size_t> tasks;               ///< by shape
    std::pair<std::string_view, std::string_view> example;  ///< names
    std::uint32_t operation = 0;
    std::uint32_t event = 0;
    std::set<std::size_t> read_by;  ///< groups of rules that read the symbols of an archetype
  };

  /// Archetypes by their index, then groups of rules.
  using Key = std::pair<bool, std::size_t>;

  const std::vector<pairing::Facet>& facets() const { return input_.applied.pairing.facets; }
  const name::Reading& reading(std::uint32_t sample) const { return input_.applied.readings[sample]; }
  std::size_t group_of(std::uint32_t sample) const { return group_[reading(sample).rule]; }

  /// A rule for operations only and one for events only are one correspondence if they meet in a facet.
  void join_rules() {
    std::vector<std::size_t> parents(group_);
    const auto root = [&](std::size_t rule) {
      while (parents[rule] != rule) rule = parents[rule];
      return rule;
    };
    for (const pairing::Facet& facet : facets()) {
      if (facet.by != pairing::FacetBy::words) continue;
      std::optional<std::size_t> first;
      for (const pairing::Member& member : facet.members) {
        const std::size_t rule = reading(member.input).rule;
        if (!naming_.rules[rule].side) continue;
        const std::size_t own = root(rule);
        const std::size_t low = std::min(first.value_or(own), own);
        parents[std::max(first.value_or(own), own)] = low;
        first = low;
      }
    }
    for (std::size_t rule = 0; rule < group_.size(); ++rule) group_[rule] = root(rule);
  }

  /// The first event of a state in the order of names, and of the whole facet.
  std::unordered_map<std::string_view, std::uint32_t> events_of(const pairing::Facet& facet) const {
    std::unordered_map<std::string_view, std::uint32_t> events;
    const auto offer = [&](std::string_view task, std::uint32_t event) {
      const auto [known, added] = events.emplace(task, event);
      if (!added && name(event) < name(known->second)) known->second = event;
    };
    for (const pairing::Member& member : facet.members) {
      if (input_.is_operation(member.input)) continue;
      offer(member.task, member.input);
      offer({}, member.input);
    }
    return events;
  }

  std::string_view name(std::uint32_t sample) const { return input_.samples[sample].text.name; }

  void add(const pairing::Facet& facet) {
    const auto events = events_of(facet);
    if (events.empty()) return;
    for (const pairing::Member& member : facet.members) {
      const std::uint32_t operation = member.input;
      if (!input_.is_operation(operation)) continue;
      const bool by_words = facet.by == pairing::FacetBy::words;
      Draft& draft = drafts_[by_words ? Key{true, group_of(operation)} : Key{false, facet.archetype}];
      if (by_words) {
        ++draft.tasks[shape_of(member.task)];
      } else {
        draft.read_by.insert(group_of(operation));
      }
      const auto state = events.find(member.task);
      add(draft, operation, state == events.end() ? events.at({}) : state->second);
    }
  }

  void add(Draft& draft, std::uint32_t operation, std::uint32_t event) {
    if (!seen_[operation]) ++draft.found.linked;
    seen_[operation] = true;
    const std::pair<std::string_view, std::string_view> names{name(operation), name(event)};
    if (draft.example.first.empty() || names < draft.example) {
      draft.example = names;
      draft.operation = operation;
      draft.event = event;
    }
    const auto why = suspicion_of(input_.texts.kinds(operation), input_.texts.kinds(event));
    if (!why) return;
    SuspiciousPairs& pairs = draft.suspects[*why];
    if (pairs.count++ != 0) return;
    pairs.why = *why;
    pairs.operation = input_.texts.shown(operation);
    pairs.event = input_.texts.shown(event);
  }

  /// Constant archetypes have no facets.
  void add_constants() {
    std::string x;
    for (std::size_t a = 0; a < naming_.archetypes.size(); ++a) {
      if (naming_.archetypes[a].model != name::ArchetypeModel::constant) continue;
      const name::ArchetypeText text(input_.naming, a, 0);
      for (std::uint32_t i = 0; i < input_.samples.size(); ++i) {
        const bool constant = input_.applied.pairing.accounts[i] == name::Account::constant;
        if (!constant || reading(i).role != name::Role::io || seen_[i]) continue;
        if (!text.matches(reading(i).task->text, x)) continue;
        seen_[i] = true;
        Draft& draft = drafts_[{false, a}];
        ++draft.found.linked;
        if (draft.example.first.empty() || name(i) < draft.example.first) draft.example = {name(i), {}};
        if (draft.example.first == name(i)) draft.event = i;
      }
    }
  }

  /// How many operations could be linked: those that a rule reads, or that match an archetype.
  void count_candidates() {
    std::vector<std::uint32_t> open;
    for (std::uint32_t i = 0; i < input_.samples.size(); ++i) {
      if (!input_.is_operation(i) || input_.applied.pairing.accounts[i] != name::Account::no_event) continue;
      open.push_back(i);
      const auto draft = drafts_.find({true, group_of(i)});
      if (draft != drafts_.end()) ++draft->second.found.candidates;
    }
    for (auto& [key, draft] : drafts_) {
      draft.found.candidates += draft.found.linked;
      if (!key.first) draft.found.candidates += matches(key.second, open);
    }
  }

  /// How many of some operations match an archetype.
  std::size_t matches(std::size_t archetype, const std::vector<std::uint32_t>& operations) const {
    const auto& texts = naming_.archetypes[archetype].texts;
    std::vector<name::ArchetypeText> own;
    for (std::size_t t = 0; t < texts.size(); ++t) {
      if (pairing::is_operation_role(texts[t].first)) own.emplace_back(input_.naming, archetype, t);
    }
    std::unordered_map<std::string_view, bool> known;
    std::string x;
    return static_cast<std::size_t>(std::count_if(operations.begin(), operations.end(), [&](std::uint32_t i) {
      const auto [match, added] = known.emplace(reading(i).task->text, false);
      if (added) {
        match->second = std::any_of(own.begin(), own.end(), [&, task = match->first](const name::ArchetypeText& text) {
          return text.matches(task, x);
        });
      }
      return match->second;
    }));
  }

  /// "{device...}_{task:known} (ADV, RET)"
  std::string text_of(const Draft& draft, std::size_t group) const {
    std::array<std::string, 2> sides;
    for (std::size_t rule = 0; rule < group_.size(); ++rule) {
      if (group_[rule] != group) continue;
      const bool event = naming_.rules[rule].side == name::Direction::event;
      std::string& side = sides[event ? 1 : 0];
      side.append(side.empty() ? "" : " | ").append(rule_text(naming_.rules[rule]));
    }
    std::string text = sides[0] + (sides[0].empty() || sides[1].empty() ? "" : " -> ") + sides[1];
    std::vector<std::pair<std::size_t, std::string_view>> tasks;
    for (const auto& [task, count] : draft.tasks) tasks.emplace_back(count, task);
    std::stable_sort(tasks.begin(), tasks.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::string names;
    for (std::size_t i = 0; i < std::min(tasks.size(), kMostNamedTasks); ++i) {
      names.append(names.empty() ? "" : ", ").append(tasks[i].second);
    }
    return fmt::format("{} ({}{})", text, names, tasks.size() > kMostNamedTasks ? " ..." : "");
  }

  std::vector<Correspondence> sorted() {
    std::vector<std::pair<Key, Draft*>> order;
    for (auto& [key, draft] : drafts_) {
      Correspondence& found = draft.found;
      found.what = key.first ? text_of(draft, key.second) : archetype_text(naming_.archetypes[key.second]);
      if (!draft.example.second.empty()) found.operation = input_.texts.shown(draft.operation);
      found.event = input_.texts.shown(draft.event);
      for (auto& [why, pairs] : draft.suspects) found.suspicious.push_back(std::move(pairs));
      if (!key.first) found.archetypes.push_back(key.second);
      for (std::size_t rule = 0; key.first && rule < group_.size(); ++rule) {
        if (group_[rule] == key.second) found.rules.push_back(rule);
      }
      order.emplace_back(key, &draft);
    }
    std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) {
      const auto rank = [](const Correspondence& one) { return std::tie(one.linked, one.candidates); };
      const Correspondence& first = a.second->found;
      const Correspondence& second = b.second->found;
      return rank(first) != rank(second) ? rank(first) > rank(second) : first.what < second.what;
    });
    std::vector<Correspondence> all;
    all.reserve(order.size());
    for (auto& [key, draft] : order) {
      for (std::size_t i = 0; key.first && i < order.size(); ++i) {
        if (order[i].second->read_by.contains(key.second)) draft->found.needed_by.push_back(i);
      }
    }
    for (auto& [key, draft] : order) all.push_back(std::move(draft->found));
    return all;
  }

  const ReportInput& input_;
  const name::Naming& naming_;
  std::vector<std::size_t> group_;  // of each rule: the first rule of its group
  std::vector<bool> seen_;          // operations that count already
  std::map<Key, Draft> drafts_;
};

}  // namespace

std::vector<Correspondence> correspondences_of(const ReportInput& input) { return CorrespondenceFinder(input).run(); }

}  // namespace symplant::infer
