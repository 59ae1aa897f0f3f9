// The links of a run: which ones, and opening them.
#pragma once

#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "symplant/core/plant.hpp"
#include "symplant/host/plant_program.hpp"
#include "symplant/host/run_options.hpp"
#include "symplant/link/link.hpp"

namespace symplant::host {

/// Whether the links that a plant brings with it are left out: with `--clock virtual`, and where a scenario is played
/// unless `--clock real` is given.
bool keeps_plants_links_closed(const RunOptions& options);

/// The URLs of a run's links: those of the command line, else the plant's own where they are not left out.
std::vector<std::string> link_urls(const PlantProgram& program, const RunOptions& options);

/// Whether one of them is a PLC, whose time is real.
bool has_real_link(const std::vector<std::string>& urls);

/// By symbol: operations that a PLC writes through one of them.
std::vector<bool> carried_operations(const std::vector<std::string>& urls, const core::PlantTables& tables);

using Links = std::vector<std::unique_ptr<link::Link>>;

/// Opens each; 0, or the exit code where one cannot be, which is told on `err`.
int open_links(const std::vector<std::string>& urls, const core::PlantTables& tables, const core::Plant& plant,
               Links& links, std::ostream& err);

}  // namespace symplant::host
