// The panel over a small plant, and over a recording of it, without a network.
#include "fuzz/http_plant.hpp"

#include <boost/asio/buffer.hpp>
#include <boost/beast/http/parser.hpp>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <sstream>
#include <utility>
#include <variant>
#include <vector>

#include "app/pipeline.hpp"
#include "support/memory_file_system.hpp"
#include "symplant/panel/live_source.hpp"
#include "symplant/panel/picture/describe.hpp"
#include "symplant/panel/recording/recording.hpp"
#include "symplant/panel/web/request.hpp"
#include "symplant/scenario/act.hpp"
#include "symplant/scenario/read_scenario.hpp"

namespace symplant::fuzz {
namespace {

namespace http = boost::beast::http;

constexpr const char* kList =
    "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial\n"
    "VAR_GLOBAL,L_P_AGV_O_P1,Y0,%QX0,BOOL,FALSE\n"
    "VAR_GLOBAL,L_P_AGV_O_P2,Y1,%QX1,BOOL,FALSE\n"
    "VAR_GLOBAL,L_P_AGV_I_P1,X0,%IX0,BOOL,TRUE\n"
    "VAR_GLOBAL,L_P_AGV_I_P2,X1,%IX1,BOOL,FALSE\n"
    "VAR_GLOBAL,L_P_EYE_I_ON,X2,%IX2,BOOL,FALSE\n"
    "VAR_GLOBAL,LEVEL,,%IW10,INT,0\n";
constexpr const char* kPlant = R"({
  "symplant": 1,
  "symbols": ["symbols.csv"],
  "material": {
    "kinds": { "raw": { "length": "200 mm" } },
    "tracks": { "BELT": { "length": "1 m", "drives": [{ "forward": "L_P_AGV.P2", "speed": "0.5 m/s" }], "end": "BOX" } },
    "places": { "BOX": { "holds": 2 } }
  },
  "requirements": [{ "name": "never in P2", "never": "L_P_AGV.P2" }],
  "malfunctions": [{ "name": "eye blind", "force": { "L_P_EYE_I_ON": false }, "lasts": "1s" }]
})";
constexpr const char* kExercise = R"({
  "symplant-scenario": 1,
  "exercise": { "title": "Move", "score": { "expect": 5 } },
  "steps": [{ "plus": "1ms", "text": "Go", "set": { "L_P_AGV_O_P2": true } }, { "wait": "L_P_AGV.P2", "within": "2s" }]
})";
constexpr const char* kTrace = R"({"symplant-trace":1,"model_hash":"00000000000000aa","seed":0}
{"t":0,"symbol":"L_P_AGV_I_P1","value":true}
{"t":1000000,"symbol":"L_P_AGV_O_P2","value":true}
{"t":1000000,"symbol":"L_P_AGV_I_P1","value":false}
{"t":5000000,"symbol":"L_P_AGV_I_P2","value":true}
)";
constexpr int kRounds = 3;  ///< of the plant: the acts of a request are done in the first

std::unique_ptr<app::Compiled> compiled_plant() {
  test::MemoryFileSystem files;
  files.files["symbols.csv"] = kList;
  files.files["plant.json"] = kPlant;
  std::ostringstream err;
  app::Progress progress(err, false);
  diag::Diagnostics diagnostics;
  auto compiled = app::compile({"plant.json", {}, {}}, files, progress, diagnostics);
  if (!compiled || diagnostics.has_errors()) std::abort();
  return std::make_unique<app::Compiled>(std::move(*compiled));
}

/// A plant with its desk, as it is at the start of a run.
struct LivePlant {
  LivePlant(const trace::PlantNames& names, const std::vector<bool>& carried,
            const std::vector<panel::ExerciseFile>& exercises)
      : plant(names.tables()),
        recorder(names.tables(), std::size_t{1} << 12, trace::Recorder::Detail::motions),
        history(names),
        utilization(names, history),
        explainer(names),
        scene(names, {}, ""),
        desk(setup(names, carried, exercises)),
        source(desk, mutex, names, scene, files, [&names](panel::Role role) { return description_of(names, role); }) {
    recorder.attach(plant);
    desk.plant_operator().advance_to(0);
    drain();
  }

  panel::Desk::Setup setup(const trace::PlantNames& names, const std::vector<bool>& carried,
                           const std::vector<panel::ExerciseFile>& exercises) {
    plant.reset(0, 0);
    return {.names = names,
            .plant = plant,
            .recorder = recorder,
            .history = history,
            .utilization = utilization,
            .explainer = explainer,
            .behaviours = {},
            .carried = carried,
            .exercises = exercises,
            .scenario = nullptr,
            .player = nullptr,
            .programs = nullptr,
            .scenario_name = "",
            .folder = "",
            .seed = 0,
            .cycle = 0,
            .with_plc = false,
            .by_plc_clock = false,
            .paced = true,
            .acts = true,
            .resumed = "",
            .view = {},
            .scene = scene};
  }
  static std::string description_of(const trace::PlantNames& names, panel::Role role) {
    std::string json;
    panel::put_plant(json, names, {}, {}, role);
    return json;
  }

  void go_on() {
    panel::Operator& stepper = desk.plant_operator();
    stepper.frozen() ? stepper.hold() : stepper.advance_to(plant.now() + tables::kMillisecond);
    drain();
  }

  void drain() {
    recorder.drain([this](const trace::Record& record) {
      if (record.kind == trace::Record::Kind::note) {
        if (record.of == scenario::kForceNote) {
          history.force(static_cast<std::uint32_t>(record.value / 2), record.value % 2 != 0, record.time);
        }
        desk.note(record);
        return;
      }
      desk.before(record);
      history.apply(record);
      desk.after(record);
      utilization.apply(record);
    });
  }

  plant::OwnedPlant plant;
  trace::Recorder recorder;
  trace::History history;
  trace::Utilization utilization;
  why::Explainer explainer;
  std::mutex mutex;
  panel::Scene scene;
  panel::SceneFiles files{{}};
  panel::Desk desk;
  panel::LiveSource source;
};

}  // namespace

std::string sent_text(std::string_view seed) {
  const std::size_t end = seed.find("\n\n");
  std::string head;
  for (const char c : seed.substr(0, end)) {
    if (c == '\n') head += '\r';
    head += c;
  }
  const std::string_view body = end == seed.npos ? std::string_view() : seed.substr(end + 2);
  const bool has_length =
      head.find("Content-Length") != head.npos || head.find("Transfer-Encoding") != head.npos || body.empty();
  if (!has_length) head += "\r\nContent-Length: " + std::to_string(body.size());
  return head + "\r\n\r\n" + std::string(body);
}

struct HttpPlant::Parts {
  Parts()
      : compiled(compiled_plant()),
        tables(compiled->tables.tables()),
        names(tables),
        carried(tables.symbols.size()),
        access("127.0.0.1", 8137, {"", std::string(kTraineeToken), std::string(kSeedToken)}) {
    auto read = scenario::read_scenario(kExercise, names, carried);
    if (!read.scenario) std::abort();
    exercises.push_back({"move", std::make_shared<const scenario::Scenario>(std::move(*read.scenario))});
  }

  panel::Recording recording() const {
    std::istringstream trace(kTrace);
    return {trace::read_trace(trace, names), names, {}, 0xAA};
  }

  /// The status with which a source answers, after `go_on` was called some times.
  template <class GoOn>
  int ask(panel::Source& source, const panel::Request& request, GoOn go_on) const {
    panel::Routes routes(source, access, std::string(kSeedRun));
    std::optional<panel::Answer> later;
    const panel::Reply reply = routes.answer(request, [&](panel::Answer done) { later = std::move(done); });
    for (int i = 0; i < kRounds; ++i) {
      go_on();
      source.changes(true);
    }
    source.picture(panel::Role::trainer);
    source.picture(panel::Role::trainee);
    if (reply.kind == panel::Reply::Kind::later) return later ? later->status : 0;
    return reply.answer.status;
  }

  std::unique_ptr<app::Compiled> compiled;
  tables::PlantTables tables;
  trace::PlantNames names;
  std::vector<bool> carried;
  std::vector<panel::ExerciseFile> exercises;
  panel::Access access;
};

HttpPlant::HttpPlant() : parts_(std::make_unique<Parts>()) {}

HttpPlant::~HttpPlant() = default;

HttpPlant::Statuses HttpPlant::play(std::string_view request) {
  http::request_parser<http::string_body> parser;
  parser.eager(true);
  boost::beast::error_code error;
  parser.put(boost::asio::buffer(request.data(), request.size()), error);
  if (error || !parser.is_done()) return {};
  const auto read = panel::web::read_request(parser.get());
  if (const auto* answer = std::get_if<panel::Answer>(&read)) return {answer->status, answer->status};
  const auto& asked = std::get<panel::Request>(read);
  LivePlant live(parts_->names, parts_->carried, parts_->exercises);
  panel::Recording recording = parts_->recording();
  Statuses statuses;
  statuses.live = parts_->ask(live.source, asked, [&] { live.go_on(); });
  statuses.recording = parts_->ask(recording, asked, [] {});
  live.desk.end();
  return statuses;
}

}  // namespace symplant::fuzz
