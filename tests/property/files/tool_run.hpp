// The tool on the files of a case.
#pragma once

#include <string>
#include <vector>

#include "property/files/expected.hpp"

namespace symplant::property::files {

/// A folder for the files of one run after the other; removed with this value.
class Workshop {
 public:
  Workshop();
  ~Workshop();
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  /// `symplant run` in this process, or the program `tool` if not empty. Its output is in said().
  Outcome run(const Files& files, const std::string& tool);
  /// Repeats the last run from its trace, in this process; the first difference from it, empty without a difference.
  std::string replay();
  const std::string& said() const { return said_; }

 private:
  std::string path(const char* name) const { return folder_ + "/" + name; }
  std::vector<std::string> arguments(const Files& files) const;

  std::string folder_;
  std::string said_;
};

/// The whole file as bytes; empty if it does not exist.
std::string read_file(const std::string& path);
void write_file(const std::string& path, const std::string& content);
std::vector<std::string> lines_of(const std::string& text);

/// The first difference from the wanted run; empty without a difference. The first word names the file or output.
std::string difference(const Outcome& wanted, const Outcome& got);

}  // namespace symplant::property::files
