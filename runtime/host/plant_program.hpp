// The plant that a program passes to the host: the same for a generated program and for `symplant run`.
#pragma once

#include <span>
#include <string_view>

#include "symplant/engine/behaviour.hpp"
#include "symplant/link/link_settings.hpp"
#include "symplant/panel/view.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::host {

/// A link of the plant's description.
struct DefaultLink {
  std::string_view controller;  ///< the controller whose symbols it carries; empty: not named, as in `--link URL`
  std::string_view url;
};

/// A PLC program of the plant's description.
struct DefaultProgram {
  std::string_view controller;  ///< whose symbols it has; empty: those of the only one
  std::string_view file;
  tables::Time period = 0;  ///< 0: the program's
  tables::Time delay = 0;   ///< 0: the period
  link::OnLoss on_loss = link::OnLoss::hold;
  std::span<const std::string_view> ignore = {};  ///< patterns of variables that need no symbol
};

/// An entry of `check` / `ignore` of the plant's description: findings of a run that are expected.
struct IgnoredFinding {
  std::string_view finding;  ///< `started on enabling`
  std::string_view of;       ///< a pattern of names; empty: all
  std::string_view until;    ///< the last day, as 2027-06-30; empty: no end
};

/// All references must outlive the run. Every generated program includes this header, so it includes little.
struct PlantProgram {
  const tables::PlantTables& tables;
  std::span<const engine::Behaviour> behaviours = {};  ///< as for plant::Plant
  std::span<const DefaultLink> links = {};             ///< links of the description, used without --link
  std::span<const DefaultProgram> programs = {};       ///< programs of the description, used without --program
  /// By controller, for any URL of its link; empty: defaults for all.
  std::span<const link::LinkSettings> link_settings = {};
  std::string_view default_link = {};  ///< as for --link, used if there are neither --link nor `links`; empty: no link
  std::span<const std::string_view> more = {};  ///< further lines of the summary at the start
  std::span<const IgnoredFinding> ignored = {};
  panel::View view = {};                          ///< where the panel shows the devices
  std::span<const std::string_view> inputs = {};  ///< files that the plant was read from: no output may overwrite them
};

}  // namespace symplant::host
