// Which devices of two plants are one device, and what changed in their models.
#include "diff_support.hpp"

namespace symplant::test {
namespace {

/// The tool on two plants of one list each, with these descriptions after `"symbols"`.
MemoryFileSystem plants(const std::vector<std::string>& before, const std::string& old_more,
                        const std::vector<std::string>& after, const std::string& new_more) {
  MemoryFileSystem files;
  files.files["old/list.csv"] = list_text(bits(before));
  files.files["new/list.csv"] = list_text(bits(after));
  const auto plant = [](const std::string& more) {
    return R"({"symplant": 1, "name": "cell", "symbols": ["list.csv"])" + more + "}";
  };
  files.files["old/plant.json"] = plant(old_more);
  files.files["new/plant.json"] = plant(new_more);
  return files;
}

/// The lines of the tool's text between the head and the last line.
std::string lines_of(MemoryFileSystem files) {
  const ToolRun run = run_tool({"diff", "old/plant.json", "new/plant.json"}, files);
  INFO(run.err);
  CHECK(run.code <= 1);
  const std::size_t begin = run.out.find('\n') + 1;
  const std::size_t end = run.out.rfind('\n', run.out.size() - 2) + 1;
  return end <= begin ? "" : run.out.substr(begin, end - begin);
}

std::string lines_of(const std::vector<std::string>& names, const std::string& before, const std::string& after) {
  return lines_of(plants(names, before, names, after));
}

const std::vector<std::string> kAgv{"L_P_AGV_O_P1", "L_P_AGV_O_P2", "L_P_AGV_I_P1", "L_P_AGV_I_P2"};

std::vector<std::string> with(std::vector<std::string> names, const std::vector<std::string>& more) {
  names.insert(names.end(), more.begin(), more.end());
  return names;
}

TEST_CASE("diff: A state that a device gains or loses is one line, what follows from it is counted") {
  const auto more = with(kAgv, {"L_P_AGV_O_P3", "L_P_AGV_I_P3"});
  CHECK(contains(lines_of(plants(kAgv, "", more, "")),
                 "1 device with another model\n"
                 "  L_P_AGV  state `P3` (`O_P3, I_P3`) gained; 8 changes follow\n"));
  CHECK(contains(lines_of(plants(more, "", kAgv, "")), "state `P3` (`O_P3, I_P3`) lost; 8 changes"));
}

TEST_CASE("diff: A task that a state gains is its other symbols, and the event and what it switches") {
  const std::vector<std::string> less{"L_P_AGV_O_P1", "L_P_AGV_O_P2", "L_P_AGV_I_P1"};
  const std::string text = lines_of(plants(less, "", kAgv, ""));
  CHECK(contains(text, "  L_P_AGV  state `P2`: `O_P2` -> `O_P2, I_P2`; 3 changes follow\n"));
}

TEST_CASE("diff: The initial state, times, conditions, actuation and disabling") {
  const auto device = [](const std::string& more) { return R"(, "devices": {"L_P_AGV": {)" + more + "}}"; };
  CHECK(lines_of(kAgv, "", device(R"("initial": "P2")")) ==
        "1 device with another model\n  L_P_AGV  initial state `P1` -> `P2`\n");
  CHECK(contains(lines_of(kAgv, "", R"(, "defaults": {"travel": "3s"})"), "travel time `1 s` -> `3 s`"));
  const auto transition = [&](const std::string& more) {
    return device(R"("transitions": [{"from": "P1", "to": "P2")" + more + "}]");
  };
  CHECK(contains(lines_of(kAgv, transition(R"(, "takes": "1s")"), transition(R"(, "takes": "3s")")),
                 "  L_P_AGV  transition `(P1, O_P2) -> P2`: `takes 1 s` -> `takes 3 s`\n"));
  CHECK(contains(lines_of(kAgv, transition(""), transition(R"(, "when": "not L_P_AGV.P2")")),
                 "`takes 1 s` -> `when not L_P_AGV.P2, takes 1 s`"));
  CHECK(contains(lines_of(kAgv, "", device(R"("actuation": "held")")), "actuation `latched` -> `held`"));
  const auto two = with(kAgv, {"L_P_DOOR_I_OPEN", "L_P_DOOR_O_OPEN"});
  CHECK(contains(lines_of(two, "", device(R"("disables": {"P2": ["L_P_DOOR"]})")), "disables `L_P_DOOR in P2` gained"));
}

TEST_CASE("diff: A renamed device is found by its symbols, and conditions on it did not change") {
  const std::string requirement = R"(, "requirements": [{"name": "r", "never": "L_P_%.P2 and not L_P_DOOR.OPEN"}])";
  const auto of = [&](const std::string& name) {
    std::string text = requirement;
    return text.replace(text.find('%'), 1, name);
  };
  const std::vector<std::string> door{"L_P_DOOR_I_OPEN", "L_P_DOOR_O_OPEN"};
  std::vector<std::string> cars = kAgv;
  for (std::string& name : cars) name.replace(4, 3, "CAR");
  const std::string text = lines_of(plants(with(kAgv, door), of("AGV"), with(cars, door), of("CAR")));
  CHECK(contains(text, "1 device renamed\n  L_P_AGV  L_P_CAR\n"));
  CHECK(!contains(text, "another model"));
  CHECK(!contains(text, "of the plant"));
}

TEST_CASE("diff: A device that becomes a small part of a new device is removed, not renamed") {
  const std::vector<std::string> more{"L_P_CAR_O_P1", "L_P_CAR_O_P2", "L_P_CAR_I_P1", "L_P_CAR_I_P2",
                                      "L_P_CAR_O_P3", "L_P_CAR_I_P3", "L_P_CAR_O_P4", "L_P_CAR_I_P4"};
  const std::string text = lines_of(plants(kAgv, "", more, ""));
  CHECK(contains(text, "1 device removed\n  L_P_AGV"));
  CHECK(!contains(text, "device renamed"));
}

TEST_CASE("diff: A renamed task is a renamed state") {
  std::vector<std::string> names = kAgv;
  names[1] = "L_P_AGV_O_HOME";
  names[3] = "L_P_AGV_I_HOME";
  const std::string none = R"(, "devices": {"L_P_AGV": {"initial": "P1"}})";
  CHECK(contains(lines_of(plants(kAgv, none, names, none)),
                 "1 device with another model\n  L_P_AGV  state name `P2` -> `HOME`\n"));
}

TEST_CASE("diff: A symbol that is now in another device is lost under its old task") {
  std::vector<std::string> names = kAgv;
  names[3] = "L_P_OTHER_I_END";
  const std::string text = lines_of(plants(kAgv, "", names, ""));
  CHECK(contains(text, "  L_P_AGV  state `P2`: `O_P2, I_P2` -> `O_P2`; 3 changes follow\n"));
}

TEST_CASE("diff: Devices are added and removed") {
  const auto more = with(kAgv, {"L_P_DOOR_I_OPEN", "L_P_DOOR_O_OPEN"});
  CHECK(contains(lines_of(plants(kAgv, "", more, "")), "1 device added\n  L_P_DOOR  2 symbols, 2 states\n"));
  CHECK(contains(lines_of(plants(more, "", kAgv, "")), "1 device removed\n  L_P_DOOR  2 symbols, 2 states\n"));
}

TEST_CASE("diff: Requirements, followed conditions and the plant's name are parts of the plant") {
  const auto all = with(kAgv, {"START"});
  CHECK(contains(lines_of(kAgv, "", R"(, "requirements": [{"name": "r", "never": "L_P_AGV.P2"}])"),
                 "1 part of the plant changed\n  requirement `r` (`never L_P_AGV.P2`) gained\n"));
  CHECK(contains(lines_of(all, "", R"(, "follow": {"START": "L_P_AGV.P2"})"), "follows `START` (`L_P_AGV.P2`) gained"));
  MemoryFileSystem files = plants(kAgv, "", kAgv, "");
  files.files["new/plant.json"].replace(files.files["new/plant.json"].find("cell"), 4, "line");
  CHECK(contains(lines_of(files), "plant `name`: `cell` -> `line`"));
}

TEST_CASE("diff: Material is compared by its elements") {
  const auto track = [](const std::string& length) {
    return R"(, "material": {"kinds": {"raw": {"length": "200mm"}}, "tracks": {"CV1": {"length": ")" + length +
           R"(", "drives": [{"speed": "100mm/s", "forward": "L_P_AGV.P2"}]}}})";
  };
  CHECK(contains(lines_of(kAgv, track("1m"), track("2m")), "material `track CV1`: `1 m"));
}

TEST_CASE("diff: The model hash does not depend on the names of files, but on the order of rows") {
  MemoryFileSystem files;
  files.files["a.csv"] = list_text(bits(kAgv));
  files.files["b.csv"] = files.files["a.csv"];
  CHECK(run_tool({"diff", "a.csv", "b.csv"}, files).code == 0);
  std::vector<Row> rows = bits(kAgv);
  std::swap(rows[0], rows[1]);
  files.files["b.csv"] = list_text(rows);
  const ToolRun run = run_tool({"diff", "a.csv", "b.csv"}, files);
  CHECK(run.code == 1);
}

}  // namespace
}  // namespace symplant::test
