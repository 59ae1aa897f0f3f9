// How a recording gets the names, types and directions of the plant.
#include "observe_support.hpp"

namespace symplant::test {
namespace {

recording::Recording table(const std::string& text) {
  std::istringstream file(text);
  recording::ReadRecording read = recording::read_recording(file, "t.csv");
  INFO(read.error);
  REQUIRE(read.error == "");
  return std::move(read.recording);
}

const std::vector<Row> kMelsec = {{"L_P_CL_O_OPEN", "Y0001", "BOOL", "FALSE", ""},
                                  {"L_P_CL_I_OPEN", "X000A", "BOOL", "FALSE", "%IX10"},
                                  {"L_P_CL_I_CLOSED", "", "BOOL", "FALSE", "%IX11"}};

TEST_CASE("A series with an address is the symbol at it, as the list writes it or not") {
  const DescribedPlant plant(kMelsec, "\"devices\": {}");
  const auto& model = plant.compiled().plant;
  const observe::Matched matched = observe::match(model, table("t/ms,y0001,%IX10,%IX11,X000F\n0,0,0,0,0\n"));
  CHECK(matched.symbols == std::vector<std::uint32_t>{plant.symbol("L_P_CL_O_OPEN"), plant.symbol("L_P_CL_I_OPEN"),
                                                      plant.symbol("L_P_CL_I_CLOSED"), observe::kNone});
  REQUIRE(matched.unknown.size() == 1);
  CHECK(matched.unknown[0].name == "X000F");
  CHECK(observe::match(model, table("t/ms,XA,Y1\n0,0,0\n")).unknown.empty());
  CHECK(matched.recorded == std::vector<bool>{true, true, true});
}

TEST_CASE("Of a name and an address of one symbol the name counts") {
  const DescribedPlant plant(kMelsec, "\"devices\": {}");
  const observe::Matched matched =
      observe::match(plant.compiled().plant, table("t/ms,Y0001,L_P_CL_O_OPEN,X000A,%IX10\n0,0,0,0,0\n"));
  CHECK(matched.symbols == std::vector<std::uint32_t>{observe::kNone, plant.symbol("L_P_CL_O_OPEN"),
                                                      plant.symbol("L_P_CL_I_OPEN"), observe::kNone});
  CHECK(matched.unknown.size() == 2);
}

TEST_CASE("Symbols on one address are recorded by the one that the others follow") {
  std::vector<Row> rows = kMelsec;
  rows.push_back({"L_P_CL2_I_OPEN", "X000A", "BOOL", "FALSE", ""});
  const DescribedPlant plant(rows, "\"devices\": {}");
  CHECK(observe::match(plant.compiled().plant, table("t/ms,X000A\n0,0\n")).symbols[0] == plant.symbol("L_P_CL_I_OPEN"));
}

TEST_CASE("A recording that adopts a plant has its names, types and directions, and operations come first") {
  std::vector<Row> rows = kMelsec;
  rows.push_back({"VALVE", "Y0002", "BOOL", "FALSE", ""});
  rows.push_back({"L_P_TANK_I_LEVEL", "K4X20", "INT", "0", ""});
  const DescribedPlant plant(rows, "\"devices\": {}");
  recording::Recording recording = table("t/ms,X000A,Y0002,K4X20,other\n0,0,0,0,0\n10,255,1,1,1\n20,0,1,1,0\n");
  CHECK(recording.order == std::vector<std::uint32_t>{0, 1, 2, 3, 0, 1, 2, 3, 0, 3});
  const observe::Matched matched = observe::adopt(plant.compiled().plant, recording);
  CHECK(matched.unknown.size() == 1);
  CHECK(recording.order == std::vector<std::uint32_t>{1, 0, 2, 3, 1, 0, 2, 3, 0, 3});
  CHECK(recording.series[0].kind == recording::Series::Kind::boolean);
  CHECK(recording.series[0].changes[1].value == 1);
  CHECK(recording.series[2].kind == recording::Series::Kind::number);
  CHECK(recording.series[1].is_operation);
  REQUIRE(recording.index.contains("L_P_CL_I_OPEN"));
  CHECK(recording.index.at("L_P_CL_I_OPEN") == 0);
  CHECK_FALSE(recording.index.contains("X000A"));
  CHECK(recording.series[3].name == "other");
}

}  // namespace
}  // namespace symplant::test
