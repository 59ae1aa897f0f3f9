// `times` of plant.json: which transitions they set, which entry wins, and what is at fault.
#include <algorithm>

#include "description/plant_file.hpp"
#include "description_support.hpp"
#include "support/tool.hpp"
#include "symplant/tables/digest.hpp"

namespace symplant::test {
namespace {

/// Two spring stoppers, a clamp with two operations, a machine with an inferred transition, and a motor.
const std::vector<std::string> kPlant{"L_P_S1_O_ADV",  "L_P_S1_I_ADV",  "L_P_S1_I_RET", "L_P_S2_O_ADV",  "L_P_S2_I_ADV",
                                      "L_P_S2_I_RET",  "L_P_C_O_OPEN",  "L_P_C_I_OPEN", "L_P_C_O_SHUT",  "L_P_C_I_SHUT",
                                      "L_P_C_O_FORCE", "L_P_M_O_RUN1",  "L_P_M_I_RUN1", "L_P_M_I_DONE2", "L_P_V_O_LEFT",
                                      "L_P_V_I_LEFT",  "L_P_V_O_RIGHT", "L_P_V_I_RIGHT"};
/// Without the state FORCE, which would be one of the clamp.
const std::string kDevices = R"("devices": {"L_P_V": {"actuation": "held"}, "L_P_C": {"transitions": [
    {"from": "OPEN", "to": "SHUT"}, {"from": "SHUT", "to": "OPEN"}, {"from": "OPEN", "to": "SHUT", "on": "FORCE"},
    {"from": "OPEN", "to": "SHUT", "automatic": true, "when": "L_P_M.DONE2"}]}})";

description::Description description_of(const std::string& members) {
  auto reading = description::read_plant_file(R"({"symplant": 1, "symbols": ["a.csv"], )" + members + "}", "symbols");
  REQUIRE(reading.sound());
  return std::move(reading.file->description);
}

Analysed timed(const std::string& times, const std::string& devices = kDevices) {
  return analyse_described(bits(kPlant), description_of(devices + ", \"times\": " + times));
}

std::string seconds(const Duration& time) {
  const std::string a = std::to_string(time.a / tables::kMillisecond);
  return time.kind == Duration::Kind::fixed ? a : a + ".." + std::to_string(time.b / tables::kMillisecond);
}

/// "OPEN>SHUT 0+1000" for each transition: after and takes in ms.
std::string times_of(const Analysed& analysed, std::string_view path) {
  const model::Unit& unit = unit_of(analysed, path);
  std::string text;
  for (const model::Transition& t : unit.transitions) {
    text += (text.empty() ? "" : ", ") + unit.states[t.from].name + ">" + unit.states[t.to].name + " " +
            seconds(t.after) + "+" + seconds(t.takes);
  }
  return text;
}

/// All warnings: "pointer: message", one per line.
std::string timed_warnings(const Analysed& analysed) {
  std::string text;
  for (const description::DescriptionFault& fault : analysed.evidence().warnings) {
    text += (text.empty() ? "" : "\n") + fault.pointer + ": " + fault.message;
  }
  return text;
}

TEST_CASE("Times set derived, inferred and given transitions, which keep their origin") {
  const Analysed list = timed(R"({"L_P_S1": {"RET->ADV": {"takes": "0.8s"}},
      "L_P_M": {"RUN1->DONE2": {"after": {"min": "2s", "max": "3s"}}, "DONE2->RUN1": {"takes": "4s"}},
      "L_P_C": {"SHUT->OPEN": {"takes": "5s", "after": "6s"}}})");
  CHECK(faults(list) == "");
  CHECK(timed_warnings(list) == "");
  CHECK(times_of(list, "L_P_S1") == "RET>ADV 0+800");
  CHECK(times_of(list, "L_P_S2") == "RET>ADV 0+1000");
  CHECK(times_of(list, "L_P_M") == "DONE2>RUN1 0+4000, RUN1>DONE2 2000..3000+0");
  CHECK(origins(unit_of(list, "L_P_M")) == "di");
  CHECK(times_of(list, "L_P_C").starts_with("OPEN>SHUT 0+1000, SHUT>OPEN 6000+5000, "));
  CHECK(origins(unit_of(list, "L_P_C")).starts_with("gggg"));
}

TEST_CASE("A key without an operation means all transitions between the states, one with an operation wins") {
  CHECK(times_of(timed(R"({"L_P_C": {"OPEN->SHUT": {"takes": "2s"}}})"), "L_P_C")
            .starts_with("OPEN>SHUT 0+2000, SHUT>OPEN 0+1000, OPEN>SHUT 0+2000, OPEN>SHUT 0+2000"));
  CHECK(times_of(timed(R"({"L_P_C": {"OPEN->SHUT": {"takes": "2s"}, "OPEN->SHUT on force": {"takes": "3s"},
                                     "*->SHUT on SHUT": {"takes": "4s"}}})"),
                 "L_P_C")
            .starts_with("OPEN>SHUT 0+2000, SHUT>OPEN 0+1000, OPEN>SHUT 0+3000, OPEN>SHUT 0+2000"));
}

TEST_CASE("From every state: a key with the state wins") {
  const std::vector<std::string> three{"L_P_D_O_A1", "L_P_D_I_A1", "L_P_D_O_B2",
                                       "L_P_D_I_B2", "L_P_D_O_C3", "L_P_D_I_C3"};
  const Analysed list = analyse_described(
      bits(three), description_of(R"("times": {"L_P_D": {"*->A1": {"takes": "2s"}, "c3->a1": {"takes": "3s"}}})"));
  CHECK(faults(list) == "");
  CHECK(times_of(list, "L_P_D").starts_with("B2>A1 0+2000, C3>A1 0+3000, A1>B2 0+1000"));
}

TEST_CASE("The return of a spring gets a transition after the given ones") {
  const Analysed list = timed(R"({"L_P_S?": {"ADV->RET": {"takes": "0.7s"}}, "L_P_S2": {"*->RET": {"takes": "9s"}}})");
  CHECK(faults(list) == "");
  CHECK(times_of(list, "L_P_S1") == "ADV>RET 0+700, RET>ADV 0+1000");
  CHECK(times_of(list, "L_P_S2") == "ADV>RET 0+9000, RET>ADV 0+1000");
  CHECK(unit_of(list, "L_P_S1").transitions[0].spring_return);
  CHECK(faults(timed(R"({"L_P_S1": {"ADV->RET": {"after": "1s"}}})")) ==
        "/times/L_P_S1/ADV->RET/after: `after` is not allowed in the return of a spring, which has only `takes`; "
        "remove it");
  // A return that the description gives is set, not doubled.
  const Analysed given =
      timed(R"({"L_P_S1": {"ADV->RET": {"takes": "0.7s"}}})",
            R"("devices": {"L_P_S1": {"transitions": [{"from": "ADV", "to": "RET", "takes": "3s"}]}})");
  CHECK(times_of(given, "L_P_S1") == "ADV>RET 0+700, RET>ADV 0+1000");
}

TEST_CASE("Overrun of held devices") {
  CHECK(unit_of(timed(R"({"L_P_V": {"overrun": "5s"}})"), "L_P_V").overrun == 5 * tables::kSecond);
  const Analysed pattern = timed(R"({"L_*": {"overrun": "never"}})");
  CHECK(faults(pattern) == "");
  CHECK(unit_of(pattern, "L_P_V").overrun == tables::kNever);
  CHECK(faults(timed(R"({"L_P_C": {"overrun": "5s"}})")) ==
        "/times/L_P_C/overrun: `L_P_C` is `latched`, but only a `held` device can overrun; remove `overrun`");
  CHECK(faults(timed(R"({"L_P_S?": {"overrun": "5s"}})")) ==
        "/times/L_P_S?/overrun: no device that `L_P_S?` matches is `held`, and only such a device can overrun; "
        "remove `overrun`");
}

TEST_CASE("The exact name wins, then the pattern with more literal characters, for each transition as a whole") {
  const Analysed list = timed(R"({"*": {"RET->ADV": {"takes": "1ms"}, "ADV->RET": {"takes": "2ms"}, "overrun": "1s"},
      "L_P_S?": {"RET->ADV": {"takes": "3ms", "after": "4ms"}}, "L_P_S2": {"*->ADV": {"takes": "5ms"}}, "L_P_V": {"overrun": "2s"}})");
  CHECK(faults(list) == "");
  CHECK(times_of(list, "L_P_S1") == "ADV>RET 0+2, RET>ADV 4+3");
  CHECK(times_of(list, "L_P_S2") == "ADV>RET 0+2, RET>ADV 0+5");
  CHECK(unit_of(list, "L_P_V").overrun == 2 * tables::kSecond);
}

TEST_CASE("Equally specific patterns must give a time the same value") {
  const Analysed list = timed(R"({"L_P_S?": {"RET->ADV": {"takes": "1s"}}, "L_P_?1": {"RET->ADV": {"takes": "2s"}},
      "?_P_V": {"overrun": "1s"}, "L_?_V": {"overrun": "2s"}})");
  CHECK(faults(list) ==
        "/times/L_P_S?/RET->ADV: `L_P_S?` and `L_P_?1` are equally specific and give a time of `L_P_S1` different "
        "values; make one more specific or name the device\n"
        "/times/L_?_V/overrun: `L_?_V` and `?_P_V` are equally specific and give a time of `L_P_V` different values; "
        "make one more specific or name the device");
  CHECK(faults(timed(R"({"L_P_S?": {"RET->ADV": {"takes": "1s"}}, "L_P_?1": {"RET->ADV": {"takes": "1s"}}})")) == "");
  CHECK(faults(timed(R"({"L_P_S?": {"RET->ADV": {"takes": "1s"}}, "L_P_?1": {"RET->ADV": {"takes": "2s"}},
                         "L_P_S1": {"RET->ADV": {"takes": "3s"}}})")) == "");
}

TEST_CASE("What a device does not have is an error under its name") {
  CHECK(faults(timed(R"({"L_P_S3": {}})")) == "/times/L_P_S3: device `L_P_S3` not found; did you mean `L_P_S1`?");
  CHECK(faults(timed(R"({"L_P_S1": {"RETT->ADV": {}, "RET->ADVV": {}, "RET->ADV on ADF": {}}})")) ==
        "/times/L_P_S1/RET->ADV on ADF: operation `ADF` of `L_P_S1` not found; did you mean `ADV`?\n"
        "/times/L_P_S1/RET->ADVV: state `ADVV` of `L_P_S1` not found; did you mean `ADV`?\n"
        "/times/L_P_S1/RETT->ADV: state `RETT` of `L_P_S1` not found; did you mean `RET`?");
  CHECK(faults(timed(R"({"L_P_V": {"LEFT->RIGHT on LEFT": {}, "LEFT->LEFT": {}}})")) ==
        "/times/L_P_V/LEFT->LEFT: transition `LEFT->LEFT` of `L_P_V` not found\n"
        "/times/L_P_V/LEFT->RIGHT on LEFT: transition `LEFT->RIGHT on LEFT` of `L_P_V` not found; did you mean "
        "`LEFT->RIGHT on RIGHT`?");
  CHECK(faults(timed(R"({"L_P_V": {"LEFT->RIGHT": {}, "left -> right": {}}})")) ==
        "/times/L_P_V/left -> right: `left -> right` means the transition of `LEFT->RIGHT`; remove one of the two");
  CHECK(faults(timed(R"({"L_P_V": {}, "l_p_v": {}})")) ==
        "/times/l_p_v: `l_p_v` has two entries in `times`; merge both");
}

TEST_CASE("Under a pattern what some devices lack is left out, with a warning, what all lack is an error") {
  const Analysed some = timed(R"({"L_P_?*": {"RET->ADV": {"takes": "2s"}}, "X*": {}})");
  CHECK(faults(some) == "");
  CHECK(timed_warnings(some) ==
        "/times/X*: `X*` matches no device\n"
        "/times/L_P_?*/RET->ADV: state `RET` of `L_P_C` not found; the entry is left out for `L_P_C`, `L_P_M`, "
        "`L_P_V`, 3 of the 5 matches");
  CHECK(times_of(some, "L_P_S2") == "RET>ADV 0+2000");
  CHECK(
      faults(timed(R"({"L_P_S?": {"REF->ADV": {"takes": "2s"}}})")) ==
      "/times/L_P_S?/REF->ADV: state `REF` of `L_P_S1` not found; did you mean `RET`? (the other match lacks it too)");
}

TEST_CASE("A computed time is a formula, in which a pattern has names in braces") {
  const Analysed list = timed(R"({"L_P_S?": {"RET->ADV": {"takes": {"seconds": "2 + {self}.moving"}}}})");
  CHECK(faults(list) == "");
  CHECK(unit_of(list, "L_P_S1").transitions[0].takes.kind == Duration::Kind::seconds);
  CHECK(list.model().time_formulas.size() == 2);
  CHECK(faults(timed(R"({"L_P_S1": {"RET->ADV": {"takes": {"seconds": "2 + LEVEL"}}}})"))
            .starts_with("/times/L_P_S1/RET->ADV/takes/seconds: "));
}

std::uint64_t hash_of(const std::string& members) {
  const CompiledText compiled = compile_described(bits(kPlant), description_of(members));
  REQUIRE(compiled.compiled);
  return tables::model_hash(compiled.tables().tables());
}

std::string json_of(const std::string& members) {
  MemoryFileSystem files;
  files.files["a.csv"] = list_text(bits(kPlant));
  files.files["plant.json"] = R"({"symplant": 1, "symbols": ["a.csv"], )" + members + "}";
  const ToolRun run = run_tool({"model", "plant.json", "--format", "json"}, files);
  CHECK(run.code == 0);
  return run.out;
}

TEST_CASE("Times apart from the devices make the model that the same times in the devices make") {
  const std::string transitions = R"("devices": {"L_P_V": {"actuation": "held"@OVERRUN@}, "L_P_S*": {"transitions": [
      {"from": "ADV", "to": "RET"@RETURN@}, {"from": "RET", "to": "ADV"@ADV@}]}, "L_P_M": {"transitions": [
      {"from": "RUN1", "to": "DONE2", "automatic": true@DWELL@}, {"from": "DONE2", "to": "RUN1"@ADV@}]}})";
  const auto with = [&](const std::vector<std::pair<std::string, std::string>>& texts) {
    std::string text = transitions;
    for (const auto& [name, value] : texts) {
      for (std::size_t at = text.find(name); at != text.npos; at = text.find(name))
        text.replace(at, name.size(), value);
    }
    return text;
  };
  const std::string in_devices = with({{"@OVERRUN@", R"(, "overrun": "3s")"},
                                       {"@RETURN@", R"(, "takes": {"min": "0.7s", "max": "0.9s"})"},
                                       {"@ADV@", R"(, "takes": "2s")"},
                                       {"@DWELL@", R"(, "after": {"mean": "2s", "sigma": "10ms"})"}});
  const std::string apart =
      with({{"@OVERRUN@", ""}, {"@RETURN@", ""}, {"@ADV@", ""}, {"@DWELL@", ""}}) +
      R"(, "times": {"L_P_V": {"overrun": "3s"}, "L_P_S?": {"ADV->RET": {"takes": {"min": "0.7s", "max": "0.9s"}},
          "RET->ADV": {"takes": "2s"}}, "L_P_M": {"RUN1->DONE2": {"after": {"mean": "2s", "sigma": "10ms"}},
          "DONE2->RUN1": {"takes": "2s"}}})";
  CHECK(hash_of(apart) == hash_of(in_devices));
  CHECK(json_of(apart) == json_of(in_devices));
  CHECK(hash_of(apart) != hash_of(with({{"@OVERRUN@", ""}, {"@RETURN@", ""}, {"@ADV@", ""}, {"@DWELL@", ""}})));
  // Of derived transitions only the origin differs, which is not in the tables.
  CHECK(hash_of(R"("times": {"L_P_S*": {"ADV->RET": {"takes": "2s"}, "RET->ADV": {"takes": "3s"}}})") ==
        hash_of(R"("devices": {"L_P_S*": {"transitions": [{"from": "ADV", "to": "RET", "takes": "2s"},
                                                          {"from": "RET", "to": "ADV", "takes": "3s"}]}})"));
  CHECK(json_of(R"("times": {"L_P_S*": {"ADV->RET": {"takes": "2s"}}})") ==
        json_of(R"("devices": {"L_P_S*": {"transitions": [{"from": "ADV", "to": "RET", "takes": "2s"}]}})"));
}

}  // namespace
}  // namespace symplant::test
