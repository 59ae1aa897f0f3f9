// Values of the parameters of a link's URL.
#include "symplant/link/url_values.hpp"

#include <charconv>
#include <system_error>

#include "symplant/tables/duration.hpp"

namespace symplant::link {

std::string ticked_text(std::string_view text) { return "`" + std::string(text) + "`"; }

Problem read_number(std::string_view text, std::uint32_t most, std::uint32_t& out) {
  const bool hexadecimal = text.starts_with("0x");
  const std::string_view digits = hexadecimal ? text.substr(2) : text;
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, out, hexadecimal ? 16 : 10);
  if (!digits.empty() && error == std::errc() && stop == end && out <= most) return {};
  return "write a number from 0 to " + std::to_string(most);
}

Problem read_time(std::string_view text, tables::Time& out, bool zero_allowed) {
  constexpr tables::Time kLongest = 3600 * tables::kSecond;
  const auto time = tables::parse_duration(text);
  if (!time || (*time == 0 && !zero_allowed) || *time > kLongest) {
    return "write a time such as 500ms or 2s, at most 1h";
  }
  out = *time;
  return {};
}

Problem read_at_end(std::string_view text, bool& zero_at_end) {
  constexpr std::array kNames = {std::pair{std::string_view("keep"), false}, std::pair{std::string_view("zero"), true}};
  return choose(kNames, text, zero_at_end);
}

}  // namespace symplant::link
