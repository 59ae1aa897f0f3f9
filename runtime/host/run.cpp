// Runs a plant.
#include "symplant/host/run.hpp"

#include <ostream>

#include "symplant/core/owned_plant.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/host/links.hpp"
#include "symplant/host/outputs.hpp"
#include "symplant/host/run_real.hpp"
#include "symplant/host/run_virtual.hpp"
#include "symplant/host/signals.hpp"
#include "symplant/host/summary.hpp"

namespace symplant::host {

int run(const PlantProgram& program, const RunOptions& options, std::ostream& out, std::ostream& err) {
  const core::PlantTables& tables = program.tables;
  const std::vector<std::string> urls = link_urls(program, options);
  const bool linked = has_real_link(urls);
  if (linked && options.clock == RunOptions::Clock::virtual_time) {
    err << "error: virtual time with a link to a PLC makes no sense, since the PLC's time is real: leave `--clock "
           "virtual` away\n";
    return kBadInput;
  }
  const bool real = linked || options.clock == RunOptions::Clock::real_time;
  catch_signals();

  // The plant stands where it starts before anybody is answered.
  core::OwnedPlant plant(tables, program.behaviours);
  plant.reset(options.seed, real ? options.cycle : 0);
  Outputs outputs(tables, options);
  outputs.attach(plant);
  plant.advance_to(0, outputs.observer());

  Links links;
  const int opened = open_links(urls, tables, plant, links, err);
  if (opened != kGood) return opened;
  if (!outputs.open(plant.model_hash(), err)) return kEnvironment;
  out << summary(tables, plant.model_hash(), program.more);
  if (real) {
    run_real(plant, options, links, outputs, out);
  } else {
    run_virtual(plant, options, outputs, out);
  }
  outputs.finish(err);
  return kGood;
}

}  // namespace symplant::host
