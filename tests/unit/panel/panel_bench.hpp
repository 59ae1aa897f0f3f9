// A plant with its panel, and clients of the panel.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "support/http_client.hpp"
#include "support/plant_bench.hpp"
#include "support/strings.hpp"
#include "support/temporary_folder.hpp"
#include "symplant/host/console.hpp"
#include "symplant/host/panel_run.hpp"
#include "symplant/host/stage.hpp"
#include "symplant/scenario/read_scenario.hpp"

namespace symplant::test {

using Json = nlohmann::json;

/// What a bench is made of.
struct PanelPlan {
  std::vector<std::string> names = {"AGV_I_P1",     "AGV_I_P2",     "AGV_O_P2", "AGV_O_P1",
                                    "DOOR_I_SHUT1", "DOOR_I_OPEN2", "EYE_I_ON"};
  Reported reported = {};
  panel::PanelOptions options = {.address = "127.0.0.1:0"};
  std::string scenario = {};                     ///< its steps; empty: none
  std::vector<std::string> exercise_files = {};  ///< paths
  bool with_plc = false;
};

/// A plant that a thread runs in cycles of 1 ms, as fast as 1 ms of the clock or faster, with a panel on a free port.
class PanelBench {
 public:
  explicit PanelBench(const PanelPlan& plan = {})
      : tables(plan.names, plan.reported),
        names(tables.rows),
        console_(out_, err_),
        streams_{out_, err_, out_, console_} {
    options_.panel = plan.options;
    options_.exercises = plan.exercise_files;
    options_.trace = folder / "trace.jsonl";
    carried_.resize(tables.rows.symbols.size());
    if (!plan.scenario.empty()) {
      scenario_ = scenario::read_scenario(R"({"symplant-scenario":1,"steps":[)" + plan.scenario + "]}", names, carried_)
                      .scenario;
      REQUIRE(scenario_);
    }
    const scenario::Scenario* const played = scenario_ ? &*scenario_ : nullptr;
    stage.emplace(program_, options_, names, played, false, streams_);
    stage->advance_to(0);
    REQUIRE(stage->outputs.open(stage->plant.model_hash(), err_));
    const int code = host::open_panel(
        {program_, options_, names, carried_, played, links_, plan.with_plc, false, plan.with_plc, "", console_},
        *stage, out_, err_, panel);
    INFO(err_.str());
    REQUIRE(code == 0);
    const std::string link = out_.str();
    const std::size_t colon = link.rfind(':', link.find("/#"));
    port = static_cast<std::uint16_t>(std::atoi(link.c_str() + colon + 1));
    token = link.substr(link.find("token=") + 6, 32);
    run = get("/api/v1/plant").at("run");
    thread_ = std::thread([this] { cycles(); });
  }
  ~PanelBench() { end(); }
  PanelBench(const PanelBench&) = delete;
  PanelBench& operator=(const PanelBench&) = delete;

  /// Ends the run, and closes the files.
  void end() {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
    if (!panel) return;
    stage->outputs.hide();
    panel.reset();
    stage->outputs.finish(stage->plant.now(), err_);
  }

  /// A request with the headers of the page; `change` may alter them.
  std::string request(const std::string& method, const std::string& target, const std::string& body = "") const {
    return method + " " + target + " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port) + "\r\n" +
           "Authorization: Bearer " + token + "\r\nX-Symplant-Run: " + run +
           "\r\nContent-Type: application/json\r\nContent-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body;
  }
  HttpAnswer send(const std::string& text) const {
    HttpClient client(port);
    client.send(text);
    return client.answer();
  }
  Json get(const std::string& target) const {
    const HttpAnswer answer = send(request("GET", target));
    INFO(answer.head << answer.body);
    REQUIRE(answer.status == 200);
    return Json::parse(answer.body);
  }
  HttpAnswer post(const std::string& acts) const {
    return send(request("POST", "/api/v1/acts", "{\"acts\":[" + acts + "]}"));
  }
  /// Acts that succeed; the plant time of their instant.
  tables::Time act(const std::string& acts) const {
    const HttpAnswer answer = post(acts);
    INFO(answer.body);
    REQUIRE(answer.status == 200);
    return Json::parse(answer.body).at("t");
  }
  Json picture() const { return get("/api/v1/picture"); }
  /// A symbol's value in the picture.
  Json value(const std::string& name) const { return picture().at("symbols").at(tables.symbol(name)).at(0); }
  Json device(const std::string& name) const { return picture().at("devices").at(tables.unit_index(name)); }
  /// Waits until something holds, for at most 20 s.
  void wait_for(const std::function<bool()>& holds) const {
    for (int i = 0; i < 4000; ++i) {
      if (holds()) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    FAIL("it did not happen in 20 s");
  }
  std::string messages() const { return err_.str(); }
  /// While it is held, the plant's thread does nothing.
  void hold(bool held) { held_ = held; }

  BenchTables tables;
  TemporaryFolder folder;
  trace::PlantNames names;
  std::optional<host::Stage> stage;
  std::unique_ptr<panel::Panel> panel;
  std::uint16_t port = 0;
  std::string token;
  std::string run;

 private:
  void cycles() {
    exec::Stepper& stepper = panel->stepper();
    while (!stop_) {
      std::this_thread::sleep_for(std::chrono::microseconds(200));
      if (held_) continue;
      if (stepper.frozen()) {
        stepper.hold();
      } else {
        stepper.advance_to(stage->plant.now() + kMs);
      }
      stage->outputs.drain();
    }
  }

  std::ostringstream out_;
  std::ostringstream err_;
  host::Console console_;
  host::RunStreams streams_;
  host::RunOptions options_;
  host::PlantProgram program_{.tables = tables.rows};
  std::vector<bool> carried_;
  std::optional<scenario::Scenario> scenario_;
  host::Links links_;
  std::atomic<bool> stop_{false};
  std::atomic<bool> held_{false};
  std::thread thread_;
};

}  // namespace symplant::test
