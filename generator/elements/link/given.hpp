// The links to PLCs in a description.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "symplant/link/link_settings.hpp"

namespace symplant::description {

/// An entry of a link's `map`: the symbols it applies to, and the settings for them.
struct MapEntry {
  enum class By : std::uint8_t { area, range, symbol };
  By by = By::symbol;
  std::string text;                     ///< an area; the range's first address; a symbol's name or a pattern
  std::string last = {};                ///< the range's last address
  std::optional<std::uint32_t> number;  ///< of the symbol, the first address of the range or address 0 of the area
  std::optional<link::WordOrder> word_order = {};
  std::optional<link::OnLoss> on_loss = {};
  std::optional<std::string> node = {};  ///< template of node ids
};

/// A link of the plant. It is opened if the command line names no link. Its map and its settings for a loss hold for
/// its controller with every URL.
struct LinkDescription {
  std::string url;
  std::string controller = {};       ///< the controller whose symbols it carries; empty if not named
  link::LinkSettings settings = {};  ///< without map rows, `keep`, clock symbol and word order, which follow
  std::vector<std::string> keep = {};
  std::vector<std::string> exclude = {};  ///< symbols that it does not carry: patterns of names or addresses
  std::string clock_of = {};              ///< the operation that is the PLC's clock; empty: the link has no clock
  std::optional<link::WordOrder> word_order = {};
  std::vector<MapEntry> map = {};
  bool has_settings = false;  ///< it has keys besides URL and controller
};

/// A PLC program that runs in lock step. It is used if the command line names no program.
struct ProgramDescription {
  std::string file;             ///< relative to plant.json
  std::string controller = {};  ///< the controller whose symbols it has; empty if not named
  tables::Time period = 0;      ///< 0: not given
  tables::Time delay = 0;       ///< 0: not given
  link::OnLoss on_loss = link::OnLoss::hold;
  std::vector<std::string> ignore = {};  ///< patterns of names or addresses
};

/// Whether a controller may have this name. It is not empty and fits `--link NAME=URL`: no `=`, `:` or control
/// character, no blank at an end.
bool is_controller_name(std::string_view name);

}  // namespace symplant::description
