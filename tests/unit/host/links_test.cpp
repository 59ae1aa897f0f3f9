// Which links a run has.
#include "symplant/host/links.hpp"

#include <array>

#include "support/bare_tables.hpp"
#include "support/catch.hpp"

namespace symplant::test {
namespace {

using Urls = std::vector<std::string>;

TEST_CASE("links come from the command line, else from the plant, else from what it was built with") {
  const core::PlantTables tables = bare_tables("p", 0, 0);
  const std::array<host::DefaultLink, 2> described{{{"PLC1", "loop:"}, {"PLC2", "modbus-tcp-server://127.0.0.1:1"}}};
  host::PlantProgram program{.tables = tables};
  host::RunOptions options;
  CHECK(host::link_urls(program, options).empty());
  program.default_link = "modbus-tcp-server://127.0.0.1:2";
  CHECK(host::link_urls(program, options) == Urls{"modbus-tcp-server://127.0.0.1:2"});
  program.links = described;
  CHECK(host::link_urls(program, options) == Urls{"loop:", "modbus-tcp-server://127.0.0.1:1"});
  options.links = {"loop:"};
  CHECK(host::link_urls(program, options) == Urls{"loop:"});
}

TEST_CASE("virtual time leaves out the links that the plant brings, and not those that were asked for") {
  const core::PlantTables tables = bare_tables("p", 0, 0);
  host::PlantProgram program{.tables = tables};
  program.default_link = "modbus-tcp-server://127.0.0.1:2";
  host::RunOptions options;
  options.clock = host::RunOptions::Clock::virtual_time;
  CHECK(host::link_urls(program, options).empty());
  options.links = {"modbus-tcp-server://127.0.0.1:3"};
  CHECK(host::has_real_link(host::link_urls(program, options)));
}

}  // namespace
}  // namespace symplant::test
