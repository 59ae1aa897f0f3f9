// symplant program: shows how the variables of PLC programs bind to the symbols of a plant.
#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <array>
#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "app/commands.hpp"
#include "app/described_programs.hpp"
#include "app/options.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/host/programs.hpp"
#include "symplant/host/words.hpp"

namespace symplant::app {
namespace {

struct ProgramOptions {
  std::string plant;
  PlantOptions plant_options;
  std::vector<std::string> programs;
};

constexpr std::size_t kColumns = 6;
using Row = std::array<std::string, kColumns>;

/// Columns two blanks apart; the last one is not filled.
std::string aligned(const std::vector<Row>& rows) {
  std::array<std::size_t, kColumns> widths{};
  for (const Row& row : rows) {
    for (std::size_t c = 0; c < kColumns; ++c) widths[c] = std::max(widths[c], row[c].size());
  }
  std::string text;
  for (const Row& row : rows) {
    for (std::size_t c = 0; c + 1 < kColumns; ++c) text += fmt::format("{:<{}}  ", row[c], widths[c]);
    text += row.back() + "\n";
  }
  return text;
}

std::string table_of(const host::OpenProgram& open, const trace::PlantNames& names) {
  const symplant_program& program = open.loaded->program();
  std::vector<Row> rows{{"variable", "does", "bits", "symbol", "address", "row"}};
  for (std::uint32_t i = 0; i < program.count; ++i) {
    const symplant_variable& variable = program.variables[i];
    const std::uint32_t symbol = open.binding.symbols[i];
    const bool bound = symbol != tables::kNone;
    rows.push_back({host::shown(variable.symbol != nullptr    ? variable.symbol
                                : variable.address != nullptr ? variable.address
                                                              : "-"),
                    variable.writes != 0 ? "writes" : "reads", std::to_string(variable.bits),
                    bound ? host::shown(names.symbol(symbol)) : "-", bound ? host::shown(names.address(symbol)) : "-",
                    bound ? host::shown(names.cite(symbol)) : "-"});
  }
  return aligned(rows);
}

void check_programs(const ProgramOptions& options, Context& context) {
  auto made = compile_for(context, options.plant, options.plant_options);
  if (!made) return;
  const auto compiled = std::make_shared<const Compiled>(std::move(*made));
  context.kept = compiled;
  const tables::PlantTables tables = compiled->tables.tables();
  const trace::PlantNames names(tables);
  const DescribedPrograms described(*compiled->plant.description, options.plant);
  host::RunOptions run;
  run.programs = options.programs;
  const auto chosen = host::programs_of({.tables = tables, .programs = described.rows()}, run);
  if (const auto* const error = std::get_if<std::string>(&chosen)) {
    context.err << "error: " << *error << "\n";
    context.exit_code = host::kBadInput;
    return;
  }
  const auto& choices = std::get<host::ProgramChoices>(chosen);
  if (choices.empty()) {
    context.err << "error: the plant has no program: give `--check FILE`\n";
    context.exit_code = host::kBadInput;
    return;
  }
  host::Programs programs;
  const int code = host::open_programs(choices, names, programs, context.err);
  for (const host::OpenProgram& open : programs) {
    context.out << host::program_lines({&open, 1}, tables) << table_of(open, names);
  }
  const bool all_open = programs.size() == choices.size();
  context.exit_code = code == host::kBadInput && all_open ? host::kFindings : code;
}

}  // namespace

void add_program(CLI::App& app, Context& context) {
  auto options = std::make_shared<ProgramOptions>();
  CLI::App* command =
      app.add_subcommand("program", "Show how the variables of a PLC program bind to the symbols of the plant");
  command->add_option("PLANT", options->plant, "a plant.json or a symbol list")->required();
  command
      ->add_option("--check", options->programs,
                   "the program: a shared library with the interface symplant/program.h (default: the plant's own "
                   "programs); loading it runs its start code")
      ->type_name("[CONTROLLER=]FILE")
      ->allow_extra_args(false);
  add_plant_options(*command, options->plant_options);
  command->footer(
      "Exit codes: 0 all variables bind; 1 some do not; 2 bad input.\nExamples:\n"
      "  symplant program --check cell.so symbols.csv\n"
      "  symplant program --check PLC1=press.so --check PLC2=robot.so plant.json");
  command->callback([options, &context] { check_programs(*options, context); });
}

}  // namespace symplant::app
