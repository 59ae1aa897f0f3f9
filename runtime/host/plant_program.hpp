// What a plant's main() hands to the host: the same for a generated program and for `symplant run`.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "symplant/engine/behaviour.hpp"
#include "symplant/link/link_settings.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::host {

/// A link that the plant's description brings with it.
struct DefaultLink {
  std::string_view controller;  ///< whose symbols it carries; empty: none is named, as in `--link URL`
  std::string_view url;
};

/// Refers to what it is made of; all of it must outlive the run.
struct PlantProgram {
  const tables::PlantTables& tables;
  std::span<const engine::Behaviour> behaviours = {};  ///< as plant::Plant takes them
  std::span<const DefaultLink> links = {};             ///< of the description, used where no --link is given
  /// By controller, whichever URL links it; empty: all as by default.
  std::span<const link::LinkSettings> link_settings = {};
  std::string_view default_link = {};    ///< as --link takes it, used where neither of them is; empty: none
  std::vector<std::string> more = {};    ///< further lines of what is told at the start
  std::vector<std::string> inputs = {};  ///< files that the plant was read from: no output may replace them
};

}  // namespace symplant::host
