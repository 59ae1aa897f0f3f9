// The links of a run: which ones, and opening them.
#pragma once

#include <memory>
#include <ostream>
#include <string>
#include <variant>
#include <vector>

#include "symplant/host/plant_program.hpp"
#include "symplant/host/run_options.hpp"
#include "symplant/link/choice.hpp"
#include "symplant/link/link.hpp"
#include "symplant/plant/plant.hpp"

namespace symplant::host {

/// Whether the links that a plant brings with it are left out: with `--clock virtual`, and where a scenario is played
/// unless `--clock real` is given.
bool keeps_plants_links_closed(const RunOptions& options);

using LinkChoices = std::vector<link::LinkChoice>;

/// Links of a run, and whose symbols each carries: those of the command line, else the plant's own where they are not
/// left out.
std::variant<LinkChoices, link::LinkError> links_of(const PlantProgram& program, const RunOptions& options);

/// Whether one of them is a PLC, whose time is real.
bool has_real_link(const LinkChoices& links);

/// By symbol: operations that a PLC writes through one of them.
std::vector<bool> carried_operations(const LinkChoices& links, const tables::PlantTables& tables);

/// A link of a run.
struct OpenLink {
  std::string controller;  ///< whose symbols it carries, where a plant of several has to say; else empty
  std::uint32_t carries;   ///< the controller's place; link::kAllControllers: of `loop:` alone
  link::LinkSettings settings;
  std::unique_ptr<link::Link> link;

  /// What a loss of it means, and what to look at.
  std::string silence() const;
  /// `PLC1=URL` or `URL`, with the real port.
  std::string text() const { return (controller.empty() ? "" : controller + "=") + link->url(); }
};
using Links = std::vector<OpenLink>;

/// Opens each; 0, or the exit code where one cannot be, which is told on `err`.
int open_links(const LinkChoices& chosen, const tables::PlantTables& tables, const plant::Plant& plant, Links& links,
               std::ostream& err);

}  // namespace symplant::host
