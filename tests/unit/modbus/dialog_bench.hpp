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
#include "symplant/link/image/words.hpp"
#include "symplant/link/modbus/io_map.hpp"
#include "unit/link/symbol_list.hpp"

namespace symplant::test {

/// The dialog of a link, its map, and images in plain memory. Bits and numbers are named by their Modbus address.
class DialogBench {
 public:
  DialogBench(const SymbolList& list, std::uint16_t port, const std::string& parameters)
      : list_(list), tables_(list_.tables()), parts_(open(port, parameters)), outbox_(tables_, parts_.map) {
    for (std::size_t i = 0; i < link::kPlanes; ++i) {
      const auto plane = static_cast<link::Plane>(i);
      const std::uint32_t size = parts_.map.sizes[i];
      words_[i].resize(link::has_bits(plane) ? link::image::bit_words(size) + 1 : size + 1);
    }
    link::LinkSettings settings;
    settings.status_block = link::kNowhere;
    const link::modbus::IoMap map = link::modbus::make_io_map(tables_, 0, settings);
    operation_lanes_ = lanes_of(map, parts_.map, link::modbus::Table::holding_register);
    event_lanes_ = lanes_of(map, parts_.map, link::modbus::Table::input_register);
  }

  link::client::Dialog& dialog() { return *parts_.dialog; }
  link::client::Outbox& outbox() { return outbox_; }
  const link::image::Map& map() const { return parts_.map; }
  std::vector<std::uint64_t>& words(link::Plane plane) { return words_[static_cast<std::size_t>(plane)]; }

  link::client::Fault read(tables::Time now = 0) {
    return parts_.dialog->read({words(link::Plane::operation_bits), words(link::Plane::operation_numbers)}, now);
  }
  /// Writes what differs from what the PLC has confirmed.
  link::client::Fault write() {
    const auto changes = outbox_.changes({words(link::Plane::event_bits), words(link::Plane::event_numbers)});
    unwritten_.clear();
    link::client::Fault fault = parts_.dialog->write(changes, unwritten_);
    if (!fault) outbox_.confirm(changes);
    return fault;
  }
  /// Of the latest write().
  const std::vector<link::client::Unwritten>& unwritten() const { return unwritten_; }
  link::client::Fault read_back(std::vector<std::uint64_t>& bits, std::vector<std::uint64_t>& numbers) {
    return parts_.dialog->read_back({bits, numbers}, 0);
  }

  bool bit(std::uint32_t coil) { return link::image::get_bit(words(link::Plane::operation_bits), coil); }
  std::uint16_t number(std::uint32_t holding_register) {
    return link::image::get_lane(words(link::Plane::operation_numbers), operation_lanes_.at(holding_register));
  }
  void set_bit(std::uint32_t discrete_input, bool on) {
    link::image::set_bit(words(link::Plane::event_bits), discrete_input, on);
  }
  void set_number(std::uint32_t input_register, std::uint16_t value) {
    link::image::set_lane(words(link::Plane::event_numbers), event_lanes_.at(input_register), value);
  }
  /// Where an input register lies in the numbers that read_back() fills.
  std::uint32_t event_lane(std::uint32_t input_register) const { return event_lanes_.at(input_register); }

 private:
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
  std::array<std::vector<std::uint64_t>, link::kPlanes> words_;
  std::vector<std::uint32_t> operation_lanes_;  ///< by holding register
  std::vector<std::uint32_t> event_lanes_;      ///< by input register
};

}  // namespace symplant::test
