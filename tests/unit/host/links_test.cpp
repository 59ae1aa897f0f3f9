// Chooses the links of a run.
#include "symplant/host/links.hpp"

#include <array>

#include "support/bare_tables.hpp"
#include "support/catch.hpp"

namespace symplant::test {
namespace {

constexpr std::string_view kOne{"PLC1\0", 5};
constexpr std::string_view kTwo{"PLC1\0PLC2\0", 10};

/// A plant of these controllers.
tables::PlantTables tables_of(std::string_view controllers) {
  tables::PlantTables tables = bare_tables("p", 0, 0);
  tables.controller_names = controllers;
  return tables;
}

/// "0=URL 1=URL", or the error's message.
std::string chosen(const host::PlantProgram& program, const host::RunOptions& options) {
  const auto links = host::links_of(program, options);
  if (const auto* error = std::get_if<link::LinkError>(&links)) return error->message;
  std::string text;
  for (const link::LinkChoice& choice : std::get<host::LinkChoices>(links)) {
    text.append(text.empty() ? "" : " ").append(std::to_string(choice.controller) + "=" + choice.url);
  }
  return text;
}

TEST_CASE("Links come from the command line, else from the plant, else from the build default") {
  const tables::PlantTables tables = tables_of(kTwo);
  const std::array<host::DefaultLink, 2> described{{{"PLC2", "loop:"}, {"PLC1", "modbus-tcp-server://127.0.0.1:1"}}};
  host::PlantProgram program{.tables = tables};
  host::RunOptions options;
  CHECK(chosen(program, options).empty());
  program.default_link = "PLC1=modbus-tcp-server://127.0.0.1:2";
  CHECK(chosen(program, options) == "0=modbus-tcp-server://127.0.0.1:2");
  program.links = described;
  CHECK(chosen(program, options) == "1=loop: 0=modbus-tcp-server://127.0.0.1:1");
  options.links = {"PLC2=modbus-tcp-server://127.0.0.1:3"};
  CHECK(chosen(program, options) == "1=modbus-tcp-server://127.0.0.1:3");
}

TEST_CASE("A controller's settings apply to every URL that links it, and --on-loss replaces the policy of the links") {
  const tables::PlantTables tables = tables_of(kTwo);
  std::array<link::LinkSettings, 2> settings{};
  settings[1].resync = 7;
  host::PlantProgram program{.tables = tables, .link_settings = settings};
  host::RunOptions options;
  options.links = {"PLC2=modbus-tcp-server://127.0.0.1:3", "PLC1=loop:"};
  const auto links = [&] { return std::get<host::LinkChoices>(host::links_of(program, options)); };
  CHECK(links().at(0).settings.resync == 7);
  CHECK(links().at(1).settings.resync == tables::kSecond);
  CHECK(links().at(0).settings.on_loss == link::OnLoss::hold);
  options.on_loss = link::OnLoss::zero;
  CHECK(links().at(0).settings.on_loss == link::OnLoss::zero);
  CHECK(links().at(1).settings.on_loss == link::OnLoss::zero);
  program.link_settings = {};
  CHECK(links().at(1).settings.on_loss == link::OnLoss::zero);
}

TEST_CASE("A link with an unknown controller is reported") {
  const tables::PlantTables tables = tables_of(kTwo);
  host::PlantProgram program{.tables = tables};
  host::RunOptions options;
  options.links = {"PLC3=loop:"};
  CHECK(chosen(program, options) == "controller `PLC3` not found; did you mean `PLC1`?");
}

TEST_CASE("Virtual time omits the links of the plant, but not the requested ones") {
  const tables::PlantTables tables = tables_of(kOne);
  host::PlantProgram program{.tables = tables};
  program.default_link = "modbus-tcp-server://127.0.0.1:2";
  host::RunOptions options;
  options.clock = host::RunOptions::Clock::virtual_time;
  CHECK(chosen(program, options).empty());
  options.links = {"modbus-tcp-server://127.0.0.1:3"};
  CHECK(chosen(program, options) == "0=modbus-tcp-server://127.0.0.1:3");
  CHECK(host::has_real_link(std::get<host::LinkChoices>(host::links_of(program, options))));
  options.links = {"loop:"};
  CHECK_FALSE(host::has_real_link(std::get<host::LinkChoices>(host::links_of(program, options))));
}

TEST_CASE("A scenario omits them, too, unless real time is requested") {
  const tables::PlantTables tables = tables_of(kOne);
  host::PlantProgram program{.tables = tables};
  program.default_link = "modbus-tcp-server://127.0.0.1:2";
  host::RunOptions options;
  options.scenario = "cycle.json";
  CHECK(chosen(program, options).empty());
  options.clock = host::RunOptions::Clock::real_time;
  CHECK(chosen(program, options) == "0=modbus-tcp-server://127.0.0.1:2");
}

TEST_CASE("A link carries only the operations of its controller, and the loop carries none") {
  const auto kind =
      tables::symbol_kind(tables::DataType::boolean, tables::Direction::operation, tables::AddressForm::number, false);
  const std::array<tables::SymbolRow, 2> symbols{{{0, tables::kNone, 1, 1, kind}, {1, tables::kNone, 1, 1, kind}}};
  const std::array<tables::SymbolListRow, 2> lists{{{0, 0}, {1, 1}}};
  tables::PlantTables tables = tables_of(kTwo);
  tables.symbols = symbols;
  tables.lists = lists;
  CHECK(host::carried_symbols({{"modbus-tcp-server://127.0.0.1:0", 1}}, tables) == std::vector<bool>{false, true});
  CHECK(host::carried_symbols({{"loop:", link::kAllControllers}}, tables) == std::vector<bool>{false, false});
}

}  // namespace
}  // namespace symplant::test
