// Descriptions that include others: what wins, where values are, and faults of each file.
#include "description/include.hpp"

#include <map>
#include <nlohmann/json.hpp>

#include "description/plant_file.hpp"
#include "support/catch.hpp"

namespace symplant::test {
namespace {

using Files = std::map<std::string, std::string>;
using Json = nlohmann::json;

struct Whole {
  description::WholeDescription read;

  const Json& value(const std::string& pointer) const { return read.root->at(Json::json_pointer(pointer)); }
  /// "lib/a.json:/times" for a value of the whole description.
  std::string origin(const std::string& pointer) const {
    const description::Origin origin = read.source->origin(pointer);
    return read.source->files()[origin.file]->path() + ":" + origin.pointer;
  }
  /// "file:pointer: message", one per line.
  std::string faults() const {
    std::string text;
    const auto add = [&](const std::string& line) { text += (text.empty() ? "" : "\n") + line; };
    for (const description::FileFaults& file : read.files) {
      for (const json::Placed& fault : file.syntax) add(file.file->path() + ": " + fault.message);
      for (const auto& fault : file.faults) add(file.file->path() + ":" + fault.pointer + ": " + fault.message);
    }
    return text;
  }
};

description::OpenFile opening(const Files& files, std::vector<std::string>* opened = nullptr) {
  return [&files, opened](const std::string& path) {
    if (opened != nullptr) opened->push_back(path);
    const auto found = files.find(path);
    if (found == files.end()) return description::OpenedFile{nullptr, "cannot read `" + path + "`"};
    return description::OpenedFile{std::make_shared<text::SourceFile>(path, found->second), {}};
  };
}

Whole whole(const Files& files, std::vector<std::string>* opened = nullptr) {
  const std::string first = files.count("plant.json") != 0 ? "plant.json" : "line/plant.json";
  return {description::read_whole(std::make_shared<text::SourceFile>(first, files.at(first)), opening(files, opened))};
}

/// The text of a file with these members.
std::string described(const std::string& members) {
  return R"({"symplant": 1)" + (members.empty() ? "" : ", " + members) + "}";
}

TEST_CASE("The including file wins, then the last included one, key by key at every depth") {
  const Whole all =
      whole({{"plant.json", described(R"("include": ["a.json", "b.json"], "symbols": ["s.csv"],
                                              "times": {"D": {"A->B": {"takes": "1s"}}})")},
             {"a.json", described(R"("name": "a", "symbols": ["a.csv"], "defaults": {"travel": "1s", "dwell": "1s"},
                               "times": {"D": {"A->B": {"takes": "2s", "after": "2s"}, "B->A": {"takes": "2s"}}, "E": {}})")},
             {"b.json", described(R"("defaults": {"travel": "3s"},
                               "times": {"D": {"A->B": {"takes": "3s"}, "B->A": {"takes": "3s"}}})")}});
  CHECK(all.faults() == "");
  CHECK(all.value("/times/D/A->B/takes") == "1s");
  CHECK(all.value("/times/D/A->B/after") == "2s");
  CHECK(all.value("/times/D/B->A/takes") == "3s");
  CHECK(all.value("/times/E") == Json::object());
  CHECK(all.value("/symbols") == Json{"s.csv"});
  CHECK(all.value("/name") == "a");
  CHECK(all.value("/defaults") == Json{{"travel", "3s"}, {"dwell", "1s"}});
  CHECK(all.origin("/times") == "plant.json:/times");
  CHECK(all.origin("/times/D/A->B/takes") == "plant.json:/times/D/A->B/takes");
  CHECK(all.origin("/times/D/A->B/after") == "a.json:/times/D/A->B/after");
  CHECK(all.origin("/times/D/B->A/takes") == "b.json:/times/D/B->A/takes");
  CHECK(all.origin("/times/E") == "a.json:/times/E");
  CHECK(all.origin("/defaults/travel") == "b.json:/defaults/travel");
  CHECK(all.origin("/defaults/dwell") == "a.json:/defaults/dwell");
}

TEST_CASE("A value that has several forms is taken as a whole, as is an array without names") {
  const Whole all = whole(
      {{"plant.json",
        described(
            R"("include": ["a.json"], "symbols": ["s.csv"], "follow": {"X": {"on": "A", "off": "B"}}, "inverted": ["P"],
            "times": {"D": {"A->B": {"takes": {"min": "1s", "max": "2s"}}}}, "devices": {"D": {"states": ["S"]}})")},
       {"a.json",
        described(R"("follow": {"X": "C"}, "inverted": ["Q", "R"], "devices": {"D": {"states": ["T"], "initial": "T"}},
            "times": {"D": {"A->B": {"takes": {"mean": "1s", "sigma": "1ms"}}}})")}});
  CHECK(all.value("/times/D/A->B/takes") == Json{{"min", "1s"}, {"max", "2s"}});
  CHECK(all.value("/follow/X") == Json{{"on", "A"}, {"off", "B"}});
  CHECK(all.value("/inverted") == Json{"P"});
  CHECK(all.value("/devices/D") == Json{{"states", {"S"}}, {"initial", "T"}});
}

TEST_CASE("Requirements and malfunctions are merged by name, links and programs by controller") {
  const Whole all = whole(
      {{"plant.json",
        described(R"("include": ["a.json"], "symbols": ["s.csv"], "requirements": [{"name": "r", "never": "A"}],
            "links": [{"url": "loop:", "controller": "P1"}], "malfunctions": [{"name": "m", "of": "X"}])")},
       {"a.json",
        described(
            R"("requirements": [{"name": "q", "never": "Q"}, {"name": "r", "after": "A", "expect": "B", "within": "1s"}],
            "links": [{"url": "loop:"}, {"url": "other:", "controller": "p1", "exclude": ["E"]}],
            "malfunctions": [{"name": "M", "of": "Y"}, {"name": "n"}], "programs": [{"file": "a.so"}])")}});
  CHECK(all.faults() == "");
  CHECK(all.value("/requirements") == Json{{{"name", "r"}, {"never", "A"}}, {{"name", "q"}, {"never", "Q"}}});
  CHECK(all.value("/links") == Json{{{"url", "loop:"}, {"controller", "P1"}, {"exclude", {"E"}}}, {{"url", "loop:"}}});
  CHECK(all.value("/malfunctions").size() == 2);
  CHECK(all.origin("/requirements/0/never") == "plant.json:/requirements/0/never");
  CHECK(all.origin("/requirements/1/never") == "a.json:/requirements/0/never");
  CHECK(all.origin("/links/0/url") == "plant.json:/links/0/url");
  CHECK(all.origin("/links/0/exclude/0") == "a.json:/links/1/exclude/0");
  CHECK(all.origin("/links/1") == "a.json:/links/0");
  CHECK(all.origin("/programs/0/file") == "a.json:/programs/0/file");
}

TEST_CASE("Paths are relative to the including file, and each file is read once") {
  std::vector<std::string> opened;
  const Whole all = whole(
      {{"line/plant.json", described(R"("include": ["../lib/a.json", "b.json"])")},
       {"lib/a.json", described(R"("include": ["c.json"], "plain": ["A"])")},
       {"line/b.json", described(R"("include": ["../lib/c.json"])")},
       {"lib/c.json", described(R"("plain": ["C"], "io": {"events": ["~1/x"]}, "view": {"a/b": {"group": "g"}})")}},
      &opened);
  CHECK(all.faults() == "");
  CHECK(opened == std::vector<std::string>{"lib/a.json", "lib/c.json", "line/b.json"});
  CHECK(all.value("/plain") == Json{"C"});  // the last included file includes it
  CHECK(all.origin("/view/a~1b/group") == "lib/c.json:/view/a~1b/group");
  CHECK(all.read.source->folder("/view") == "lib");
  CHECK(all.read.source->paths() ==
        std::vector<std::string>{"line/plant.json", "lib/a.json", "lib/c.json", "line/b.json"});
}

TEST_CASE("Faults name the file that has them") {
  const Whole all = whole(
      {{"plant.json", described(R"("include": ["a.json", "none.json", "./a.json", "bad.json", "scenario.json"])")},
       {"a.json", described(R"("tims": {}, "include": ["b.json"])")},
       {"b.json", described(R"("include": ["plant.json", "a.json", "b.json"])")},
       {"bad.json", "{"},
       {"scenario.json", R"({"symplant-scenario": 1})"}});
  CHECK_FALSE(all.read.complete);
  CHECK(all.faults() ==
        "plant.json:/include/1: cannot read `none.json`\n"
        "plant.json:/include/2: `./a.json` is included twice; remove one of the two\n"
        "a.json:/tims: the key `tims` is unknown here; did you mean `times`?\n"
        "b.json:/include/0: `plant.json` includes itself; remove one of the includes\n"
        "b.json:/include/1: `a.json` includes itself; remove one of the includes\n"
        "b.json:/include/2: `b.json` includes itself; remove one of the includes\n"
        "bad.json: this is not valid JSON: unexpected end of input; expected string literal\n"
        "scenario.json:/symplant-scenario: this is a scenario; give it to `symplant run PLANT --scenario`");
}

TEST_CASE("A chain of includes has a limit") {
  Files files{{"plant.json", described(R"("include": ["0.json"])")}};
  for (int i = 0; i < 40; ++i) {
    files[std::to_string(i) + ".json"] = described("\"include\": [\"" + std::to_string(i + 1) + ".json\"]");
  }
  CHECK(whole(files).faults() == "31.json:/include/0: more than 32 files include each other in a chain; remove some");
}

TEST_CASE("Symbol lists may be in an included file, but must be somewhere") {
  const auto read = [](const Files& files) {
    return description::read_plant_file(std::make_shared<text::SourceFile>("plant.json", files.at("plant.json")), "s",
                                        opening(files));
  };
  const auto found = read({{"plant.json", described(R"("include": ["lib/a.json"])")},
                           {"lib/a.json", described(R"("symbols": ["s.csv"], "programs": [{"file": "p.so"}])")}});
  REQUIRE(found.sound());
  CHECK(found.file->symbols.at(0).file == "s.csv");
  CHECK(found.source->folder("/symbols/0") == "lib");
  CHECK(found.file->description.programs.at(0).file == "lib/p.so");  // relative to plant.json
  const auto missing = read({{"plant.json", described(R"("include": ["a.json"])")}, {"a.json", described("")}});
  REQUIRE(missing.faults.size() == 1);
  CHECK(missing.faults[0].message == "the key `symbols` is missing here; it holds an array of symbol lists");
  // An included file that cannot be read may have them.
  CHECK(read({{"plant.json", described(R"("include": ["a.json"])")}}).faults.size() == 1);
}

TEST_CASE("Values and material keep the order of the files, then the order in each") {
  const Files files{
      {"plant.json",
       described(R"("include": ["a.json"], "symbols": ["s"], "values": {"z": {"start": 1}, "y": {"start": 1}})")},
      {"a.json", described(R"("values": {"x": {"start": 1}, "b": {"start": 1}, "y": {"unit": "l"}},
                                       "material": {"places": {"q": {}, "p": {}}})")}};
  const auto read = description::read_plant_file(
      std::make_shared<text::SourceFile>("plant.json", files.at("plant.json")), "s", opening(files));
  REQUIRE(read.sound());
  std::string names;
  for (const auto& value : read.file->description.values) names += value.name;
  for (const auto& place : read.file->description.material.places) names += place.name;
  CHECK(names == "zyxbqp");
}

}  // namespace
}  // namespace symplant::test
