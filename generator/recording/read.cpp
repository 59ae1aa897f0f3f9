// Reads traces and recordings of any format.
#include "recording/read.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "recording/input.hpp"
#include "recording/read_csv.hpp"
#include "recording/read_json_lines.hpp"
#include "recording/read_vcd.hpp"
#include "recording/renamer.hpp"

namespace symplant::recording {
namespace {

/// The first character of a text that is not a blank; 0 if all are blanks.
char first_character(std::string_view head) {
  if (head.starts_with("\xEF\xBB\xBF")) head.remove_prefix(3);
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  return first == head.npos ? '\0' : head[first];
}

struct Format {
  /// Whether a file that begins like this has the format, if it has none of those before.
  bool (*is)(std::string_view head);
  ReadRecording (*read)(std::istream& file, const std::string& name, const ReadOptions& options);
};
constexpr std::array kFormats{
    Format{[](std::string_view head) { return first_character(head) == '{' || first_character(head) == '\0'; },
           read_json_lines},
    Format{[](std::string_view head) { return first_character(head) == '$'; }, read_vcd},
    Format{[](std::string_view) { return true; }, read_csv},
};

}  // namespace

ReadRecording read_recording(std::istream& file, const std::string& name, const ReadOptions& options) {
  Input input(file);
  const std::string_view head = input.head();
  const auto format = std::find_if(kFormats.begin(), kFormats.end(), [&](const Format& one) { return one.is(head); });
  ReadRecording read = format->read(input.stream(), name, options);
  if (!read.error.empty() || format->read == read_csv || options.renames.empty()) return read;
  for (const Series& series : read.recording.series) {
    if (series.kind != Series::Kind::parts) read.names.push_back(series.name);
  }
  read.error = rename_series(options.renames, read.recording);
  return read;
}

}  // namespace symplant::recording
