// Work in several processes.
#include "batch/workers.hpp"

#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <map>
#include <set>

#include "support/catch.hpp"

namespace symplant::batch {
namespace {

const auto kNever = [] { return false; };

std::map<std::size_t, Done> done_of(std::size_t count, std::size_t jobs,
                                    const std::function<std::string(std::size_t)>& work) {
  std::map<std::size_t, Done> all;
  const auto done = [&](const Done& piece) { CHECK(all.emplace(piece.piece, piece).second); };
  CHECK(do_in_processes(count, jobs, work, done, kNever).empty());
  return all;
}

TEST_CASE("Each piece is done once, by as many processes as wanted") {
  const auto all = done_of(200, 3, [](std::size_t piece) {
    return std::to_string(piece) + " " + std::to_string(::getpid()) + " " + std::string(piece * 1000, 'x');
  });
  REQUIRE(all.size() == 200);
  std::set<std::string> processes;
  for (const auto& [piece, done] : all) {
    CHECK(done.answer.starts_with(std::to_string(piece) + " "));
    CHECK(done.answer.size() > piece * 1000);
    const std::size_t begin = done.answer.find(' ') + 1;
    processes.insert(done.answer.substr(begin, done.answer.find(' ', begin) - begin));
  }
  CHECK(processes.size() == 3);
  CHECK_FALSE(processes.contains(std::to_string(::getpid())));
  CHECK(done_of(0, 3, [](std::size_t) { return "x"; }).empty());
}

TEST_CASE("A process that ends costs its piece only, and its last words are reported") {
  const auto all = done_of(20, 2, [](std::size_t piece) -> std::string {
    if (piece == 3) {
      if (::write(STDERR_FILENO, "it was me\n", 10) == 10) ::_exit(3);
    }
    if (piece == 5) ::raise(SIGKILL);
    if (piece == 7) ::_exit(4);
    return "good";
  });
  REQUIRE(all.size() == 20);
  for (const auto& [piece, done] : all) CHECK((done.answer == "good") == (piece != 3 && piece != 5 && piece != 7));
  CHECK(all.at(3).words == "it was me\n");
  CHECK(all.at(5).words == "the process of the case was ended by Killed");
  CHECK(all.at(7).words == "the process of the case ended with exit code 4");
}

TEST_CASE("What a process writes is not taken for the words of a later piece") {
  const auto all = done_of(2, 1, [](std::size_t piece) -> std::string {
    const std::string words(100'000, 'x');  // more than a pipe has room for
    if (piece == 0 && ::write(STDOUT_FILENO, words.data(), words.size()) > 0) return "good";
    ::_exit(4);
  });
  CHECK(all.at(0).answer == "good");
  CHECK(all.at(1).words == "the process of the case ended with exit code 4");
}

TEST_CASE("Work that is stopped ends with its processes") {
  std::size_t ended = 0;
  const auto work = [](std::size_t piece) -> std::string {
    if (piece > 0) ::pause();
    return "good";
  };
  const auto done = [&](const Done&) { ++ended; };
  CHECK(do_in_processes(10, 2, work, done, [&] { return ended > 0; }).empty());
  CHECK(ended == 1);
}

}  // namespace
}  // namespace symplant::batch
