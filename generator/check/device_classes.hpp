// Devices of one kind: those whose names differ in digits alone.
#pragma once

#include <cstdint>
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
/// does not count. Made once in O(symbols); points into the plant.
class DeviceClasses {
 public:
  struct Class {
    std::vector<std::uint32_t> units;  ///< ascending
  };
  /// A symbol that devices of a class have: its direction and its task, as the first of them writes it.
  struct Part {
    std::uint32_t of = 0;  ///< the class
    core::Direction direction{};
    std::string_view task;
  };

  explicit DeviceClasses(const model::PlantModel& plant);

  const std::vector<Class>& classes() const { return classes_; }
  /// The class of a unit, by their places.
  std::uint32_t class_of(std::uint32_t unit) const { return class_of_[unit]; }
  /// All parts of a class, in the order of their first symbols.
  const std::vector<Part>& parts(std::uint32_t of) const { return parts_[of]; }
  /// How many units of the class have the part. O(1).
  std::uint32_t count(std::uint32_t of, core::Direction direction, std::string_view task) const;
  /// Whether a unit is expected to have a part, by what the others of its class have; `has` says whether it has it
  /// itself. O(1).
  Expected expects(std::uint32_t unit, core::Direction direction, std::string_view task, bool has) const;

 private:
  struct HashPart {
    std::size_t operator()(const Part& part) const;
  };
  struct SamePart {
    bool operator()(const Part& a, const Part& b) const;
  };

  void add_part(std::uint32_t of, const model::Symbol& symbol);

  std::vector<Class> classes_;
  std::vector<std::uint32_t> class_of_;
  std::vector<std::vector<Part>> parts_;
  std::unordered_map<Part, std::uint32_t, HashPart, SamePart> counts_;
};

/// A device's name with `#` for each run of digits, in capitals.
std::string class_name(std::string_view device);

}  // namespace symplant::check
