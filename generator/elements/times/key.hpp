// The keys of `times` in plant.json: `FROM->TO` and `FROM->TO on OPERATION`.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace symplant::description {

/// The transitions that an entry of `times` is for.
struct TimesKey {
  std::string from;  ///< a state, or "*": every state except `to`
  std::string to;
  std::string on = {};  ///< the task of an operation; empty: whatever causes the transition
};

/// Reads a key. A name with `->`, ` on ` or a quote in it is in single quotes, in which a quote is doubled. Nothing for
/// other texts.
std::optional<TimesKey> times_key_of(std::string_view text);

/// The key as text, with quotes where times_key_of() needs them.
std::string times_key_text(const TimesKey& key);

}  // namespace symplant::description
