// Sentences about anomalies.
#include "watch/words.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "symplant/trace/words.hpp"
#include "view/words.hpp"
#include "watch/drift.hpp"

namespace symplant::watch {
namespace {

class Words {
 public:
  Words(const model::PlantModel& plant, const Anomaly& anomaly, Time resolution)
      : plant_(plant),
        anomaly_(anomaly),
        move_(anomaly.move),
        unit_(plant.units[anomaly.unit]),
        resolution_(resolution),
        name_(unit_.path) {}

  std::string text() const {
    switch (anomaly_.kind) {
      case Kind::late:
      case Kind::early:
        return name_ + " " + when_words() + ", allowed " + range_words();
      case Kind::missing:
        return missing_words();
      case Kind::unexpected:
        return unexpected_words();
      case Kind::contradiction:
        return anomaly_.on.empty() ? dark_words() : contradiction_words();
      case Kind::drift:
        return drift_words();
      case Kind::silent:
        break;
    }
    return {};
  }

 private:
  using Kind = Anomaly::Kind;
  using Part = Anomaly::Part;

  std::string time(Time value) const { return seconds(value, resolution_); }
  std::string state(std::uint32_t index) const { return index == kNone ? "a state" : unit_.states[index].name; }

  std::string event(std::uint32_t index) const {
    if (index == kNone || unit_.states[index].event == kNone) return {};
    return symbol_words(plant_, unit_.events[unit_.states[index].event]);
  }

  /// `after O_CLOSE (list.csv:12)`.
  std::string cause_words() const {
    if (move_.spring_return) return "after its command ended";
    if (move_.transition == kNone) return "after its cause";
    const model::Transition& transition = unit_.transitions[move_.transition];
    if (transition.on == kNone) {
      return transition.when == kNone ? "after it came to " + state(move_.from) : "after its condition began to hold";
    }
    const model::Symbol& symbol = plant_.symbols[unit_.operations[transition.on]];
    return fmt::format("after {} ({}:{})", view::operation_text(plant_, unit_, transition.on),
                       plant_.list_of(symbol).name(), symbol.row->line);
  }

  std::string when_words() const {
    const char* const word = anomaly_.kind == Kind::late ? "late" : "early";
    const std::string what = anomaly_.part == Part::leaving ? fmt::format("left {} {}", state(move_.from), word)
                                                            : fmt::format("arrived {} in {}", word, state(move_.to));
    return fmt::format("{}: {} {}", what, time(anomaly_.took), cause_words());
  }

  std::string range_words() const {
    const Time least = std::max<Time>(anomaly_.allowed.least - anomaly_.margin, 0);
    return fmt::format("{} to {} (the model's {} with a margin of {})", time(least),
                       time(anomaly_.allowed.most + anomaly_.margin),
                       anomaly_.allowed.least == anomaly_.allowed.most
                           ? trace::seconds(anomaly_.allowed.most)
                           : trace::seconds(anomaly_.allowed.least) + " to " + trace::seconds(anomaly_.allowed.most),
                       time(anomaly_.margin));
  }

  std::string missing_words() const {
    const bool leaves = anomaly_.part == Part::leaving;
    const std::string what = leaves ? "leave " + state(move_.from) : "arrive in " + state(move_.to);
    std::string text;
    if (anomaly_.took > anomaly_.allowed.most + anomaly_.margin) {
      text = fmt::format("{} did not {}: {} {}, which takes at most {}", name_, what, time(anomaly_.took),
                         cause_words(), trace::seconds(anomaly_.allowed.most));
      if (anomaly_.failed > 1) text += fmt::format(", for the {}. time in a row", anomaly_.failed);
    } else {
      text = fmt::format("{} did not {} {} times in a row: {} {} it was commanded elsewhere, or no more", name_, what,
                         anomaly_.failed, time(anomaly_.took), cause_words());
    }
    const std::string shown = event(leaves ? move_.from : move_.to);
    if (!shown.empty()) text += fmt::format("; {} is still {}", shown, leaves ? "on" : "off");
    return text;
  }

  std::string unexpected_words() const {
    const std::string shown = event(move_.from);
    const std::string off = shown.empty() ? "" : ": " + shown + " went off";
    if (anomaly_.part == Part::arriving) {
      const std::string target = event(move_.to);
      return fmt::format("{} went from {} to {}, and nothing caused it{}", name_, state(move_.from), state(move_.to),
                         target.empty() ? off : ": " + target + " came on");
    }
    if (move_.to != kNone && move_.to == move_.from) {
      return fmt::format("{} left {} for {} and came back, and nothing caused it{}", name_, state(move_.from),
                         time(move_.arrived - move_.left), off);
    }
    return fmt::format("{} left {}, and nothing caused it{}", name_, state(move_.from), off);
  }

  std::string contradiction_words() const {
    std::string events;
    for (const std::uint32_t symbol : anomaly_.on) {
      events += (events.empty() ? "" : symbol == anomaly_.on.back() ? " and " : ", ") + symbol_words(plant_, symbol);
    }
    return fmt::format("{} shows several states for over {}: {} are on", name_, time(2 * resolution_), events);
  }

  std::string dark_words() const {
    return fmt::format("{} shows no state: none of its events is on {} after {} came on", name_, time(anomaly_.took),
                       symbol_words(plant_, anomaly_.symbols.front()));
  }

  std::string drift_words() const {
    const double change = 100.0 * static_cast<double>(anomaly_.took - anomaly_.learned) /
                          static_cast<double>(std::max<Time>(anomaly_.learned, 1));
    const bool leaves = anomaly_.part == Part::leaving;
    return fmt::format("{} drifts: {} {} now takes {} on average of {} moves, learned {} of {} moves: {:+.0f} %", name_,
                       leaves ? "leaving" : "moving from",
                       leaves ? state(move_.from) : state(move_.from) + " to " + state(move_.to),
                       seconds(anomaly_.took, resolution_ / 10), Drift::kLast,
                       seconds(anomaly_.learned, resolution_ / 10), anomaly_.learned_moves, change);
  }

  const model::PlantModel& plant_;
  const Anomaly& anomaly_;
  const observe::Move& move_;
  const model::Unit& unit_;
  const Time resolution_;
  const std::string name_;
};

}  // namespace

std::string seconds(Time time, Time resolution) {
  Time step = 1;
  while (step <= resolution / 10) step *= 10;
  const Time half = step / 2;
  return trace::seconds((time + half) / step * step);
}

std::string symbol_words(const model::PlantModel& plant, std::uint32_t symbol) {
  const model::Symbol& of = plant.symbols[symbol];
  const std::string_view address = of.written_address();
  return fmt::format("{} ({}{}{}:{})", of.name(), address, address.empty() ? "" : ", ", plant.list_of(of).name(),
                     of.row->line);
}

std::string name_of(const model::PlantModel& plant, const Anomaly& anomaly) {
  return anomaly.unit == kNone ? "readings" : std::string(plant.units[anomaly.unit].path);
}

std::string words(const model::PlantModel& plant, const Anomaly& anomaly, Time resolution) {
  if (anomaly.unit == kNone) {
    return fmt::format("nothing was read for {}: no device is judged until it is seen again",
                       seconds(anomaly.took, resolution));
  }
  return Words(plant, anomaly, resolution).text();
}

std::string sentence(const model::PlantModel& plant, const Anomaly& anomaly, Time resolution) {
  return fmt::format("at {}: {}", seconds(anomaly.time, resolution), words(plant, anomaly, resolution));
}

}  // namespace symplant::watch
