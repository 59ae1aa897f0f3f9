// Reading values of a plant.json whose shape the schema has looked at: what has the wrong type counts as not there.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "description/description.hpp"
#include "description/faults.hpp"

namespace symplant::description {

/// The member of an object; null where there is none, or `object` is none.
const nlohmann::json* member(const nlohmann::json& object, std::string_view key);
/// A member that is a text; null where it is none.
const std::string* text_member(const nlohmann::json& object, std::string_view key);
/// A member that is a text, empty where it is none.
std::string text_or_empty(const nlohmann::json& object, std::string_view key);
bool flag_member(const nlohmann::json& object, std::string_view key);

/// Faults of shape.
class ShapeFaults {
 public:
  explicit ShapeFaults(std::vector<DescriptionFault>& faults) : faults_(faults) {}
  void add(const Pointer& at, std::string message, FaultKind kind = FaultKind::shape) {
    faults_.push_back({at.text(), std::move(message), 0, kind});
  }

 private:
  std::vector<DescriptionFault>& faults_;
};

/// Refuses control characters, which a name that is shown and written to files must not hold.
void check_text(std::string_view text, const Pointer& here, ShapeFaults& faults);

/// A duration member; nothing where there is none, or it is none and the fault has been told.
std::optional<tables::Time> time_member(const nlohmann::json& object, std::string_view key, const Pointer& here,
                                        ShapeFaults& faults);
/// Likewise one that may be drawn: {"min","max"} or {"mean","sigma"}.
std::optional<Duration> duration_member(const nlohmann::json& object, std::string_view key, const Pointer& here,
                                        ShapeFaults& faults);
std::optional<tables::Actuation> actuation_member(const nlohmann::json& object);

/// An entry of `devices`.
DeviceDescription device_entry(const std::string& path, const nlohmann::json& entry, ShapeFaults& faults);

/// An entry of `links`.
LinkDescription link_entry(const nlohmann::json& entry, const Pointer& here, ShapeFaults& faults);

}  // namespace symplant::description
