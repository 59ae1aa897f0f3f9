// One PLC program that runs: its cells, its scans, and what it wrote.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "symplant/link/link_settings.hpp"
#include "symplant/plant/plant.hpp"
#include "symplant/program/binding.hpp"

namespace symplant::program {

/// What the user chooses for a program.
struct Options {
  std::uint32_t controller = 0;             ///< whose symbols it has
  std::optional<tables::Time> period = {};  ///< from scan to scan, above 0; nothing: the program's, else 10 ms
  std::optional<tables::Time> delay =
      {};  ///< from a scan until its writes are sampled, 1 ns to the period; nothing: the period
  link::OnLoss on_loss = link::OnLoss::hold;  ///< what its operations do while its controller is lost
  std::vector<std::string> ignore = {};       ///< patterns of variables that need no symbol
};

/// The times of a program with these options, or why they do not fit.
struct Times {
  tables::Time period = 0;
  tables::Time delay = 0;
  std::string error;
};
Times times_of(const symplant_program& program, const Options& options);

/// An instance of a program. Not copyable: the program has the addresses of its cells.
class Instance {
 public:
  /// All arguments must outlive it. Neither the binding nor the times may have errors.
  Instance(const symplant_program& program, const Binding& binding, const Options& options, const Times& times,
           plant::Plant& plant);
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;
  ~Instance() { end(); }

  /// A cold start of a plant at time 0: makes the program's instance, with the events as they are. False if the program
  /// failed. O(symbols).
  bool begin() noexcept;
  /// Ends the program's instance, if there is one.
  void end() noexcept;
  /// A cold start while the plant runs: operations go to zero until the writes of the next scan are sampled.
  /// O(symbols).
  bool restart() noexcept;

  /// Writes changed events to the program's cells. O(changes).
  void take_events() noexcept;
  /// One scan at plant time `now`; what it wrote is sampled at now + delay. Returns what the program returned. O(cells
  /// that it writes / 8, and changes).
  int scan(tables::Time now) noexcept;
  /// Writes the operations of the latest scan to the plant. O(changes).
  void write_operations() noexcept;
  /// Its controller is lost: what was not yet written is dropped, and operations follow `on_loss`. True if that changes
  /// operations.
  bool lose() noexcept;

  const char* name() const noexcept { return program_.name; }
  const Times& times() const noexcept { return times_; }
  std::uint32_t controller() const noexcept { return options_.controller; }
  /// When the writes of the latest scan are to be sampled; kNever: there are none.
  tables::Time sample() const noexcept { return changed_.empty() ? tables::kNever : sample_; }

 private:
  /// An operation that the program writes.
  struct Write {
    std::uint32_t symbol;
    std::uint64_t at_start;  ///< its cell at time 0
  };
  struct Change {
    std::uint32_t write;
    std::uint64_t before;  ///< its cell, as the plant has it
  };

  std::uint64_t number(std::uint32_t symbol) const noexcept;
  void take_event_word(std::uint32_t word) noexcept;
  bool start() noexcept;
  void put(std::uint32_t write) noexcept;
  bool zero() noexcept;
  void drop() noexcept;

  const symplant_program& program_;
  const Options options_;
  const Times times_;
  plant::Plant& plant_;
  void* instance_ = nullptr;
  std::vector<std::uint64_t> cells_;  ///< first those of writes_, then events, then what is ignored
  std::vector<void*> addresses_;      ///< by variable
  std::vector<Write> writes_;
  std::vector<std::uint64_t> written_;  ///< the cells of writes_, as written to the plant or in changed_
  std::vector<Change> changed_;         ///< by the latest scan, not yet written
  tables::Time sample_ = 0;
  std::vector<std::uint64_t> read_bits_;       ///< by word of the events' plane: those that have a cell
  std::vector<std::uint32_t> cell_of_bit_;     ///< by bit; valid in read_bits_
  std::vector<std::uint32_t> cell_of_slot_;    ///< by slot of a numeric event; tables::kNone
  std::vector<std::uint32_t> symbol_of_slot_;  ///< by slot; valid with a cell
};

}  // namespace symplant::program
