// The run as a VCD file (IEEE 1364) for wave viewers: bits, numbers, and the states of units as strings.
#pragma once

#include <string>
#include <vector>

#include "symplant/trace/history.hpp"
#include "symplant/trace/output_file.hpp"
#include "symplant/trace/plant_names.hpp"

namespace symplant::trace {

/// One writer; not thread-safe. What goes wrong is in error(). `names` must outlive it.
class VcdFile {
 public:
  VcdFile(OutputFile file, const PlantNames& names);

  /// Header and all values, once, as they stand at the end of the first instant. What comes before it is not written.
  void begin(tables::Time time, const History& history);
  /// A change of a symbol or a unit; other records are passed over.
  void write(const Record& record);
  /// Between two instants: begins a further part, with header and values, where the file is full.
  void part(tables::Time time, const History& history);
  /// So that a viewer shows the run up to its end.
  void end(tables::Time time) { put_time(time); }

  void flush() { file_.flush(); }
  const std::string& error() const { return file_.error(); }

 private:
  void put_time(tables::Time time);
  void put_symbol(std::uint32_t symbol, std::uint64_t value);
  void put_unit(std::uint32_t unit, const plant::UnitView& view);

  OutputFile file_;
  const PlantNames& names_;
  std::vector<std::string> identifiers_;  ///< of symbols, then units, with a line's end
  tables::Time last_time_ = -1;
  bool begun_ = false;
  bool has_lines_ = false;  ///< this part, so that a large header is not all that is written
};

}  // namespace symplant::trace
