// Faults of the material flow: each entry of plant.json that contradicts itself or the plant.
#include "material_support.hpp"

namespace symplant::test {
namespace {

std::string track_faults(const std::string& members) { return faults(track_with(members)); }
std::string line_faults(const std::string& material) { return faults(line_of(material)); }

std::string drives_faults(const std::string& drives) {
  return faults(line_with(kinds() + R"(, "tracks": {"T": {"length": "3 m", "drives": [)" + drives + "]}}"));
}

TEST_CASE("Tracks and places have one namespace with devices") {
  const auto with = [](const std::string& track, const std::string& place) {
    return faults(line_with(kinds() + R"(, "tracks": {")" + track +
                            R"(": {"length": "3 m", "drives": [{"forward": "S_10_CV1.RUN", "speed": "1 m/s"}]}},
                            "places": {")" +
                            place + "\": {}}"));
  };
  CHECK(with("T", "P") == "");
  CHECK(with("T", "t") == "/material/places/t: `t` already names another track or place; choose another name");
  CHECK(with("s_10_cv1", "P") == "/material/tracks/s_10_cv1: `s_10_cv1` is the name of a device; choose another name");
  CHECK(with("T", "Out") == "/material/places/Out: `Out` is a reserved word; choose another name");
  CHECK(with("T", "part") == "/material/places/part: `part` is a reserved word; choose another name");
  CHECK(with("PARTS", "P") == "/material/tracks/PARTS: `PARTS` is a reserved word; choose another name");
  CHECK(with("", "P") == "/material/tracks/: this name is empty; write a name");
  CHECK(with("A@1", "P") == "/material/tracks/A@1: `A@1` has an `@`, which begins a position; choose another name");
  CHECK(with("T ", "P") == "/material/tracks/T : `T ` begins or ends with a blank; remove it");
}

TEST_CASE("A track with the name of a device is reported once") {
  CHECK(faults(line_with(kinds() + R"(, "tracks": {"S_10_CV1": {"length": "3 m",
          "drives": [{"forward": "S_10_CV1.RUN", "speed": "1 m/s"}], "end": "S_10_CV1"}},
          "sources": [{"name": "s", "at": "S_10_CV1@1 m", "kind": "raw"}])")) ==
        "/material/tracks/S_10_CV1: `S_10_CV1` is the name of a device; choose another name");
}

TEST_CASE("A place may have the name of a device of which a sensor is the only symbol") {
  const Analysed list =
      line_with(kinds() + R"(, "places": {"S_10_FIX1": {"sensors": [{"symbol": "S_10_FIX1_I_PART"}]}})");
  CHECK(faults(list) == "");
  CHECK(names_text(list) == "| S_10_FIX1 | | |");
}

TEST_CASE("Kinds have different names, none of them reserved") {
  const auto with = [](const std::string& kind) {
    return faults(line_with(R"("kinds": {"raw": {"length": "1 mm"}, )" + kind + "}"));
  };
  CHECK(with(R"("RAW": {"length": "1 mm"})") == "/material/kinds/RAW: `RAW` appears twice; remove one");
  CHECK(with(R"("Part": {"length": "1 mm"})") ==
        "/material/kinds/Part: `Part` is a reserved word; choose another name");
}

TEST_CASE("Only the last drive has no `until`, the others are in order within the track") {
  const std::string drive = R"("forward": "S_10_CV1.RUN", "speed": "1 m/s"})";
  CHECK(drives_faults(R"({"until": "1 m", )" + drive + ", {" + drive) == "");
  CHECK(drives_faults(R"({"until": "3 m", )" + drive) ==
        "/material/tracks/T/drives/0/until: the last drive moves parts up to the end of the track; remove `until`");
  CHECK(drives_faults("{" + drive + ", {" + drive) ==
        "/material/tracks/T/drives/0: only the last drive has no `until`; add the position up to which this one moves "
        "parts");
  CHECK(drives_faults(R"({"until": "1 m", )" + drive + R"(, {"until": "1 m", )" + drive + ", {" + drive) ==
        "/material/tracks/T/drives/1/until: the drives are not in order; write an `until` above that of the drive "
        "before this one");
  CHECK(drives_faults(R"({"until": "0 m", )" + drive + ", {" + drive) ==
        "/material/tracks/T/drives/0/until: this drive moves no part; write an `until` above 0");
  CHECK(drives_faults(R"({"until": "3 m", )" + drive + ", {" + drive) == "");  // the last one moves no part
  CHECK(drives_faults(R"({"until": "3001 mm", )" + drive + ", {" + drive) ==
        "/material/tracks/T/drives/0/until: this is beyond the end of the track; write a smaller `until`");
  CHECK(drives_faults(R"({"speed": "1 m/s"})") == "");  // it never moves
}

TEST_CASE("A speed comes from a numeric symbol") {
  const auto of = [](const std::string& symbol) {
    return drives_faults(R"({"forward": "S_10_CV1.RUN", "speed": {"of": ")" + symbol + R"(", "unit": "1 mm/s"}})");
  };
  CHECK(of("S_10_CV1_O_SPEED") == "");
  CHECK(of("S_10_CV1_O_SPED") ==
        "/material/tracks/T/drives/0/speed/of: symbol `S_10_CV1_O_SPED` not found; did you mean `S_10_CV1_O_SPEED`?");
  CHECK(of("S_10_CV1_O_RUN") ==
        "/material/tracks/T/drives/0/speed/of: `S_10_CV1_O_RUN` is BOOL; name a numeric symbol or a value");
}

TEST_CASE("Positions are on the track") {
  const std::string rest = ": this position is beyond the end of track `T`";
  CHECK(track_faults(R"("stops": [{"at": "3000.001 mm", "when": "S_10_STP1.ADV"}])") ==
        "/material/tracks/T/stops/0/at" + rest);
  CHECK(track_faults(R"("sensors": [{"symbol": "S_10_PE1_I_PART", "at": "301 cm"}])") ==
        "/material/tracks/T/sensors/0/at" + rest);
  CHECK(line_faults(R"("sources": [{"name": "s", "at": "T@4 m", "kind": "raw"}])") == "/material/sources/0/at" + rest);
}

TEST_CASE("A kind is not longer than a track, and a track holds at most 1,000 parts") {
  const auto track = [](const std::string& kind, const std::string& length) {
    return faults(line_with(R"("kinds": {"k": {"length": ")" + kind + R"("}}, "tracks": {"T": {"length": ")" + length +
                            R"(", "drives": [{"forward": "S_10_CV1.RUN", "speed": "1 m/s"}]}})"));
  };
  CHECK(track("1 m", "1 m") == "");
  CHECK(track("1.1 m", "1 m") ==
        "/material/tracks/T/length: kind `k` is longer than this track; make the track longer");
  CHECK(track("1 mm", "998 mm") == "");
  CHECK(track("1 mm", "999 mm") ==
        "/material/tracks/T/length: up to 1001 parts fit on this track, more than 1000; divide the track, or make the "
        "parts or the gap longer");
}

TEST_CASE("A location is a track, a position on a track, or a place") {
  const auto from = [](const std::string& location) {
    return line_faults(R"("transfers": [{"name": "n", "from": ")" + location + R"(", "to": "out"}])");
  };
  const std::string here = "/material/transfers/0/from: ";
  CHECK(from("T@3 m") == "");
  CHECK(from("TT") == here + "track or place `TT` not found; did you mean `T`?");
  CHECK(from("S_10_CV1") == here + "track or place `S_10_CV1` not found");
  CHECK(from("P@0 m") == here + "`P` is a place and has no positions; remove `@` and the position");
  const std::string none =
      "the position of `T` is not a length in whole micrometers; write a number and um, mm, cm or m, such as "
      "`T@300 mm`";
  CHECK(from("T@") == here + none);
  CHECK(from("T@1 km") == here + none);
  CHECK(from("T@0.0001 mm") == here + none);
  CHECK(from("out") == here + "`out` is only a target of transfers and of the ends of tracks; name a track or a place");
}

TEST_CASE("A target is a location or `out`, the end of a track names no position") {
  CHECK(line_faults(R"("transfers": [{"name": "n", "from": "P", "to": "out@1 m"}])") ==
        "/material/transfers/0/to: `out` has no positions; remove `@` and the position");
  CHECK(track_faults(R"("end": "T@1 m")") ==
        "/material/tracks/T/end/0/to: parts arrive at the start of a track, not at a position; write `T`");
  CHECK(track_faults(R"("end": [{"to": "out"}, {"to": "X1"}])") ==
        "/material/tracks/T/end/1/to: track or place `X1` not found");
}

TEST_CASE("A transfer from a location to itself is an error") {
  const auto between = [](const std::string& from, const std::string& to) {
    return line_faults(R"("transfers": [{"name": "n", "from": ")" + from + R"(", "to": ")" + to + "\"}]");
  };
  CHECK(between("T", "T@1 m") == "");
  CHECK(between("T@1 m", "T") == "");
  CHECK(between("T@1 m", "t@100 cm") ==
        "/material/transfers/0/to: this transfer moves parts from `T@1 m` to itself; write another location");
  CHECK(between("P", "P") ==
        "/material/transfers/0/to: this transfer moves parts from `P` to itself; write another location");
}

TEST_CASE("Work changes a kind to one of the same length") {
  const auto work = [](const std::string& from, const std::string& to) {
    return line_faults(R"("work": [{"name": "n", "at": "P", "when": "P.part", "from": ")" + from + R"(", "to": ")" +
                       to + "\"}]");
  };
  CHECK(work("raw", "done") == "");
  const description::Pointer entry = description::Pointer("/material") / "work" / 0;
  CHECK(work("raw", "tall") ==
        (entry / "to").text() + ": `tall` and `raw` have different lengths; work cannot change the length of a part");
  CHECK(work("row", "done") == (entry / "from").text() + ": kind of part `row` not found; did you mean `raw`?");
}

TEST_CASE("Kinds of sensors and sources exist") {
  CHECK(track_faults(R"("sensors": [{"symbol": "S_10_PE1_I_PART", "at": "1 m", "kinds": ["raw", "tal"]}])") ==
        "/material/tracks/T/sensors/0/kinds/1: kind of part `tal` not found; did you mean `tall`?");
  CHECK(line_faults(R"("sources": [{"name": "n", "at": "P", "kind": "rax"}])") ==
        "/material/sources/0/kind/0: kind of part `rax` not found; did you mean `raw`?");
}

TEST_CASE("Names of transfers, work and sources are unique in their list") {
  CHECK(line_faults(R"("transfers": [{"name": "n", "from": "P", "to": "T"}, {"name": "N", "from": "T", "to": "P"}],
                       "sources": [{"name": "n", "at": "P", "kind": "raw"}])") ==
        "/material/transfers/1/name: `N` already names another entry of this list; choose another name");
}

TEST_CASE("A sensor drives an input of the PLC, which belongs to no other sensor") {
  const auto sensor = [](const std::string& members, const std::string& before = "") {
    return track_faults("\"sensors\": [" + before + R"({"at": "1 m", "symbol": )" + members + "}]");
  };
  const std::string here = "/material/tracks/T/sensors/0/symbol: ";
  CHECK(sensor("\"S_10_PE3_I_PART\"") == here + "symbol `S_10_PE3_I_PART` not found; did you mean `S_10_PE1_I_PART`?");
  CHECK(sensor("\"S_10_CV1_O_RUN\"") == here + "`S_10_CV1_O_RUN` is an output of the PLC; a sensor drives an input");
  CHECK(sensor("\"s_10_pe1_i_part\"", R"({"at": "2 m", "symbol": "S_10_PE1_I_PART"}, )") ==
        "/material/tracks/T/sensors/1/symbol: `s_10_pe1_i_part` belongs to another sensor too; remove one of the two");
  CHECK(sensor("\"S_10_PE1_I_PART\", \"reads\": \"number\"") == here + "`S_10_PE1_I_PART` is BOOL; remove `reads`");
  CHECK(sensor("\"S_10_RFID_I_CODE\"") ==
        here + "`S_10_RFID_I_CODE` is numeric; add `\"reads\": \"code\"` or `\"reads\": \"number\"`");
  CHECK(sensor("\"S_10_RFID_I_CODE\", \"reads\": \"code\", \"inverted\": true") ==
        here + "`S_10_RFID_I_CODE` is numeric; only BOOL symbols can be `inverted`");
}

TEST_CASE("The codes that a sensor may read fit its type") {
  const auto reader = [](const std::string& type, const std::string& members) {
    std::vector<Row> rows = line_rows();
    rows[rows.size() - 2] = {"S_10_RFID_I_CODE", "", type, "0"};
    return faults(
        line_with(R"("kinds": {"low": {"length": "1 m", "code": 127}, "high": {"length": "1 m", "code": 40000}},
                               "places": {"P": {"sensors": [{"symbol": "S_10_RFID_I_CODE")" +
                      members + "}]}}",
                  "", rows));
  };
  const std::string here = "/material/places/P/sensors/0/symbol: `S_10_RFID_I_CODE` is of type ";
  const std::string code = R"(, "reads": "code")";
  CHECK(reader("INT", code) ==
        here + "INT, which holds at most 32767; the code of `high` is 40000; write a smaller code");
  CHECK(reader("BYTE", code) ==
        here + "BYTE, which holds at most 255; the code of `high` is 40000; write a smaller code");
  CHECK(reader("SINT", code + R"(, "kinds": ["low"])") == "");
  CHECK(reader("INT", code + R"(, "kinds": ["LOW"])") == "");
  CHECK(reader("INT", R"(, "reads": "number")") == "");
  for (const char* type : {"UINT", "WORD", "DINT", "REAL"}) CHECK(reader(type, code) == "");
}

TEST_CASE("A symbol that follows a condition is not a sensor too") {
  CHECK(faults(line_of(R"("work": [], "sources": [])", R"("follow": {"S_10_PE1_I_PART": "T.part"})")) == "");
  CHECK(faults(line_with(kinds() + R"(, "places": {"P": {"sensors": [{"symbol": "S_10_PE1_I_PART"}]}})",
                         R"("follow": {"S_10_PE1_I_PART": "P.part"})")) ==
        "/material/places/P/sensors/0/symbol: `S_10_PE1_I_PART` follows a condition and is a sensor too; remove one of "
        "the two");
}

TEST_CASE("A description that names the task of a sensor is an error") {
  const std::string place = R"(, "places": {"P": {"sensors": [{"symbol": "S_10_STP1_I_PART"}]}})";
  const auto device = [&](const std::string& members) {
    return faults(line_with(kinds() + place, R"("devices": {"S_10_STP1": {)" + members + "}}"));
  };
  CHECK(device(R"("outputs": {"ADV": {"enter": {"PART": true}}})") ==
        "/devices/S_10_STP1/outputs/ADV/enter/PART: event `PART` of `S_10_STP1` not found");
  CHECK(device(R"("initial": "PART")") == "/devices/S_10_STP1/initial: state `PART` of `S_10_STP1` not found");
  CHECK(device(R"("states": ["PART"])") ==
        "/devices/S_10_STP1/states/0: `PART` is the task of `S_10_STP1_I_PART`, which is a sensor of parts; choose "
        "another name");
}

TEST_CASE("A sensor and a device on one address are a finding") {
  std::vector<Row> rows = line_rows();
  rows[12].iec = rows[1].iec;  // PE1 and the feedback of CV1
  const Analysed list = line_with(
      kinds() + R"(, "places": {"P": {"sensors": [{"symbol": "S_10_PE1_I_PART"}, {"symbol": "S_10_PE2_I_TALL"}]}})", "",
      rows);
  CHECK(finding_of(list, "event-driven-twice").message.find("the plant drives each of them") != std::string::npos);
  rows[12].iec = rows[17].iec;  // the button follows it
  const Analysed button =
      line_with(kinds() + R"(, "places": {"P": {"sensors": [{"symbol": "S_10_PE1_I_PART"}]}})", "", rows);
  CHECK(button.count("event-driven-twice") == 0);
  CHECK(button.model().symbols.at(17).leader == 12);
  CHECK(button.count("event-not-driven") == 2);  // PE2 and FIX1, not the button, which has a driver
}

TEST_CASE("Conditions of the material flow are checked") {
  CHECK(drives_faults(R"({"forward": "S_10_CV1.RUM", "speed": "1 m/s"})") ==
        "/material/tracks/T/drives/0/forward: state `RUM` of `S_10_CV1` not found; did you mean `RUN`?");
  CHECK(track_faults(R"("stops": [{"at": "1 m", "when": "S_10_STP1.ADV and"}])")
            .starts_with("/material/tracks/T/stops/0/when: "));
  CHECK(line_faults(R"("transfers": [{"name": "n", "from": "P", "to": "T", "when": "T.rax"}])") ==
        "/material/transfers/0/when: kind of part `rax` not found; did you mean `raw`?");
  CHECK(line_faults(R"("transfers": [{"name": "n", "from": "P", "to": "T", "when": "T2.part"}])") ==
        "/material/transfers/0/when: device `T2` not found; did you mean `T`?");
}

TEST_CASE("Transfers without tracks and places are errors, not ignored") {
  CHECK(faults(line_with(R"("transfers": [{"name": "n", "from": "P", "to": "T"}])")) ==
        "/material/transfers/0/from: track or place `P` not found\n"
        "/material/transfers/0/to: track or place `T` not found");
}

}  // namespace
}  // namespace symplant::test
