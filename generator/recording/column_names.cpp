// What the headers of columns say.
#include "recording/column_names.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

#include "text/ascii.hpp"

namespace symplant::recording {
namespace {

/// A name without case, blanks, `_`, `-` and `/`.
struct KnownName {
  std::string_view name;
  ColumnRole role;
};

constexpr std::array<KnownName, 62> kKnownNames{{
    {"t", ColumnRole::time},
    {"ts", ColumnRole::time},
    {"time", ColumnRole::time},
    {"timestamp", ColumnRole::time},
    {"tstamp", ColumnRole::time},
    {"timestring", ColumnRole::time},
    {"datetime", ColumnRole::time},
    {"localtime", ColumnRole::time},
    {"utc", ColumnRole::time},
    {"utctime", ColumnRole::time},
    {"timeutc", ColumnRole::time},
    {"systemtime", ColumnRole::time},
    {"sourcetimestamp", ColumnRole::time},
    {"elapsed", ColumnRole::time},
    {"elapsedtime", ColumnRole::time},
    {"relativetime", ColumnRole::time},
    {"samplingtime", ColumnRole::time},
    {"zeit", ColumnRole::time},
    {"zeitstempel", ColumnRole::time},
    {"zeitpunkt", ColumnRole::time},
    {"uhrzeit", ColumnRole::time},
    {"datumzeit", ColumnRole::time},
    {"datumuhrzeit", ColumnRole::time},
    {"temps", ColumnRole::time},
    {"horodatage", ColumnRole::time},
    {"heure", ColumnRole::time},
    {"tiempo", ColumnRole::time},
    {"fechahora", ColumnRole::time},
    {"hora", ColumnRole::time},
    {"tempo", ColumnRole::time},
    {"ora", ColumnRole::time},
    {"\xEC\x8B\x9C\xEA\xB0\x84", ColumnRole::time},  // time in Korean
    {"\xEC\x8B\x9C\xEA\xB0\x81", ColumnRole::time},  // time of day in Korean
    {"\xE6\x97\xA5\xE6\x99\x82", ColumnRole::time},  // date and time in Japanese
    {"\xE6\x99\x82\xE5\x88\xBB", ColumnRole::time},  // time of day in Japanese
    {"\xE6\x99\x82\xE9\x96\x93", ColumnRole::time},  // time in Japanese
    {"\xE6\x97\xB6\xE9\x97\xB4", ColumnRole::time},  // time in Chinese
    {"date", ColumnRole::date},
    {"datum", ColumnRole::date},
    {"fecha", ColumnRole::date},
    {"\xE6\x97\xA5\xE4\xBB\x98", ColumnRole::date},  // date in Japanese
    {"\xEB\x82\xA0\xEC\xA7\x9C", ColumnRole::date},  // date in Korean
    {"symbol", ColumnRole::symbol},
    {"symbolname", ColumnRole::symbol},
    {"tag", ColumnRole::symbol},
    {"tagname", ColumnRole::symbol},
    {"variable", ColumnRole::symbol},
    {"variablename", ColumnRole::symbol},
    {"varname", ColumnRole::symbol},
    {"name", ColumnRole::symbol},
    {"signal", ColumnRole::symbol},
    {"path", ColumnRole::symbol},
    {"item", ColumnRole::symbol},
    {"itemid", ColumnRole::symbol},
    {"address", ColumnRole::symbol},
    {"key", ColumnRole::symbol},
    {"value", ColumnRole::value},
    {"varvalue", ColumnRole::value},
    {"tagvalue", ColumnRole::value},
    {"tagval", ColumnRole::value},
    {"wert", ColumnRole::value},
    {"validity", ColumnRole::validity},
}};

std::string plain(std::string_view text) {
  std::string name;
  for (const char c : text) {
    if (c != ' ' && c != '_' && c != '-' && c != '/') name += text::lower(c);
  }
  return name;
}

ColumnRole role_of(std::string_view name) {
  const std::string wanted = plain(name);
  const auto found = std::find_if(kKnownNames.begin(), kKnownNames.end(),
                                  [&](const KnownName& known) { return known.name == wanted; });
  return found == kKnownNames.end() ? ColumnRole::other : found->role;
}

bool is_time_role(ColumnRole role) { return role == ColumnRole::time || role == ColumnRole::date; }

std::string_view trimmed_name(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '#')) text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

}  // namespace

ColumnHeader column_header(std::string_view header) {
  const std::string_view name = trimmed_name(header);
  if (const std::size_t bracket = name.find_first_of("[("); bracket != name.npos) {
    const std::size_t end = name.find_first_of("])", bracket);
    const ColumnRole role = role_of(name.substr(0, bracket));
    if (!is_time_role(role) || end == name.npos) return {};
    return {role, time_form_of(trimmed_name(name.substr(bracket + 1, end - bracket - 1)))};
  }
  if (const std::size_t split = name.find_last_of("/_ ."); split != name.npos) {
    const TimeForm form = time_form_of(name.substr(split + 1));
    std::string_view before = trimmed_name(name.substr(0, split));
    if (before.ends_with(" in")) before.remove_suffix(3);
    const ColumnRole role = role_of(before);
    if (form != TimeForm::unknown && is_time_role(role)) return {role, form};
  }
  return {role_of(name), TimeForm::unknown};
}

bool is_logging_column(std::string_view header) {
  constexpr std::array<std::string_view, 5> kNames{"INTERVAL", "INDEX", "STEP NO.", "PROGRAM NAME", "TRIGGER"};
  const std::string_view name = trimmed_name(header.substr(0, header.find_first_of("[(")));
  return std::any_of(kNames.begin(), kNames.end(),
                     [&](std::string_view other) { return text::equal_ignoring_case(name, other); });
}

}  // namespace symplant::recording
