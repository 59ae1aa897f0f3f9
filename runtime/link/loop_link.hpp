// The link in process: a test or a library user is the PLC.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "symplant/link/link.hpp"
#include "symplant/link/names.hpp"
#include "symplant/share/shared_words.hpp"

namespace symplant::link {

/// Both images in memory. Serves every symbol, those without an address and wide numbers too.
///
/// The cycle's thread uses it as an Exchange; one other thread may hold the PLC's end at the same time.
class LoopLink final : public Link {
 public:
  /// With the symbols of one controller, or of all: those of others can neither be written nor read.
  explicit LoopLink(const tables::PlantTables& tables, std::uint32_t controller = kAllControllers);

  // The PLC's end. Symbols by name or by row in PlantTables::symbols. What was written is seen by the next cycle, and
  // acts on all symbols of the same address; what is read is the state after the latest cycle.

  /// Writes a BOOL operation; false where the symbol is none.
  bool set(std::string_view symbol, bool on);
  bool set(std::uint32_t symbol, bool on) noexcept;
  /// Writes a numeric operation, as Plant::set_operation_value takes it; false where the symbol is none.
  bool set_value(std::string_view symbol, std::uint64_t value);
  bool set_value(std::uint32_t symbol, std::uint64_t value) noexcept;
  /// A BOOL event; nothing where the symbol is none.
  std::optional<bool> event(std::string_view symbol);
  std::optional<bool> event(std::uint32_t symbol) noexcept;
  /// A numeric event, as Plant::event_value gives it; nothing where the symbol is none.
  std::optional<std::uint64_t> event_value(std::string_view symbol);
  std::optional<std::uint64_t> event_value(std::uint32_t symbol) noexcept;

  std::string url() const override { return "loop:"; }
  void read_operations(plant::Plant& plant, tables::Time now) noexcept override;
  void write_events(const plant::Plant& plant, const exec::CycleStatus& status) noexcept override;
  LinkStatus status() const noexcept override { return {}; }

 private:
  bool is(std::uint32_t symbol, tables::Direction direction, bool bit) const noexcept;
  std::uint32_t leader(std::uint32_t symbol) const noexcept;
  template <class Write>
  void write_all_of_address(std::uint32_t symbol, Write write) noexcept;
  void write_event_word(std::size_t word, std::uint64_t value) noexcept;

  const tables::PlantTables& tables_;
  std::uint32_t controller_;
  SymbolNames names_;
  std::size_t operation_words_;  ///< of bits; a word each numeric operation follows
  std::size_t event_words_;
  share::SharedWords operations_;       ///< PLC -> cycle
  share::SharedWords events_;           ///< cycle -> PLC
  std::vector<std::uint64_t> applied_;  ///< operations that the plant was given
  bool events_written_ = false;
};

}  // namespace symplant::link
