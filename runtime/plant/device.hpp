// The devices and symbols of a running plant by the names of its generated classes, for tests and your own programs.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "symplant/plant/owned_plant.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::plant {

/// A device of a running plant. `Class` is its generated class. A small value: copy it as you like while the plant
/// lives. Every member is O(1) and real-time safe like the plant's; one thread at a time may use a plant.
template <class Class>
class Device {
 public:
  using State = typename Class::State;
  using Operation = typename Class::Operation;
  using Event = typename Class::Event;

  Device(Plant& plant, std::uint32_t unit) noexcept : plant_(&plant), unit_(unit) {}

  /// Writes an operation as the PLC does; the next advance_to() reads it. Operations stay as written.
  Device& command(Operation operation, bool on = true) noexcept {
    plant_->set_operation(row().operation_bit + static_cast<std::uint32_t>(operation), on);
    return *this;
  }
  /// Whether an operation was on, after forces, in the last instant.
  bool operation(Operation operation) const noexcept {
    return plant_->operation(row().operation_bit + static_cast<std::uint32_t>(operation));
  }
  /// An event, after forces, as the PLC reads it.
  bool event(Event event) const noexcept { return plant_->event(row().event_bit + static_cast<std::uint32_t>(event)); }

  /// The state in which the device is settled, or from which it moves.
  State state() const noexcept { return static_cast<State>(plant_->unit(unit_).state); }
  /// The state to which it moves; empty if it is settled.
  std::optional<State> moving_to() const noexcept {
    const UnitView view = plant_->unit(unit_);
    return view.moving ? std::optional(static_cast<State>(view.target)) : std::nullopt;
  }
  /// Whether it is settled in a state.
  bool is_in(State state) const noexcept {
    const UnitView view = plant_->unit(unit_);
    return !view.moving && view.state == static_cast<std::uint8_t>(state);
  }
  double progress() const noexcept { return plant_->unit(unit_).progress; }  ///< of its move, 0 to 1; 0 if settled
  /// Whether another device or an active malfunction disables it.
  bool disabled() const noexcept { return plant_->unit(unit_).disabled; }
  /// Puts it into a state, as if moved by hand (Plant::set_state).
  void put(State state) noexcept { plant_->set_state(unit_, static_cast<std::uint8_t>(state)); }
  /// Starts or ends an ordinary malfunction of the device: with `set_stuck` it does not move, with `set_slow` its moves
  /// take three times as long. Returns false if too many are active (Plant::start_malfunction).
  bool set_stuck(bool on = true) noexcept { return set_malfunction(plant_->malfunction_numbers().stuck(unit_), on); }
  bool set_slow(bool on = true) noexcept { return set_malfunction(plant_->malfunction_numbers().slow(unit_), on); }

  std::uint32_t index() const noexcept { return unit_; }  ///< in PlantTables::units
  UnitView view() const noexcept { return plant_->unit(unit_); }

 private:
  const tables::UnitRow& row() const noexcept { return plant_->tables().units[unit_]; }
  bool set_malfunction(std::uint32_t number, bool on) noexcept {
    return on ? plant_->start_malfunction(number) : plant_->stop_malfunction(number);
  }

  Plant* plant_;
  std::uint32_t unit_;
};

/// One of several devices whose names differ only in the number at the end.
struct NumberedUnit {
  std::uint64_t number;
  std::uint32_t unit;  ///< index in PlantTables::units
};

/// The devices CLAMP1, CLAMP2, ... of a process, ascending by number.
template <class Class>
class DeviceArray {
 public:
  DeviceArray(Plant& plant, std::span<const NumberedUnit> units) noexcept : plant_(&plant), units_(units) {}

  std::size_t size() const noexcept { return units_.size(); }
  /// The device with a number in its name. Throws std::out_of_range if no device has it. O(devices).
  Device<Class> operator[](std::uint64_t number) const {
    for (const NumberedUnit& unit : units_) {
      if (unit.number == number) return {*plant_, unit.unit};
    }
    throw std::out_of_range("no device of this name has the number " + std::to_string(number));
  }

  class Iterator {
   public:
    using value_type = Device<Class>;
    using difference_type = std::ptrdiff_t;

    Iterator() = default;
    Iterator(Plant* plant, const NumberedUnit* at) noexcept : plant_(plant), at_(at) {}
    Device<Class> operator*() const noexcept { return {*plant_, at_->unit}; }
    Iterator& operator++() noexcept {
      ++at_;
      return *this;
    }
    Iterator operator++(int) noexcept {
      Iterator before = *this;
      ++at_;
      return before;
    }
    friend bool operator==(const Iterator&, const Iterator&) noexcept = default;

   private:
    Plant* plant_ = nullptr;
    const NumberedUnit* at_ = nullptr;
  };
  Iterator begin() const noexcept { return {plant_, units_.data()}; }
  Iterator end() const noexcept { return {plant_, units_.data() + units_.size()}; }

 private:
  Plant* plant_;
  std::span<const NumberedUnit> units_;
};

/// A plant that allocates its memory and whose symbols have enumerators: `Symbol` enumerates the rows of
/// PlantTables::symbols.
template <class Symbol>
class NamedPlant : public OwnedPlant {
 public:
  using OwnedPlant::force;
  using OwnedPlant::OwnedPlant;
  using OwnedPlant::release;

  /// Writes an operation as the PLC does, or sets an event that no device drives, as a sensor would. A number is
  /// converted to the symbol's type as C++ converts it. Throws std::logic_error if a device drives the event: only
  /// force() can change it. O(symbols on the address).
  template <class Number>
  void set(Symbol symbol, Number number) {
    const std::uint64_t bits = bits_of(row(symbol), number);
    const tables::SymbolRow& symbol_row = row(symbol);
    if (symbol_row.direction() == tables::Direction::event) {
      if (!set_input(index(symbol), bits)) {
        throw std::logic_error("the event is driven by its device; use force() to change it");
      }
    } else if (symbol_row.type() == tables::DataType::boolean) {
      set_operation(symbol_row.index, bits != 0);
    } else {
      set_operation_value(symbol_row.index, bits);
    }
  }

  /// Whether a symbol is on, after forces: an operation as the last instant read it, or an event. A number is on if it
  /// is not 0. O(1).
  bool is_on(Symbol symbol) const noexcept {
    const tables::SymbolRow& symbol_row = row(symbol);
    if (symbol_row.type() != tables::DataType::boolean) return value<double>(symbol) != 0;
    const bool operation = symbol_row.direction() == tables::Direction::operation;
    return operation ? this->operation(symbol_row.index) : event(symbol_row.index);
  }
  /// The value of a symbol after forces, converted to `Number`; of a BOOL 0 or 1. O(1).
  template <class Number = double>
  Number value(Symbol symbol) const noexcept {
    const tables::SymbolRow& symbol_row = row(symbol);
    if (symbol_row.type() == tables::DataType::boolean) return static_cast<Number>(is_on(symbol) ? 1 : 0);
    const bool operation = symbol_row.direction() == tables::Direction::operation;
    const std::uint64_t bits = operation ? operation_value(symbol_row.index) : event_value(symbol_row.index);
    if (is_real(symbol_row)) return static_cast<Number>(std::bit_cast<double>(bits));
    if (is_signed(symbol_row)) return static_cast<Number>(static_cast<std::int64_t>(bits));
    return static_cast<Number>(bits);
  }

  /// Holds a symbol at a value until release() (Plant::force).
  template <class Number>
  void force(Symbol symbol, Number number) noexcept {
    force(index(symbol), bits_of(row(symbol), number));
  }
  void release(Symbol symbol) noexcept { release(index(symbol)); }
  /// Starts the ordinary malfunction that holds the bit of an event on or off. Returns false if the symbol is not a
  /// BOOL event, or if too many ordinary malfunctions are active (Plant::start_malfunction).
  bool set_stuck(Symbol event, bool on) noexcept {
    return start_malfunction(malfunction_numbers().stuck(index(event), on));
  }
  /// Ends the malfunctions of an event that set_stuck() starts, on and off.
  void free(Symbol event) noexcept {
    for (const bool on : {false, true}) stop_malfunction(malfunction_numbers().stuck(index(event), on));
  }

 private:
  static std::uint32_t index(Symbol symbol) noexcept { return static_cast<std::uint32_t>(symbol); }
  const tables::SymbolRow& row(Symbol symbol) const noexcept { return tables().symbols[index(symbol)]; }
  static bool is_real(const tables::SymbolRow& row) noexcept {
    return row.type() == tables::DataType::real || row.type() == tables::DataType::lreal;
  }
  static bool is_signed(const tables::SymbolRow& row) noexcept {
    return row.type() >= tables::DataType::sint && row.type() <= tables::DataType::lint;
  }
  template <class Number>
  static std::uint64_t bits_of(const tables::SymbolRow& row, Number number) noexcept {
    static_assert(std::is_arithmetic_v<Number>, "a symbol's value is a bool or a number");
    using tables::DataType;
    switch (row.type()) {
      case DataType::boolean:
        return number != Number{} ? 1 : 0;
      case DataType::real:
        return std::bit_cast<std::uint64_t>(static_cast<double>(static_cast<float>(number)));
      case DataType::lreal:
        return std::bit_cast<std::uint64_t>(static_cast<double>(number));
      case DataType::sint:
        return narrowed<std::int8_t>(number);
      case DataType::int_:
        return narrowed<std::int16_t>(number);
      case DataType::dint:
        return narrowed<std::int32_t>(number);
      case DataType::lint:
        return narrowed<std::int64_t>(number);
      case DataType::usint:
      case DataType::byte:
        return narrowed<std::uint8_t>(number);
      case DataType::uint:
      case DataType::word:
        return narrowed<std::uint16_t>(number);
      case DataType::udint:
      case DataType::dword:
        return narrowed<std::uint32_t>(number);
      case DataType::ulint:
      case DataType::lword:
        return narrowed<std::uint64_t>(number);
    }
    return 0;
  }
  /// Converts a number to `To`, then to the form of a value slot: two's complement of 64 bits.
  template <class To, class Number>
  static std::uint64_t narrowed(Number number) noexcept {
    return static_cast<std::uint64_t>(static_cast<To>(number));
  }
};

}  // namespace symplant::plant
