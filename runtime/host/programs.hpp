// Selects and opens the PLC programs of a run.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "symplant/host/links.hpp"
#include "symplant/host/plant_program.hpp"
#include "symplant/host/run_options.hpp"
#include "symplant/program/lock_step.hpp"
#include "symplant/trace/plant_names.hpp"

namespace symplant::host {

/// A program of a run.
struct ProgramChoice {
  std::string file;
  program::Options options;
};
using ProgramChoices = std::vector<ProgramChoice>;

/// The programs of a run: those of the command line; else the plant's own, except of controllers that a link of the
/// command line carries. A text is the error.
std::variant<ProgramChoices, std::string> programs_of(const PlantProgram& program, const RunOptions& options);

/// By controller: whether it has a program.
std::vector<bool> controllers_of(const ProgramChoices& programs);

/// An error if a controller has a program and a link; empty otherwise.
std::string link_beside_program(const ProgramChoices& programs, const LinkChoices& links,
                                const tables::PlantTables& tables);

/// A program with its binding.
struct OpenProgram {
  ProgramChoice choice;
  std::unique_ptr<program::Library> loaded;
  program::Binding binding;
  program::Times times;
  std::string digest;  ///< of its file
};
using Programs = std::vector<OpenProgram>;

/// Opens and binds all; 0, or the exit code, with messages on `err`.
int open_programs(const ProgramChoices& choices, const trace::PlantNames& names, Programs& programs, std::ostream& err);

/// Adds to `carried` (by symbol) what the programs write.
void add_written(const Programs& programs, const tables::PlantTables& tables, std::vector<bool>& carried);

/// The programs as messages and traces name them.
std::vector<trace::PlantNames::Program> named_programs(const Programs& programs, const tables::PlantTables& tables);

/// "program `cell` (cell.so): reads 4 and writes 6 symbols, a scan every 10 ms", a line for each.
std::string program_lines(std::span<const OpenProgram> programs, const tables::PlantTables& tables);

/// An option that cannot be used with programs, in words; empty if there is none. `restores`: the scenario begins with
/// a restore.
std::string refused_with_programs(const RunOptions& options, bool restores);

}  // namespace symplant::host
