// Finds pairs in recordings: candidates from a sample, then all changes, then the choice between operations.
#include "learn/pairs.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "learn/candidates.hpp"
#include "learn/causes.hpp"
#include "learn/choose.hpp"
#include "learn/timeline.hpp"
#include "score/score.hpp"
#include "symplant/tables/digest.hpp"

namespace symplant::learn {
namespace {

using model::PlantModel;
using tables::Direction;

/// The symbols of which pairs are looked for.
struct Subjects {
  std::vector<std::uint32_t> operations;  ///< all that changed: also those that names pair may drive other events
  std::vector<std::uint32_t> events;      ///< that changed and that nothing pairs
  std::vector<bool> named;                ///< by symbol: names pair it
  std::size_t unpaired_operations = 0;
};

Subjects subjects_of(const PlantModel& plant, const Timeline& timeline) {
  const std::vector<score::Account> accounts = score::score_of(plant).accounts;
  Subjects subjects;
  subjects.named.resize(plant.symbols.size());
  for (std::uint32_t s = 0; s < plant.symbols.size(); ++s) {
    subjects.named[s] = accounts[s] == score::Account::modelled;
    const Track& track = timeline.tracks[s];
    if (track.rises.empty() && track.falls.empty()) continue;
    if (plant.symbols[s].direction == Direction::operation) {
      subjects.operations.push_back(s);
      subjects.unpaired_operations += name::is_left_over(accounts[s]) ? 1U : 0U;
    } else if (name::is_left_over(accounts[s])) {
      subjects.events.push_back(s);
    }
  }
  return subjects;
}

std::uint64_t id_of(const PlantModel& plant, std::uint32_t operation, std::uint32_t event) {
  tables::Fnv1a64 hash;
  for (const std::uint32_t symbol : {operation, event}) {
    for (const char c : plant.symbols[symbol].name()) hash.byte(static_cast<std::uint8_t>(c));
    hash.byte(0);
  }
  return hash.value();
}

class PairSearch {
 public:
  PairSearch(const PlantModel& plant, const Timeline& timeline, std::uint64_t seed)
      : plant_(plant), timeline_(timeline), subjects_(subjects_of(plant, timeline)) {
    pairs_.operations = subjects_.unpaired_operations;
    pairs_.events = subjects_.events.size();
    pairs_.length = timeline.length();
    pairs_.resolution = timeline.resolution;
    pairs_.seed = seed;
  }

  Pairs run() {
    const std::vector<EventCauses> events = causes();
    const std::vector<Choice> choices = choose(events, subjects_.named, timeline_);
    for (std::size_t e = 0; e < events.size(); ++e) {
      if (choices[e].causes.size() == 1) {
        add_pair(events[e], choices[e].causes.front());
      } else if (!choices[e].causes.empty()) {
        add_together(events[e].event, choices[e].causes);
      } else {
        add_alternate(events[e]);
      }
    }
    std::sort(pairs_.pairs.begin(), pairs_.pairs.end(), [](const Pair& a, const Pair& b) {
      return a.operation != b.operation ? a.operation < b.operation : a.event < b.event;
    });
    add_fan_outs();
    return std::move(pairs_);
  }

 private:
  std::vector<EventCauses> causes() const {
    const auto candidates = candidates_of(subjects_.operations, subjects_.events, timeline_);
    std::vector<EventCauses> all;
    for (std::size_t e = 0; e < subjects_.events.size(); ++e) {
      const std::uint32_t event = subjects_.events[e];
      const Track& track = timeline_.tracks[event];
      all.push_back({event, causes_of(Edges(track, true), candidates[e], timeline_),
                     causes_of(Edges(track, false), both_ways(candidates[e]), timeline_)});
    }
    return all;
  }

  /// The changes of the same operations in both directions.
  static std::vector<EdgeOf> both_ways(const std::vector<EdgeOf>& edges) {
    std::vector<EdgeOf> all;
    for (const EdgeOf& edge : edges) {
      const bool has = std::any_of(all.begin(), all.end(), [&](const EdgeOf& o) { return o.symbol == edge.symbol; });
      if (!has) all.insert(all.end(), {{edge.symbol, true}, {edge.symbol, false}});
    }
    return all;
  }

  void add_pair(const EventCauses& event, const Cause& cause) {
    const Track& operation = timeline_.tracks[cause.edge.symbol];
    const Track& track = timeline_.tracks[event.event];
    Pair pair{
        cause.edge.symbol, event.event, !cause.edge.on, subjects_.named[cause.edge.symbol], cause.follows, {}, {}};
    pair.off = follow(Edges(operation, !cause.edge.on), Edges(track, false), timeline_);
    // A change to off is often the other end of a move: without both directions it shows no pair.
    if (pair.inverted && !pair.follows_off()) return;
    pair.chance = chance_of(Edges(operation, cause.edge.on), Edges(track, true), cause.follows, timeline_, pairs_.seed,
                            id_of(plant_, pair.operation, pair.event));
    if (pair.chance.passed()) pairs_.pairs.push_back(pair);
  }

  void add_together(std::uint32_t event, const std::vector<Cause>& causes) {
    Interlock interlock{event, Interlock::Kind::together, {}};
    for (const Cause& cause : causes) interlock.operations.push_back(cause.edge.symbol);
    std::sort(interlock.operations.begin(), interlock.operations.end());
    interlock.operations.erase(std::unique(interlock.operations.begin(), interlock.operations.end()),
                               interlock.operations.end());
    pairs_.interlocks.push_back(std::move(interlock));
  }

  /// Two operations that the event follows, each at its own changes, which together are all of the event's.
  void add_alternate(const EventCauses& event) {
    std::vector<const Cause*> parts;
    for (const Cause& cause : event.on) {
      if (cause.edge.on && is_followed(cause, timeline_) && !is_only_cause(cause)) parts.push_back(&cause);
    }
    for (std::size_t a = 0; a < parts.size(); ++a) {
      for (std::size_t b = a + 1; b < parts.size(); ++b) {
        const std::size_t both = parts[a]->follows.hits + parts[b]->follows.hits;
        const std::size_t effects = std::max(parts[a]->follows.effects, parts[b]->follows.effects);
        if (both < hits_needed(effects) || both > effects + 1) continue;
        const auto [first, second] = std::minmax(parts[a]->edge.symbol, parts[b]->edge.symbol);
        pairs_.interlocks.push_back({event.event, Interlock::Kind::alternate, {first, second}});
        return;
      }
    }
  }

  void add_fan_outs() {
    for (std::size_t i = 0; i < pairs_.pairs.size();) {
      FanOut fan_out{pairs_.pairs[i].operation, {}};
      for (; i < pairs_.pairs.size() && pairs_.pairs[i].operation == fan_out.operation; ++i) {
        if (!pairs_.pairs[i].inverted) fan_out.events.push_back(pairs_.pairs[i].event);
      }
      if (fan_out.events.size() > 1) pairs_.fan_outs.push_back(std::move(fan_out));
    }
  }

  const PlantModel& plant_;
  const Timeline& timeline_;
  const Subjects subjects_;
  Pairs pairs_;
};

}  // namespace

Pairs learn_pairs(const PlantModel& plant, const std::vector<Input>& inputs, std::uint64_t seed) {
  const Timeline timeline = timeline_of(inputs, plant.symbols.size());
  return PairSearch(plant, timeline, seed).run();
}

}  // namespace symplant::learn
