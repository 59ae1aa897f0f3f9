// Writes findings to a file, as JSON lines.
#pragma once

#include <string>

#include "symplant/trace/finding_words.hpp"
#include "symplant/trace/output_file.hpp"

namespace symplant::trace {

/// One writer; not thread-safe. Errors are in error().
class FindingFile {
 public:
  FindingFile(OutputFile file, const PlantNames& names) : file_(std::move(file)), names_(names) {}

  /// `words` are the sentences about the finding.
  void write(const FoundThing& found, const std::string& words, const History& history);
  void flush() { file_.flush(); }
  const std::string& error() const { return file_.error(); }

 private:
  OutputFile file_;
  const PlantNames& names_;
};

}  // namespace symplant::trace
