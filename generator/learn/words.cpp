// Texts about what was learned.
#include "learn/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "learn/groups.hpp"
#include "learn/proposal.hpp"
#include "symplant/trace/words.hpp"
#include "view/words.hpp"

namespace symplant::learn {
namespace {

constexpr std::size_t kFewSamples = 5;
constexpr Time kWideResolutions = 4;
constexpr Time kFarResolutions = 2;
constexpr Time kFarShare = 5;  ///< of the model's time: 20 %
constexpr std::size_t kMostFiles = 3;
constexpr std::size_t kMostDevices = 10;  ///< of a sentence

using Kind = description::Duration::Kind;

std::string counted_words(std::size_t count, std::string_view word) {
  return fmt::format("{} {}{}", count, word, count == 1 ? "" : "s");
}

description::Duration model_time(const model::Unit& unit, const LearnedTransition& of, bool after) {
  if (of.transition != kNone) {
    const model::Transition& transition = unit.transitions[of.transition];
    return after ? transition.after : transition.takes;
  }
  for (const model::Transition& transition : unit.transitions) {
    if (transition.spring_return && transition.from == of.from && transition.to == of.to) return transition.takes;
  }
  for (const model::Transition& transition : view::spring_returns(unit)) {
    if (transition.from == of.from) return transition.takes;
  }
  return description::Duration::fixed(unit.travel);
}

/// How far a time is outside of what the model allows; 0 if it is inside.
Time distance(Time time, const description::Duration& model) {
  switch (model.kind) {
    case Kind::uniform:
      return std::max({Time{0}, model.a - time, time - model.b});
    case Kind::normal:
      return std::max<Time>(0, std::abs(time - model.a) - 3 * model.b);
    case Kind::seconds:
      return 0;
    case Kind::fixed:
      break;
  }
  return std::abs(time - model.a);
}

std::string cluster_words(const LearnedTime& time, const Cluster& cluster) {
  const Time digit = digit_of(time.resolution);
  const Time least = rounded(time.samples[cluster.begin].duration, digit);
  const Time most = rounded(time.samples[cluster.end - 1].duration, digit);
  std::string text = trace::seconds(least);
  if (most != least) text += " to " + trace::seconds(most);
  return fmt::format("{}: {}", text, counted_words(cluster.size(), "move"));
}

std::string explanation_words(const Learned& learned, const Explanation& explanation) {
  std::string text = explanation.unit != kNone
                         ? fmt::format("it goes with {}", learned.plant->units[explanation.unit].path)
                         : fmt::format("it goes with the last part at {}", explanation.location);
  for (const std::size_t group : {std::size_t{0}, std::size_t{1}}) {
    std::string names;
    for (const Explanation::Value& value : explanation.values) {
      if (value.group == group) names += (names.empty() ? "" : ", ") + value.name;
    }
    text += fmt::format("{} {}: {}", group == 0 ? "," : ";", group == 0 ? "shorter" : "longer", names);
  }
  text += fmt::format(" ({} of {} moves", explanation.right, explanation.moves);
  if (explanation.others > 0) text += fmt::format("; {} fit as well", counted_words(explanation.others, "other"));
  return text + ")";
}

}  // namespace

std::vector<TimeRow> time_rows(const Learned& learned) {
  std::vector<TimeRow> rows;
  for (const LearnedGroup& group : learned.groups) {
    const model::Unit& unit = learned.plant->units[group.times.unit];
    for (const LearnedTransition& transition : group.times.transitions) {
      const std::string key = key_of(*learned.plant, unit, transition);
      if (transition.after) {
        rows.push_back({&group, key, "after", &*transition.after, model_time(unit, transition, true)});
      }
      if (transition.takes) {
        rows.push_back({&group, key, "takes", &*transition.takes, model_time(unit, transition, false)});
      }
    }
    if (group.times.overrun) {
      rows.push_back({&group, {}, "overrun", &*group.times.overrun, description::Duration::fixed(unit.overrun)});
    }
  }
  return rows;
}

int Oddities::rank() const {
  return (has_groups ? 16 : 0) + (outliers > 0 ? 8 : 0) + (is_wide ? 4 : 0) + (is_rare ? 2 : 0) + (is_far_off ? 1 : 0);
}

std::string Oddities::text(const TimeRow& row) const {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  if (has_groups) add(fmt::format("{} groups", row.time->clusters.kept.size()));
  if (outliers > 0) add(counted_words(outliers, "outlier"));
  if (is_wide) add("wide");
  if (is_rare) add("few moves");
  if (is_far_off) add("far from the model");
  return text;
}

bool is_of_few(const LearnedTime& time) { return time.statistics.count < kFewSamples; }

Oddities oddities_of(const TimeRow& row) {
  const LearnedTime& time = *row.time;
  const Statistics& of = time.statistics;
  Oddities odd;
  odd.has_groups = time.clusters.kept.size() > 1;
  odd.outliers = time.clusters.outliers.size();
  odd.is_wide = of.max > 2 * of.min && of.max - of.min > kWideResolutions * time.resolution;
  odd.is_rare = is_of_few(time);
  const Time off = row.kind == "overrun" ? std::max<Time>(0, of.max - row.model.a) : distance(of.median, row.model);
  odd.is_far_off = off > std::max(kFarResolutions * time.resolution, row.model.a / kFarShare);
  return odd;
}

std::string duration_words(const description::Duration& duration) {
  switch (duration.kind) {
    case Kind::fixed:
      return duration.a == tables::kNever ? "never" : trace::seconds(duration.a);
    case Kind::uniform:
      return trace::seconds(duration.a) + " to " + trace::seconds(duration.b);
    default:
      return view::duration_text(duration);
  }
}

std::string group_title(const LearnedGroup& group) {
  return group.units.size() == 1 ? group.name
                                 : fmt::format("{} ({})", group.name, counted_words(group.units.size(), "device"));
}

std::string provenance(const Learned& learned, const LearnedGroup& group, const LearnedTime& time) {
  std::set<std::uint32_t> inputs;
  for (const Sample& sample : time.samples) inputs.insert(sample.input);
  std::string files;
  for (const std::uint32_t input : inputs) {
    files += (files.empty() ? "" : ", ") + std::string(file_name(learned.sources[input].name));
  }
  if (inputs.size() > kMostFiles) files = fmt::format("{} recordings", inputs.size());
  std::string text = counted_words(time.statistics.count, "move");
  if (group.units.size() > 1) text += fmt::format(" of {} devices", group.units.size());
  text += " in " + files;
  if (time.resolution > 0) text += ", resolution " + trace::seconds(time.resolution);
  if (!time.clusters.outliers.empty()) {
    text += fmt::format(", without {}", counted_words(time.clusters.outliers.size(), "outlier"));
  }
  return text;
}

std::string groups_text(const Learned& learned, const LearnedTime& time) {
  if (time.clusters.kept.size() < 2) return {};
  std::string text;
  for (const Cluster& cluster : time.clusters.kept) text += (text.empty() ? "" : "; ") + cluster_words(time, cluster);
  if (time.explanation) text += "; " + explanation_words(learned, *time.explanation);
  return text;
}

std::string outlier_text(const Learned& learned, const LearnedGroup& group, const Sample& sample) {
  std::string text = fmt::format("{} at {} in {}", trace::seconds(sample.duration), trace::seconds(sample.at),
                                 file_name(learned.sources[sample.input].name));
  if (group.units.size() > 1) text = fmt::format("{} {}", learned.plant->units[sample.unit].path, text);
  return text;
}

std::string source_text(const Source& source) {
  std::string text = fmt::format("{}: {}", source.name, trace::seconds(source.length));
  return text + (source.resolution > 0 ? ", resolution " + trace::seconds(source.resolution) : ", exact times");
}

std::string summary(const Learned& learned) {
  std::size_t devices = 0;
  for (const LearnedGroup& group : learned.groups) devices += group.units.size();
  std::string text = fmt::format("{} of {}", counted_words(learned.moves, "move"), counted_words(devices, "device"));
  if (learned.unused > 0) {
    text += fmt::format("; {} not used: turned round, or without a cause that the model knows",
                        counted_words(learned.unused, "more move"));
  }
  return text;
}

std::vector<std::string> unused_warnings(const Learned& learned) {
  struct Group {
    UnusedReason reason;
    std::string_view text;
  };
  static constexpr std::array<Group, 3> kGroups{{
      {UnusedReason::inverted,
       "would have a cause if their operations were active-low: name these in `inverted` of plant.json"},
      {UnusedReason::not_recorded, "have no cause, since their operations are not recorded"},
      {UnusedReason::unknown,
       "are without a cause that the model knows: is an operation not recorded, or the model of the device wrong?"},
  }};
  std::vector<std::string> texts;
  for (const Group& group : kGroups) {
    std::size_t unused = 0;
    std::size_t all = 0;
    std::size_t devices = 0;
    std::string names;
    for (const UnusedMoves& moves : learned.unused_moves) {
      if (moves.reason != group.reason) continue;
      unused += moves.unused();
      all += moves.all();
      if (++devices > kMostDevices) continue;
      names += (names.empty() ? "" : ", ") + std::string(learned.plant->units[moves.unit].path);
    }
    if (devices == 0) continue;
    if (devices > kMostDevices) names += fmt::format(" and {} more", devices - kMostDevices);
    texts.push_back(fmt::format("{} of {} of {} {} ({})", unused, counted_words(all, "move"),
                                counted_words(devices, "device"), group.text, names));
  }
  return texts;
}

std::string unused_text(const Learned& learned, const UnusedMoves& moves) {
  return fmt::format("{} {} of {} ({} without a cause, {} turned round)", learned.plant->units[moves.unit].path,
                     moves.unused(), moves.all(), moves.uncaused, moves.turned);
}

std::string_view reason_name(UnusedReason reason) {
  switch (reason) {
    case UnusedReason::inverted:
      return "inverted";
    case UnusedReason::not_recorded:
      return "not_recorded";
    case UnusedReason::unknown:
      return "unknown";
    case UnusedReason::few:
      break;
  }
  return {};
}

std::string_view file_name(std::string_view path) {
  const std::size_t slash = path.find_last_of("/\\");
  return slash == path.npos ? path : path.substr(slash + 1);
}

std::string transition_name(const model::PlantModel& plant, std::uint32_t unit, std::uint32_t transition) {
  const model::Transition& of = plant.units[unit].transitions[transition];
  LearnedTransition key;
  key.from = of.from;
  key.to = of.to;
  key.transition = of.spring_return ? kNone : transition;
  return key_of(plant, plant.units[unit], key);
}

}  // namespace symplant::learn
