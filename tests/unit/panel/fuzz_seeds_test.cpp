// The seeds of the fuzz target `http` reach every route of the interface.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "fuzz/http_plant.hpp"
#include "support/catch.hpp"
#include "symplant/panel/web/page_files.hpp"
#include "unit/panel/request_corpus.hpp"

namespace symplant::test {
namespace {

using Json = nlohmann::json;

/// "GET /api/v1/plant" and so on: what openapi.json describes, each value of a path's parameter separately.
std::set<std::string> documented_routes() {
  const Json openapi = Json::parse(panel::openapi());
  std::set<std::string> routes;
  for (const auto& [path, methods] : openapi.at("paths").items()) {
    for (const auto& [method, operation] : methods.items()) {
      std::string name = method;
      std::transform(name.begin(), name.end(), name.begin(), [](char c) { return static_cast<char>(c - 'a' + 'A'); });
      const std::string begin = name + " " + openapi.at("servers").at(0).at("url").get<std::string>();
      const std::size_t brace = path.find('{');
      if (brace == std::string::npos) {
        routes.insert(begin + path);
        continue;
      }
      const Json& schema = operation.at("parameters").at(0).at("schema");
      if (!schema.contains("enum")) continue;  // files, of which the fuzz target has none
      for (const Json& value : schema.at("enum")) {
        routes.insert(begin + path.substr(0, brace) + value.get<std::string>());
      }
    }
  }
  return routes;
}

/// Method and path of a request.
std::string route_of(const std::string& request) {
  const std::size_t blank = request.find(' ');
  return request.substr(0, std::min(request.find(' ', blank + 1), request.find('?', blank + 1)));
}

TEST_CASE("Each route of openapi.json has a seed of the fuzz target that reaches it") {
  fuzz::HttpPlant plant;
  std::set<std::string> reached;
  for (const auto& [name, seed] : request_seeds()) {
    const fuzz::HttpPlant::Statuses statuses = plant.play(fuzz::sent_text(seed));
    INFO(name);
    CHECK(statuses.live != 0);
    if (statuses.live == 200 || statuses.recording == 200) reached.insert(route_of(seed));
  }
  for (const std::string& route : documented_routes()) {
    INFO(route << ": add a seed to tests/fuzz/corpus/http");
    // A session that does not begin with a snapshot has no `start`.
    const bool is_start = route == "GET /api/v1/session/start";
    CHECK((reached.count(route) == 1 || is_start));
  }
}

TEST_CASE("A seed without a length gets that of its body") {
  CHECK(fuzz::sent_text("GET / HTTP/1.1\nHost: a\n\n") == "GET / HTTP/1.1\r\nHost: a\r\n\r\n");
  CHECK(fuzz::sent_text("POST / HTTP/1.1\nHost: a\n\n{}\n") ==
        "POST / HTTP/1.1\r\nHost: a\r\nContent-Length: 3\r\n\r\n{}\n");
  CHECK(fuzz::sent_text("x") == "x\r\n\r\n");
}

}  // namespace
}  // namespace symplant::test
