// The settings of a link, by the names that links know them by.
#pragma once

#include "symplant/core/link_settings.hpp"

namespace symplant::link {

using core::kAbove;
using core::kNowhere;
using core::kTables;
using core::LinkSettings;
using core::OnLoss;
using core::PlaceRow;
using core::PlantOnLoss;
using core::Table;
using core::WordOrder;

}  // namespace symplant::link
