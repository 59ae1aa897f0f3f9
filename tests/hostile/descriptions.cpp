// Hostile plant.json and scenario.json files.
#include <array>

#include "inputs.hpp"

namespace symplant::hostile {
namespace {

/// A plant.json of good_list() with additional members.
std::string plant(const std::string& more) {
  return R"({ "symplant": 1, "symbols": ["symbols.csv"])" + (more.empty() ? "" : ",\n" + more) + " }\n";
}
std::string guarded(const std::string& condition) {
  return plant(R"("devices": { "L_P_AGV": { "transitions": [ { "from": "P1", "to": "P2", "when": ")" + condition +
               R"(" } ] } })");
}
std::string scenario(const std::string& steps) { return R"({ "symplant-scenario": 1, "steps": [ )" + steps + " ] }\n"; }

std::string numbered(const std::string& before, const std::string& after, std::size_t count,
                     const char* between = ",\n") {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += (i == 0 ? "" : between) + before + std::to_string(i) + after;
  return text;
}

std::string nothing() { return ""; }
std::string brace() { return "{"; }
std::string array() { return "[]\n"; }
std::string deep_arrays() { return plant("\"x\": " + std::string(1'000'000, '[') + std::string(1'000'000, ']')); }
std::string deep_objects() { return repeated("{\"a\":", 1'000'000); }
std::string deep_comment() { return plant("/*" + std::string(10'000'000, '*') + "/ \"name\": \"x\""); }
std::string open_comment() { return plant("\"name\": \"x\" /* never closed"); }
std::string long_text() { return plant("\"name\": \"" + std::string(50'000'000, 'A') + "\""); }
std::string open_text() { return "{ \"symplant\": 1, \"symbols\": [\"" + std::string(10'000'000, 'A'); }
std::string many_entries() { return plant("\"devices\": { " + numbered("\"L_P_D", "\": {}", 200'000) + " }"); }
std::string same_keys() {
  return plant("\"devices\": { " + repeated("\"L_P_AGV\": {},", 100'000) + "\"L_P_AGV\": {} }");
}
std::string unknown_keys() { return plant(numbered("\"k", "\": 1", 100'000)); }
std::string numbers() { return R"({ "symplant": 1e400, "symbols": ["symbols.csv"] })"; }
std::string version() { return R"({ "symplant": 9007199254740993, "symbols": ["symbols.csv"] })"; }
std::string surrogate() { return plant(R"("name": "\ud800")"); }
std::string nul() { return plant(R"("name": "a\u0000b")"); }
std::string ill_formed() { return plant("\"name\": \"\xC0\xAF\""); }
std::string utf16() {
  std::string bytes = "\xFF\xFE";
  for (const char c : plant("\"name\": \"x\"")) bytes += {c, '\0'};
  return bytes;
}
std::string itself() { return R"({ "symplant": 1, "symbols": ["plant.json"] })"; }
std::string far_lists() { return R"({ "symplant": 1, "symbols": ["/etc/passwd"] })"; }
std::string many_lists() { return R"({ "symplant": 1, "symbols": [ )" + numbered("\"none", ".csv\"", 10'000) + " ] }"; }
std::string names() {
  return plant(R"("name": "*/ \"{{x}}\\ %n ../../x \u202e\u001b[31m",
"devices": { "L_P_AGV": { "type": "int", "behaviour": "std::system" }, "L_P_CYL": { "type": "*/{{x}}" } })");
}
std::string long_names() {
  const std::string name(20'000, 'x');
  return plant("\"name\": \"" + name + R"(", "devices": { "L_P_AGV": { "type": "A)" + name + R"(", "states": [")" +
               name + R"("] } }, "requirements": [ { "name": ")" + name + R"(", "never": "L_P_AGV.P1" } ])");
}
std::string patterns() {
  return plant("\"devices\": { \"" + repeated("*a", 20'000) + "\": {}, \"" + repeated("?*", 20'000) + "\": {} }");
}
std::string many_patterns() {
  return plant("\"devices\": { " + numbered("\"*", "*\": { \"initial\": \"P1\" }", 20'000) + " }");
}
std::string durations() {
  return plant(R"("defaults": { "travel": "99999999999999999999s", "dwell": "1e999s" }, "devices": { "L_P_AGV": {
"transitions": [ { "from": "P1", "to": "P2", "takes": "0.0000000001ns" }, { "from": "P2", "to": "P1", "takes": "-1s" } ] } })");
}
std::string transitions() {
  return plant("\"devices\": { \"L_P_AGV\": { \"transitions\": [ " +
               numbered(R"({ "from": "P1", "to": "P2", "when": "LEVEL = )", R"(" })", 20'000) + " ] } }");
}
std::string states() {
  return plant("\"devices\": { \"L_P_AGV\": { \"states\": [ " + numbered("\"S", "\"", 100'000) + " ] } }");
}
std::string requirements() {
  return plant(
      "\"requirements\": [ " +
      numbered("{ \"name\": \"r", R"(", "after": "L_P_AGV.P1", "expect": "L_P_AGV.P2", "within": "1s" })", 20'000) +
      " ]");
}
std::string malfunctions() {
  std::string text;
  for (int i = 0; i < 20'000; ++i) {
    text += (i == 0 ? "" : ",\n") + (R"({ "name": "m)" + std::to_string(i)) +
            R"(", "of": "*", "slower": 2, "when": "L_P_AGV.P1", "becomes": { "after": "400ms", "start": "m)" +
            std::to_string((i + 1) % 20'000) + "\" } }";
  }
  return plant("\"malfunctions\": [ " + text + " ]");
}
std::string malfunction_names() {
  return plant(R"("malfunctions": [ { "name": "*/ \"{{x}}\\ %n", "of": "L_P_AGV", "stuck": true }, { "name": "int",
"lose": true }, { "name": "\u202e", "force": { "L_P_AGV_I_P1": true } }, { "name": ")" +
               std::string(20'000, 'x') +
               R"(", "flicker": { "symbol": "L_P_AGV_I_P1", "every": "1ns", "for": "2562047h" } } ])");
}
std::string settings() {
  return plant("\"check\": { \"ignore\": [ " +
               numbered(R"({ "rule": "event-not-driven", "why": "x", "symbols": "*)", "*\" }", 20'000) + " ] }");
}
std::string links() {
  return plant(R"("links": [ { "url": "modbus-tcp-server://[::1]:99999999999" }, { "url": "javascript:alert" },
{ "url": "modbus-tcp-server://127.0.0.1:502/../../etc?a=\u001b" } ])");
}

std::string layout() {
  return plant("\"plan\": { \"devices\": { " + numbered("\"L_P_D", "\": { \"x\": 1e4, \"y\": -1e4 }", 100'000) +
               " }, \"frames\": { " + numbered("\"F", "\": { \"x\": 1e308, \"y\": 0 }", 1'000) + " } }");
}
std::string layout_names() {
  return plant(R"("plan": { "devices": { "L_P_AGV": { "x": 1, "y": 2, "group": "*/ \"{{x}}\\ %n \u202e??/" } } },
"view3d": { "cameras": { "*/ \"{{x}}\\ ??/": { "from": [0, 0, 0], "to": [1, 1, 1] } } })");
}
std::string scene_bindings() {
  return plant("\"view3d\": { \"model\": \"/etc/passwd\", \"nodes\": { " +
               numbered("\"X", R"(": { "node": "../../x", "turn": { "by": "no.value", "axis": "y" } })", 20'000) +
               " } }");
}
std::string deep_condition() {
  return guarded(std::string(1'000'000, '(') + "LEVEL = 1" + std::string(1'000'000, ')'));
}
std::string nested_condition() {
  return guarded(repeated("(L_P_AGV.P1 and (L_P_CYL.ADV or ", 128) + "L_P_LAMP_O_ON" + repeated("))", 128));
}
std::string long_condition() { return guarded(numbered("LEVEL = ", "", 100'000, " or ")); }
std::string long_chain() { return guarded(repeated("not ", 1'000'000) + "L_P_AGV.P1"); }
std::string alternating() { return guarded(repeated("not (", 256) + "L_P_AGV.P1" + repeated(")", 256)); }
std::string long_name_condition() { return guarded("'" + std::string(10'000'000, 'x') + "'.P1"); }
std::string long_number_condition() { return guarded("LEVEL < 1" + std::string(10'000'000, '0')); }
std::string far_exponent() { return guarded("LEVEL < 1e999999999999999999999"); }
std::string no_utf8_condition() { return guarded("L_P_AGV.P1 and \\ud800"); }
std::string tangled_condition() {
  std::string text;
  for (int i = 0; i < 2'000; ++i) {
    text += std::string(i == 0 ? "" : " or ") + "(LEVEL = " + std::to_string(i) + " and not (LEVEL < " +
            std::to_string(2 * i) + " or L_P_CYL.ADV) and (L_P_AGV.P1 or LEVEL > " + std::to_string(i) + "))";
  }
  return guarded(text);
}

std::string scenario_deep() { return R"({ "symplant-scenario": 1, "steps": )" + std::string(1'000'000, '['); }
std::string scenario_long() {
  return scenario(
      numbered(R"({ "plus": "1ms", "set": { "L_P_AGV_O_P1": true }, "expect": { "LEVEL": )", " } }", 100'000));
}
std::string scenario_names() {
  return scenario(
      R"({ "at": "0s", "set": { "*/ \"{{x}}\\ %n": true } }, { "at": "1s", "state": { "\u202e\u001b[31m": "P1" } })");
}
std::string scenario_times() {
  return scenario(
      R"({ "at": "99999999999999999999s", "set": {} }, { "at": "-1s", "set": {} }, { "wait": "L_P_AGV.P2", "within": "1e999s" })");
}
std::string scenario_far() {
  return scenario(
      R"({ "at": "200y", "set": {} }, { "at": "2562047h", "set": { "L_P_AGV_O_P2": true } }, { "plus": "2562047h", "expect": "L_P_AGV.P2" })");
}
std::string scenario_condition() {
  return scenario(R"({ "at": "1s", "expect": ")" + std::string(1'000'000, '(') + "\" }");
}
std::string scenario_values() {
  return scenario(
      R"({ "at": "1s", "set": { "LEVEL": 1e400 } }, { "at": "2s", "force": { "LEVEL": 9007199254740993, "L_P_AGV_O_P1": "yes" } })");
}

std::string scenario_malfunctions() {
  return scenario(R"({ "at": "1s", "start": [ )" + numbered("\"L_P_AGV stuck", "\"", 100'000) +
                  R"( ], "stop": [ "*/ {{x}} %n", "" ] })");
}

constexpr auto kPlant = Input::Kind::plant;
constexpr std::array kPlants{
    Input{kPlant, "an empty file", nothing},
    Input{kPlant, "`{`", brace},
    Input{kPlant, "`[]`", array},
    Input{kPlant, "a million arrays, one in another", deep_arrays},
    Input{kPlant, "a million objects, one in another", deep_objects},
    Input{kPlant, "a comment of 10 MB", deep_comment, true},
    Input{kPlant, "a comment that is never closed", open_comment},
    Input{kPlant, "a name of 50 MB", long_text, true},
    Input{kPlant, "a text of 10 MB that is never closed", open_text, true},
    Input{kPlant, "200,000 devices that the list has not", many_entries, true},
    Input{kPlant, "one key 100,001 times", same_keys, true},
    Input{kPlant, "100,000 unknown keys", unknown_keys, true},
    Input{kPlant, "the number 1e400", numbers},
    Input{kPlant, "the number 2^53 + 1", version},
    Input{kPlant, "`\\ud800`, half a character", surrogate},
    Input{kPlant, "`\\u0000`", nul},
    Input{kPlant, "ill-formed UTF-8", ill_formed},
    Input{kPlant, "UTF-16", utf16},
    Input{kPlant, "itself as its symbol list", itself},
    Input{kPlant, "`/etc/passwd` as its symbol list", far_lists, false, "etc/passwd"},
    Input{kPlant, "10,000 lists that are not there", many_lists, false, "none0.csv"},
    Input{kPlant, "plant, types and behaviours called `*/`, `int`, `std::system`, ESC", names},
    Input{kPlant, "names of 20,000 characters", long_names},
    Input{kPlant, "patterns of 20,000 `*`", patterns},
    Input{kPlant, "20,000 patterns", many_patterns, true},
    Input{kPlant, "times beyond 64 bits, below 1 ns, negative", durations},
    Input{kPlant, "20,000 transitions of one device, each with a condition", transitions, true},
    Input{kPlant, "100,000 states of one device", states, true},
    Input{kPlant, "20,000 requirements", requirements, true},
    Input{kPlant, "20,000 malfunctions that become each other", malfunctions, true},
    Input{kPlant, "malfunctions called `*/`, `int`, bidi characters, and 20,000 `x`", malfunction_names},
    Input{kPlant, "20,000 rules to be ignored", settings, true},
    Input{kPlant, "links that lead nowhere", links},
    Input{kPlant, "a layout of 100,000 devices that the plant has not", layout, true},
    Input{kPlant, "groups and cameras called `*/`, `{{x}}`, `\\\\`", layout_names},
    Input{kPlant, "a model `/etc/passwd`, and 20,000 bindings to values that are not there", scene_bindings},
    Input{kPlant, "a condition of a million parentheses", deep_condition, true},
    Input{kPlant, "a condition of 256 parentheses", nested_condition},
    Input{kPlant, "a condition of 100,000 parts", long_condition, true},
    Input{kPlant, "a million `not`", long_chain, true},
    Input{kPlant, "256 `not (`", alternating},
    Input{kPlant, "a condition with a name of 10 MB", long_name_condition, true},
    Input{kPlant, "a condition with a number of 10 MB", long_number_condition, true},
    Input{kPlant, "a condition with the number 1e999999999999999999999", far_exponent},
    Input{kPlant, "a condition with half a character", no_utf8_condition},
    Input{kPlant, "a condition of 2,000 parts that all look at one number", tangled_condition, true},
};

constexpr auto kScenario = Input::Kind::scenario;
constexpr std::array kScenarios{
    Input{kScenario, "an empty file", nothing},
    Input{kScenario, "`[]`", array},
    Input{kScenario, "a million arrays, one in another", scenario_deep},
    Input{kScenario, "100,000 steps that expect in vain", scenario_long, true},
    Input{kScenario, "names with `*/`, `{{`, `%n`, ESC, bidi characters", scenario_names},
    Input{kScenario, "times beyond 64 bits, negative", scenario_times},
    Input{kScenario, "times that add up to more than 292 years", scenario_far},
    Input{kScenario, "a condition of a million parentheses", scenario_condition, true},
    Input{kScenario, "100,002 malfunctions that the plant has not", scenario_malfunctions, true},
    Input{kScenario, "values that their symbols cannot hold", scenario_values},
};

}  // namespace

std::span<const Input> plant_inputs() { return kPlants; }
std::span<const Input> scenario_inputs() { return kScenarios; }

std::vector<Input> inputs() {
  std::vector<Input> all;
  for (const auto part : {list_inputs(), name_inputs(), plant_inputs(), scenario_inputs()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

}  // namespace symplant::hostile
