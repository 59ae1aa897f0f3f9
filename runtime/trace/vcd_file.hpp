// Writes the run as a VCD file (IEEE 1364) for wave viewers: bits, numbers, and states of units as strings.
#pragma once

#include <string>
#include <vector>

#include "symplant/trace/history.hpp"
#include "symplant/trace/output_file.hpp"
#include "symplant/trace/plant_names.hpp"

namespace symplant::trace {

/// One writer; not thread-safe. Errors are in error(). `names` must outlive it.
class VcdFile {
 public:
  VcdFile(OutputFile file, const PlantNames& names);

  /// Writes the header and all values at the end of the first instant, once. Earlier records are not written.
  void begin(tables::Time time, const History& history);
  /// Writes a change of a symbol, a unit, parts or a written malfunction; ignores other records.
  void write(const Record& record);
  /// To be called between two instants: starts a new part, with header and values, if the file is full.
  void part(tables::Time time, const History& history);
  bool has_begun() const noexcept { return begun_; }
  /// Writes the final time, so that a viewer shows the run up to its end.
  void end(tables::Time time) { put_time(time); }

  void flush() { file_.flush(); }
  const std::string& error() const { return file_.error(); }

 private:
  void put_time(tables::Time time);
  void put_symbol(std::uint32_t symbol, std::uint64_t value);
  void put_unit(std::uint32_t unit, const plant::UnitView& view);
  void put_location(std::uint32_t location);
  void move_part(const PartRecord& part);
  void put_output(std::uint32_t output, double number);
  void put_malfunction(std::uint32_t malfunction, bool active);

  struct Content {
    std::uint64_t number;
    std::uint32_t kind;
  };

  OutputFile file_;
  const PlantNames& names_;
  std::vector<std::string> identifiers_;        ///< as vcd_header.hpp numbers them, each with a line end
  std::vector<std::vector<Content>> contents_;  ///< the parts of each location
  Record part_;                                 ///< the last record of a part, whose part_move is next
  tables::Time last_time_ = -1;
  bool begun_ = false;
  bool has_lines_ = false;  ///< whether this part has lines, so that no part is only a header
};

}  // namespace symplant::trace
