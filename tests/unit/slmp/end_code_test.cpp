// End codes in words, and their table in the manual.
#include "symplant/link/slmp/end_code.hpp"

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "support/catch.hpp"

using namespace symplant::link::slmp;

namespace {

const std::string kPage = SYMPLANT_SOURCE_DIR "/docs/mitsubishi.md";
constexpr const char* kBegin = "<!-- end codes -->\n";
constexpr const char* kEnd = "<!-- /end codes -->";

std::string read_page() {
  std::ostringstream text;
  text << std::ifstream(kPage).rdbuf();
  return text.str();
}

std::string table() {
  std::ostringstream text;
  text << "| code | meaning | what to do |\n|---|---|---|\n";
  for (const EndCode& row : end_codes()) {
    text << "| " << end_code_text(row.code, {}).substr(9, 4) << " | " << row.meaning << " | " << row.action << " |\n";
  }
  return text.str();
}

}  // namespace

TEST_CASE("The manual lists every end code with its meaning") {
  std::string page = read_page();
  const std::size_t begin = page.find(kBegin) + std::string(kBegin).size();
  const std::size_t end = page.find(kEnd);
  REQUIRE(end != std::string::npos);
  REQUIRE(begin <= end);
  if (std::getenv("SYMPLANT_UPDATE_GOLDENS") != nullptr) {
    page.replace(begin, end - begin, table());
    std::ofstream(kPage) << page;
    return;
  }
  CHECK(page.substr(begin, end - begin) == table());
}

TEST_CASE("An end code is a meaning and an action, an unknown one names its origin") {
  CHECK(end_code_text(0x0055, {}) ==
        "end code 0055 (the PLC is in RUN and its port does not permit writing): set `Enable online change` in the "
        "parameters of the port (GX Simulator3: `Enable All (SLMP)`)");
  CHECK(end_code_text(0x4ABC, {}).find("an error that the CPU module reports") != std::string::npos);
  CHECK(end_code_text(0xFFFF, {}).find("an unknown error") != std::string::npos);
  CHECK(end_code_of(0xC056).remedy == Remedy::configure);
  CHECK(end_code_of(0x0055).remedy == Remedy::permit);
  CHECK(end_code_of(0xCEE0).remedy == Remedy::try_again);
}
