// The words of the text format.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "property/plant_text.hpp"

namespace symplant::property {

inline constexpr std::array<std::string_view, 4> kActuationWords = {"latched", "bistable", "held", "spring"};

/// The words after the first word of an action line.
struct ActionWord {
  std::string_view word;
  bool what;
  bool value;
  bool time;
};
/// In the order of Action::Kind.
inline constexpr std::array<ActionWord, 19> kActionWords = {{{"reset", false, true, true},
                                                             {"set", true, true, false},
                                                             {"input", true, true, false},
                                                             {"force", true, true, false},
                                                             {"release", true, false, false},
                                                             {"state", true, true, false},
                                                             {"quality", false, true, false},
                                                             {"advance", false, false, true},
                                                             {"advance-to-due", false, false, false},
                                                             {"before", false, false, true},
                                                             {"save", false, false, false},
                                                             {"restore", false, true, true},
                                                             {"put", true, true, false},
                                                             {"take", true, false, false},
                                                             {"further", true, true, true},
                                                             {"run", false, true, true},
                                                             {"start", true, true, false},
                                                             {"stop", true, true, false},
                                                             {"value", true, true, false}}};

inline std::string_view word_of(tables::Actuation actuation) {
  return kActuationWords[static_cast<std::size_t>(actuation)];
}
inline const ActionWord& row_of(Action::Kind kind) { return kActionWords[static_cast<std::size_t>(kind)]; }
inline std::string_view word_of(Action::Kind kind) { return row_of(kind).word; }
inline bool takes_what(Action::Kind kind) { return row_of(kind).what; }
inline bool takes_value(Action::Kind kind) { return row_of(kind).value; }
inline bool takes_time(Action::Kind kind) { return row_of(kind).time; }

/// A time, or `never`.
inline std::string text_of_overrun(tables::Time time) {
  return time == tables::kNever ? "never" : std::to_string(time);
}

/// `5`, `uniform:1:2`, `normal:1:2` or `seconds:FORMULA`, whose blanks are `~`.
inline std::string text_of(const description::Duration& duration) {
  if (duration.kind == description::Duration::Kind::seconds) {
    std::string text = "seconds:" + *duration.formula;
    std::replace(text.begin(), text.end(), ' ', '~');
    return text;
  }
  const std::string a = std::to_string(duration.a);
  if (duration.kind == description::Duration::Kind::fixed) return a;
  return (duration.kind == description::Duration::Kind::uniform ? "uniform:" : "normal:") + a + ":" +
         std::to_string(duration.b);
}

}  // namespace symplant::property
