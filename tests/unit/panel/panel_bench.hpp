// A plant with its panel, and clients of the panel.
#pragma once

#include <array>
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
#include "support/set_link.hpp"
#include "support/strings.hpp"
#include "support/temporary_folder.hpp"
#include "symplant/host/console.hpp"
#include "symplant/host/panel_run.hpp"
#include "symplant/host/stage.hpp"
#include "symplant/host/why.hpp"
#include "symplant/scenario/read_scenario.hpp"

namespace symplant::test {

using Json = nlohmann::json;

/// What a bench is made of.
struct PanelPlan {
  std::vector<std::string> names = {"AGV_I_P1",     "AGV_I_P2",     "AGV_O_P2", "AGV_O_P1",
                                    "DOOR_I_SHUT1", "DOOR_I_OPEN2", "EYE_I_ON"};
  Reported reported = {};
  std::vector<Row> rows = {};  ///< if there are any: the list, instead of `names`
  panel::View view = {};       ///< must outlive the bench
  panel::PanelOptions options = {.address = "127.0.0.1:0"};
  std::string scenario = {};                     ///< its steps; empty: none
  std::vector<std::string> exercise_files = {};  ///< paths
  bool with_plc = false;
  std::optional<exec::LinkState> link = {};  ///< of a link that carries all symbols; nothing: there is no link
  bool freezes = false;                      ///< the plant, while the link is not live
};

/// BOOL symbols; the names omit `L_P_`.
inline std::vector<Row> rows_of(std::vector<std::string> names) {
  for (std::string& name : names) name.insert(0, "L_P_");
  return bits(names);
}

/// A plant with a place for one part.
inline PanelPlan with_fixture() {
  PanelPlan plan;
  description::GivenMaterial& material = plan.reported.description.material;
  material.kinds.push_back({"raw", 200'000, 1});
  material.kinds.push_back({"machined", 200'000, 2});
  description::GivenPlace place;
  place.name = "FIXTURE";
  place.holds = 1;
  material.places.push_back(place);
  return plan;
}

/// A plant that a thread runs in cycles of 1 ms, as fast as 1 ms of the clock or faster, with a panel on a free port.
class PanelBench {
 public:
  explicit PanelBench(const PanelPlan& plan = {})
      : tables(plan.reported, plan.rows.empty() ? rows_of(plan.names) : plan.rows),
        names(tables.rows),
        console_(out_, err_),
        streams_{out_, err_, out_, console_},
        program_{.tables = tables.rows, .view = plan.view} {
    options_.panel = plan.options;
    options_.exercises = plan.exercise_files;
    options_.trace = folder / "trace.jsonl";
    carried_.resize(tables.rows.symbols.size(), plan.link.has_value());
    if (plan.link) add_link(*plan.link, plan.freezes);
    if (!plan.scenario.empty()) {
      scenario_ = scenario::read_scenario(R"({"symplant-scenario":1,"steps":[)" + plan.scenario + "]}", names, carried_)
                      .scenario;
      REQUIRE(scenario_);
    }
    const scenario::Scenario* const played = scenario_ ? &*scenario_ : nullptr;
    stage.emplace(program_, options_, names, played, false, streams_);
    stage->advance_to(0);
    REQUIRE(stage->outputs.open(stage->plant.model_hash(), 0, err_));
    const int code = host::open_panel(
        {program_, options_, names, carried_, played, links_, plan.with_plc, false, plan.with_plc, "", console_},
        *stage, out_, err_, panel);
    INFO(err_.str());
    REQUIRE(code == 0);
    if (plan.link) panel->set_links([state = *plan.link] { return std::vector{state}; });
    const std::string link = out_.str();
    const std::size_t colon = link.rfind(':', link.find("/#"));
    port = static_cast<std::uint16_t>(std::atoi(link.c_str() + colon + 1));
    token = link.substr(link.find("token=") + 6, 32);
    if (plan.options.trainees) {
      const auto token_after = [&](const std::string& words) {
        return link.substr(link.find("token=", link.find(words)) + 6, 32);
      };
      tokens = {token_after("panel, viewer"), token_after("panel, trainee"), token};
    }
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
  /// What the panel says about a name.
  std::string why(const std::string& name) const { return get("/api/v1/why?name=" + name).at("text"); }
  /// What `--why` says about it at the end of the run, which comes now.
  std::string why_at_the_end(const std::string& name) {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
    stage->outputs.drain();
    std::ostringstream none;
    const auto questions = host::questions_of({name}, names, none);
    REQUIRE(questions);
    std::string text;
    for (const host::Answer& answer :
         host::answers_to(*questions, *stage, {links_, carried_, panel->playing(), panel->frozen()})) {
      for (const std::string& line : why::lines_of(answer.explanation)) text += line + "\n";
    }
    return text;
  }
  /// While it is held, the plant's thread does nothing.
  void hold(bool held) { held_ = held; }

  BenchTables tables;
  TemporaryFolder folder;
  trace::PlantNames names;
  std::optional<host::Stage> stage;
  std::unique_ptr<panel::Panel> panel;
  std::uint16_t port = 0;
  std::string token;                  ///< of the trainer; requests have it
  std::array<std::string, 3> tokens;  ///< by role, with PanelOptions::trainees
  std::string run;

 private:
  void add_link(exec::LinkState state, bool freezes) {
    auto link = std::make_unique<SetLink>();
    link->now = state;
    link::LinkSettings settings;
    if (freezes) settings.plant_on_loss = link::PlantOnLoss::freeze;
    links_.push_back({"", {"", 0, settings}, std::move(link)});
    names.name_links(host::named_links(links_));
  }
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
  host::PlantProgram program_;
  std::vector<bool> carried_;
  std::optional<scenario::Scenario> scenario_;
  host::Links links_;
  std::atomic<bool> stop_{false};
  std::atomic<bool> held_{false};
  std::thread thread_;
};

}  // namespace symplant::test
