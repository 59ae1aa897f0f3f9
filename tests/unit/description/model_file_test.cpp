// The nodes of a model of the 3D view, and the bindings to them.
#include <cstdint>

#include "elements/scene/file.hpp"
#include "support/catch.hpp"

namespace symplant::test {
namespace {

std::string word(std::size_t number) {
  std::string bytes;
  for (int i = 0; i < 4; ++i, number >>= 8U) bytes += static_cast<char>(number & 0xFFU);
  return bytes;
}

std::string glb(const std::string& json) {
  return "glTF" + word(2) + word(20 + json.size()) + word(json.size()) + "JSON" + json;
}

std::string paths(const std::string& nodes) {
  const description::ModelReading model = description::read_model(glb(R"({"nodes":)" + nodes + "}"));
  std::string text = model.error;
  for (std::uint32_t node = 0; node < model.nodes.size(); ++node) {
    if (!model.nodes[node].name.empty()) text += description::path_of(model.nodes, node) + "\n";
  }
  return text;
}

std::string faults_of(const std::string& bytes, const std::vector<std::string>& nodes) {
  description::GivenScene scene;
  scene.model = "cell.glb";
  for (const std::string& node : nodes) scene.nodes.push_back({node, "/view3d/nodes/X/node"});
  std::vector<description::DescriptionFault> faults;
  description::check_model(bytes, scene, faults);
  std::string text;
  for (const description::DescriptionFault& fault : faults) text += fault.pointer + ": " + fault.message + "\n";
  return text;
}

constexpr const char* kCell =
    R"([{"name":"Cell","children":[1,2,4]},{"name":"AGV"},{"name":"Crane","children":[3]},{"name":"Boom"},{"children":[5]},{"name":"Boom"}])";

TEST_CASE("A node has the names from its root as its path, nodes without a name left out") {
  CHECK(paths(kCell) == "Cell\nCell/AGV\nCell/Crane\nCell/Crane/Boom\nCell/Boom\n");
}

TEST_CASE("A node of `view3d` is found by its path, or by the end of it") {
  const std::string cell = glb(std::string(R"({"nodes":)") + kCell + "}");
  CHECK(faults_of(cell, {"Cell/AGV", "AGV", "Crane/Boom", "Cell/Boom"}) == "");
  CHECK(faults_of(cell, {"Cell/AGX"}) ==
        "/view3d/nodes/X/node: node `Cell/AGX` of the model not found; did you mean `AGV`?\n");
  CHECK(faults_of(cell, {"oom"}).find("not found") != std::string::npos);
  CHECK(faults_of(cell, {"Boom"})
            .find("several nodes of the model are `Boom`, such as `Cell/Crane/Boom` and `Cell/Boom`") !=
        std::string::npos);
}

TEST_CASE("Only nodes of the scene that is shown are found") {
  const std::string model = glb(
      R"({"scene":1,"scenes":[{"nodes":[0]},{"nodes":[1]}],"nodes":[{"name":"A"},{"name":"B","children":[2]},{"name":"C"}]})");
  CHECK(faults_of(model, {"B", "B/C"}) == "");
  CHECK(faults_of(model, {"A"}).find("node `A` of the model not found") != std::string::npos);
}

TEST_CASE("A file that is no model, or a hostile one, is one fault") {
  const std::string no_model = "/view3d/model: `cell.glb`: it is no binary glTF 2.0; export the model as .glb\n";
  const std::string cell = glb(std::string(R"({"nodes":)") + kCell + "}");
  CHECK(faults_of("", {"A", "B"}) == no_model);
  CHECK(faults_of("solid cube", {"A"}) == no_model);
  for (const std::size_t size : {4U, 12U, 19U, 30U}) CHECK(faults_of(cell.substr(0, size), {"A"}) == no_model);
  std::string version = cell;
  version[4] = 1;
  CHECK(faults_of(version, {"A"}) == no_model);
  std::string length = cell;
  length[15] = '\x7F';
  CHECK(faults_of(length, {"A"}) == no_model);
  CHECK(faults_of(glb("{]"), {"A"}).find("its JSON is not valid") != std::string::npos);
  CHECK(faults_of(glb(std::string(200, '[')), {"A"}).find("its JSON is not valid") != std::string::npos);
  CHECK(paths("{}") == "it has no nodes");
  CHECK(paths(R"([{"name":"A","children":[1]},{"name":"B","children":[0]}])") == "");  // below no root
  const std::string circle = R"({"scenes":[{"nodes":[0]}],"nodes":[{"name":"A","children":[1]},{"children":[0]}]})";
  CHECK(description::read_model(glb(circle)).error == "a node is in its scene twice, or nodes are nested in a circle");
  CHECK(paths("[{\"name\":\"" + std::string(1'001, 'x') + "\"}]") == "a node has a name of more than 1,000 bytes");
  CHECK(paths(R"([{"children":[1,1]},{}])") == "a node has two parents");
  CHECK(paths(R"([{"children":[7]}])") == "a node has a child that the model does not have");
  CHECK(paths(R"([{"children":[-1]}])") == "a node has a child that the model does not have");
  CHECK(paths(R"([{"children":3}])") == "`children` of a node is no array");
  CHECK(paths(R"([1,"x",null,{"name":7}])") == "");
}

TEST_CASE("A model has at most 64 levels and 20,000 nodes") {
  const auto chain = [](std::size_t nodes) {
    std::string json = "[";
    for (std::size_t i = 0; i + 1 < nodes; ++i) json += R"({"name":"N","children":[)" + std::to_string(i + 1) + "]},";
    return json + R"({"name":"N"}])";
  };
  CHECK(paths(chain(64)).find("its nodes") == std::string::npos);
  CHECK(paths(chain(65)) == "its nodes are nested more than 64 deep");
  std::string many = "[{}";
  for (int i = 0; i < 20'000; ++i) many += ",{}";
  CHECK(paths(many + "]") == "it has more than 20,000 nodes");
}

}  // namespace
}  // namespace symplant::test
