// The file of `--baseline` and `--write-baseline`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/context.hpp"
#include "findings/baseline.hpp"

namespace symplant::app {

/// Reads the baseline of a check, and writes it at the end.
class BaselineFile {
 public:
  /// `read` and `write` are the files of the options; at most one is given. No file is read yet.
  BaselineFile(const std::string& read, const std::string& write, Context& context)
      : path_(write.empty() ? read : write), writes_(!write.empty()), context_(context) {}

  /// False if the file cannot be used: a message is written and the exit code set.
  bool open();
  /// Null without a baseline.
  findings::Baseline* baseline() { return baseline_ ? &*baseline_ : nullptr; }
  /// Reports entries of the baseline that the plants no longer have, or writes the file without them. `inputs` are
  /// never overwritten.
  void close(diag::Diagnostics& findings, const std::vector<std::string>& inputs);

 private:
  std::string path_;
  bool writes_;
  bool exists_ = false;
  Context& context_;
  std::optional<findings::Baseline> baseline_;
};

}  // namespace symplant::app
