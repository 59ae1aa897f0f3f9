// The page for browsers: its content, and that every name stays in its element.
#include <nlohmann/json.hpp>

#include "flow_support.hpp"

namespace symplant::test {
namespace {

using Json = nlohmann::json;

std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t at = text.find(begin);
  REQUIRE(at != std::string::npos);
  const std::size_t from = at + begin.size();
  return text.substr(from, text.find(end, from) - from);
}

Json data_of(const std::string& page) {
  return Json::parse(between(page, "<script type=\"application/json\" id=\"data\">", "</script>"));
}

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST_CASE("The page needs no other file and may not load anything") {
  const std::string page = render(described_cell(), "html").text;
  CHECK(contains(page,
                 "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
                 "style-src 'unsafe-inline'; script-src 'unsafe-inline'; base-uri 'none'; form-action 'none'\">"));
  CHECK_FALSE(contains(page, " src="));
  CHECK_FALSE(contains(page, "<link"));
  CHECK_FALSE(contains(page, "@import"));
  CHECK_FALSE(contains(page, "url(h"));
  CHECK_FALSE(contains(page, "innerHTML"));
  CHECK_FALSE(contains(page, "https:"));
  CHECK(occurrences(page, "<script") == 2);
  CHECK(occurrences(page, "</script") == 2);
  CHECK(page.ends_with("</html>\n"));
}

TEST_CASE("No name ends the page's script or becomes an element") {
  const std::string page = render(hostile_cell(), "html").text;
  CHECK(occurrences(page, "<script") == 2);
  CHECK(occurrences(page, "</script") == 2);
  CHECK_FALSE(contains(page, "<img"));
  CHECK_FALSE(contains(page, "<b>"));
  CHECK_FALSE(contains(page, "\xE2\x80\xAE"));
  const std::string shown = "</script><img src=x onerror=\"a('&')\">]]>--\\N;<U+202E>%%<U+000A>";
  const Json data = data_of(page);
  CHECK(data.at("units")[0].at("behaviour") == "OwnHarm");
  CHECK(data.at("requirements")[0][0] == shown);
  CHECK(data.at("kinds")[0].at("states")[1][0] == shown);
}

TEST_CASE("The page has the drawings and lists of a material flow, and nothing of it without one") {
  const Json data = data_of(render(plant_with_material(), "html").text);
  const Json& material = data.at("material");
  REQUIRE(material.at("locations").size() == 2);
  CHECK(material.at("locations")[0].at("title") == "CV1: 2 m, gap 10 mm");
  CHECK(material.at("locations")[0].at("width").get<int>() > 700);
  CHECK(contains(material.at("locations")[0].at("shapes").dump(), R"("L_P_PE_I_ON, sees raw, inverted")"));
  CHECK(material.at("locations")[1].at("name") == "FIX");
  CHECK(material.at("kinds").size() == 2);
  CHECK(material.at("transfers") == Json::parse(R"([["pick", "CV1@1 m", "out", "L_P_CV.RUN", "once"]])"));
  CHECK(material.at("work") == Json::parse(R"([["mill", "FIX", "raw", "done", "L_P_CV.RUN"]])"));
  CHECK(material.at("sources") == Json::parse(R"([["feed", "CV1", "raw", "1 s", "1 s", "", "3"]])"));
  CHECK_FALSE(data_of(render(described_cell(), "html").text).contains("material"));
}

TEST_CASE("The page has the values, the signals and the signal flow, and nothing of it without values") {
  const Json data = data_of(render(tank_with_values(), "html").text);
  const Json& values = data.at("values");
  REQUIRE(values.at("list").size() == 9);
  CHECK(values.at("list")[2] == Json::parse(R"(["leak", "l/s", "parameter, at least 0 l/s, starts at 0"])"));
  CHECK(values.at("signals")[0] ==
        Json::parse(R"(["S_T_TANK_I_LEVEL", "level, from 0 to 100 as 0 to 27648, each 10 ms"])"));
  // x, y, width, height, style, lines, all lines, value, device
  const Json& boxes = values.at("boxes");
  const auto box = [&](const std::string& name) {
    for (const Json& each : boxes) {
      if (each[5][0] == name) return each;
    }
    FAIL("no box " << name);
    return Json();
  };
  CHECK(box("level [l]")[7] == 0);
  CHECK(box("level [l]")[8] == -1);
  CHECK(box("level [l]")[6].empty());
  CHECK(box("S_T_TANK_I_LEVEL")[6].size() == 3);
  CHECK(box("S_T_PUMP")[8] == 0);
  CHECK(values.at("arrows").size() == 25);
  for (const Json& arrow : values.at("arrows")) {
    CHECK(arrow[0].get<std::size_t>() < boxes.size());
    CHECK(arrow[1].get<std::size_t>() < boxes.size());
  }
  CHECK_FALSE(data_of(render(described_cell(), "html").text).contains("values"));
}

TEST_CASE("A page of some devices links only to boxes that it has") {
  const Json data = data_of(render(tank_with_values(), "html", {2}).text);
  REQUIRE(data.at("values").at("list").size() == 1);
  CHECK(data.at("values").at("list")[0][0] == "pos");
  CHECK(data.at("values").at("boxes")[0][8] == 0);
  CHECK(data.at("values").at("boxes")[1][7] == 0);
}

TEST_CASE("The title of the page is text, too") {
  CompiledText compiled = compile_text(list_text({{"START", "X1"}}), "a&<b>.csv");
  CHECK(contains(render(compiled, "html").text, "<title>a&amp;&lt;b&gt;</title>"));
}

TEST_CASE("The page contains the whole model") {
  const Json data = data_of(render(described_cell(), "html").text);
  const Json& agv = data.at("units")[0];
  CHECK(agv.at("path") == "L_P_AGV");
  CHECK(agv.at("conditions") == Json({"not (L_P_MC.RUN2 or L_Q_DOOR.OPEN1) and LEVEL < 2.5"}));
  CHECK(agv.at("disabledBy") == Json::parse(R"([["L_P_MC", "RUN2"]])"));
  CHECK(agv.at("requirements") == Json({0, 1}));
  const Json& kind = data.at("kinds")[agv.at("kind").get<std::size_t>()];
  CHECK(kind.at("external")[3] ==
        Json::parse(R"edge([1, 2, "O_CHARGE, once", 0, "", "takes 4 s (sigma 100 ms)", 1, "given", 0, ""])edge"));
  CHECK(kind.at("enter")[2] == Json::parse("[[2, 1]]"));
  const Json& layout = data.at("layouts")[kind.at("layout").get<std::size_t>()];
  CHECK(layout.at("arrows").size() == kind.at("edges").size());
  CHECK(layout.at("states").size() == 3);
  const Json& signal = data.at("symbols")[agv.at("operations")[0].get<std::size_t>()];
  CHECK(signal == Json::parse(R"(["L_P_AGV_O_P1", 2, 0, 0, 0, "Y1", "%QX1", "", 0, 0])"));
  const Json& stopper = data.at("units")[2];
  CHECK(stopper.at("inputs") == Json::parse(R"([["part", "L_P_AGV.P2 and not L_P_AGV.moving"]])"));
  CHECK(stopper.at("values").size() == 1);
  CHECK(data.at("requirements")[0][1] == "never L_P_MC.RUN2 and not L_P_AGV.P2");
}

TEST_CASE("Devices of one structure share the page's drawing, with any conditions") {
  std::vector<std::string> names;
  for (int i = 0; i < 50; ++i) {
    for (const char* end : {"_O_ADV1", "_I_ADV1", "_O_RET2", "_I_RET2"})
      names.push_back("L_P_V" + std::to_string(i) + end);
  }
  description::Description description;
  for (int i = 0; i < 2; ++i) {
    description::DeviceDescription device;
    device.path = "L_P_V" + std::to_string(i);
    device.transitions = {transition("ADV1", "RET2")};
    device.transitions[0].when = i == 0 ? "L_P_V7.ADV1" : "L_P_V8.ADV1 and L_P_V9.RET2 or L_P_V10.moving";
    description.devices.push_back(device);
  }
  const Json data = data_of(render(compile_described(bits(names), description), "html").text);
  CHECK(data.at("units").size() == 50);
  CHECK(data.at("kinds").size() == 2);
  CHECK(data.at("layouts").size() == 2);
}

TEST_CASE("A page of some devices contains only their symbols") {
  const CompiledText cell = described_cell();
  const std::string page = render(cell, "html", {2}).text;
  const Json data = data_of(page);
  REQUIRE(data.at("units").size() == 1);
  CHECK(data.at("symbols").size() == 4);
  CHECK(data.at("units")[0].at("operations") == Json::array({0}));
  CHECK(data.at("symbols")[0][0] == "L_Q_STOPPER1_O_ADV");
}

}  // namespace
}  // namespace symplant::test
