// What the commands have in common that read recordings.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/context.hpp"
#include "observe/matched.hpp"
#include "recording/recording.hpp"

namespace CLI {
class App;
}

namespace symplant::app {

struct RecordingOptions {
  std::string rename_file;  ///< which symbol a name of a recording is; empty: names are symbols
  std::string time_column;  ///< empty: by the header
  std::string time_unit;    ///< empty: by the header or the cells
};

/// Adds --rename, --time-column and --time-unit.
void add_recording_options(CLI::App& command, RecordingOptions& options);

/// The traces or recordings in files of any format. Shows what was left out as warnings, and the names of --rename that
/// no file has. If a file, or that of --rename, cannot be read, shows the error, returns no value and sets the exit
/// code to 2.
std::optional<std::vector<recording::Recording>> read_recording_files(const std::vector<std::string>& paths,
                                                                      const RecordingOptions& options,
                                                                      Context& context);
/// The same for one file.
std::optional<recording::Recording> read_recording_file(const std::string& path, const RecordingOptions& options,
                                                        Context& context);

/// The names of a recording that are no symbols, at most five of them, each with a similar symbol.
std::string unknown_names(const observe::Matched& matched);

/// The error if no name of a recording is a symbol of the plant, with some of the names; empty: one is, or it
/// has no names.
std::string no_symbol_error(const std::string& recording, const std::string& plant, const observe::Matched& matched);

}  // namespace symplant::app
