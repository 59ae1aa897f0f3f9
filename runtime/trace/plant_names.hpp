// The names of symbols, units, states, requirements, lists and links; the symbols of each unit.
#pragma once

#include <cstdint>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "symplant/tables/tables.hpp"
#include "symplant/trace/name_index.hpp"

namespace symplant::trace {

/// Views into the tables' blobs, which must outlive it. Construction is O(types and lists). Members are O(1) unless
/// noted, after a first call that is O(plant): a run that needs no name of a symbol or unit has no index of them.
/// Several threads may use it at the same time.
class PlantNames {
 public:
  explicit PlantNames(const tables::PlantTables& tables);

  const tables::PlantTables& tables() const { return tables_; }
  std::string_view symbol(std::uint32_t symbol) const { return symbols_[2 * std::size_t{symbol}]; }
  /// As in the list; empty if the symbol has no address.
  std::string_view address(std::uint32_t symbol) const { return symbols_[2 * std::size_t{symbol} + 1]; }
  std::string_view unit(std::uint32_t unit) const { return units_[unit]; }
  std::string_view state(std::uint32_t unit, std::uint8_t state) const;
  std::span<const std::string_view> states(std::uint32_t unit) const;
  std::string_view requirement(std::uint32_t requirement) const { return requirements_[requirement]; }
  /// A track or place; `out` for tables::kOut.
  std::string_view location(std::uint32_t location) const {
    return location == tables::kOut ? "out" : locations_[location];
  }
  std::string_view part_kind(std::uint32_t kind) const { return part_kinds_[kind]; }
  std::string_view transfer(std::uint32_t transfer) const { return transfers_[transfer]; }
  std::string_view work(std::uint32_t work) const { return work_[work]; }
  std::string_view source(std::uint32_t source) const { return sources_[source]; }
  std::string_view value(std::uint32_t value) const { return values_[2 * std::size_t{value}]; }
  std::string_view unit_of_value(std::uint32_t value) const { return values_[2 * std::size_t{value} + 1]; }
  /// The value of an output. O(log values).
  std::uint32_t value_of(std::uint32_t output) const;
  /// `TANK.level`, or `BOOM[2]` for an output of a value with several. O(log values).
  std::string output(std::uint32_t output) const;
  /// As tables::MalfunctionNumbers numbers them: a written name, or that of an ordinary one, `EXLINE_MB_AGV stuck`.
  std::string malfunction(std::uint32_t number) const;
  /// A member of an instantaneous loop, as Finding::of numbers it.
  std::string_view loop_member(std::uint32_t of) const;
  /// A link of the run, for messages.
  struct Link {
    std::string name;
    std::string silence;                       ///< why a loss is reported, and what to check
    std::string absence;                       ///< why `no PLC` is reported, and what to check
    std::uint32_t controller = tables::kNone;  ///< whose symbols it carries
    bool freezes = false;                      ///< whether the plant is frozen while the link is not live
  };
  /// The number of links; 0 without name_links().
  std::size_t links() const { return links_.size(); }
  /// The link with this index; empty without name_links().
  Link link(std::uint32_t link) const { return link < links_.size() ? links_[link] : Link(); }
  void name_links(std::vector<Link> links) { links_ = std::move(links); }
  /// A PLC program that runs in lock step.
  struct Program {
    std::string name;
    std::uint32_t controller = 0;  ///< whose symbols it has
    std::string digest;            ///< of its file
    tables::Time period = 0;
    tables::Time delay = 0;     ///< from a scan until its writes are sampled
    std::vector<bool> written;  ///< by symbol: whether it writes it
  };
  std::span<const Program> programs() const { return programs_; }
  void name_programs(std::vector<Program> programs) { programs_ = std::move(programs); }
  /// The task of a symbol: the state that a unit's operation leads to, else the end of the symbol's name.
  std::string_view task(std::uint32_t symbol) const;
  /// The name of the list that declares a symbol. O(log lists).
  std::string_view list(std::uint32_t symbol) const;
  /// The location of a symbol, such as `symbols.csv:4`. O(log lists).
  std::string cite(std::uint32_t symbol) const;

  /// The symbols of a unit, in list order.
  std::span<const std::uint32_t> symbols_of(std::uint32_t unit) const;
  bool is_operation(std::uint32_t symbol) const {
    return tables_.symbols[symbol].direction() == tables::Direction::operation;
  }

 private:
  void group() const;

  const tables::PlantTables& tables_;
  NameIndex symbols_;  ///< name and address of each symbol
  NameIndex units_;
  std::vector<std::string_view> states_;
  std::vector<std::string_view> requirements_;
  std::vector<std::string_view> lists_;
  std::vector<std::string_view> locations_;
  std::vector<std::string_view> part_kinds_;
  std::vector<std::string_view> transfers_;
  std::vector<std::string_view> work_;
  std::vector<std::string_view> sources_;
  std::vector<std::string_view> malfunctions_;
  std::vector<std::string_view> values_;  ///< name and unit of each
  std::vector<Link> links_;
  std::vector<Program> programs_;
  std::vector<std::uint32_t> first_states_;  ///< by type: the index of its first state in states_
  mutable std::once_flag grouped_;
  mutable std::vector<std::uint32_t> by_unit_;  ///< symbols of units, grouped by unit
  /// By unit: the index of its first symbol in by_unit_; one more entry at the end.
  mutable std::vector<std::uint32_t> first_of_;
};

}  // namespace symplant::trace
