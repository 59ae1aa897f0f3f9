// The trace as a file: JSON lines, a header first, then a line for every net change.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "symplant/tables/tables.hpp"
#include "symplant/trace/history.hpp"
#include "symplant/trace/output_file.hpp"
#include "symplant/trace/record.hpp"

namespace symplant::trace {

/// One writer; not thread-safe.
class TraceFile {
 public:
  /// Writes the header. What goes wrong is in error().
  TraceFile(OutputFile file, const tables::PlantTables& tables, std::uint64_t model_hash, std::uint64_t seed);

  /// A record of a change; others are passed over. O(line).
  void write(const Record& record);
  /// Between two instants: begins a further part where the file is full. Its header holds `part`, counted from 1, the
  /// time `t`, and all `values` that are not off or 0, so that it can be read alone. O(1), then O(symbols).
  void part(tables::Time time, const History& history);

  void flush() { file_.flush(); }
  const std::string& error() const { return file_.error(); }

 private:
  const tables::PlantTables& tables_;
  OutputFile file_;
  std::string head_;                ///< of every part, without its closing brace
  std::vector<std::string> names_;  ///< of symbols: what stands between time and value
  std::string time_;                ///< of the lines being written
  tables::Time last_time_ = -1;
  std::uint64_t parts_ = 1;
  bool has_lines_ = false;  ///< this part, so that a large header is not all that is written
};

}  // namespace symplant::trace
