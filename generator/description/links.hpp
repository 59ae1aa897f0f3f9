// What a description says of links to PLCs.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "symplant/link/link_settings.hpp"

namespace symplant::description {

/// An entry of a link's `map`: of whose symbols it speaks, and what it says of them.
struct MapEntry {
  enum class By : std::uint8_t { area, range, symbol };
  By by = By::symbol;
  std::string text;                     ///< an area; the range's first address; a symbol's name or a pattern
  std::string last = {};                ///< the range's last address
  std::optional<std::uint32_t> number;  ///< of the symbol; of the first address of the range; of the area's address 0
  std::optional<link::WordOrder> word_order = {};
  std::optional<link::OnLoss> on_loss = {};
};

/// A link of the plant. It is opened where the command line names none; what it says of the map and of its loss holds
/// for its controller whichever URL links it.
struct LinkDescription {
  std::string url;
  std::string controller = {};       ///< whose symbols it carries; empty where none is named
  link::LinkSettings settings = {};  ///< without `places`, `keep` and word order, which follow
  std::vector<std::string> keep = {};
  std::optional<link::WordOrder> word_order = {};
  std::vector<MapEntry> map = {};
  bool has_settings = false;  ///< it says more than URL and controller
};

/// Whether a controller may have this name: it is not empty, and `--link NAME=URL` can say it: no `=`, `:` or control
/// character, no blank at an end.
bool is_controller_name(std::string_view name);

}  // namespace symplant::description
