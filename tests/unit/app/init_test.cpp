// Tests of symplant init: a description to start from.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "app_support.hpp"

namespace symplant::test {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

bool is_key(const std::string& line) {
  return line.find("// \"") == line.find_first_not_of(' ') && contains(line, "\": ");
}

std::string uncommented(const std::string& line) {
  std::string text = line;
  return text.erase(text.find("// "), 3);
}

/// All lines unchanged, except those that `wanted` selects, which lose their `//`.
template <class Wanted>
std::string without_comments(const std::vector<std::string>& lines, Wanted&& wanted) {
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    text += (is_key(lines[i]) && wanted(i) ? uncommented(lines[i]) : lines[i]) + "\n";
  }
  return text;
}

nlohmann::json json_of(const std::string& text) { return nlohmann::json::parse(text, nullptr, true, true); }

/// Every kind of device: a robot, cylinders, a lamp, buttons, a sequence, one of six states; numbers, and symbols of no
/// device.
std::string every_shape() {
  std::vector<std::string> names{"L_S1_RBT_O_HOME1", "L_S1_RBT_I_HOME1", "L_S1_RBT_O_WORK2", "L_S1_RBT_I_WORK2",
                                 "L_S1_LMP_O_GREEN", "L_S1_PB_I_ON",     "L_S1_DR_I_OPEN",   "L_S1_DR_I_SHUT",
                                 "L_S1_MC_O_RUN2",   "L_S1_MC_I_RUN2",   "L_S1_MC_I_IDLE1",  "START"};
  for (int i = 1; i <= 20; ++i) {
    const std::string cylinder = "L_S" + std::to_string(i) + "_CYL" + std::to_string(i);
    for (const char* task : {"_O_ADV", "_I_ADV", "_I_RET"}) names.push_back(cylinder + task);
  }
  for (int i = 1; i <= 6; ++i) {
    names.push_back("L_S2_AGV_O_P" + std::to_string(i));
    names.push_back("L_S2_AGV_I_P" + std::to_string(i));
  }
  std::vector<Row> rows = bits(names);
  for (const char* name :
       {"L_S1_TANK1_I_LEVEL", "L_S1_TANK2_I_LEVEL", "L_S1_OVEN_I_TEMP", "L_S1_BELT_I_WEIGHT", "L_S1_RBT_I_PROG",
        "L_S1_LMP_I_GREEN9", "L_S1_SEQ_I_SEQUENCE", "L_S1_SPEED_I_VALUE", "L_S1_PIPE_I_flowRate", "NUMBER"}) {
    rows.push_back({name, "", "INT", "0", fmt::format("%IW{}", rows.size())});
  }
  return list_text(rows);
}

ToolRun begin(MemoryFileSystem& files, const std::string& list, const std::string& output) {
  return run_tool({"init", list, "-o", output}, files);
}

TEST_CASE("init: The skeleton of the paper's cell is as expected") {
  check_golden(std::string(SYMPLANT_SOURCE_DIR) + "/tests/golden/init/excell.json",
               run_lists({"init", "excell.csv"}).out);
}

TEST_CASE("init: The skeleton of every shape of device is as expected") {
  MemoryFileSystem files;
  files.files["every.csv"] = every_shape();
  check_golden(std::string(SYMPLANT_SOURCE_DIR) + "/tests/golden/init/every.json",
               run_tool({"init", "every.csv"}, files).out);
}

TEST_CASE("init: The skeleton is JSON, unchanged and with every key uncommented, alone or together") {
  for (const std::string& list : {excell(), every_shape()}) {
    MemoryFileSystem files;
    files.files["list.csv"] = list;
    const std::vector<std::string> lines = lines_of(run_tool({"init", "list.csv"}, files).out);
    CHECK_NOTHROW(json_of(without_comments(lines, [](std::size_t) { return false; })));
    CHECK_NOTHROW(json_of(without_comments(lines, [](std::size_t) { return true; })));
    std::size_t keys = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (!is_key(lines[i])) continue;
      ++keys;
      INFO(lines[i]);
      CHECK_NOTHROW(json_of(without_comments(lines, [&](std::size_t line) { return line == i; })));
    }
    CHECK(keys >= 5);
  }
}

/// The report of `symplant check` on a description and its list, and the resulting plant.
struct Tried {
  int code;
  std::string out;
  std::string model_hash;
};
Tried tried(const std::string& list, const std::string& description) {
  MemoryFileSystem files;
  files.files["list.csv"] = list;
  files.files["plant.json"] = description;
  const ToolRun check = run_tool({"check", "plant.json"}, files);
  const ToolRun model = run_tool({"model", "plant.json", "--format", "json"}, files);
  return {check.code, check.out, model.code == 0 ? json_of(model.out).at("model_hash").get<std::string>() : ""};
}

TEST_CASE("init: The unchanged skeleton is the plant of the bare list, and each uncommented key is valid") {
  for (const std::string& list : {excell(), every_shape()}) {
    MemoryFileSystem files;
    files.files["list.csv"] = list;
    const std::string text = run_tool({"init", "list.csv"}, files).out;
    const ToolRun bare = run_tool({"model", "list.csv", "--format", "json"}, files);
    const Tried as_is = tried(list, text);
    CHECK(as_is.code == 0);
    CHECK(as_is.model_hash == json_of(bare.out).at("model_hash").get<std::string>());

    const std::vector<std::string> lines = lines_of(text);
    const Tried all = tried(list, without_comments(lines, [](std::size_t) { return true; }));
    INFO(all.out);
    CHECK(all.code == 0);
    CHECK_FALSE(all.model_hash.empty());
    CHECK_FALSE(contains(all.out, "[SP6"));  // faults of the description
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (!is_key(lines[i])) continue;
      const Tried one = tried(list, without_comments(lines, [&](std::size_t line) { return line == i; }));
      INFO(lines[i] << "\n" << one.out);
      CHECK(one.code == 0);
      CHECK_FALSE(one.model_hash.empty());
      CHECK_FALSE(contains(one.out, "[SP6"));
    }
  }
}

TEST_CASE("init: Inputs that look like sensors of parts become a proposed material flow, which is valid") {
  std::vector<Row> rows = bits({"L_S1_BELT_O_RUN", "L_S1_BELT_I_RUN", "L_S1_PE1_I_ON", "L_S1_PE2_I_ON",
                                "L_S2_CLAMP_O_ADV", "L_S2_CLAMP_I_ADV", "L_S2_FIX_I_PART"});
  rows.push_back({"L_S2_PE3_I_ON", "", "BOOL", "FALSE", "%IX1"});  // the belt's device drives this address
  const std::string list = list_text(rows);
  MemoryFileSystem files;
  files.files["list.csv"] = list;
  const std::string text = run_tool({"init", "list.csv"}, files).out;
  CHECK(contains(text, R"(// "material": {"kinds": {"box": {"length": "200 mm"}}, "tracks": {"TRACK_L_S1": )"));
  CHECK(contains(text, R"("forward": "L_S1_BELT.RUN")"));
  CHECK(contains(text, R"({"symbol": "L_S1_PE2_I_ON", "at": "1000 mm"})"));
  CHECK(contains(text, R"("TRACK_L_S2": )"));
  CHECK_FALSE(contains(text, R"("symbol": "L_S2_PE3_I_ON")"));
  CHECK_FALSE(contains(text, R"("L_S1_PE?": {)"));
  CHECK(contains(text, R"(// No operation moves "L_S2_PE3": give `initial`)"));  // not those of the proposal
  const std::vector<std::string> lines = lines_of(text);
  const Tried made = tried(list, without_comments(lines, [](std::size_t) { return true; }));
  INFO(made.out);
  CHECK(made.code == 0);
  CHECK_FALSE(contains(made.out, "[SP6"));
}

TEST_CASE("init: The proposed requirement is for all devices of a pattern, and valid") {
  std::vector<std::string> names;
  for (const std::string clamp : {"L_S1_CLAMP1", "L_S2_CLAMP2", "L_S3_CLAMP3"}) {
    for (const char* task : {"_O_RET", "_I_RET", "_O_ADV", "_I_ADV"}) names.push_back(clamp + task);
  }
  MemoryFileSystem files;
  files.files["list.csv"] = list_text(bits(names));
  const std::vector<std::string> lines = lines_of(run_tool({"init", "list.csv"}, files).out);
  const std::string text = without_comments(lines, [&](std::size_t i) { return contains(lines[i], "requirements"); });
  INFO(text);
  CHECK(contains(text, R"({"name": "{self} answers", "for": ")"));
  CHECK(contains(text, R"("after": "{self}_O_)"));
  const Tried proposed = tried(files.files["list.csv"], text);
  CHECK(proposed.code == 0);
  CHECK_FALSE(contains(proposed.out, "warning"));
  files.files["plant.json"] = text;
  const ToolRun model = run_tool({"model", "plant.json", "--format", "json"}, files);
  CHECK(json_of(model.out).at("requirements").size() == 4);  // three that answer, two devices apart
}

TEST_CASE("init: A plant description is rejected as input") {
  MemoryFileSystem files = lists();
  REQUIRE(begin(files, "excell.csv", "plant.json").code == 0);
  const ToolRun run = begin(files, "plant.json", "other.json");
  CHECK(run.code == 2);
  CHECK(contains(run.err, "is a plant description already"));
}

TEST_CASE("init: On a body-shop line each kind of device is one entry with a natural name") {
  MemoryFileSystem files;
  files.files["list.csv"] = read_bytes(std::string(SYMPLANT_SOURCE_DIR) + "/examples/body-shop/body-shop.csv");
  const std::string text = run_tool({"init", "list.csv"}, files).out;
  CHECK_FALSE(contains(text, "without a common pattern"));
  std::string keys;
  const auto description = json_of(text);
  for (const auto& [key, value] : description.at("devices").items()) keys += key + "\n";
  CHECK(keys ==
        "BODY_*_AIR\nBODY_*_BUTTONHALT\nBODY_*_BUTTONRESET\nBODY_*_BUTTONSTART\nBODY_*_CLAMP?\nBODY_*_CURTAIN\n"
        "BODY_*_DOOR?\nBODY_*_DRESSER?\nBODY_*_ESTOP?\nBODY_*_GRIPPER1\nBODY_*_HORN\nBODY_*_LATCH?\n"
        "BODY_*_LIFTER1\nBODY_*_LIGHTAMBER\nBODY_*_LIGHTGREEN\nBODY_*_LIGHTRED\nBODY_*_PIN?\n"
        "BODY_*_ROBOT?\nBODY_*_SEALER?\nBODY_*_SELECTOR\nBODY_*_WELDER?\nBODY_FRAME*_DRUM1\nBODY_INSP*_CAMERA?\n"
        "BODY_MOVE*_CONVEYOR1\nBODY_MOVE*_DRIVE?\nBODY_MOVE*_SHUTTLE1\nBODY_SEAL*_PUMP1\nBODY_SIDE*_TABLE1\n");
}

TEST_CASE("init: Three thousand devices of few shapes give a short file") {
  std::vector<std::string> names;
  for (int i = 0; i < 1000; ++i) {
    const std::string cylinder = "L" + std::to_string(i % 7) + "_S" + std::to_string(i) + "_CYL";
    for (const char* task : {"_O_ADV", "_I_ADV", "_I_RET"}) names.push_back(cylinder + task);
  }
  for (int i = 0; i < 500; ++i) names.push_back("L1_S" + std::to_string(i) + "_PB_I_ON");
  MemoryFileSystem files;
  files.files["list.csv"] = list_text(bits(names));
  const std::string text = run_tool({"init", "list.csv"}, files).out;
  CHECK(lines_of(text).size() < 40);
  const auto devices = json_of(text).at("devices");
  CHECK(devices.contains("L*_CYL"));
  CHECK(devices.contains("L1_S*_PB"));
}

TEST_CASE("init: The path of the list is relative to the description") {
  MemoryFileSystem files;
  files.files["lists/list.csv"] = excell();
  const auto list_in = [&](const std::string& output) {
    REQUIRE(begin(files, "lists/list.csv", output).code == 0);
    return json_of(files.files[output]).at("symbols").at(0).get<std::string>();
  };
  CHECK(list_in("plant.json") == "lists/list.csv");
  CHECK(list_in("lists/plant.json") == "list.csv");
  CHECK(list_in("plants/a/plant.json") == "../../lists/list.csv");
}

TEST_CASE("init: The options of the list are in the description") {
  MemoryFileSystem files = lists();
  const ToolRun run =
      run_tool({"init", "excell.csv", "--xy", "octal", "--encoding", "utf-8", "--input-format", "gx-iec"}, files);
  CHECK(json_of(run.out).at("symbols").at(0) ==
        nlohmann::json{{"file", "excell.csv"}, {"format", "gx-iec"}, {"encoding", "utf-8"}, {"xy", "octal"}});
}

TEST_CASE("init: The naming rule of the option is in the description") {
  MemoryFileSystem files = lists();
  files.files["rules/own.json"] = R"({"symplant-naming": 1, "rules": [{"pattern": "{device}"}]})";
  CHECK(json_of(run_tool({"init", "excell.csv", "--naming", "@strict"}, files).out).at("naming") == "@strict");
  CHECK(run_tool({"init", "excell.csv", "--naming", "rules/own.json", "-o", "out/plant.json"}, files).code == 0);
  CHECK(json_of(files.files["out/plant.json"]).at("naming") == "../rules/own.json");
  CHECK_FALSE(json_of(run_tool({"init", "excell.csv"}, files).out).contains("naming"));
}

TEST_CASE("init: An existing file is not overwritten without --force") {
  MemoryFileSystem files = lists();
  files.files["plant.json"] = "my work";
  const ToolRun run = begin(files, "excell.csv", "plant.json");
  CHECK(run.code == 2);
  CHECK(contains(run.err, "--force"));
  CHECK(files.files["plant.json"] == "my work");
  CHECK(run_tool({"init", "excell.csv", "-o", "plant.json", "--force"}, files).code == 0);
  CHECK(json_of(files.files["plant.json"]).at("symplant") == 1);
}

TEST_CASE("init: A list with errors gives no description, and its errors are reported") {
  MemoryFileSystem files = lists();
  const ToolRun run = begin(files, "error.csv", "plant.json");
  CHECK(run.code == 2);
  CHECK(contains(run.err, "SP302"));
  CHECK(files.written.empty());
}

}  // namespace
}  // namespace symplant::test
