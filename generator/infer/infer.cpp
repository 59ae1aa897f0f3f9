// The order of inference: texts, candidates, search, archetypes, roles.
#include "infer/infer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "infer/archetypes.hpp"
#include "infer/candidates.hpp"
#include "infer/frame.hpp"
#include "infer/roles.hpp"
#include "infer/search.hpp"
#include "name/vocabulary.hpp"

namespace symplant::infer {
namespace {

constexpr std::size_t kMostSearched = 6'000;  ///< samples in search of rules

/// The begin of a text up to its first separator: mostly the station.
std::string_view first_word(const Sample& sample) {
  const std::string_view text = sample.text.comment.empty() ? sample.text.name : sample.text.comment;
  return text.substr(0, text.find_first_of(" _-."));
}

/// Samples of whole stations, some thousand of them. All if there are few.
std::vector<Sample> searched(std::span<const Sample> samples) {
  std::vector<Sample> all;
  std::map<std::string_view, std::size_t> stations;
  for (const Sample& sample : samples) {
    if (!sample.boolean) continue;
    all.push_back(sample);
    ++stations[first_word(sample)];
  }
  if (all.size() <= kMostSearched) return all;
  // Each n-th station, so that all kinds are met.
  std::size_t step = all.size() / kMostSearched + 1;
  std::map<std::string_view, bool> taken;
  std::size_t index = 0;
  for (const auto& [station, count] : stations) taken[station] = index++ % step == 0;
  std::vector<Sample> some;
  for (const Sample& sample : all) {
    if (taken[first_word(sample)] && some.size() < 2 * kMostSearched) some.push_back(sample);
  }
  return some.size() >= kMostSearched / 8 ? some : std::vector<Sample>(all.begin(), all.begin() + kMostSearched);
}

/// The samples that no rule matches.
std::vector<Sample> without(const std::vector<Sample>& samples, name::Naming frame,
                            const std::vector<name::SymbolRule>& rules) {
  frame.rules = rules;
  std::vector<name::NamingFault> faults;
  const auto compiled = name::CompiledNaming::compile(std::move(frame), faults);
  if (compiled == nullptr) return samples;
  name::SymbolReader reader(compiled);
  std::vector<Sample> others;
  for (const Sample& sample : samples) {
    if (reader.read(sample.text).account == name::Account::no_rule) others.push_back(sample);
  }
  return others;
}

std::vector<name::Source> sources_of(std::span<const Sample> samples) {
  const auto has = [&](auto member) {
    return std::any_of(samples.begin(), samples.end(),
                       [&](const Sample& sample) { return !(sample.text.*member).empty(); });
  };
  std::vector<name::Source> sources = {name::Source::name};
  if (has(&name::SymbolText::parent_comment)) {
    sources.push_back(name::Source::parent_and_comment);
  } else if (has(&name::SymbolText::comment)) {
    sources.push_back(name::Source::comment);
  }
  return sources;
}

std::vector<Candidate> all_candidates(const name::Naming& frame, std::span<const Sample> samples) {
  const name::Vocabulary vocabulary(frame.tasks, {});
  std::vector<Candidate> all;
  for (const name::Source source : sources_of(samples)) {
    const std::vector<SampleWords> words = words_of(samples, source, frame, vocabulary);
    std::vector<Candidate> candidates = candidates_of(words, source, vocabulary);
    all.insert(all.end(), std::make_move_iterator(candidates.begin()), std::make_move_iterator(candidates.end()));
    if (source != name::Source::comment) continue;
    std::vector<Candidate> both = two_source_candidates(words, vocabulary);
    all.insert(all.end(), std::make_move_iterator(both.begin()), std::make_move_iterator(both.end()));
  }
  std::stable_sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) { return a.kind < b.kind; });
  return all;
}

/// What a rule explains of the samples that are searched.
struct Merit {
  name::Counts score;
  std::size_t devices = 0;  ///< with facets

  /// Rules that pair nearly as much with finer devices are better: a coarse device pairs by chance.
  bool exceeds(const Merit& other) const {
    const double all = static_cast<double>(score.counted()) / 100;
    const double more = static_cast<double>(score.paired()) - static_cast<double>(other.score.paired());
    if (more > all || more < -all) return more > 0;
    return devices != other.devices ? devices > other.devices : more > 0;
  }
};

Merit merit_on(const name::Naming& naming, std::span<const Sample> samples) {
  std::vector<name::NamingFault> faults;
  const auto compiled = name::CompiledNaming::compile(naming, faults);
  if (compiled == nullptr) return {};
  const Applied applied = apply_rule(compiled, samples);
  std::set<std::string_view> devices;
  for (const pairing::Facet& facet : applied.pairing.facets) devices.insert(facet.path);
  return {applied.score, devices.size()};
}

name::Counts score_on(const name::Naming& naming, std::span<const Sample> samples) {
  std::vector<name::NamingFault> faults;
  const auto compiled = name::CompiledNaming::compile(naming, faults);
  return compiled == nullptr ? name::Counts() : apply_rule(compiled, samples).score;
}

/// The best rule that the search finds from its different starts.
Proposal search(const name::Naming& frame, std::span<const Sample> samples) {
  const std::vector<Candidate> candidates = all_candidates(frame, samples);
  std::vector<Start> starts{{}};
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (candidates[i].kind == CandidateKind::devices) starts.insert(starts.end(), {{i, true}, {i, false}});
  }
  Proposal best;
  best.naming = frame;
  Merit best_merit;
  const Search rules(frame, candidates, samples);
  for (const Start& start : starts) {
    Choice choice = rules.run(start);
    name::Naming naming = frame;
    naming.rules = std::move(choice.rules);
    if (naming.rules.empty()) continue;
    naming = with_archetypes(naming, samples, choice.steps);
    const Merit merit = merit_on(naming, samples);
    if (!merit.exceeds(best_merit)) continue;
    best_merit = merit;
    best = {std::move(naming), merit.score, std::move(choice.steps)};
  }
  return best;
}

/// Leaves out the rules that no sample matches.
name::Naming pruned(name::Naming naming, std::span<const Sample> samples) {
  std::vector<name::NamingFault> faults;
  const auto compiled = name::CompiledNaming::compile(naming, faults);
  if (compiled == nullptr) return naming;
  const Applied applied = apply_rule(compiled, samples);
  const std::vector<std::size_t>& matched = applied.reader->matched();
  std::vector<name::SymbolRule> kept;
  for (std::size_t i = 0; i < naming.rules.size(); ++i) {
    if (matched[i] != 0) kept.push_back(std::move(naming.rules[i]));
  }
  naming.rules = std::move(kept);
  return naming;
}

}  // namespace

Proposal infer(std::span<const Sample> samples, std::span<const name::Naming> known, Interlocks interlocks) {
  const std::vector<Sample> all_some = searched(samples);
  name::Naming frame = frame_of(all_some);
  add_abbreviations(frame, all_some);
  std::vector<name::SymbolRule> apart = panel_rules(frame, all_some);
  for (name::SymbolRule& rule : indicator_rules(frame, all_some)) apart.push_back(std::move(rule));
  if (interlocks == Interlocks::apart) {
    for (name::SymbolRule& rule : interlock_rules(frame, all_some)) apart.push_back(std::move(rule));
  }
  const std::vector<Sample> some = without(all_some, frame, apart);
  Proposal proposal = search(frame, some);
  for (const name::Naming& naming : known) {
    const name::Counts score = score_on(naming, some);
    if (score.paired() <= proposal.score.paired()) continue;
    proposal.naming = naming;
    proposal.score = score;
    proposal.steps = {fmt::format("ready rule `{}`: {} paired", naming.name, score.paired())};
  }
  proposal.naming.rules.insert(proposal.naming.rules.begin(), apart.begin(), apart.end());
  proposal.naming = with_roles(proposal.naming, all_some);
  proposal.naming = pruned(std::move(proposal.naming), samples);
  proposal.score = score_on(proposal.naming, samples);
  return proposal;
}

}  // namespace symplant::infer
