// Threads that print at the same time print whole lines.
#include "symplant/host/console.hpp"

#include <sstream>
#include <thread>
#include <vector>

#include "support/catch.hpp"

using namespace symplant;

TEST_CASE("host: A message replaces the status line, which is drawn again below it") {
  std::ostringstream all;
  host::Console console(all, all);
  console.draw("7 cycles");
  all.str("");
  console.message("warning: short\n");
  CHECK(all.str() == "\r\x1b[Kwarning: short\n7 cycles\r");
  console.clear();
  all.str("");
  console.line("8 cycles\n");
  CHECK(all.str() == "8 cycles\n");
}

TEST_CASE("host: Threads that print at the same time do not mix their lines") {
  constexpr std::size_t kLines = 500;
  std::ostringstream all;
  host::Console console(all, all);
  const std::string words(100, 'x');
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < 2; ++i) {
      threads.emplace_back([&] {
        for (std::size_t line = 0; line < kLines; ++line) console.message(words + "\n");
      });
      threads.emplace_back([&] {
        for (std::size_t line = 0; line < kLines; ++line) console.line(words + "\n");
      });
    }
  }
  std::istringstream lines(all.str());
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line); ++count) REQUIRE(line == words);
  CHECK(count == 4 * kLines);
}

TEST_CASE("host: While threads run a message does not flush the output it is tied to") {
  std::ostringstream out;
  std::ostringstream err;
  err.tie(&out);
  {
    const host::Untied untied(err);
    CHECK(err.tie() == nullptr);
  }
  CHECK(err.tie() == &out);
}
