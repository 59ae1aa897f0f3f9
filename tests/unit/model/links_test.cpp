// `links` of plant.json: every key, every fault, and which entry speaks of which symbol.
#include <map>

#include "description/plant_file.hpp"
#include "support/catch.hpp"
#include "support/compile.hpp"
#include "support/memory_file_system.hpp"

namespace symplant::test {
namespace {

using link::LinkSettings;
using link::OnLoss;
using link::WordOrder;

const std::string kList =
    "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial\n"
    "VAR_GLOBAL,L_P_D_I_A,,%IX2.0,BOOL,FALSE\n"
    "VAR_GLOBAL,L_P_D_O_A,,%QX0,BOOL,FALSE\n"
    "VAR_GLOBAL,SPEED,,%QD5,DINT,0\n"
    "VAR_GLOBAL,MODE,,%QW30,INT,0\n"
    "VAR_GLOBAL,LEVEL,,%IW7,WORD,0\n"
    "VAR_GLOBAL,LEVEL2,,%IW7,WORD,0\n"
    "VAR_GLOBAL,X_Y_Z_O_NOWHERE,,,BOOL,FALSE\n";

/// A plant of the list with one link of these members.
Analysed linked(const std::string& members, const std::string& list = kList) {
  MemoryFileSystem files;
  files.files["l.csv"] = list;
  files.files["plant.json"] = R"({"symplant": 1, "symbols": ["l.csv"], "links": [{"url": "loop:", )" + members + "}]}";
  std::ostringstream err;
  app::Progress progress(err, false);
  Analysed result;
  result.plant = app::analyse({"plant.json", {}, {}, "2026-07-01"}, files, progress, result.diagnostics);
  return result;
}

/// What is said of the description, a line each.
std::string reported(const Analysed& analysed) {
  std::string text;
  for (const diag::Diagnostic& finding : analysed.diagnostics.all()) {
    if (finding.rule->id.substr(0, 3) != "SP6" && finding.rule->slug != "places-overlap") continue;
    text += (text.empty() ? "" : "\n") + finding.message;
  }
  return text;
}
std::string reported(const std::string& members) { return reported(linked(members)); }

LinkSettings settings(const std::string& members) {
  const Analysed analysed = linked(members);
  CHECK(reported(analysed).empty());
  return analysed.model().links.at(0).link;
}

/// Numbers that entries of a map give, by symbol.
std::map<std::string, std::uint32_t> numbers(const std::string& map) {
  const Analysed analysed = linked("\"map\": [" + map + "]");
  CHECK(reported(analysed).empty());
  std::map<std::string, std::uint32_t> result;
  for (const link::MapRow& row : analysed.model().links.at(0).rows) {
    if (row.number != link::MapRow::kDefault) result.emplace(analysed.model().symbols[row.symbol].name(), row.number);
  }
  return result;
}
using Numbers = std::map<std::string, std::uint32_t>;

TEST_CASE("a link that says nothing has the settings by default") {
  const LinkSettings none;
  const LinkSettings read = settings(R"("word-order": "high-first")");
  CHECK(read.word_order == none.word_order);
  CHECK(read.on_loss == OnLoss::hold);
  CHECK(read.plant_on_loss == link::PlantOnLoss::run);
  CHECK(read.loss_after == tables::kSecond);
  CHECK(read.resync == tables::kSecond);
  CHECK(read.status_block == link::kAbove);
  CHECK(read.watchdog == link::kNowhere);
  CHECK(read.sizes == none.sizes);
  CHECK(read.connections == 32);
  CHECK(read.idle == 300 * tables::kSecond);
}

TEST_CASE("every key of a link arrives in its settings") {
  const LinkSettings read = settings(R"("word-order": "low-first", "on-loss": "zero", "plant-on-loss": "freeze",
    "loss-after": "250ms", "resync": "0s", "status": 70, "watchdog": {"register": 9, "within": "2s"},
    "size": {"coils": 8, "discrete-inputs": 17, "holding-registers": 40, "input-registers": 100},
    "connections": 3, "idle": "1min", "keep": ["127.0.0.1"])");
  CHECK(read.word_order == WordOrder::low_first);
  CHECK(read.on_loss == OnLoss::zero);
  CHECK(read.plant_on_loss == link::PlantOnLoss::freeze);
  CHECK(read.loss_after == 250 * tables::kMillisecond);
  CHECK(read.resync == 0);
  CHECK(read.status_block == 70);
  CHECK(read.watchdog == 9);
  CHECK(read.watchdog_within == 2 * tables::kSecond);
  CHECK(read.sizes == std::array<std::uint32_t, 4>{8, 17, 40, 100});
  CHECK(read.connections == 3);
  CHECK(read.idle == 60 * tables::kSecond);
  CHECK(settings(R"("status": "off")").status_block == link::kNowhere);
  CHECK(settings(R"("status": "above")").status_block == link::kAbove);
  const Analysed kept = linked(R"("keep": ["127.0.0.1", "::1"])");
  CHECK(kept.model().links.at(0).settings().keep.size() == 2);
  CHECK(kept.model().links.at(0).settings().keep[1] == "::1");
  // However they are written, they are compared as the system tells them.
  const Analysed forms = linked(R"("keep": ["0:0:0:0:0:0:0:1", "::ffff:10.0.0.7", "FD00::00A1"])");
  CHECK(reported(forms).empty());
  const auto keep = forms.model().links.at(0).settings().keep;
  CHECK(std::vector<std::string>(keep.begin(), keep.end()) == std::vector<std::string>{"::1", "10.0.0.7", "fd00::a1"});
}

TEST_CASE("a client to be kept is one numeric address") {
  for (const std::string text : {"127.0.0.01", "foo", "10.0.0.0/24", "1.2.3", "::g"}) {
    CHECK(reported("\"keep\": [\"::1\", \"" + text + "\"]")
              .starts_with("`" + text + "` is no numeric address of one host"));
  }
}

TEST_CASE("the low word comes first where a list has a MELSEC address, else the high one, unless the link says") {
  const std::string melsec = kList + "VAR_GLOBAL,L_P_E_I_A,X10,,BOOL,FALSE\n";
  CHECK(linked(R"("resync": "1s")", melsec).model().links.at(0).link.word_order == WordOrder::low_first);
  CHECK(linked(R"("resync": "1s")").model().links.at(0).link.word_order == WordOrder::high_first);
  CHECK(linked(R"("word-order": "high-first")", melsec).model().links.at(0).link.word_order == WordOrder::high_first);
}

TEST_CASE("an area moves all symbols whose addresses are of it, by their own number in registers") {
  CHECK(numbers(R"({"area": "%IX", "number": 100})") == Numbers{{"L_P_D_I_A", 116}});
  CHECK(numbers(R"({"area": "X", "number": 1})") == Numbers{{"L_P_D_I_A", 17}});
  CHECK(numbers(R"({"area": "%QD", "number": 5})") == Numbers{{"SPEED", 15}});
  CHECK(numbers(R"({"area": "%iw", "number": 0})") == Numbers{{"LEVEL", 7}, {"LEVEL2", 7}});
}

TEST_CASE("a range moves the symbols from its first address to its last, so that the first stands on the number") {
  CHECK(numbers(R"({"range": ["%IX2.0", "%IX2.7"], "number": 0})") == Numbers{{"L_P_D_I_A", 0}});
  CHECK(numbers(R"({"range": ["%QD3", "%QD5"], "number": 100})") == Numbers{{"SPEED", 104}});
  CHECK(numbers(R"({"range": ["%QW30", "%QW30"], "number": 1})") == Numbers{{"MODE", 1}});
}

TEST_CASE(
    "a symbol stands on the number that is given to it, also one without an address, and so do others of its address") {
  CHECK(numbers(R"({"symbol": "speed", "number": 100}, {"symbol": "X_Y_Z_O_NOWHERE", "number": 3})") ==
        Numbers{{"SPEED", 100}, {"X_Y_Z_O_NOWHERE", 3}});
  CHECK(numbers(R"({"symbol": "LEVEL2", "number": 20})") == Numbers{{"LEVEL", 20}, {"LEVEL2", 20}});
}

TEST_CASE("a symbol's own entry comes before a range's, that before an area's, key by key and in whatever order") {
  CHECK(
      numbers(
          R"({"symbol": "MODE", "number": 1}, {"range": ["%QW0", "%QW99"], "number": 2}, {"area": "%QW", "number": 3})") ==
      Numbers{{"MODE", 1}});
  CHECK(
      numbers(
          R"({"area": "%QW", "number": 3}, {"range": ["%QW30", "%QW99"], "number": 2}, {"symbol": "MODE", "on-loss": "zero"})") ==
      Numbers{{"MODE", 2}});
}

TEST_CASE("word order and on-loss of patterns: the one with more letters wins") {
  const Analysed analysed = linked(R"("map": [{"symbol": "*", "on-loss": "zero", "word-order": "low-first"},
                                              {"symbol": "SP*", "on-loss": "hold"}])");
  CHECK(reported(analysed).empty());
  for (const link::MapRow& row : analysed.model().links.at(0).rows) {
    const bool speed = analysed.model().symbols[row.symbol].name() == "SPEED";
    CHECK(row.on_loss == (speed ? OnLoss::hold : OnLoss::zero));
    CHECK(row.word_order == WordOrder::low_first);
    CHECK(row.number == link::MapRow::kDefault);
  }
  CHECK(analysed.model().links.at(0).rows.size() == analysed.model().symbols.size());
}

TEST_CASE("what an entry names and is not there is told with the nearest") {
  CHECK(reported(R"("map": [{"symbol": "SPED", "number": 1}])") == "there is no symbol `SPED`, the nearest is `SPEED`");
  CHECK(reported(R"("map": [{"area": "%MW", "number": 1}])")
            .starts_with("`%MW` is no area of inputs or outputs, write X, "));
  CHECK(reported(R"("map": [{"area": "%QX1", "number": 1}])").starts_with("`%QX1` is no area of inputs or outputs"));
  CHECK(reported(R"("map": [{"area": "%IL", "number": 1}])") ==
        "no symbol of this controller stands in the area `%IL`");
  CHECK(reported(R"("map": [{"range": ["%QW1", "%QW2"], "number": 1}])") ==
        "no symbol of this controller stands between `%QW1` and `%QW2`");
  CHECK(reported(R"("map": [{"symbol": "Q*", "on-loss": "zero"}])") ==
        "no symbol of this controller is matched by `Q*`");
}

TEST_CASE("a row that is no input or output is told as what it is") {
  const std::string list = kList + "VAR_GLOBAL,STEP,M100,,BOOL,FALSE\n";
  CHECK(
      reported(linked(R"("map": [{"symbol": "Step", "number": 1}])", list)) ==
      "`Step` is in the list, but no input or output of this controller, its address is `M100`: leave this entry away");
}

TEST_CASE("a setting without effect on any symbol of its entry is told") {
  CHECK(reported(R"("map": [{"symbol": "LEVEL", "on-loss": "zero"}])") ==
        "this says what operations do without their PLC, and no operation is matched by `LEVEL`");
  CHECK(reported(R"("map": [{"symbol": "MODE", "word-order": "low-first"}])") ==
        "this is the order of several registers, and no number of 32 or 64 bits is matched by `MODE`");
  CHECK(reported(R"("map": [{"symbol": "*", "word-order": "low-first", "on-loss": "zero"}])").empty());
}

TEST_CASE("entries that cannot be are told") {
  CHECK(reported(R"("map": [{"symbol": "S*", "number": 1}])") ==
        "`S*` is a pattern, and its symbols cannot all stand on one `number`: name each");
  CHECK(reported(R"("map": [{"range": ["%QW9", "%QW2"], "number": 1}])") ==
        "`%QW9` and `%QW2` are not the first and the last address of one area, write them in their order");
  CHECK(reported(R"("map": [{"range": ["%QW2", "%QD9"], "number": 1}])")
            .starts_with("`%QW2` and `%QD9` are not the first"));
  CHECK(reported(R"("map": [{"range": ["%MW2", "%IX1.2.3"], "number": 1}])") ==
        "`%MW2` is no address of an input or output that has a number, write one such as `X10` or `%IX100.0`\n"
        "`%IX1.2.3` is no address of an input or output that has a number, write one such as `X10` or `%IX100.0`");
  CHECK(reported(R"("map": [{"area": "%QW", "number": 1}, {"area": "%QW", "number": 2}])") ==
        "two entries that are equally specific give `MODE` different values of `number`: leave one away, or name the "
        "symbol");
  CHECK(reported(R"("map": [{"symbol": "MODE", "number": 1}, {"symbol": "mode", "number": 2}])") ==
        "two entries that are equally specific give `MODE` different values of `number`: leave one away");
  CHECK(reported(R"("map": [{"area": "%QW", "number": 1}, {"area": "%QW", "number": 1}])").empty());
  CHECK(reported(
            R"("map": [{"area": "%QW", "number": 1}, {"area": "%QW", "number": 2}, {"symbol": "MODE", "number": 3}])")
            .empty());
  CHECK(reported(R"("map": [{"symbol": "LEVEL", "number": 1}, {"symbol": "LEVEL2", "number": 2}])") ==
        "`LEVEL2` stands on the same address as `LEVEL`, which has another `number`: give both the same");
  CHECK(reported(R"("map": [{"number": 1, "on-loss": "zero"}])") ==
        "this entry does not say whose symbols it means: give it an `area`, a `range` or a `symbol`");
  CHECK(reported(R"("map": [{"number": 1, "area": "X", "symbol": "MODE"}])") ==
        "this entry has several of `area`, `range` and `symbol`: make an entry of each");
}

TEST_CASE("an entry that says nothing of its symbols is told") {
  CHECK(reported(R"("map": [{"area": "X", "symbol": "MODE"}])") != "");
  CHECK(reported(R"("map": [{"symbol": "MODE"}])") ==
        "this entry says nothing of its symbols: give it a `number`, a `word-order` or `on-loss`");
  CHECK(reported(R"("map": [{}])") ==
        "this entry does not say whose symbols it means: give it an `area`, a `range` or a `symbol`");
}

TEST_CASE("values that do not fit are told in the schema's words") {
  CHECK(reported(R"("status": "on")") != "");
  CHECK(reported(R"("status": 65536)") != "");
  CHECK(reported(R"("word-order": "big")") == "the text `big` stands here, wanted is one of `low-first`, `high-first`");
  CHECK(reported(R"("on-loss": "zeros")") ==
        "the text `zeros` stands here, wanted is one of `hold`, `zero`; the nearest is `zero`");
  CHECK(reported(R"("size": {"coil": 5})") == "the key `coil` is unknown here, the nearest is `coils`");
  CHECK(reported(R"("size": {"coils": 0})") != "");
  CHECK(reported(R"("connections": 0)") != "");
  CHECK(reported(R"("watchdog": {"within": "1s"})") ==
        "the key `register` is missing here, it holds a number from 0 to 65535");
  CHECK(reported(R"("loss-after": "0s")") == "the time is 0, write a longer one, such as `500ms`");
  CHECK(reported(R"("watchdog": {"register": 1, "within": "0s"})") ==
        "the time is 0, write a longer one, such as `500ms`");
  CHECK(reported(R"("loss-after": "1 fortnight")") != "");
  CHECK(
      reported(R"("idle": "999ms")") ==
      "the time is shorter than a second, a connection would be closed between two requests: write `0s` for never, or "
      "a longer one, such as `60s`");
  CHECK(settings(R"("idle": "1s")").idle == tables::kSecond);
  CHECK(settings(R"("idle": "0s")").idle == 0);
}

TEST_CASE("symbols that meet, and settings that do not fit the map, are told by check") {
  CHECK(reported(R"("map": [{"symbol": "MODE", "number": 11}])") ==
        "`SPEED` stands on holding registers 10 to 11, and so does `MODE` on holding register 11: give one of them "
        "another number, in the list or in `links`");
  CHECK(reported(R"("status": 0)").starts_with("the status block begins on input register 0 and meets `LEVEL`"));
  CHECK(reported(R"("watchdog": {"register": 30})")
            .starts_with("the watchdog stands on holding register 30, and so does `MODE`"));
  CHECK(reported(R"("size": {"holding-registers": 30})")
            .starts_with("1 symbol stands beyond the size of 30, `MODE` the furthest on holding register 30: give a "
                         "size of 31 or more"));
  CHECK(
      reported(R"("size": {"holding-registers": 3})").starts_with("2 symbols stand beyond the size of 3, `MODE` the"));
  CHECK(reported(R"("map": [{"symbol": "SPEED", "number": 65535}])") ==
        "`SPEED` would end behind place 65535, the last that Modbus has: give a lower number");
}

TEST_CASE("settings are a controller's: of one link, and of `loop:` only where that names it") {
  const auto of_two = [](const std::string& links) {
    MemoryFileSystem files;
    files.files["a.csv"] = kList;
    files.files["plant.json"] = R"({"symplant": 1, "symbols": [{"file": "a.csv", "controller": "PLC1"},
      {"file": "b.csv", "controller": "PLC2"}], "links": [)" +
                                links + "]}";
    files.files["b.csv"] = "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial\nVAR_GLOBAL,A_B_C_I_D,X1,,BOOL,FALSE\n";
    std::ostringstream err;
    app::Progress progress(err, false);
    Analysed result;
    result.plant = app::analyse({"plant.json", {}, {}, "2026-07-01"}, files, progress, result.diagnostics);
    return result;
  };
  const Analysed sound = of_two(R"({"url": "loop:", "controller": "plc2", "on-loss": "zero"},
                                   {"url": "modbus-tcp-server://:1502", "controller": "PLC1", "resync": "2s"})");
  CHECK(reported(sound).empty());
  CHECK(sound.model().links.at(0).link.resync == 2 * tables::kSecond);
  CHECK(sound.model().links.at(1).link.on_loss == OnLoss::zero);
  CHECK(
      reported(R"("controller": "PLC9")") ==
      "this plant's one controller has no name, so that `PLC9` is none: leave `controller` out here, or name it beside "
      "its list in `symbols`");
  CHECK(reported(of_two(R"({"url": "loop:", "resync": "2s"})")) ==
        "this `loop:` is of all controllers, and settings are of one: give it a `controller`");
  CHECK(reported(of_two(R"({"url": "loop:", "controller": "PLC1", "resync": "2s"},
                       {"url": "modbus-tcp-server://:1502", "controller": "PLC1", "on-loss": "zero"})")) ==
        "another link of this controller has settings too, give them in one place");
}

TEST_CASE("values of every wrong type are refused in every key of a link, and nothing breaks") {
  const std::vector<std::string> values{"null", "true", "-1",   "1.5", "99999999999", "\"x\"",
                                        "\"\"", "[]",   "[[]]", "{}",  R"({"x": {}})"};
  for (const std::string& value : values) {
    for (const char* key : {"map", "word-order", "size", "on-loss", "plant-on-loss", "loss-after", "resync", "status",
                            "watchdog", "connections", "idle", "keep"}) {
      CHECK(description::read_plant_file(
                std::string(R"({"symplant": 1, "symbols": ["a"], "links": [{"url": "loop:", ")") + key +
                    "\": " + value + "}]}",
                "s")
                .file);
    }
    for (const char* key : {"area", "range", "symbol", "number", "word-order", "on-loss"}) {
      CHECK(description::read_plant_file(
                std::string(R"({"symplant": 1, "symbols": ["a"], "links": [{"url": "loop:", "map": [{")") + key +
                    "\": " + value + "}]}]}",
                "s")
                .file);
    }
  }
}

}  // namespace
}  // namespace symplant::test
