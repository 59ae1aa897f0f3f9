// The layout of the plan, pictures and models, and the trainer's camera.
#include "symplant/panel/scene/scene.hpp"

#include <fstream>

#include "description/plant_schema.hpp"
#include "symplant/panel/scene/files.hpp"
#include "unit/panel/panel_bench.hpp"

namespace symplant::test {
namespace {

constexpr const char* kLayout = "/api/v1/layout";

/// A panel with a folder for files, and links for all roles.
struct FilesBench {
  explicit FilesBench(panel::View view = {}) : bench(plan(view)) {}
  PanelPlan plan(const panel::View& view) const {
    PanelPlan plan = with_fixture();
    plan.view = view;
    plan.options.files = folder / "";
    plan.options.trainees = true;
    return plan;
  }
  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder / name, std::ios::binary) << bytes;
  }
  HttpAnswer get(const std::string& path) const { return bench.send(bench.request("GET", "/api/v1/" + path)); }
  HttpAnswer save(const std::string& body) const { return bench.send(bench.request("POST", kLayout, body)); }
  HttpAnswer as(std::size_t role, const std::string& method, const std::string& path, const std::string& body) const {
    std::string request = bench.request(method, "/api/v1/" + path, body);
    request.replace(request.find(bench.token), bench.token.size(), bench.tokens[role]);
    return bench.send(request);
  }

  TemporaryFolder folder;
  PanelBench bench;
};

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST_CASE("A saved layout is in the folder, is sent to everyone, and is the layout of the next start") {
  const FilesBench files;
  CHECK(files.bench.get(kLayout) == Json::parse(R"({"revision":0,"plan":{}})"));
  CHECK(files.bench.picture().at("layout") == 0);
  const std::string plan =
      R"({"devices":{"L_P_AGV":{"x":1,"y":2.5,"turn":90,"group":"Safety"}},)"
      R"("frames":{"L P":{"x":0,"y":0},"Safety":{"x":9,"y":-3}},"locations":{"FIXTURE":{"x":4,"y":4}}})";
  const HttpAnswer answer = files.save(R"({"plan":)" + plan + "}");
  INFO(answer.body);
  REQUIRE(answer.status == 200);
  CHECK(Json::parse(answer.body).at("file") == files.folder / "layout.json");
  CHECK(files.bench.get(kLayout) == Json::parse(R"({"revision":1,"plan":)" + plan + "}"));
  CHECK(files.bench.picture().at("layout") == 1);
  CHECK(Json::parse(text_of(files.folder / "layout.json")) == Json::parse(R"({"symplant":1,"plan":)" + plan + "}"));
}

TEST_CASE("A layout with a wrong name or number changes nothing") {
  const FilesBench files;
  const auto refused = [&](const std::string& plan) {
    const HttpAnswer answer = files.save(R"({"plan":)" + plan + "}");
    CHECK(answer.status == 422);
    return Json::parse(answer.body).at("error").get<std::string>();
  };
  CHECK(refused(R"({"devices":{"L_P_AGX":{"x":1,"y":2}}})") == "device `L_P_AGX` not found; did you mean `L_P_AGV`?");
  CHECK(refused(R"({"frames":{"Safety":{"x":1,"y":2}}})") == "station or group `Safety` not found");
  CHECK(refused(R"({"locations":{"FIXTUR":{"x":1,"y":2}}})") ==
        "track or place `FIXTUR` not found; did you mean `FIXTURE`?");
  CHECK(contains(refused(R"({"devices":{"L_P_AGV":{"x":1e9,"y":2}}})"), "/plan/devices/L_P_AGV/x"));
  CHECK(contains(refused(R"({"devices":[]})"), "/plan/devices"));
  CHECK(contains(refused(R"({"moons":{}})"), "moons"));
  CHECK(contains(refused(R"({"background":{"file":"../hall.svg","x":0,"y":0,"width":9}})"), "../hall.svg"));
  CHECK(files.save("{").status == 400);
  CHECK(files.save(std::string(500, '[')).status == 400);
  CHECK(files.save(R"({"plan":{},"plan":{}})").status == 400);
  CHECK(files.bench.get(kLayout).at("revision") == 0);
  CHECK(text_of(files.folder / "layout.json") == "");
}

TEST_CASE("A layout that is based on an older one is refused, and a saved one is in the log of acts") {
  const FilesBench files;
  CHECK(files.save(R"({"plan":{},"revision":0})").status == 200);
  const HttpAnswer older = files.save(R"({"plan":{"frames":{"L P":{"x":1,"y":1}}},"revision":0})");
  CHECK(older.status == 422);
  CHECK(contains(older.body, "another layout was saved meanwhile"));
  CHECK(files.bench.get(kLayout) == Json::parse(R"({"revision":1,"plan":{}})"));
  CHECK(files.save(R"({"plan":{},"revision":1})").status == 200);
  CHECK(files.bench.picture().at("acts").back().at("act") == Json::parse(R"({"layout":"saved"})"));
}

TEST_CASE("Only the trainer saves a layout and switches the camera") {
  const FilesBench files({.view3d = R"({"cameras":{"gate":{"from":[5,3,5],"to":[0,0,0]}}})"});
  for (const std::size_t role : {std::size_t{0}, std::size_t{1}}) {
    CHECK(files.as(role, "POST", "layout", R"({"plan":{}})").status == 403);
    CHECK(files.as(role, "POST", "acts", R"({"acts":[{"camera":"gate"}]})").status == 403);
    CHECK(files.as(role, "GET", "layout", "").status == 200);
  }
  CHECK(files.bench.picture().at("camera").is_null());
  files.bench.act(R"({"camera":"gate"})");
  CHECK(files.bench.picture().at("camera") == Json::parse(R"({"n":1,"name":"gate"})"));
  files.bench.act(R"({"camera":""})");
  CHECK(files.bench.picture().at("camera") == Json::parse(R"({"n":2,"name":""})"));
  const HttpAnswer unknown = files.bench.post(R"({"camera":"gaet"})");
  CHECK(unknown.status == 422);
  CHECK(contains(unknown.body, "did you mean `gate`?"));
  CHECK(files.bench.post(R"({"camera":3})").status == 422);
}

TEST_CASE("Pictures and models are read by their plain names, and no other file") {
  const FilesBench files;
  files.write("hall.svg", "<svg/>");
  files.write("cell.glb", "glTF");
  files.write("secret.json", "{}");
  files.write(".hidden.svg", "<svg/>");
  CHECK(files.bench.get("/api/v1/files") == Json::parse(R"({"files":["cell.glb","hall.svg"]})"));
  const HttpAnswer picture = files.get("files/hall.svg");
  CHECK(picture.body == "<svg/>");
  CHECK(contains(picture.head, "Content-Type: image/svg+xml"));
  CHECK(contains(picture.head, "Content-Security-Policy: sandbox"));
  CHECK(contains(files.get("files/cell.glb").head, "Content-Type: model/gltf-binary"));
  for (const char* const name :
       {"secret.json", ".hidden.svg", "..%2Fhall.svg", "%2Fetc%2Fpasswd", "sub/x.svg", "no.png", ""}) {
    INFO(name);
    CHECK(files.get(std::string("files/") + name).status == 404);
  }
}

TEST_CASE("A file that changes is read again") {
  const FilesBench files;
  files.write("hall.svg", "<svg/>");
  CHECK(files.get("files/hall.svg").body == "<svg/>");
  files.write("hall.svg", "<svg></svg>");
  CHECK(files.get("files/hall.svg").body == "<svg></svg>");
  std::filesystem::remove(files.folder / "hall.svg");
  CHECK(files.get("files/hall.svg").status == 404);
}

TEST_CASE("The list of files is cut after 1000 names") {
  const TemporaryFolder folder;
  for (int i = 1'002; i-- > 0;) folder.write(std::to_string(1'000 + i) + ".svg", "");
  const Json names = Json::parse(panel::SceneFiles({folder.path()}).list()).at("files");
  CHECK(names.size() == 1'000);
  CHECK(names.back() == "1999.svg");
}

TEST_CASE("A model that is larger than 32 MiB is refused") {
  const FilesBench files;
  files.write("large.glb", "");
  std::filesystem::resize_file(files.folder / "large.glb", panel::kMostFileBytes + 1);
  const HttpAnswer answer = files.get("files/large.glb");
  CHECK(answer.status == 422);
  CHECK(contains(answer.body, "larger than 32 MiB"));
}

TEST_CASE("A layout may be longer than an act, up to 1 MiB") {
  const FilesBench files;
  const std::string blanks(100'000, ' ');
  CHECK(files.save(blanks + R"({"plan":{}})").status == 200);
  CHECK(files.bench.send(files.bench.request("POST", "/api/v1/acts", blanks + R"({"acts":[{"run":true}]})")).status ==
        413);
  CHECK(files.save(std::string(panel::kLongestLayout, ' ') + R"({"plan":{}})").status == 413);
}

TEST_CASE("Without a folder a layout is only for the clients") {
  const PanelBench bench;
  const HttpAnswer answer = bench.send(bench.request("POST", kLayout, R"({"plan":{"frames":{"L P":{"x":1,"y":1}}}})"));
  CHECK(answer.status == 200);
  CHECK(Json::parse(answer.body) == Json::parse(R"({"file":null})"));
  CHECK(bench.get(kLayout).at("revision") == 1);
}

TEST_CASE("The form of a saved layout is that of `plan` in plant.json") {
  const Json saved = Json::parse(panel::layout_schema());
  const Json plant = Json::parse(description::plant_schema());
  for (const char* const name : {"plan", "coordinate", "quarter_turn"}) {
    CHECK(saved.at("definitions").at(name) == plant.at("definitions").at(name));
  }
}

}  // namespace
}  // namespace symplant::test
