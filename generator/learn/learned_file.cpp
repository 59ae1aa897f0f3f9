// Writes learned times as a part of plant.json.
#include "learn/learned_file.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "diag/visible_text.hpp"
#include "learn/groups.hpp"
#include "learn/words.hpp"
#include "symplant/tables/duration.hpp"

namespace symplant::learn {
namespace {

std::string json_string(std::string_view text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string json_text(const description::Duration& duration) {
  if (duration.kind == description::Duration::Kind::fixed) return json_string(tables::duration_text(duration.a));
  return fmt::format("{{ \"min\": {}, \"max\": {} }}", json_string(tables::duration_text(duration.a)),
                     json_string(tables::duration_text(duration.b)));
}

std::string comment(const std::string& text) { return "      // " + diag::visible(text) + "\n"; }

/// Where a time is from, and its groups if it has several.
std::string comments(const Learned& learned, const LearnedGroup& group, const LearnedTime& time,
                     std::string_view what) {
  std::string text = comment(fmt::format("{}{}{}", what, provenance(learned, group, time),
                                         is_of_few(time) ? "; few moves: others may differ" : ""));
  const std::string groups = groups_text(learned, time);
  return groups.empty() ? text : text + comment(groups);
}

std::string transition_text(const Learned& learned, const LearnedGroup& group, const LearnedTransition& transition) {
  const model::Unit& unit = learned.plant->units[group.times.unit];
  std::string text;
  const bool both = transition.after && transition.takes;
  if (transition.after) text += comments(learned, group, *transition.after, both ? "after: " : "");
  if (transition.takes) text += comments(learned, group, *transition.takes, both ? "takes: " : "");
  std::string members;
  const auto add = [&](std::string_view key, const std::optional<LearnedTime>& time, bool resets) {
    if (!time && !resets) return;
    members += fmt::format("{}\"{}\": {}", members.empty() ? "" : ", ", key,
                           json_text(time ? time->proposed : description::Duration::fixed(0)));
  };
  add("after", transition.after, transition.resets_after);
  add("takes", transition.takes, transition.resets_takes);
  return text + fmt::format("      {}: {{ {} }}", json_string(key_of(*learned.plant, unit, transition)), members);
}

/// The members of an entry.
std::string entry_text(const Learned& learned, const LearnedGroup& group) {
  const LearnedDevice& device = group.times;
  std::string text;
  for (const LearnedTransition& transition : device.transitions) {
    text += (text.empty() ? "" : ",\n") + transition_text(learned, group, transition);
  }
  if (device.overrun) {
    text += text.empty() ? "" : ",\n";
    text += comments(learned, group, *device.overrun, "the command after arrival, the longest time and a margin: ") +
            "      \"overrun\": " + json_text(device.overrun->proposed);
  }
  return text;
}

/// What `symplant watch` compares with, by device and transition; other commands ignore it.
std::string baselines_text(const Learned& learned) {
  std::string text;
  std::uint32_t unit = kNone;
  std::string key;
  for (const Baseline& one : learned.baselines) {
    const model::Unit& device = learned.plant->units[one.unit];
    LearnedTransition transition;
    transition.from = one.from;
    transition.to = one.to;
    transition.transition = one.transition;
    const std::string next = json_string(key_of(*learned.plant, device, transition));
    if (one.unit != unit) {
      text += fmt::format("{}      {}: {{\n        {}: {{", unit == kNone ? "" : "}\n      },\n",
                          json_string(device.path), next);
    } else if (next != key) {
      text += fmt::format("}},\n        {}: {{", next);
    } else {
      text += ",";
    }
    text += fmt::format(R"( "{}": {{ "n": {}, "mean": "{}", "sd": "{}" }} )", one.span, one.count,
                        tables::duration_text(one.mean), tables::duration_text(one.deviation));
    unit = one.unit;
    key = next;
  }
  return unit == kNone ? text : text + "}\n      }\n";
}

}  // namespace

std::string learned_file(const Learned& learned) {
  std::string text = "{\n  \"symplant\": 1,\n  \"times\": {";
  bool first = true;
  for (const LearnedGroup& group : learned.groups) {
    text += fmt::format("{}\n    {}: {{\n{}\n    }}", first ? "" : ",", json_string(group.name),
                        entry_text(learned, group));
    first = false;
  }
  text += "\n  }";
  if (!learned.baselines.empty()) {
    text += ",\n  // means that `symplant watch` compares with\n  \"learned\": {\n    \"devices\": {\n" +
            baselines_text(learned) + "    }\n  }";
  }
  return text + "\n}\n";
}

}  // namespace symplant::learn
