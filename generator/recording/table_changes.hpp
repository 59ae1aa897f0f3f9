// Makes changes of symbols from the cells of a table.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "recording/collector.hpp"
#include "recording/reading.hpp"
#include "recording/renamer.hpp"

namespace symplant::recording {

/// Where a cell is, for messages.
struct CellAt {
  std::uint32_t line = 0;
  std::size_t column = 0;  ///< counted from 0
};

/// The cells of each symbol, by time; kinds and changes follow from them.
class TableChanges {
 public:
  /// What is made of the cells goes to `read`, which must outlive this object, as the name of the file does.
  TableChanges(ReadRecording& read, const Renamer& renamer)
      : read_(read), renamer_(renamer), changes_(read.recording) {}

  /// The number of the symbol of a column. If an earlier column is the same symbol, this one is left out with a
  /// warning.
  std::uint32_t add(std::string_view name, CellAt at);
  /// The number of the symbol with this name in a row; it is added if it is new. O(1).
  std::uint32_t symbol(std::string_view name, CellAt at);

  /// Takes a cell that is not empty. Times of one symbol must not decrease. False if it is not a value;
  /// then read.error is set. A cell that says that there is no value counts as empty.
  bool take(std::uint32_t symbol, tables::Time time, std::string_view cell, CellAt at);

  /// From now on take() can be undone.
  void begin_undo();
  /// Undoes what was taken since begin_undo().
  void undo();

  /// Passes all changes on, by time, with `begin` as time 0. Call once.
  void finish(tables::Time begin);

  /// The names in the file.
  const std::vector<std::string>& names() const { return names_; }

  std::string at_cell(CellAt at, std::string_view text) const;

 private:
  struct Symbol {
    std::string name;  ///< after renaming
    std::string cell;  ///< the last one
    double value = 0;
    bool begun = false;
    bool left_out = false;  ///< its cells are texts
    bool has_words = false;
    bool has_numbers = false;
  };
  struct Change {
    tables::Time time;
    double value;
    std::uint32_t symbol;
  };

  void leave_out(Symbol& symbol, std::string_view cell, CellAt at);

  ReadRecording& read_;
  const Renamer& renamer_;
  Collector changes_;
  std::vector<Symbol> symbols_;
  std::vector<std::string> names_;                          ///< of the symbols in the file
  std::unordered_map<std::string, std::uint32_t> by_name_;  ///< in rows
  std::unordered_map<std::string, CellAt> begins_;          ///< of symbols
  std::vector<Change> all_;
  std::size_t left_out_ = 0;
  std::size_t unknown_ = 0;    ///< cells that say that there is no value
  std::string first_unknown_;  ///< the first of them, with its place
  struct Undo {
    std::size_t changes;
    std::size_t warnings;
    std::size_t left_out;
    std::size_t unknown;
    std::vector<std::pair<std::uint32_t, Symbol>> symbols;  ///< as they were before
  };
  std::optional<Undo> undo_;
  std::string key_;  ///< reused
};

}  // namespace symplant::recording
