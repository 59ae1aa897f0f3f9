// The result files of a run. A failed run never leaves a result file of an earlier run.
#pragma once

#include <functional>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <string_view>

#include "symplant/host/run_options.hpp"
#include "symplant/trace/output_file.hpp"

namespace symplant::host {

/// The files of `--junit`, `--findings` and `--stats`. Used by one thread at a time; the arguments of the constructor
/// must outlive it.
class ResultFiles {
 public:
  /// Removes the results of an earlier run: regular files that are empty or begin as a result of their kind. Any other
  /// file stays for now, since it may be an input that an option names by mistake.
  ResultFiles(const RunOptions& options, std::ostream& out);
  ResultFiles(const ResultFiles&) = delete;
  ResultFiles& operator=(const ResultFiles&) = delete;

  /// From now on a failed run replaces the files, whatever they contain, if no output of the run is one of its
  /// `inputs`.
  void replace_unless_among(std::span<const std::string_view> inputs);
  /// Opens the JUnit file and that of the statistics, so that an error shows before a long run; `--findings` is opened
  /// by Outputs. Until write_junit() the JUnit file has a case with the error that the run has not ended, which remains
  /// if the run is killed. False, with a message on `err`, if one cannot be opened.
  bool open(std::string_view plant, std::ostream& err);
  /// The statistics of a run that has ended. Returns the error; empty if there is none.
  std::string write_stats(std::string_view text);
  /// The JUnit file of a run that has ended. Returns the error; empty if there is none.
  std::string write_junit(std::string_view text);
  /// The run failed before it could end, with this error: the JUnit file has it as a case, and there is no file of
  /// findings and statistics. No effect after write_junit().
  void fail(std::string_view plant, std::string_view error);

 private:
  trace::OutputFile file(const char* what, const std::string& path) const;
  void put_junit(std::string_view text);
  void remove_results() const;

  const RunOptions& options_;
  std::ostream& out_;
  std::optional<trace::OutputFile> junit_;
  std::optional<trace::OutputFile> stats_;
  bool replaces_ = false;
  bool written_ = false;
};

/// Runs `body`, which returns an exit code, and returns that code; 3, with a message on `err`, if it throws. If the
/// code is 2 or 3, the result files are those of a failed run, with the first errors that were written to `err`.
/// `plant`: its name in the JUnit file. While it runs, only one thread at a time may write to `err`.
int with_results(const RunOptions& options, std::string_view plant, std::ostream& out, std::ostream& err,
                 const std::function<int(ResultFiles&)>& body);

/// The command line of a run cannot be read: its result files are those of a failed run. `inputs`: files that are not
/// replaced, as far as they are known.
void fail_unread_run(const RunOptions& options, std::span<const std::string_view> inputs, std::string_view plant,
                     std::string_view error, std::ostream& out);

}  // namespace symplant::host
