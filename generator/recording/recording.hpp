// What a trace or a recording holds: the changes of each symbol, and where parts arrive.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "symplant/tables/time.hpp"

namespace symplant::recording {

/// The latest time and the longest window, in ns (73 years): their sums do not overflow.
inline constexpr tables::Time kLatestTime = std::numeric_limits<tables::Time>::max() / 4;

/// One element that a trace has lines of.
struct Series {
  enum class Kind : std::uint8_t {
    boolean,  ///< a symbol that is on or off, at first off
    number,   ///< a numeric symbol, at first 0
    parts,    ///< each change is a part of one kind that arrives at one location; its value is 1
  };
  struct Change {
    tables::Time time;
    double value;
  };
  std::string name;  ///< of the symbol or of the location
  Kind kind = Kind::boolean;
  std::string part;             ///< the kind of parts
  std::vector<Change> changes;  ///< by time
  bool is_operation = false;    ///< a PLC writes it, as far as the trace says
  bool may_be_number = false;   ///< a BOOL by its values, 0 and 1; the file has no types

  /// Identifies the same element in every trace: a symbol and a location may have the same name.
  std::string key() const { return kind == Kind::parts ? "@" + name + "@" + part : name; }
};

/// A time in which nothing was read: the link was lost, or a column had no cells.
struct Gap {
  tables::Time begin;
  tables::Time length;
};

/// A trace of a run, or a recording of a real plant, in any of the formats that read_recording() reads.
struct Recording {
  std::string name;                                    ///< of the file, for messages
  std::vector<Series> series;                          ///< by their first change
  std::unordered_map<std::string, std::size_t> index;  ///< of series, by key()
  /// The series of each change: by time; at one time those of operations first, as they are the causes.
  std::vector<std::uint32_t> order;
  tables::Time end = 0;         ///< the time of the last line, or a later one that the header has as `end`
  tables::Time resolution = 0;  ///< what times are exact to: an interval of reading, a cycle; 0: virtual time
  bool of_plant = true;         ///< else recorded from a PLC: a symbol without lines was not recorded
  bool has_parts = false;
  std::vector<Gap> gaps;   ///< by time
  std::string plant;       ///< its name, by the header of a trace; empty: unknown
  std::string model_hash;  ///< as `plant`

  /// The series of the same element; null if there is none. O(1).
  const Series* find(const Series& same) const;
};

/// Whether a symbol is an operation by its name, which has the level `O`.
bool is_operation_name(std::string_view name);

/// Puts the operations of each time first in `order`, after Series::is_operation changed. O(changes).
void order_operations(Recording& recording);

}  // namespace symplant::recording
