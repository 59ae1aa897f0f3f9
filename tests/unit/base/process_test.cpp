// Runs other programs: those that every POSIX system has.
#include "base/process.hpp"

#include "support/catch.hpp"

namespace symplant::test {
namespace {

using base::ProcessCall;
using Kind = base::ProcessError::Kind;

base::Result<std::string, base::ProcessError> run(const ProcessCall& call) {
  base::SystemProcessRunner runner;
  return runner.run(call);
}

TEST_CASE("A program receives its input and returns its output, of any size") {
  const std::string input(3'000'000, 'x');
  const auto output = run({"cat", {}, input});
  REQUIRE(output);
  CHECK(*output == input);
}

TEST_CASE("No shell interprets an argument") {
  const auto output = run({"printf", {"%s", "$(id) `id` ; 'a' \"b\" *"}});
  REQUIRE(output);
  CHECK(*output == "$(id) `id` ; 'a' \"b\" *");
}

TEST_CASE("A program that does not read its input does no harm") {
  const std::string input(3'000'000, 'x');
  const auto output = run({"true", {}, input});
  REQUIRE(output);
  CHECK(output->empty());
}

TEST_CASE("A program that is missing, fails, is too slow or writes too much is reported as such") {
  CHECK(run({"symplant-no-such-program", {}}).error().kind == Kind::absent);
  const auto failed = run({"false", {}});
  CHECK(failed.error().kind == Kind::failed);
  CHECK(failed.error().message == "`false` ended with code 1");
  const auto slow = run({"sleep", {"100"}, {}, std::chrono::milliseconds(50)});
  CHECK(slow.error().kind == Kind::too_slow);
  CHECK(slow.error().message == "`sleep` took more than 50 ms");
  const auto large = run({"yes", {}, {}, std::chrono::milliseconds(10'000), 100'000});
  CHECK(large.error().kind == Kind::too_large);
}

}  // namespace
}  // namespace symplant::test
