// Values of the parameters of a link's URL, and the table of keys that reads them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "symplant/link/url.hpp"
#include "symplant/tables/nearest.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::link {

/// What to write instead of an invalid value; empty if the value is valid.
using Problem = std::string;

/// `text` in back-ticks.
std::string ticked_text(std::string_view text);

/// A number from 0 to `most`, decimal or hexadecimal (`0x1A`).
Problem read_number(std::string_view text, std::uint32_t most, std::uint32_t& out);

/// A duration of at most 1 h.
Problem read_time(std::string_view text, tables::Time& out, bool zero_allowed);

/// Sets `out` to the value whose name is `text`; otherwise lists the names.
template <class Value, std::size_t Count>
Problem choose(const std::array<std::pair<std::string_view, Value>, Count>& names, std::string_view text, Value& out) {
  std::string known;
  for (const auto& [name, value] : names) {
    if (name == text) {
      out = value;
      return {};
    }
    known.append(known.empty() ? "" : ", ").append(name);
  }
  return "write one of " + known;
}

/// `keep` or `zero`: what happens to the events at the end of the run.
Problem read_at_end(std::string_view text, bool& zero_at_end);

/// A key of a URL and how it changes the settings.
template <class Settings>
struct UrlKey {
  std::string_view name;
  Problem (*read)(std::string_view text, Settings& settings);
};

/// Reads one parameter. An unknown key is a problem that names the nearest one, or else `page`, which lists them.
/// O(keys).
template <class Settings, std::size_t Count>
Problem read_parameter(const UrlParameter& parameter, const std::array<UrlKey<Settings>, Count>& keys,
                       Settings& settings, std::string_view link_name, std::string_view page) {
  tables::NearestName nearest(parameter.key);
  for (const UrlKey<Settings>& key : keys) {
    nearest.offer(key.name);
    if (key.name != parameter.key) continue;
    Problem problem = key.read(parameter.value, settings);
    return problem.empty() ? problem : "`" + parameter.key + "=" + parameter.value + "`: " + problem;
  }
  std::string text = ticked_text(parameter.key) + " is not a setting of " + std::string(link_name) + "; ";
  if (nearest.name().empty()) return text + std::string(page) + " lists them";
  return text + "did you mean " + ticked_text(nearest.name()) + "?";
}

}  // namespace symplant::link
