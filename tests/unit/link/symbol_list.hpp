// Tables of symbols without units, built one symbol at a time.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "symplant/tables/tables.hpp"

namespace symplant::test {

class SymbolList {
 public:
  using Row = tables::SymbolRow;
  static constexpr auto kIn = tables::Direction::event;
  static constexpr auto kOut = tables::Direction::operation;

  /// A symbol with a plain number as address. Returns its row.
  std::uint32_t add(std::string_view name, tables::Direction direction, std::uint32_t number,
                    tables::DataType type = tables::DataType::boolean) {
    return add(name, direction, tables::AddressForm::number, number, type);
  }

  std::uint32_t add(std::string_view name, tables::Direction direction, tables::AddressForm form,
                    std::uint32_t number = 0, tables::DataType type = tables::DataType::boolean) {
    const bool bit = type == tables::DataType::boolean;
    std::uint32_t& next = direction == kOut ? (bit ? bits_out_ : slots_out_) : (bit ? bits_in_ : slots_in_);
    const auto row = static_cast<std::uint32_t>(rows_.size());
    rows_.push_back({.index = next++,
                     .unit = tables::kNone,
                     .number = number,
                     .row = row + 1,
                     .kind = tables::symbol_kind(type, direction, form, false)});
    names_ += name;
    names_ += '\0';
    names_ += address_;
    names_ += '\0';
    return row;
  }

  /// A symbol whose address has no plain number, as in a list of devices.
  std::uint32_t add_device(std::string_view name, tables::Direction direction, std::string_view address,
                           tables::DataType type = tables::DataType::boolean) {
    address_ = address;
    const std::uint32_t row = add(name, direction, tables::AddressForm::other, 0, type);
    address_.clear();
    return row;
  }
  /// A symbol with an address text that was read as this number.
  std::uint32_t add_device(std::string_view name, tables::Direction direction, std::string_view address,
                           std::uint32_t number) {
    address_ = address;
    const std::uint32_t row = add(name, direction, number);
    address_.clear();
    return row;
  }

  /// The symbols added from now on belong to this controller; earlier ones to one without a name.
  void controller(std::string_view name) {
    if (!rows_.empty() && lists_.empty()) {
      lists_.push_back({0, 0});
      controllers_ += '\0';
    }
    lists_.push_back({static_cast<std::uint32_t>(rows_.size()), static_cast<std::uint32_t>(lists_.size())});
    controllers_.append(name).push_back('\0');
  }

  /// Its bit has the opposite meaning.
  void invert(std::uint32_t row) {
    rows_[row].kind =
        tables::symbol_kind(rows_[row].type(), rows_[row].direction(), rows_[row].form(), rows_[row].moved(), true);
  }
  void start_at(std::uint32_t row, std::uint64_t value) { initial_.push_back({row, value}); }
  void share(std::uint32_t row, std::uint32_t leader) { shared_.push_back({row, leader}); }

  /// Valid while the list exists and no symbol is added.
  tables::PlantTables tables() const {
    tables::PlantTables tables{};
    tables.name = "list";
    tables.symbols = rows_;
    tables.lists = lists_;
    tables.controller_names = controllers_;
    tables.initial_values = initial_;
    tables.shared_addresses = shared_;
    tables.operation_bits = (bits_out_ + 63) / 64 * 64;
    tables.event_bits = (bits_in_ + 63) / 64 * 64;
    tables.operation_slots = slots_out_;
    tables.event_slots = slots_in_;
    tables.symbol_names = names_;
    return tables;
  }

 private:
  std::vector<Row> rows_;
  std::vector<tables::SymbolListRow> lists_;
  std::string controllers_;
  std::vector<tables::InitialValue> initial_;
  std::vector<tables::SharedAddress> shared_;
  std::string names_;
  std::string address_;  ///< of the symbol to add
  std::uint32_t bits_in_ = 0;
  std::uint32_t bits_out_ = 0;
  std::uint32_t slots_in_ = 0;
  std::uint32_t slots_out_ = 0;
};

}  // namespace symplant::test
