// The conversation of a Modbus client link with a server on this machine, step by step.
#pragma once

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "symplant/link/client/outbox.hpp"
#include "symplant/link/client_parts.hpp"
#include "symplant/link/image/table_view.hpp"
#include "unit/link/symbol_list.hpp"

namespace symplant::test {

/// The dialog of a link, its map, and images in plain memory.
class DialogBench {
 public:
  DialogBench(const SymbolList& list, std::uint16_t port, const std::string& parameters)
      : list_(list), tables_(list_.tables()), parts_(open(port, parameters)), outbox_(parts_.map) {
    for (std::size_t i = 0; i < link::modbus::kTables; ++i) words_[i].resize(parts_.map.sizes[i] / 16 * 4 + 4);
  }

  link::client::Dialog& dialog() { return *parts_.dialog; }
  link::client::Outbox& outbox() { return outbox_; }
  const link::modbus::IoMap& map() const { return parts_.map; }
  std::vector<std::uint64_t>& words(link::modbus::Table table) { return words_[static_cast<std::size_t>(table)]; }

  link::client::Fault read(tables::Time now = 0) {
    link::image::Tables tables = images();
    return parts_.dialog->read(tables, now);
  }
  /// Writes what differs from what the PLC has confirmed.
  link::client::Fault write() {
    const auto changes = outbox_.changes(images());
    unwritten_.clear();
    link::client::Fault fault = parts_.dialog->write(changes, unwritten_);
    if (!fault) outbox_.confirm(changes);
    return fault;
  }
  /// Of the latest write().
  const std::vector<link::client::Unwritten>& unwritten() const { return unwritten_; }
  link::client::Fault read_back(std::vector<std::uint64_t>& bits, std::vector<std::uint64_t>& numbers) {
    return parts_.dialog->read_back(bits, numbers, 0);
  }

  bool bit(link::modbus::Table table, std::uint32_t number) { return link::image::get_bit(words(table), number); }
  std::uint16_t number(link::modbus::Table table, std::uint32_t number) {
    return link::image::get_register(words(table), number);
  }
  void set_bit(std::uint32_t number, bool on) { link::image::set_bit(words(link::modbus::Table::discrete_input), number, on); }
  void set_number(std::uint32_t number, std::uint16_t value) {
    link::image::set_register(words(link::modbus::Table::input_register), number, value);
  }

 private:
  link::image::Tables images() {
    const auto size = [&](std::size_t table) { return parts_.map.sizes[table]; };
    return {{words_[0], size(0)}, {words_[1], size(1)}, {words_[2], size(2)}, {words_[3], size(3)}};
  }
  link::client::ClientParts open(std::uint16_t port, const std::string& parameters) const {
    auto parts = link::client_parts({"modbus-tcp://127.0.0.1:" + std::to_string(port) + "?" + parameters, 0}, tables_);
    if (auto* error = std::get_if<link::LinkError>(&parts)) throw std::runtime_error(error->message);
    return std::get<link::client::ClientParts>(std::move(parts));
  }

  SymbolList list_;
  tables::PlantTables tables_;
  link::client::ClientParts parts_;
  link::client::Outbox outbox_;
  std::vector<link::client::Unwritten> unwritten_;
  std::array<std::vector<std::uint64_t>, link::modbus::kTables> words_;
};

}  // namespace symplant::test
