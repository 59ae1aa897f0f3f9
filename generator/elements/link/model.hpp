// The settings of a controller's link, resolved.
#pragma once

#include <string_view>
#include <vector>

#include "symplant/link/link_settings.hpp"

namespace symplant::model {

/// The settings of a controller's link, with the memory that they point to.
struct ControllerLink {
  link::LinkSettings link;             ///< without spans
  std::vector<link::MapRow> rows;      ///< their texts are in the description
  std::vector<std::string_view> keep;  ///< into the description

  /// Refers to this object: valid until it is moved or destroyed.
  link::LinkSettings settings() const {
    link::LinkSettings settings = link;
    settings.rows = rows;
    settings.keep = keep;
    return settings;
  }
};

}  // namespace symplant::model
