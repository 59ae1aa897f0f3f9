// Reads values of a plant.json that the schema has checked: a value of the wrong type counts as missing.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "description/description.hpp"
#include "description/faults.hpp"

namespace symplant::description {

/// The member of an object; null if it is missing or `object` is not an object.
const nlohmann::json* member(const nlohmann::json& object, std::string_view key);
/// A member that is a text; null if it is missing or not a text.
const std::string* text_member(const nlohmann::json& object, std::string_view key);
/// A member that is a text; empty if it is missing or not a text.
std::string text_or_empty(const nlohmann::json& object, std::string_view key);
/// The texts of a member that is an array; none if it is missing.
std::vector<std::string> texts_member(const nlohmann::json& object, std::string_view key);
/// A member that is a formula: a text, or a number as text. Empty if it is missing.
std::string formula_member(const nlohmann::json& object, std::string_view key);
/// The text of a formula: that of a number as it is written. Empty for another type.
std::string formula_text(const nlohmann::json& formula);
bool flag_member(const nlohmann::json& object, std::string_view key);

/// Collects faults of shape.
class ShapeFaults {
 public:
  explicit ShapeFaults(std::vector<DescriptionFault>& faults) : faults_(faults) {}
  void add(const Pointer& at, std::string message, FaultKind kind = FaultKind::shape) {
    faults_.push_back({at.text(), std::move(message), 0, kind});
  }
  /// Adds a fault of the value's key.
  void add_at_key(const Pointer& at, std::string message) {
    add(at, std::move(message));
    faults_.back().at_key = true;
  }

 private:
  std::vector<DescriptionFault>& faults_;
};

/// Rejects control characters: a name is shown and written to files.
void check_text(std::string_view text, const Pointer& here, ShapeFaults& faults);

/// A duration member; nothing if it is missing or invalid. An invalid duration is reported.
std::optional<tables::Time> time_member(const nlohmann::json& object, std::string_view key, const Pointer& here,
                                        ShapeFaults& faults);
/// Like time_member(), for a step: from 100 us to 1 h, else a fault and nothing.
std::optional<tables::Time> step_member(const nlohmann::json& object, std::string_view key, const Pointer& here,
                                        ShapeFaults& faults);
/// Like time_member(), for a duration that may be random: {"min","max"} or {"mean","sigma"}.
std::optional<Duration> duration_member(const nlohmann::json& object, std::string_view key, const Pointer& here,
                                        ShapeFaults& faults);
/// Like duration_member(), for a duration that may also be computed: {"seconds": FORMULA}.
std::optional<Duration> computed_duration_member(const nlohmann::json& object, std::string_view key,
                                                 const Pointer& here, ShapeFaults& faults);
std::optional<tables::Actuation> actuation_member(const nlohmann::json& object);
std::optional<Sequence> sequence_member(const nlohmann::json& object);
/// The member `overrun`: a duration, or kNever for `never`.
std::optional<tables::Time> overrun_member(const nlohmann::json& object, const Pointer& here, ShapeFaults& faults);

/// An entry of `devices`.
DeviceDescription device_entry(const std::string& path, const nlohmann::json& entry, ShapeFaults& faults);

/// An entry of `links`.
LinkDescription link_entry(const nlohmann::json& entry, const Pointer& here, ShapeFaults& faults);

/// An entry of `programs`.
ProgramDescription program_entry(const nlohmann::json& entry, const Pointer& here, ShapeFaults& faults);

}  // namespace symplant::description
