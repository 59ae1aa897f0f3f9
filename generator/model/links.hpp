// What a description says of links to PLCs.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "symplant/core/link_settings.hpp"

namespace symplant::model {

/// An entry of a link's `map`: of whose symbols it speaks, and what it says of them.
struct MapEntry {
  enum class By : std::uint8_t { area, range, symbol };
  By by = By::symbol;
  std::string text;                     ///< an area; the range's first address; a symbol's name or a pattern
  std::string last = {};                ///< the range's last address
  std::optional<std::uint32_t> number;  ///< of the symbol; of the first address of the range; of the area's address 0
  std::optional<core::WordOrder> word_order = {};
  std::optional<core::OnLoss> on_loss = {};
};

/// A link of the plant. It is opened where the command line names none; what it says of the map and of its loss holds
/// for its controller whichever URL links it.
struct LinkDescription {
  std::string url;
  std::string controller = {};       ///< whose symbols it carries; empty where none is named
  core::LinkSettings settings = {};  ///< without `places`, `keep` and word order, which follow
  std::vector<std::string> keep = {};
  std::optional<core::WordOrder> word_order = {};
  std::vector<MapEntry> map = {};
  bool has_settings = false;  ///< it says more than URL and controller
};

/// The settings of a controller's link, with the memory that they point to.
struct ControllerLink {
  core::LinkSettings link;  ///< without spans
  std::vector<core::PlaceRow> places;
  std::vector<std::string_view> keep;  ///< into the description

  /// Valid for as long as this stands where it does.
  core::LinkSettings settings() const;
};

/// Whether a controller may have this name: it is not empty, and `--link NAME=URL` can say it: no `=`, `:` or control
/// character, no blank at an end.
bool is_controller_name(std::string_view name);

class Faults;
struct PlantModel;

/// Records what is wrong with the links of a plant's description: a controller that the plant has not, none named where
/// that leaves it open, two links of one controller. Gives by controller the link whose settings hold; null: none.
/// O(links * controllers).
std::vector<const LinkDescription*> check_links(const PlantModel& plant, Faults& faults);

/// Makes PlantModel::links, the settings by controller; shared addresses must be known. Records what an entry of a
/// `map` names and is not there, and where two say different things of one symbol. O(symbols * entries).
void resolve_links(PlantModel& plant, const std::vector<const LinkDescription*>& links, Faults& faults);

}  // namespace symplant::model
