// Selects and opens the links of a run.
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
#include "symplant/trace/plant_names.hpp"

namespace symplant::host {

/// Whether the plant's own links stay closed: with `--clock virtual`, and with a scenario or a program unless another
/// clock is given.
bool keeps_plants_links_closed(const RunOptions& options, bool with_program);

using LinkChoices = std::vector<link::LinkChoice>;

/// The links of a run and the controllers of their symbols: those of the command line, else the plant's own unless they
/// stay closed. `with_program`: by controller, whether it has a program, so that the plant's own link of it stays
/// closed.
std::variant<LinkChoices, link::LinkError> links_of(const PlantProgram& program, const RunOptions& options,
                                                    const std::vector<bool>& with_program = {});

/// Whether one of them is a link to a PLC, which needs real time.
bool has_real_link(const LinkChoices& links);

/// Whether one of the links goes to a PLC: the PLC is the server, the plant its client.
bool goes_to_plc(const LinkChoices& links);

/// By symbol: whether it is an operation that a PLC writes through one of the links.
std::vector<bool> carried_symbols(const LinkChoices& links, const tables::PlantTables& tables);

/// "carries 2 of 4 I/O symbols: ...", with the first symbol that is left out and why, if a real link leaves out a tenth
/// or more of its controller's symbols; else empty. O(symbols).
std::string left_out_words(const link::LinkChoice& choice, const tables::PlantTables& tables);

/// A link of a run.
struct OpenLink {
  std::string controller;   ///< name of its controller if the plant has several; else empty
  link::LinkChoice choice;  ///< of link::kAllControllers only with `loop:`
  std::unique_ptr<link::Link> link;

  /// Why a loss of it is reported, and what to check.
  std::string silence() const;
  /// Why `no PLC` is reported, and what to check.
  std::string absence() const;
  /// `PLC1=URL` or `URL`, with the real port.
  std::string text() const { return (controller.empty() ? "" : controller + "=") + link->url(); }
};
using Links = std::vector<OpenLink>;

/// The links as messages of the run name them.
std::vector<trace::PlantNames::Link> named_links(const Links& links);

/// Opens each link; 0, or the exit code of the first failure, with a message on `err`.
int open_links(const LinkChoices& chosen, const tables::PlantTables& tables, const plant::Plant& plant, Links& links,
               std::ostream& err);

}  // namespace symplant::host
