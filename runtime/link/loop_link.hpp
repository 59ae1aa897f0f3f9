// The link inside the process: a test or a library user acts as the PLC.
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

/// Keeps both images in memory. Serves every symbol, including those without an address.
///
/// The cycle's thread uses it as an Exchange; one other thread may use the PLC's side at the same time.
class LoopLink final : public Link {
 public:
  /// Serves the symbols of one controller, or of all; other symbols can be neither written nor read.
  explicit LoopLink(const tables::PlantTables& tables, std::uint32_t controller = kAllControllers);

  // The PLC's side. A symbol is given by name or by row in PlantTables::symbols. The next cycle reads what was written,
  // for all symbols of the same address. Reads return the state after the latest cycle.

  /// Writes a BOOL operation; false if the symbol is not one.
  bool set(std::string_view symbol, bool on);
  bool set(std::uint32_t symbol, bool on) noexcept;
  /// Writes a numeric operation, as Plant::set_operation_value takes it; false if the symbol is not one.
  bool set_value(std::string_view symbol, std::uint64_t value);
  bool set_value(std::uint32_t symbol, std::uint64_t value) noexcept;
  /// A BOOL event; nothing if the symbol is not one.
  std::optional<bool> event(std::string_view symbol);
  std::optional<bool> event(std::uint32_t symbol) noexcept;
  /// A numeric event, as Plant::event_value returns it; nothing if the symbol is not one.
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
  std::size_t operation_words_;  ///< of bits; then one word for each numeric operation
  std::size_t event_words_;
  share::SharedWords operations_;       ///< PLC -> cycle
  share::SharedWords events_;           ///< cycle -> PLC
  std::vector<std::uint64_t> applied_;  ///< operations that the plant has
  bool events_written_ = false;
};

/// Why `rest`, the URL after `loop:`, is invalid; empty if it is valid.
std::string loop_fault(std::string_view rest);

/// Never an error. Tables must outlive the link.
LinkResult open_loop_link(std::string_view rest, const LinkChoice& link, const tables::PlantTables& tables,
                          const plant::Plant* plant);

}  // namespace symplant::link
