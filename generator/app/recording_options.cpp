// What the commands have in common that read recordings.
#include "app/recording_options.hpp"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <system_error>
#include <utility>
#include <vector>

#include "diag/visible_text.hpp"
#include "recording/read.hpp"
#include "recording/renamer.hpp"
#include "symplant/host/exit_codes.hpp"

namespace symplant::app {
namespace {

std::nullopt_t fail(Context& context, const std::string& message) {
  context.err << "error: " << diag::visible(message) << "\n";
  context.exit_code = host::kBadInput;
  return std::nullopt;
}

void warn(Context& context, const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) context.err << "warning: " << diag::visible(warning) << "\n";
}

/// Nothing, with a message and the exit code, if the file of renames cannot be read.
std::optional<recording::ReadOptions> read_options(const RecordingOptions& options, Context& context) {
  recording::ReadOptions how{options.time_column, options.time_unit, {}};
  if (options.rename_file.empty()) return how;
  auto bytes = context.files.read(options.rename_file);
  if (!bytes) return fail(context, bytes.error().message);
  recording::ReadRenames read = recording::read_renames(std::move(*bytes), options.rename_file);
  if (!read.error.empty()) return fail(context, read.error);
  warn(context, read.warnings);
  how.renames = std::move(read.renames);
  return how;
}

}  // namespace

void add_recording_options(CLI::App& command, RecordingOptions& options) {
  command
      .add_option("--rename", options.rename_file,
                  "a CSV with two columns: a name in a recording, the symbol that it is")
      ->type_name("FILE");
  command
      .add_option("--time-column", options.time_column,
                  "the column of times of a recording that is a CSV: its header or number (default: detected)")
      ->type_name("C");
  command
      .add_option("--time-unit", options.time_unit,
                  "the unit of these times (default: by the header or the cells): s, ms, us, ns, filetime or iso")
      ->type_name("U")
      ->check(CLI::IsMember({"s", "ms", "us", "ns", "filetime", "iso"}));
}

std::optional<std::vector<recording::Recording>> read_recording_files(const std::vector<std::string>& paths,
                                                                      const RecordingOptions& options,
                                                                      Context& context) {
  const auto how = read_options(options, context);
  if (!how) return std::nullopt;
  std::vector<recording::Recording> recordings;
  std::vector<std::string> names;  // in all files
  for (const std::string& path : paths) {
    std::error_code unknown;
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file || std::filesystem::is_directory(path, unknown)) {
      return fail(context, fmt::format("cannot read the trace `{}`: {}", path,
                                       file ? "it is a directory" : std::strerror(errno)));
    }
    recording::ReadRecording read = recording::read_recording(file, path, *how);
    if (!read.error.empty()) return fail(context, read.error);
    warn(context, read.warnings);
    names.insert(names.end(), read.names.begin(), read.names.end());
    recordings.push_back(std::move(read.recording));
  }
  warn(context, recording::not_found(how->renames, options.rename_file, names));
  return recordings;
}

std::optional<recording::Recording> read_recording_file(const std::string& path, const RecordingOptions& options,
                                                        Context& context) {
  auto all = read_recording_files({path}, options, context);
  if (!all) return std::nullopt;
  return std::move(all->front());
}

std::string unknown_names(const observe::Matched& matched) {
  constexpr std::size_t kMostNames = 5;
  std::string names;
  for (std::size_t i = 0; i < std::min(kMostNames, matched.unknown.size()); ++i) {
    names += (i == 0 ? "" : ", ") + observe::words_of(matched.unknown[i]);
  }
  return matched.unknown.size() > kMostNames ? names + ", ..." : names;
}

std::string no_symbol_error(const std::string& recording, const std::string& plant, const observe::Matched& matched) {
  if (matched.has_symbols() || matched.unknown.empty()) return {};
  return fmt::format("no name in `{}` is a symbol of `{}`: {}; give `--rename FILE`, with the symbol of each name",
                     recording, plant, unknown_names(matched));
}

}  // namespace symplant::app
