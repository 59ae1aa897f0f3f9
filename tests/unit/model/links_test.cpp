// `links` of plant.json: every key, every fault, and the entry that applies to each symbol.
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
  if (auto compiled = app::compile({"plant.json", {}, {}, "2026-07-01"}, files, progress, result.diagnostics)) {
    result.derived = model::Derived{std::move(compiled->plant), std::move(compiled->evidence)};
  }
  return result;
}

/// The findings on the description, one per line.
std::string reported(const Analysed& analysed) {
  std::string text;
  for (const diag::Diagnostic& finding : analysed.diagnostics.all()) {
    if (finding.rule->id.substr(0, 3) != "SP6" && finding.rule->slug != "symbols-overlap") continue;
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

/// The numbers that entries of a map set, by symbol.
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

TEST_CASE("A link without keys has the default settings") {
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

TEST_CASE("Every key of a link reaches its settings") {
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
  // They are compared in the system's notation, whatever the input.
  const Analysed forms = linked(R"("keep": ["0:0:0:0:0:0:0:1", "::ffff:10.0.0.7", "FD00::00A1"])");
  CHECK(reported(forms).empty());
  const auto keep = forms.model().links.at(0).settings().keep;
  CHECK(std::vector<std::string>(keep.begin(), keep.end()) == std::vector<std::string>{"::1", "10.0.0.7", "fd00::a1"});
}

TEST_CASE("A client to be kept is one numeric address") {
  for (const std::string text : {"127.0.0.01", "foo", "10.0.0.0/24", "1.2.3", "::g"}) {
    CHECK(reported("\"keep\": [\"::1\", \"" + text + "\"]")
              .starts_with("`" + text + "` is not the numeric address of a host"));
  }
}

TEST_CASE("The low word comes first if a list has a MELSEC address, else the high one, unless the link sets it") {
  const std::string melsec = kList + "VAR_GLOBAL,L_P_E_I_A,X10,,BOOL,FALSE\n";
  CHECK(linked(R"("resync": "1s")", melsec).model().links.at(0).link.word_order == WordOrder::low_first);
  CHECK(linked(R"("resync": "1s")").model().links.at(0).link.word_order == WordOrder::high_first);
  CHECK(linked(R"("word-order": "high-first")", melsec).model().links.at(0).link.word_order == WordOrder::high_first);
}

TEST_CASE("An area moves all symbols with an address in it, by their own number in registers") {
  CHECK(numbers(R"({"area": "%IX", "number": 100})") == Numbers{{"L_P_D_I_A", 116}});
  CHECK(numbers(R"({"area": "X", "number": 1})") == Numbers{{"L_P_D_I_A", 17}});
  CHECK(numbers(R"({"area": "%QD", "number": 5})") == Numbers{{"SPEED", 15}});
  CHECK(numbers(R"({"area": "%iw", "number": 0})") == Numbers{{"LEVEL", 7}, {"LEVEL2", 7}});
}

TEST_CASE("A range moves the symbols from its first address to its last, so that the first is at the number") {
  CHECK(numbers(R"({"range": ["%IX2.0", "%IX2.7"], "number": 0})") == Numbers{{"L_P_D_I_A", 0}});
  CHECK(numbers(R"({"range": ["%QD3", "%QD5"], "number": 100})") == Numbers{{"SPEED", 104}});
  CHECK(numbers(R"({"range": ["%QW30", "%QW30"], "number": 1})") == Numbers{{"MODE", 1}});
}

TEST_CASE("A symbol is at its given number, also without an address, and so are others of its address") {
  CHECK(numbers(R"({"symbol": "speed", "number": 100}, {"symbol": "X_Y_Z_O_NOWHERE", "number": 3})") ==
        Numbers{{"SPEED", 100}, {"X_Y_Z_O_NOWHERE", 3}});
  CHECK(numbers(R"({"symbol": "LEVEL2", "number": 20})") == Numbers{{"LEVEL", 20}, {"LEVEL2", 20}});
}

TEST_CASE("A symbol's entry overrides a range's, that overrides an area's, key by key and in any order") {
  CHECK(
      numbers(
          R"({"symbol": "MODE", "number": 1}, {"range": ["%QW0", "%QW99"], "number": 2}, {"area": "%QW", "number": 3})") ==
      Numbers{{"MODE", 1}});
  CHECK(
      numbers(
          R"({"area": "%QW", "number": 3}, {"range": ["%QW30", "%QW99"], "number": 2}, {"symbol": "MODE", "on-loss": "zero"})") ==
      Numbers{{"MODE", 2}});
}

TEST_CASE("The pattern with more letters sets word order and on-loss") {
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

TEST_CASE("The most specific entry gives a symbol its node of OPC UA, which may be a template") {
  const Analysed analysed = linked(R"("map": [{"area": "%QW", "node": "ns=3;s=\"SET\".\"{symbol}\""},
                                              {"symbol": "L*", "node": "ns=3;s={address}"},
                                              {"symbol": "SPEED", "node": "i=7", "number": 3}])");
  CHECK(reported(analysed).empty());
  std::map<std::string, std::string> nodes;
  for (const link::MapRow& row : analysed.model().links.at(0).rows) {
    nodes.emplace(analysed.model().symbols[row.symbol].name(), row.node);
  }
  CHECK(nodes == std::map<std::string, std::string>{{"MODE", "ns=3;s=\"SET\".\"{symbol}\""},
                                                    {"LEVEL", "ns=3;s={address}"},
                                                    {"LEVEL2", "ns=3;s={address}"},
                                                    {"L_P_D_I_A", "ns=3;s={address}"},
                                                    {"L_P_D_O_A", "ns=3;s={address}"},
                                                    {"SPEED", "i=7"}});
}

TEST_CASE("A text that is no node id of OPC UA is reported at its entry") {
  CHECK_THAT(reported(R"("map": [{"symbol": "SPEED", "node": "SPEED"}])"),
             Catch::Matchers::StartsWith("`SPEED`: write a node id, such as ns=3;s="));
  CHECK_THAT(reported(R"("map": [{"symbol": "*", "node": "s={name}"}])"),
             Catch::Matchers::StartsWith("`s={name}`: `{name}` is not known: use {symbol} and {address}"));
  CHECK(reported(R"("map": [{"area": "%QW", "node": "i=1"}, {"area": "%QW", "node": "i=2"}])") ==
        "two equally specific entries give `MODE` different values of `node`; remove one, or name the symbol");
}

TEST_CASE("An unknown name in an entry is reported with the nearest one") {
  CHECK(reported(R"("map": [{"symbol": "SPED", "number": 1}])") == "symbol `SPED` not found; did you mean `SPEED`?");
  CHECK(reported(R"("map": [{"area": "%MW", "number": 1}])")
            .starts_with("`%MW` is not an area of inputs or outputs; write X, "));
  CHECK(
      reported(R"("map": [{"area": "%QX1", "number": 1}])").starts_with("`%QX1` is not an area of inputs or outputs"));
  CHECK(reported(R"("map": [{"area": "%IL", "number": 1}])") == "no symbol of this controller is in the area `%IL`");
  CHECK(reported(R"("map": [{"range": ["%QW1", "%QW2"], "number": 1}])") ==
        "no symbol of this controller is between `%QW1` and `%QW2`");
  CHECK(reported(R"("map": [{"symbol": "Q*", "on-loss": "zero"}])") ==
        "no symbol of this controller is matched by `Q*`");
}

TEST_CASE("A row that is not I/O is reported as what it is") {
  const std::string list = kList + "VAR_GLOBAL,STEP,M100,,BOOL,FALSE\n";
  CHECK(reported(linked(R"("map": [{"symbol": "Step", "number": 1}])", list)) ==
        "`Step` is in the list, but is not an input or output of this controller, its address is `M100`; remove this "
        "entry");
}

TEST_CASE("A setting without effect on any symbol of its entry is reported") {
  CHECK(reported(R"("map": [{"symbol": "LEVEL", "on-loss": "zero"}])") ==
        "`on-loss` applies only to operations, and no operation is matched by `LEVEL`");
  CHECK(reported(R"("map": [{"symbol": "MODE", "word-order": "low-first"}])") ==
        "`word-order` applies only to numbers of 32 or 64 bits, and no such number is matched by `MODE`");
  CHECK(reported(R"("map": [{"symbol": "*", "word-order": "low-first", "on-loss": "zero"}])").empty());
}

TEST_CASE("Invalid entries are reported") {
  CHECK(reported(R"("map": [{"symbol": "S*", "number": 1}])") ==
        "`S*` is a pattern, but its symbols cannot share one `number`; name each symbol");
  CHECK(reported(R"("map": [{"range": ["%QW9", "%QW2"], "number": 1}])") ==
        "`%QW9` and `%QW2` are not the first and the last address of one area; write them in ascending order");
  CHECK(reported(R"("map": [{"range": ["%QW2", "%QD9"], "number": 1}])")
            .starts_with("`%QW2` and `%QD9` are not the first"));
  CHECK(reported(R"("map": [{"range": ["%MW2", "%IX1.2.3"], "number": 1}])") ==
        "`%MW2` is not an input or output address with a number; write one such as `X10` or `%IX100.0`\n"
        "`%IX1.2.3` is not an input or output address with a number; write one such as `X10` or `%IX100.0`");
  CHECK(reported(R"("map": [{"area": "%QW", "number": 1}, {"area": "%QW", "number": 2}])") ==
        "two equally specific entries give `MODE` different values of `number`; remove one, or name the "
        "symbol");
  CHECK(reported(R"("map": [{"symbol": "MODE", "number": 1}, {"symbol": "mode", "number": 2}])") ==
        "two equally specific entries give `MODE` different values of `number`; remove one");
  CHECK(reported(R"("map": [{"area": "%QW", "number": 1}, {"area": "%QW", "number": 1}])").empty());
  CHECK(reported(
            R"("map": [{"area": "%QW", "number": 1}, {"area": "%QW", "number": 2}, {"symbol": "MODE", "number": 3}])")
            .empty());
  CHECK(reported(R"("map": [{"symbol": "LEVEL", "number": 1}, {"symbol": "LEVEL2", "number": 2}])") ==
        "`LEVEL2` has the same address as `LEVEL`, which has another `number`; give both the same");
  CHECK(reported(R"("map": [{"number": 1, "on-loss": "zero"}])") ==
        "this entry does not name its symbols; give it an `area`, a `range` or a `symbol`");
  CHECK(reported(R"("map": [{"number": 1, "area": "X", "symbol": "MODE"}])") ==
        "this entry has more than one of `area`, `range` and `symbol`; write an entry for each");
}

TEST_CASE("An entry that sets nothing for its symbols is reported") {
  CHECK(reported(R"("map": [{"area": "X", "symbol": "MODE"}])") != "");
  CHECK(reported(R"("map": [{"symbol": "MODE"}])") ==
        "this entry sets nothing for its symbols; give it a `number`, a `node`, a `word-order` or `on-loss`");
  CHECK(reported(R"("map": [{}])") ==
        "this entry does not name its symbols; give it an `area`, a `range` or a `symbol`");
}

TEST_CASE("Invalid values are reported in the words of the schema") {
  CHECK(reported(R"("status": "on")") != "");
  CHECK(reported(R"("status": 65536)") != "");
  CHECK(reported(R"("word-order": "big")") == "expected one of `low-first`, `high-first`, but found the text `big`");
  CHECK(reported(R"("on-loss": "zeros")") ==
        "expected one of `hold`, `zero`, but found the text `zeros`; did you mean `zero`?");
  CHECK(reported(R"("size": {"coil": 5})") == "the key `coil` is unknown here; did you mean `coils`?");
  CHECK(reported(R"("size": {"coils": 0})") != "");
  CHECK(reported(R"("connections": 0)") != "");
  CHECK(reported(R"("watchdog": {"within": "1s"})") ==
        "the key `register` is missing here; it holds a number from 0 to 65535");
  CHECK(reported(R"("loss-after": "0s")") == "the time is 0; write a longer one, such as `500ms`");
  CHECK(reported(R"("watchdog": {"register": 1, "within": "0s"})") ==
        "the time is 0; write a longer one, such as `500ms`");
  CHECK(reported(R"("loss-after": "1 fortnight")") != "");
  CHECK(
      reported(R"("idle": "999ms")") ==
      "the time is shorter than 1 s, so a connection would be closed between two requests; write `0s` for never, or a "
      "longer time such as `60s`");
  CHECK(settings(R"("idle": "1s")").idle == tables::kSecond);
  CHECK(settings(R"("idle": "0s")").idle == 0);
}

TEST_CASE("The clock of a link is a whole number that the PLC writes") {
  CHECK(settings(R"("resync": "1s")").clock.symbol == link::ClockSettings::kNone);
  const link::ClockSettings mode = settings(R"("clock": {"of": "mode"})").clock;
  CHECK(mode.symbol == 3);
  CHECK(mode.unit == tables::kMillisecond);
  CHECK(mode.limit == 10 * tables::kSecond);
  const link::ClockSettings speed = settings(R"("clock": {"of": "SPEED", "unit": "100us", "limit": "1min"})").clock;
  CHECK(speed.symbol == 2);
  CHECK(speed.unit == 100 * tables::kMicrosecond);
  CHECK(speed.limit == 60 * tables::kSecond);
}

TEST_CASE("A symbol that cannot be a clock is reported with the reason") {
  CHECK(reported(R"("clock": {"of": "MODEL"})") == "symbol `MODEL` not found; did you mean `MODE`?");
  CHECK(reported(R"("clock": {"of": "LEVEL"})") ==
        "`LEVEL` is an event, which the plant writes; a clock is an operation, which the PLC counts up");
  CHECK(reported(R"("clock": {"of": "L_P_D_O_A"})") ==
        "`L_P_D_O_A` has the type BOOL; a clock is a whole number of 16, 32 or 64 bits, such as a WORD or a UDINT");
  const auto of_row = [](const std::string& row) {
    return reported(linked(R"("clock": {"of": "T"})", kList + "VAR_GLOBAL,T," + row + "\n"));
  };
  CHECK(of_row(",%QD9,REAL,0").starts_with("`T` has the type REAL;"));
  CHECK(of_row(",%QB90,BYTE,0").starts_with("`T` has the type BYTE;"));
  CHECK(of_row("D100,,INT,0") ==
        "`T` is in the list, but is not an input or output of this controller, its address is `D100`; give the counter "
        "an output address");
}

TEST_CASE("Faults of shape in a clock are reported") {
  CHECK(reported(R"("clock": {"unit": "1ms"})") ==
        "the key `of` is missing here; it holds the name of a numeric operation");
  CHECK(reported(R"("clock": {"of": "MODE", "unit": "0s"})") == "the time is 0; write a longer one, such as `500ms`");
  CHECK(reported(R"("clock": {"of": "MODE", "unit": "2s"})") ==
        "the time is longer than 1 s; write a shorter one, such as `1ms`");
  CHECK(reported(R"("clock": {"of": "MODE", "unit": "1ms", "limit": "1us"})") ==
        "the time is shorter than one count of the clock; write a longer one, such as `10s`");
  CHECK(reported(R"("clock": {"of": "MODE", "limit": "0s"})") == "the time is 0; write a longer one, such as `500ms`");
}

TEST_CASE("check reports symbols that overlap, and settings that do not fit the map") {
  CHECK(reported(R"("map": [{"symbol": "MODE", "number": 11}])") ==
        "`SPEED` on holding registers 10 to 11 and `MODE` on holding register 11 overlap: give one of them "
        "another number, in the list or in `links`");
  CHECK(reported(R"("status": 0)").starts_with("the status block from input register 0 on overlaps `LEVEL`"));
  CHECK(reported(R"("watchdog": {"register": 30})").starts_with("the watchdog on holding register 30 overlaps `MODE`"));
  CHECK(reported(R"("size": {"holding-registers": 30})")
            .starts_with("1 symbol is beyond the size of 30, the last is `MODE` on holding register 30: give a "
                         "size of 31 or more"));
  CHECK(reported(R"("size": {"holding-registers": 3})")
            .starts_with("2 symbols are beyond the size of 3, the last is `MODE`"));
  CHECK(reported(R"("map": [{"symbol": "SPEED", "number": 65535}])") ==
        "`SPEED` would end after 65535, the last address of Modbus; give a lower number");
}

TEST_CASE("Settings belong to the controller of one link, and of `loop:` only if it names the controller") {
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
    if (auto compiled = app::compile({"plant.json", {}, {}, "2026-07-01"}, files, progress, result.diagnostics)) {
      result.derived = model::Derived{std::move(compiled->plant), std::move(compiled->evidence)};
    }
    return result;
  };
  const Analysed sound = of_two(R"({"url": "loop:", "controller": "plc2", "on-loss": "zero"},
                                   {"url": "modbus-tcp-server://:1502", "controller": "PLC1", "resync": "2s"})");
  CHECK(reported(sound).empty());
  CHECK(sound.model().links.at(0).link.resync == 2 * tables::kSecond);
  CHECK(sound.model().links.at(1).link.on_loss == OnLoss::zero);
  CHECK(reported(R"("controller": "PLC9")") ==
        "controller `PLC9` not found, because this plant's only controller has no name; remove `controller` here, or "
        "add it to its list in `symbols`");
  CHECK(reported(of_two(R"({"url": "loop:", "resync": "2s"})")) ==
        "this `loop:` is for all controllers, but settings are for one; give it a `controller`");
  CHECK(reported(of_two(R"({"url": "modbus-tcp-server://:1502", "controller": "PLC1", "clock": {"of": "MODE"}},
                           {"url": "modbus-tcp-server://:1503", "controller": "PLC2", "clock": {"of": "A_B_C_I_D"}})")) ==
        "another link also has a `clock`, and plant time can follow only one; remove one");
  CHECK(reported(of_two(R"({"url": "loop:", "controller": "PLC1", "resync": "2s"},
                       {"url": "modbus-tcp-server://:1502", "controller": "PLC1", "on-loss": "zero"})")) ==
        "another link of this controller also has settings; give all of them in one link");
}

TEST_CASE("Values of every wrong type are rejected in every key of a link without harm") {
  const std::vector<std::string> values{"null", "true", "-1",   "1.5", "99999999999", "\"x\"",
                                        "\"\"", "[]",   "[[]]", "{}",  R"({"x": {}})"};
  for (const std::string& value : values) {
    for (const char* key : {"map", "word-order", "size", "on-loss", "plant-on-loss", "loss-after", "resync", "status",
                            "watchdog", "clock", "connections", "idle", "keep"}) {
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
