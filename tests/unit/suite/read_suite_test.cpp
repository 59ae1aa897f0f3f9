// suite.json and the cases of a folder.
#include "suite/suite.hpp"
#include "support/catch.hpp"
#include "support/strings.hpp"
#include "support/temporary_folder.hpp"

namespace symplant::suite {
namespace {

using test::contains;
using test::TemporaryFolder;

constexpr const char* kScenario = R"({"symplant-scenario":1,"steps":[]})";

TEST_CASE("A case is each scenario in the folder, without other files, folders and `before`") {
  const TemporaryFolder folder;
  folder.write("suite.json", R"({"symplant-suite":1,"plant":"../plant.json","before":"home.json",
    "programs":[{"file":"cell.so"},{"file":"../b.so","controller":"PLC2"}],
    "window":"30ms","align":"follow","tolerance":"2.5%","only":["*_O_*"],"limit":"2min"})");
  for (const char* name : {"b.json", "a.json", "home.json", "parts/c.json"}) folder.write(name, kScenario);
  folder.write("layout.json", R"({"other":1})");
  folder.write("a.reference.jsonl", "");
  const ReadSuite read = read_suite(folder.path());
  REQUIRE(read.suite);
  CHECK(read.suite->cases == std::vector<std::string>{"a", "b"});
  CHECK(read.suite->plant == folder / "../plant.json");
  CHECK(read.suite->programs == std::vector<std::string>{folder / "cell.so", "PLC2=" + (folder / "../b.so")});
  CHECK(read.suite->how.window == 30 * tables::kMillisecond);
  CHECK(read.suite->how.align == compare::Align::follow);
  CHECK(read.suite->how.tolerance == 0.025);
  CHECK(read.suite->limit == 120 * tables::kSecond);
  CHECK(read.suite->reference("a", Speed::normal) == folder / "a.reference.jsonl");
  CHECK(read.suite->reference("a", Speed::slow) == folder / "a.slow.reference.jsonl");
}

TEST_CASE("A file that cannot be read is a case, which fails, and does not disappear") {
  const TemporaryFolder folder;
  folder.write("suite.json", R"({"symplant-suite":1,"plant":"p.csv"})");
  folder.write("a.json", "{");
  const ReadSuite read = read_suite(folder.path());
  REQUIRE(read.suite);
  CHECK(read.suite->cases == std::vector<std::string>{"a"});
  CHECK(read.suite->how.align == compare::Align::none);
  CHECK(read.suite->limit == 600 * tables::kSecond);
}

std::string faults(const std::string& suite) {
  const TemporaryFolder folder;
  folder.write("suite.json", suite);
  folder.write("a.json", kScenario);
  const ReadSuite read = read_suite(folder.path());
  CHECK_FALSE(read.suite);
  std::string text;
  for (const std::string& error : read.errors) text += error + "\n";
  return text;
}

TEST_CASE("What is wrong in suite.json is reported with its place") {
  CHECK(contains(faults("{"), "suite.json:1:"));
  CHECK(contains(faults(R"({"symplant-suite":1})"), "`plant`"));
  CHECK(contains(faults("{\"symplant-suite\":1,\n\"plant\":\"p\",\"windw\":\"1s\"}"), "suite.json:2:13: "));
  CHECK(contains(faults("{\"symplant-suite\":1,\"plant\":\"p\",\n \"window\":\"soon\"}"),
                 "suite.json:2:11: `soon` is not"));
  CHECK(contains(faults(R"({"symplant-suite":1,"plant":"p","tolerance":"5"})"), "`5` is not a share"));
  CHECK(contains(faults(R"({"symplant-suite":2,"plant":"p"})"), "1:"));
}

TEST_CASE("A folder without suite.json or without cases is no suite") {
  const TemporaryFolder folder;
  CHECK(contains(read_suite(folder.path()).errors.at(0), "cannot read `" + (folder / "suite.json")));
  folder.write("suite.json", R"({"symplant-suite":1,"plant":"p.csv"})");
  CHECK(contains(read_suite(folder.path()).errors.at(0), "has no case"));
}

}  // namespace
}  // namespace symplant::suite
