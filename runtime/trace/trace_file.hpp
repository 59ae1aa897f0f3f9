// The trace as a file: JSON lines, a header first, then a line for every net change.
#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "symplant/core/tables.hpp"
#include "symplant/trace/recorder.hpp"

namespace symplant::trace {

/// One writer; not thread-safe. A write that fails (a full disk) ends the file, not the plant: see error().
class TraceFile {
 public:
  /// Opens the file and writes the header. What went wrong is in error().
  TraceFile(const std::string& path, const core::PlantTables& tables, std::uint64_t model_hash, std::uint64_t seed);

  void write(const Change& change);
  /// Gives everything written so far to the system.
  void flush();

  /// Empty while all is well; else what the system said, once and for all.
  const std::string& error() const { return error_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  void put(const std::string& text);
  void fail();

  const core::PlantTables& tables_;
  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;
  std::vector<std::string> names_;  ///< of symbols, as JSON strings
  std::string line_;
  std::string error_;
};

/// The value of a symbol as JSON: true or false; a number, or a string where a number cannot say it (integers beyond
/// 2^53, NaN, infinities). REAL and LREAL in the shortest form that reads back.
std::string json_value(core::DataType type, std::uint64_t value);

}  // namespace symplant::trace
