// Devices of one kind: those whose names differ only in digits.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "model/plant_model.hpp"

namespace symplant::check {

/// What the other devices of a class say about one of its symbols.
enum class Expected : std::uint8_t {
  no,       ///< at most a quarter of them have it
  unclear,  ///< there are fewer than three others, or they disagree
  yes,      ///< at least three quarters of them have it
};

/// The classes of a plant's devices: `CLAMP1` and `CLAMP12`, of whatever line and process, are `CLAMP#`. ASCII case
/// does not count. The first devices are the plant's units, by the same indexes; after them come those that have
/// numeric symbols only. Made once in O(symbols); points into the plant.
class DeviceClasses {
 public:
  struct Class {
    std::string_view device;             ///< as the first of them is called
    std::vector<std::uint32_t> devices;  ///< ascending
    std::vector<std::uint32_t> parts;    ///< what its devices have, in the order of the first symbols
  };
  /// A symbol that devices of a class have: its direction and its task, as the first of them writes it.
  struct Part {
    std::uint32_t of = 0;  ///< the class
    tables::Direction direction{};
    std::string_view task;
  };

  explicit DeviceClasses(const model::PlantModel& plant);

  const std::vector<Class>& classes() const { return classes_; }
  const std::vector<Part>& parts() const { return parts_; }
  /// The class of a device, by their indexes.
  std::uint32_t class_of(std::uint32_t device) const { return class_of_[device]; }
  /// The class of that class_name(); kNone if there is none. O(1).
  std::uint32_t class_called(const std::string& name) const;
  std::size_t devices() const { return class_of_.size(); }
  /// A numeric symbol, by its index, and its device.
  struct Number {
    std::uint32_t device;
    std::uint32_t symbol;
  };
  /// Those of a device, in the order of lists. O(log numeric symbols).
  std::span<const Number> numbers_of(std::uint32_t device) const;
  /// The first symbol of a device in the order of lists.
  std::uint32_t first_symbol(std::uint32_t device) const { return first_symbol_[device]; }
  /// The device of a symbol; kNone where its name is against the rule, or it is in no model for another reason than
  /// being numeric.
  std::uint32_t device_of(std::uint32_t symbol) const { return device_of_[symbol]; }
  /// The part of a class; kNone where no device of it has one. O(1).
  std::uint32_t find(std::uint32_t of, tables::Direction direction, std::string_view task) const;
  /// How many devices have a part.
  std::uint32_t count(std::uint32_t part) const { return counts_[part]; }
  /// Whether a device is expected to have a part, by what the others of its class have; `has` says whether it has it
  /// itself. O(1).
  Expected expects(std::uint32_t device, tables::Direction direction, std::string_view task, bool has) const;

 private:
  struct HashPart {
    std::size_t operator()(const Part& part) const;
  };
  struct SamePart {
    bool operator()(const Part& a, const Part& b) const;
  };

  void add_device(std::string_view name, std::uint32_t first_symbol);
  void add_part(std::uint32_t device, std::uint32_t symbol, const model::PlantModel& plant);
  void add_numeric(const model::PlantModel& plant);

  std::vector<Class> classes_;
  std::unordered_map<std::string, std::uint32_t> class_by_name_;
  std::vector<std::uint32_t> class_of_;
  std::vector<std::uint32_t> first_symbol_;
  std::vector<std::uint32_t> device_of_;
  std::vector<Number> numbers_;  ///< by device
  std::vector<Part> parts_;
  std::vector<std::uint32_t> counts_;
  std::unordered_map<Part, std::uint32_t, HashPart, SamePart> part_;
};

/// A device's name with `#` for each run of digits, in capitals.
std::string class_name(std::string_view device);

}  // namespace symplant::check
