// The formats of symplant map for other tools: what they contain is read back and compared with the map.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app_support.hpp"
#include "map_reading.hpp"

namespace symplant::test {
namespace {

using nlohmann::json;

/// A plant of every kind of number; `more` are members of its link.
MemoryFileSystem numbers(const std::string& more = R"("watchdog": {"register": 90})") {
  MemoryFileSystem files;
  files.files["list.csv"] = list_text({{"L_P_A_O_ON", "", "BOOL", "FALSE", "%QX100.0"},
                                       {"L_P_A_I_ON", "", "BOOL", "FALSE", "%IX100.3"},
                                       {"L_P_A_I_OFF", "", "BOOL", "FALSE", "%IX101.4"},
                                       {"SPEED", "", "INT", "0", "%QW100"},
                                       {"TARGET", "", "DINT", "0", "%QD51"},
                                       {"TOTAL", "", "LINT", "0", "%QL26"},
                                       {"LEVEL", "", "REAL", "0", "%ID50"},
                                       {"COUNT", "", "WORD", "0", "%IW104"},
                                       {"BOUND", "", "USINT", "0", "%IB3"},
                                       {"Füllstand", "", "UINT", "0", "%IW105"},
                                       {"BOUND_", "", "UINT", "0", "%IW106"}});
  files.files["plant.json"] =
      R"({"symplant": 1, "symbols": ["list.csv"], "links": [{"url": "modbus-tcp-server://127.0.0.1:1502", "map": [
        {"symbol": "BOUND", "number": 107}, {"symbol": "COUNT", "word-order": "low-first"}], )" +
      more + "}]}";
  return files;
}

/// BOOL symbols with X and Y addresses, as MELSEC lists have them.
MemoryFileSystem melsec() {
  MemoryFileSystem files;
  files.files["list.csv"] = list_text(
      {{"L_P_A_O_ON", "Y1F"}, {"L_P_A_I_ON", "X3"}, {"L_P_A_I_OFF", "X11"}, {"NUMBER", "", "WORD", "0", "%IW1"}});
  files.files["plant.json"] = R"({"symplant": 1, "symbols": ["list.csv"]})";
  return files;
}

/// A number of two registers at an odd one.
MemoryFileSystem odd() {
  MemoryFileSystem files;
  files.files["list.csv"] = list_text({{"SPEED", "", "DINT", "0", "%QD1"}, {"TARGET", "", "INT", "0", "%QW9"}});
  files.files["plant.json"] = R"({"symplant": 1, "symbols": ["list.csv"], "links": [{"url": "loop:",
    "word-order": "low-first", "map": [{"symbol": "SPEED", "number": 5}]}]})";
  return files;
}

/// Registers that need several requests.
MemoryFileSystem many() {
  MemoryFileSystem files;
  std::vector<Row> rows;
  for (int i = 0; i < 150; ++i) {
    rows.push_back({"LEVEL_" + std::to_string(i), "", "DINT", "0", "%ID" + std::to_string(i)});
    rows.push_back({"SPEED_" + std::to_string(i), "", "INT", "0", "%QW" + std::to_string(i)});
  }
  files.files["list.csv"] = list_text(rows);
  files.files["plant.json"] = R"({"symplant": 1, "symbols": ["list.csv"]})";
  return files;
}

std::vector<MemoryFileSystem> plants() {
  return {
      numbers(), numbers(R"("word-order": "low-first", "status": 20)"), numbers(R"("status": "off")"), melsec(), odd(),
      many()};
}

std::string map_in(const std::string& format, MemoryFileSystem files) {
  const ToolRun run = run_tool({"map", "plant.json", "--format", format}, files);
  INFO(run.err);
  REQUIRE(run.code == 0);
  return run.out;
}

TEST_CASE("map --format csv has the numbers of the JSON form, the status block and the channels") {
  for (const MemoryFileSystem& files : plants()) {
    const json link = json::parse(map_in("json", files)).at("links").at(0);
    std::istringstream lines(map_in("csv", files));
    std::string line;
    Registers found;
    json channels = json::array();
    while (std::getline(lines, line)) {
      const std::vector<std::string> cells = cells_of(line);
      REQUIRE(cells.size() == 19);
      if ((cells[0] == "symbol" || cells[0] == "status" || cells[0] == "watchdog") && !cells[8].empty()) {
        const std::string name = cells[0] == "watchdog" ? "watchdog" : cells[2];
        found[name] = {cells[8], std::stoul(cells[9]), std::stoul(cells[10])};
      }
      if (cells[0] == "channel") {
        channels.push_back({std::stoi(cells[14]), cells[8], std::stoul(cells[9]), std::stoul(cells[10])});
      }
    }
    CHECK(found == registers_of(link));
    json expected = json::array();
    for (const json& channel : link.at("channels")) {
      expected.push_back({channel.at("function"), channel.at("table"), channel.at("start"), channel.at("count")});
    }
    CHECK(channels == expected);
  }
}

TEST_CASE("map: The channels carry each number once, and none is longer than a request may be") {
  for (const MemoryFileSystem& files : plants()) {
    const json link = json::parse(map_in("json", files)).at("links").at(0);
    for (const auto& [name, where] : registers_of(link)) {
      INFO(name);
      int carried = 0;
      for (const json& channel : link.at("channels")) {
        const auto start = channel.at("start").get<std::size_t>();
        const auto end = start + channel.at("count").get<std::size_t>();
        const bool bits = channel.at("function") == 2 || channel.at("function") == 15;
        CHECK(end - start <= (bits ? 1968U : 123U + 2U * (channel.at("function") == 4)));
        if (channel.at("table") == where.table && where.first < end && where.first + where.count > start) {
          CHECK(start <= where.first);
          CHECK(where.first + where.count <= end);
          ++carried;
        }
      }
      CHECK(carried == 1);
    }
  }
}

TEST_CASE("map --format st and codesys: Each variable is at the register that the link serves") {
  for (const char* format : {"st", "codesys"}) {
    for (const MemoryFileSystem& files : plants()) {
      INFO(format);
      const std::string text = map_in(format, files);
      INFO(text);
      const Declarations read = declarations_of(text, std::string(format) == "codesys");
      CHECK(read.located == renamed(registers_of(json::parse(map_in("json", files)).at("links").at(0))));
      CHECK_FALSE(read.overlap);
    }
  }
}

TEST_CASE("map --format st: A list of the declarations has the same map") {
  for (const MemoryFileSystem& files : {numbers(), many()}) {
    MemoryFileSystem again;
    again.files["list.st"] = map_in("st", files);
    const ToolRun run = run_tool({"map", "list.st", "--format", "json"}, again);
    REQUIRE(run.code == 0);
    const Registers back = registers_of(json::parse(run.out).at("links").at(0));
    for (const auto& [name, where] : declarations_of(again.files["list.st"], false).addressed) {
      INFO(name);
      REQUIRE(back.count(name) == 1);
      CHECK(back.at(name) == where);
    }
  }
}

TEST_CASE("map --format openplc: OpenPLC's parser finds blocks that give each variable its register") {
  for (const MemoryFileSystem& files : plants()) {
    const std::string text = map_in("openplc", files);
    INFO(text);
    const json link = json::parse(map_in("json", files)).at("links").at(0);
    const Registers found = openplc_registers(text);
    CHECK(found == renamed(words_of(registers_of(link), link)));
  }
}

TEST_CASE("map --format openplc: No number is in two requests") {
  const MemoryFileSystem files = many();
  const std::vector<Numbers> blocks = openplc_blocks(map_in("openplc", files));
  CHECK(blocks.size() > 4);
  for (const auto& entry : registers_of(json::parse(map_in("json", files)).at("links").at(0))) {
    INFO(entry.first);
    CHECK(std::any_of(blocks.begin(), blocks.end(), [&number = entry.second](const Numbers& block) {
      return block.table == number.table && block.first <= number.first &&
             number.first + number.count <= block.first + block.count;
    }));
  }
}

TEST_CASE("map --format openplc: The symbols keep OpenPLC's addresses of the list") {
  const std::string text = map_in("openplc", numbers());
  CHECK(contains(text, "device0.Discrete_Inputs_Start = \"800\"\n"));
  CHECK(contains(text, "device0.Coils_Start = \"800\"\n"));
  CHECK(contains(text, "#   L_P_A_I_OFF AT %IX101.4 : BOOL; (* discrete input 812 *)\n"));
  CHECK(contains(text, "#   SPEED AT %QW100 : INT; (* holding register 100 *)\n"));
  CHECK(contains(map_in("openplc", melsec()), "#   L_P_A_I_OFF AT %IX102.1 : BOOL; (* discrete input 17 *)\n"));
  CHECK(contains(text, "renamed, row 11 of the list"));
}

/// The message of a map that cannot be written.
std::string refused(const std::string& format, MemoryFileSystem files, const std::string& link = "") {
  std::vector<std::string> words{"map", "plant.json", "--format", format};
  if (!link.empty()) words.insert(words.end(), {"--link", link});
  const ToolRun run = run_tool(words, files);
  CHECK(run.code == 2);
  CHECK(run.out.empty());
  return run.err;
}

TEST_CASE("map: A format that makes no sense for a link is refused") {
  for (const char* format : {"st", "codesys", "openplc"}) {
    INFO(format);
    CHECK(contains(
        refused(format, melsec(), "modbus-tcp://127.0.0.1:502?events=coils:800&event-values=holding-registers:1"),
        "this link goes to the PLC, whose program chooses its addresses: use `csv` or `json`"));
    MemoryFileSystem two = numbers();
    two.files["plant.json"] = R"({"symplant": 1, "symbols": [{"file": "list.csv", "controller": "A"},
      {"file": "list.csv", "controller": "B"}]})";
    two.files["other.csv"] = list_text({{"L_P_B_O_ON", "Y1"}});
    two.files["plant.json"] = R"({"symplant": 1, "symbols": [{"file": "list.csv", "controller": "A"},
      {"file": "other.csv", "controller": "B"}]})";
    CHECK(contains(refused(format, two), "choose one, as in `--link B=modbus-tcp-server://127.0.0.1:1502`"));
    CHECK(run_tool({"map", "plant.json", "--format", format, "--link", "B=modbus-tcp-server://127.0.0.1:1502"}, two)
              .code == 0);
  }
  CHECK(contains(refused("openplc", numbers(), "modbus-tcp-server://plant.local:1502"), "an IPv4 address"));
  CHECK(contains(refused("openplc", numbers(), "modbus-tcp-server://127.0.0.1:0"), "port 0"));
  MemoryFileSystem wide = numbers();
  wide.files["list.csv"] += "VAR_GLOBAL,FAR,,%QX0.0,BOOL,FALSE\n";
  CHECK(contains(refused("openplc", wide),
                 "OpenPLC has 400 coils of slave devices, and this map needs 801, from 0 to 800"));
}

TEST_CASE("map: A link that goes to the PLC is described by its addresses there") {
  MemoryFileSystem files = melsec();
  const std::string url = "modbus-tcp://127.0.0.1:502?events=coils:800&event-values=holding-registers:50";
  const json link =
      json::parse(run_tool({"map", "plant.json", "--format", "json", "--link", url}, files).out).at("links").at(0);
  CHECK(link.at("server") == false);
  CHECK(link.at("symbols").at(1).at("on_link").at("location") == "coil 803");
  CHECK_FALSE(link.contains("channels"));
  CHECK(contains(run_tool({"map", "plant.json", "--format", "csv", "--link", url}, files).out,
                 "L_P_A_I_ON,list.csv,3,X3,,BOOL,,,,,coil 803,"));
}

TEST_CASE("map: The bit of an inverted operation that goes to zero is on") {
  MemoryFileSystem files = melsec();
  files.files["plant.json"] = R"({"symplant": 1, "symbols": ["list.csv"], "inverted": ["L_P_A_O_ON"],
    "links": [{"url": "loop:", "on-loss": "zero"}]})";
  const json symbol = json::parse(map_in("json", files)).at("links").at(0).at("symbols").at(0);
  CHECK(symbol.at("inverted") == true);
  CHECK(symbol.at("on_link").at("on_loss") == "on");
  CHECK(contains(map_in("table", files), "inverted"));
  CHECK(contains(map_in("st", files), "(* coil 31, inverted *)"));
}

}  // namespace
}  // namespace symplant::test
