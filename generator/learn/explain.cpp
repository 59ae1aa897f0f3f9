// What explains two groups of durations.
#include "learn/explain.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace symplant::learn {
namespace {

constexpr double kExplainedShare = 0.9;
constexpr double kMostChance = 0.01;

/// A move of one of the two groups.
struct Grouped {
  Time at = 0;
  std::uint32_t input = 0;
  std::size_t group = 0;
};

/// The moves of the two groups, by recording and time.
std::vector<Grouped> grouped(const LearnedTime& time) {
  std::vector<Grouped> moves;
  for (std::size_t g = 0; g < time.clusters.kept.size(); ++g) {
    const Cluster& cluster = time.clusters.kept[g];
    for (std::size_t i = cluster.begin; i < cluster.end; ++i) {
      moves.push_back({time.samples[i].at, time.samples[i].input, g});
    }
  }
  std::sort(moves.begin(), moves.end(),
            [](const Grouped& a, const Grouped& b) { return a.input != b.input ? a.input < b.input : a.at < b.at; });
  return moves;
}

double log_choose(std::size_t n, std::size_t k) {
  const auto log_factorial = [](std::size_t m) { return std::lgamma(static_cast<double>(m) + 1); };
  return log_factorial(n) - log_factorial(k) - log_factorial(n - k);
}

/// How many moves of each group have a value, or are predicted to be in a group.
struct Counts {
  std::size_t of[2] = {0, 0};

  std::size_t most() const { return std::max(of[0], of[1]); }
  std::size_t sum() const { return of[0] + of[1]; }
  std::size_t group() const { return of[1] > of[0] ? 1 : 0; }
};

/// Values of one thing at the moves, counted by group.
class Values {
 public:
  void add(std::uint32_t value, std::size_t group) {
    if (value == kNone) return;
    if (value >= counts_.size()) counts_.resize(value + 1);
    ++counts_[value].of[group];
  }

  const std::vector<Counts>& counts() const { return counts_; }

  std::size_t right() const {
    std::size_t right = 0;
    for (const Counts& value : counts_) right += value.most();
    return right;
  }

  /// Whether the values go with the groups, of which `groups` says how large they are, better than by chance.
  bool explains(const Counts& groups, std::size_t candidates) const {
    Counts right;
    std::size_t predicted = 0;  // to be in group 1
    std::size_t seen = 0;
    for (const Counts& value : counts_) {
      right.of[value.group()] += value.most();
      if (value.group() == 1) predicted += value.sum();
      if (value.sum() > 0) ++seen;
    }
    for (std::size_t g = 0; g < 2; ++g) {
      if (static_cast<double>(right.of[g]) < kExplainedShare * static_cast<double>(groups.of[g])) return false;
    }
    // Each value could go with either group: a thing with many values fits more easily.
    const double tries = static_cast<double>(candidates) * std::exp2(static_cast<double>(seen));
    return chance(groups, predicted, right.of[1]) * tries <= kMostChance;
  }

 private:
  /// The chance that at least `both` of those predicted to be in group 1 are in it (Fisher's exact test).
  static double chance(const Counts& groups, std::size_t predicted, std::size_t both) {
    double sum = 0;
    for (std::size_t k = both; k <= std::min(groups.of[1], predicted); ++k) {
      if (predicted - k > groups.of[0]) continue;
      sum += std::exp(log_choose(groups.of[1], k) + log_choose(groups.of[0], predicted - k) -
                      log_choose(groups.sum(), predicted));
    }
    return sum;
  }

  std::vector<Counts> counts_;
};

/// The best of all explanations: of equally good ones, one of the same station, else the first.
class Best {
 public:
  Best(const Counts& groups, std::size_t candidates) : groups_(groups), candidates_(candidates) {}

  /// `fill` completes an explanation.
  void consider(const Values& values, bool is_near, const auto& fill) {
    if (!values.explains(groups_, candidates_)) return;
    const std::size_t right = values.right();
    if (best_ && right < best_->right) return;
    const bool equal = best_ && right == best_->right;
    const std::size_t others = equal ? best_->others + 1 : 0;
    if (!equal || (is_near && !is_near_)) {
      is_near_ = is_near;
      best_ = Explanation{};
      best_->right = right;
      best_->moves = groups_.sum();
      fill(*best_);
    }
    best_->others = others;
  }

  std::optional<Explanation> take() { return std::move(best_); }

 private:
  const Counts groups_;
  const std::size_t candidates_;
  std::optional<Explanation> best_;
  bool is_near_ = false;
};

/// The values of a thing, which changes at known times, when the moves were caused.
Values values_at(const std::vector<Grouped>& moves, const auto& changes_of_input) {
  Values values;
  std::size_t next = 0;
  std::uint32_t input = kNone;
  const std::vector<StateChange>* changes = nullptr;
  for (const Grouped& move : moves) {
    if (move.input != input) {
      input = move.input;
      changes = &changes_of_input(input);
      next = 0;
    }
    while (next < changes->size() && (*changes)[next].time <= move.at) ++next;
    if (next > 0) values.add((*changes)[next - 1].state, move.group);
  }
  return values;
}

std::vector<Explanation::Value> names_of(const Values& values, const auto& name) {
  std::vector<Explanation::Value> names;
  for (std::uint32_t v = 0; v < values.counts().size(); ++v) {
    const Counts& counts = values.counts()[v];
    if (counts.sum() > 0) names.push_back({name(v), counts.group()});
  }
  return names;
}

}  // namespace

Explainer::Explainer(const model::PlantModel& plant, const std::vector<Input>& inputs, const Moves& moves)
    : plant_(plant), moves_(moves), layout_(model::layout_of(plant)) {
  std::unordered_map<std::string, std::size_t> locations;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    for (const recording::Series& series : inputs[i].recording.series) {
      if (series.kind != recording::Series::Kind::parts) continue;
      const auto [found, added] = locations.try_emplace(series.name, arrivals_.size());
      if (added) arrivals_.push_back({series.name, {}, std::vector<std::vector<StateChange>>(inputs.size())});
      Arrivals& arrivals = arrivals_[found->second];
      auto kind = std::find(arrivals.kinds.begin(), arrivals.kinds.end(), series.part);
      if (kind == arrivals.kinds.end()) kind = arrivals.kinds.insert(kind, series.part);
      const auto index = static_cast<std::uint32_t>(kind - arrivals.kinds.begin());
      for (const auto& change : series.changes) arrivals.by_input[i].push_back({change.time, index});
    }
  }
  for (Arrivals& arrivals : arrivals_) {
    for (std::vector<StateChange>& changes : arrivals.by_input) {
      std::stable_sort(changes.begin(), changes.end(),
                       [](const StateChange& a, const StateChange& b) { return a.time < b.time; });
    }
  }
}

std::optional<Explanation> Explainer::explain(std::uint32_t unit, const LearnedTime& time) const {
  if (time.clusters.kept.size() != 2) return std::nullopt;
  const std::vector<Grouped> moves = grouped(time);
  const Counts groups{{time.clusters.kept[0].size(), time.clusters.kept[1].size()}};
  Best best(groups, plant_.units.size() + arrivals_.size());
  for (std::uint32_t u = 0; u < plant_.units.size(); ++u) {
    if (u == unit || !moves_.moved[u]) continue;
    const Values values = values_at(
        moves, [&](std::uint32_t input) -> const auto& { return moves_.states[input][u]; });
    best.consider(values, layout_.devices[u].station == layout_.devices[unit].station, [&](Explanation& found) {
      found.unit = u;
      found.values = names_of(values, [&](std::uint32_t state) { return plant_.units[u].states[state].name; });
    });
  }
  for (const Arrivals& arrivals : arrivals_) {
    const Values values = values_at(
        moves, [&](std::uint32_t input) -> const auto& { return arrivals.by_input[input]; });
    best.consider(values, false, [&](Explanation& found) {
      found.location = arrivals.location;
      found.values = names_of(values, [&](std::uint32_t kind) { return arrivals.kinds[kind]; });
    });
  }
  return best.take();
}

}  // namespace symplant::learn
