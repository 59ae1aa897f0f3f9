// Chooses rules greedily.
#include "infer/search.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace symplant::infer {
namespace {

/// Candidates below this share of the best one's pairs are not looked at again.
constexpr double kWorthLooking = 0.02;

/// Every candidate's readings, made once: whatever is chosen, the first rule that matches counts.
class Search {
 public:
  Search(const name::Naming& frame, const std::vector<Candidate>& candidates, std::span<const Sample> samples)
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

  Choice run() {
    Choice choice;
    if (naming_ == nullptr) return choice;
    std::vector<std::size_t> chosen;  // candidates, in the order in which they apply
    std::vector<std::size_t> open(candidates_.size());
    for (std::size_t i = 0; i < open.size(); ++i) open[i] = i;
    while (!open.empty()) {
      std::size_t best = open.size();
      Score best_score = choice.score;
      std::vector<std::size_t> best_order;
      std::vector<std::pair<std::size_t, std::size_t>> gains;  // paired, index in `open`
      for (std::size_t i = 0; i < open.size(); ++i) {
        std::vector<std::size_t> order = with(chosen, open[i]);
        const Score score = score_of(order);
        gains.emplace_back(score.paired, i);
        if (!better(score, best_score)) continue;
        best = i;
        best_score = score;
        best_order = std::move(order);
      }
      if (best == open.size()) break;
      choice.steps.push_back(
          fmt::format("{}: {} paired, {} before", candidates_[open[best]].why, best_score.paired, choice.score.paired));
      forget(open, gains, choice.score.paired, best_score.paired, best);
      choice.score = best_score;
      chosen = std::move(best_order);
    }
    for (const std::size_t candidate : chosen) {
      const auto& rules = candidates_[candidate].rules;
      choice.rules.insert(choice.rules.end(), rules.begin(), rules.end());
    }
    return choice;
  }

 private:
  bool better(const Score& a, const Score& b) const { return a.paired > b.paired + samples_.size() / 1000 + 1; }

  /// Drops the chosen candidate and those that gained next to nothing.
  static void forget(std::vector<std::size_t>& open, const std::vector<std::pair<std::size_t, std::size_t>>& gains,
                     std::size_t before, std::size_t after, std::size_t best) {
    const double least = kWorthLooking * static_cast<double>(after - before);
    std::vector<std::size_t> kept;
    for (const auto& [paired, i] : gains) {
      const double gain = static_cast<double>(paired) - static_cast<double>(before);
      if (i != best && gain >= least && gain > 0) kept.push_back(open[i]);
    }
    open = std::move(kept);
  }

  /// Kinds apply in their order; within a kind the candidate chosen first applies first.
  std::vector<std::size_t> with(const std::vector<std::size_t>& chosen, std::size_t candidate) const {
    std::vector<std::size_t> order = chosen;
    const auto after = std::find_if(order.begin(), order.end(), [&](std::size_t other) {
      return candidates_[other].kind > candidates_[candidate].kind;
    });
    order.insert(after, candidate);
    return order;
  }

  Score score_of(const std::vector<std::size_t>& order) const {
    static const name::RuleReading kNone;
    std::vector<pairing::Input> inputs;
    inputs.reserve(samples_.size());
    for (std::size_t s = 0; s < samples_.size(); ++s) {
      const name::RuleReading* reading = &kNone;
      for (const std::size_t candidate : order) {
        for (std::size_t r = 0; r < candidates_[candidate].rules.size(); ++r) {
          const name::RuleReading& read = readings_[first_rule_[candidate] + r][s];
          if (read.outcome == name::Outcome::no_rule) continue;
          reading = &read;
          break;
        }
        if (reading != &kNone) break;
      }
      inputs.push_back({reading, samples_[s].text.name, reading->side.value_or(samples_[s].side), samples_[s].boolean,
                        samples_[s].controller});
    }
    return infer::score_of(pairing::pair(*naming_, inputs), samples_);
  }

  const std::vector<Candidate>& candidates_;
  std::span<const Sample> samples_;
  std::vector<std::size_t> first_rule_;
  std::shared_ptr<const name::CompiledNaming> naming_;
  std::unique_ptr<name::SymbolReader> reader_;
  std::vector<std::vector<name::RuleReading>> readings_;  // by rule, then by sample
};

}  // namespace

Choice choose(const name::Naming& frame, const std::vector<Candidate>& candidates, std::span<const Sample> samples) {
  return Search(frame, candidates, samples).run();
}

}  // namespace symplant::infer
