// Chooses rules greedily.
#include "infer/search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace symplant::infer {
namespace {

/// Candidates below this share of the best one's gain are not looked at again.
constexpr double kWorthLooking = 0.02;

/// The rank of a candidate's rules among those chosen.
int rank(CandidateKind kind, bool devices_first) {
  if (kind == CandidateKind::devices && !devices_first) return static_cast<int>(CandidateKind::motions) * 2 + 1;
  return static_cast<int>(kind) * 2;
}

/// A candidate that is still open, and what is paired with it.
struct Trial {
  std::size_t candidate;
  std::vector<std::size_t> order;
  name::Counts score;
};

}  // namespace

Search::Search(const name::Naming& frame, const std::vector<Candidate>& candidates, std::span<const Sample> samples)
    : candidates_(candidates), samples_(samples) {
  name::Naming all = frame;
  for (const Candidate& candidate : candidates) {
    first_rule_.push_back(all.rules.size());
    all.rules.insert(all.rules.end(), candidate.rules.begin(), candidate.rules.end());
  }
  std::vector<name::NamingFault> faults;
  naming_ = name::CompiledNaming::compile(std::move(all), faults);
  if (naming_ == nullptr) return;  // never: candidates are valid
  reader_ = std::make_unique<name::SymbolReader>(naming_);
  readings_.resize(naming_->naming().rules.size());
  for (std::size_t rule = 0; rule < readings_.size(); ++rule) {
    readings_[rule].reserve(samples.size());
    for (const Sample& sample : samples) readings_[rule].push_back(reader_->read_by(rule, sample.text));
  }
}

bool Search::better(const name::Counts& a, const name::Counts& b) const {
  return a.paired() > b.paired() + samples_.size() / 1000 + 1;
}

/// Kinds apply in their order; within a kind the candidate chosen first applies first.
std::vector<std::size_t> Search::with(const std::vector<std::size_t>& chosen, std::size_t candidate,
                                      bool devices_first) const {
  std::vector<std::size_t> order = chosen;
  const int own = rank(candidates_[candidate].kind, devices_first);
  const auto after = std::find_if(order.begin(), order.end(), [&](std::size_t other) {
    return rank(candidates_[other].kind, devices_first) > own;
  });
  order.insert(after, candidate);
  return order;
}

name::Counts Search::score_of(const std::vector<std::size_t>& order) const {
  static const name::Reading kNone;
  std::vector<pairing::Input> inputs;
  inputs.reserve(samples_.size());
  for (std::size_t s = 0; s < samples_.size(); ++s) {
    const name::Reading* reading = &kNone;
    for (const std::size_t candidate : order) {
      for (std::size_t r = 0; r < candidates_[candidate].rules.size() && reading == &kNone; ++r) {
        const name::Reading& read = readings_[first_rule_[candidate] + r][s];
        if (read.account != name::Account::no_rule) reading = &read;
      }
      if (reading != &kNone) break;
    }
    inputs.push_back({reading, samples_[s].text.name, reading->direction.value_or(samples_[s].side),
                      samples_[s].boolean, samples_[s].controller});
  }
  return infer::score_of(pairing::pair(*naming_, inputs, pairing::Extent::linked), samples_);
}

Choice Search::run(Start start) const {
  Choice choice;
  if (naming_ == nullptr) return choice;
  std::vector<std::size_t> chosen;
  if (start.devices < candidates_.size()) {
    chosen.push_back(start.devices);
    choice.score = score_of(chosen);
    choice.steps.push_back(fmt::format("{}: {} paired", candidates_[start.devices].why, choice.score.paired()));
  }
  const auto is_others = [&](std::size_t i) { return candidates_[i].kind == CandidateKind::others; };
  std::vector<std::size_t> open;
  std::vector<std::size_t> later;
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    if (i != start.devices) (is_others(i) ? later : open).push_back(i);
  }
  add_best(chosen, std::move(open), start.devices_first, choice);
  add_best(chosen, std::move(later), start.devices_first, choice);
  for (const std::size_t candidate : chosen) {
    const auto& rules = candidates_[candidate].rules;
    choice.rules.insert(choice.rules.end(), rules.begin(), rules.end());
  }
  return choice;
}

void Search::add_best(std::vector<std::size_t>& chosen, std::vector<std::size_t> open, bool devices_first,
                      Choice& choice) const {
  while (!open.empty()) {
    std::vector<Trial> trials;
    for (const std::size_t candidate : open) {
      std::vector<std::size_t> order = with(chosen, candidate, devices_first);
      const name::Counts score = score_of(order);
      trials.push_back({candidate, std::move(order), score});
    }
    const auto best = std::max_element(trials.begin(), trials.end(), [](const Trial& a, const Trial& b) {
      return a.score.paired() < b.score.paired();
    });
    if (!better(best->score, choice.score)) break;
    choice.steps.push_back(fmt::format("{}: {} paired, {} before", candidates_[best->candidate].why,
                                       best->score.paired(), choice.score.paired()));
    const double least = kWorthLooking * static_cast<double>(best->score.paired() - choice.score.paired());
    open.clear();
    for (const Trial& trial : trials) {
      const double gain = static_cast<double>(trial.score.paired()) - static_cast<double>(choice.score.paired());
      if (trial.candidate != best->candidate && gain > 0 && gain >= least) open.push_back(trial.candidate);
    }
    choice.score = best->score;
    chosen = best->order;
  }
}

}  // namespace symplant::infer
