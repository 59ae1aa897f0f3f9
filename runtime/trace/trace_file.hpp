// Writes the trace to a file: JSON lines, first a header, then one line for each net change.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "symplant/tables/tables.hpp"
#include "symplant/trace/history.hpp"
#include "symplant/trace/output_file.hpp"
#include "symplant/trace/plant_names.hpp"
#include "symplant/trace/record.hpp"

namespace symplant::trace {

/// Where a recording of a real plant comes from.
struct RecordedFrom {
  std::string link;        ///< URL
  tables::Time every = 0;  ///< interval of readings, ns
  std::string utc;         ///< of t = 0, ISO 8601
};

/// One writer; not thread-safe.
class TraceFile {
 public:
  /// Writes the header, which names the programs. `cycle`: in real time, in ns; 0: virtual time. Errors are in error().
  TraceFile(OutputFile file, const tables::PlantTables& tables, std::uint64_t model_hash, std::uint64_t seed,
            tables::Time cycle = 0, std::span<const PlantNames::Program> programs = {});
  /// Writes the header of a recording. Only symbols with a line were recorded; later parts have the values of all of
  /// these.
  TraceFile(OutputFile file, const tables::PlantTables& tables, std::uint64_t model_hash, const RecordedFrom& from);

  /// Writes a record of a change, of a part or of a malfunction; ignores others. O(line).
  void write(const Record& record);
  /// A line about a plant that was set to another state at `time`: `{"t":0,"reset":"","values":{...}}`, with all values
  /// that are not off or 0. `what` is the key, `name` the snapshot. O(symbols).
  void set_back(std::string_view what, std::string_view name, tables::Time time, const History& history);
  /// A line about what was done to the plant, as JSON: `{"t":5000000,"act":{"force":{"X":true}},"by":"hand"}`. `by` is
  /// `hand` or `scenario`.
  void act(tables::Time time, std::string_view json, std::string_view by);
  /// What follows at this time belongs to a further instant: if there are lines of it, the first one is
  /// `{"t":0,"instant":2}`.
  void instant(tables::Time time, std::uint64_t number);
  /// A line about the link of a device with a behavior: `{"t":0,"quality":{"ARM":false}}`.
  void quality(tables::Time time, std::string_view device, bool well);
  /// A line about a time in which nothing was recorded: `{"t":0,"gap":800000000}`.
  void gap(tables::Time time, tables::Time length);
  /// A line about the interval of readings that a PLC reaches, if it is slower than wanted:
  /// `{"t":0,"every":222000000}`. Later parts have the latest one, too.
  void interval(tables::Time time, tables::Time every);
  /// The last line of a recording: `{"t":0,"end":true}`; with the key `every` if the interval is not 0.
  void end(tables::Time time, tables::Time every = 0);
  /// A line about changes that are missing: `{"t":0,"lost":3}`.
  void lost(tables::Time time, std::uint64_t changes);
  /// To be called between two instants: starts a new part if the file is full. Its header has `part`, counted from 1,
  /// the time `t`, and all `values` that are not off or 0, so that each part can be read alone. O(1); O(symbols) for a
  /// new part.
  void part(tables::Time time, const History& history);

  void flush() { file_.flush(); }
  const std::string& error() const { return file_.error(); }

 private:
  void begin();
  void put_time(tables::Time time);
  void add_programs(std::span<const PlantNames::Program> programs);
  void put_part(const PartRecord& part);
  void put_values(const History& history);
  void put_malfunctions(const History& history);
  void put_malfunction(const Record& record);

  const tables::PlantTables& tables_;
  PlantNames plant_names_;
  OutputFile file_;
  std::string head_;                    ///< the header of every part, without its closing brace
  std::vector<std::string> names_;      ///< by symbol: the text between time and value
  std::vector<std::string> locations_;  ///< as JSON; so are the kinds
  std::vector<std::string> kinds_;
  std::vector<std::string> outputs_;  ///< of values: the text between time and number
  std::uint64_t instant_ = 0;         ///< the number of the instant of the next line, if that is its first line; else 0
  tables::Time instant_time_ = 0;     ///< of that instant
  Record part_;                       ///< the last record of a part, whose part_move is next
  std::string time_;                  ///< the text of last_time_
  tables::Time last_time_ = -1;
  std::uint64_t parts_ = 1;
  bool recorded_ = false;         ///< of a real plant
  tables::Time every_ = 0;        ///< of the latest interval(); 0: there was none
  std::vector<bool> has_values_;  ///< by symbol: it has had a line; of a recording
  bool has_lines_ = false;        ///< whether this part has lines, so that no part is only a header
};

}  // namespace symplant::trace
