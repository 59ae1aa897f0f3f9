// The panel of a run.
#include "symplant/panel/panel.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "symplant/panel/operate/desk.hpp"
#include "symplant/panel/picture/json_text.hpp"
#include "symplant/panel/web/open_port.hpp"
#include "symplant/panel/web/query.hpp"
#include "symplant/panel/web/routes.hpp"
#include "symplant/panel/web/server.hpp"

namespace symplant::panel {
using link::LinkError;

/// The names of the interface over a desk, under its mutex.
struct Panel::Parts final : Source {
  Parts(const PanelOptions& chosen, PanelPlant of, Access granted)
      : options(chosen),
        plant(std::move(of)),
        access(std::move(granted)),
        desk({plant.names, plant.plant, plant.recorder, plant.history, plant.explainer, plant.behaviours, plant.carried,
              plant.exercises, plant.scenario, plant.player, plant.scenario_name, options.files, plant.seed,
              plant.cycle, plant.with_plc, plant.by_plc_clock, plant.paced, !options.view_only, plant.resumed}),
        routes(*this, access) {
    put_plant(description, plant.names, plant.view, plant.links);
  }

  void put_description(std::string& json) override {
    const std::lock_guard guard(mutex);
    desk.put_description(json);
    json += "," + description;
  }
  bool acts() const override { return !options.view_only; }

  std::optional<Reply> get(std::string_view path, const std::map<std::string, std::string>& query,
                           const Answered& later) override {
    const std::lock_guard guard(mutex);
    if (path == "chart") return chart(query);
    if (path == "why") {
      const auto name = query.find("name");
      if (name == query.end()) return Reply{Reply::Kind::now, error_answer(400, "`why` needs a `name`")};
      desk.why(name->second, later);
      return Reply{Reply::Kind::later, {}};
    }
    constexpr std::string_view kSession = "session/";
    if (!path.starts_with(kSession)) return std::nullopt;
    const std::string_view kind = path.substr(kSession.size());
    static const std::map<std::string_view, std::pair<std::string, std::string_view>> kKinds{
        {"scenario", {"session.scenario.json", "application/json"}},
        {"start", {"session.start.snapshot", "application/octet-stream"}},
        {"session", {"session.session.json", "application/json"}},
        {"junit", {"session.junit.xml", "application/xml"}}};
    const auto found = kKinds.find(kind);
    if (found == kKinds.end()) return std::nullopt;
    Reply reply{Reply::Kind::now, desk.session_file(kind)};
    if (reply.answer.status == 200) std::tie(reply.file_name, reply.content_type) = found->second;
    return reply;
  }

  Reply chart(const std::map<std::string, std::string>& query) {
    ChartWish wish;
    if (!read_chart(query, plant.names, wish)) return {Reply::Kind::now, error_answer(400, kChartForm)};
    return {Reply::Kind::now, {200, desk.chart(wish)}};
  }

  void post(std::string_view path, std::string_view body, const Answered& later) override {
    const std::lock_guard guard(mutex);
    path == "check" ? later(desk.check(body)) : desk.request(body, later);
  }

  std::string picture() override {
    const std::lock_guard guard(mutex);
    std::string json = desk.picture();
    json.insert(json.size() - 1, status.empty() ? "" : "," + status);
    return json;
  }

  std::string changes() override {
    const std::lock_guard guard(mutex);
    std::string json = desk.changes();
    if (!std::exchange(status_is_new, false)) return json;
    if (json.empty()) json = desk.beat() + "}";
    json.insert(json.size() - 1, status.empty() ? "" : "," + status);
    return json;
  }

  bool begun_again() override {
    const std::lock_guard guard(mutex);
    return desk.begun_again();
  }

  void each_second() {
    const std::lock_guard guard(mutex);
    desk.look_at_time(options.backtrack);
    const auto now = std::chrono::steady_clock::now();
    const tables::Time time = desk.plant_operator().now();
    const std::chrono::duration<double> passed = now - last_look;
    if (time >= last_time) desk.note_real_speed(static_cast<double>(time - last_time) / 1e9 / passed.count());
    last_look = now;
    last_time = time;
    status_is_new = true;
    if (ask_status) status = ask_status();
  }

  const PanelOptions options;
  const PanelPlant plant;
  const Access access;
  std::mutex mutex;
  Desk desk;
  Routes routes;
  std::string description;  ///< what follows from the tables
  std::string status;       ///< the keys `links` and `cycle`
  bool status_is_new = false;
  std::function<std::string()> ask_status;
  std::chrono::steady_clock::time_point last_look = std::chrono::steady_clock::now();
  tables::Time last_time = 0;
  std::optional<Server> server;  ///< the last member: it uses the others
};

std::variant<std::unique_ptr<Panel>, LinkError> Panel::open(const PanelOptions& options, PanelPlant plant) {
  auto opened = open_port(options);
  if (auto* error = std::get_if<LinkError>(&opened)) return std::move(*error);
  auto& open = std::get<OpenPort>(opened);
  auto parts = std::make_unique<Parts>(options, std::move(plant), std::move(open.access));
  Parts& all = *parts;
  all.server.emplace(std::move(open.listener), all.routes, all, options.patience, [&all] { all.each_second(); });
  return std::unique_ptr<Panel>(new Panel(std::move(parts)));
}

Panel::Panel(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}

Panel::~Panel() {
  {
    const std::lock_guard guard(parts_->mutex);
    parts_->desk.end();
  }
  parts_->server.reset();
}

std::string Panel::link() const { return parts_->access.url() + "#token=" + parts_->access.token(); }

exec::Stepper& Panel::stepper() { return parts_->desk.plant_operator(); }

tables::Time Panel::next_step() const noexcept { return parts_->desk.plant_operator().next(); }

double Panel::speed() const noexcept { return parts_->desk.speed(); }

Stepping Panel::stepping() const noexcept { return parts_->desk.plant_operator().stepping(); }

std::unique_lock<std::mutex> Panel::lock() { return std::unique_lock(parts_->mutex); }

void Panel::before(const trace::Record& record) { parts_->desk.before(record); }

void Panel::after(const trace::Record& record) { parts_->desk.after(record); }

std::optional<Jump> Panel::note(const trace::Record& record) {
  std::optional<SetBack> back = parts_->desk.note(record);
  if (!back) return std::nullopt;
  return Jump{back->what, std::move(back->name), back->time};
}

std::vector<std::string> Panel::take_acts() { return parts_->desk.take_acts(); }

void Panel::finding(const trace::FoundThing& found, const std::string& words) { parts_->desk.finding(found, words); }

void Panel::set_status(std::function<std::string()> status) {
  const std::lock_guard guard(parts_->mutex);
  parts_->ask_status = std::move(status);
}

void Panel::set_links(std::function<std::vector<exec::LinkState>()> states) {
  const std::lock_guard guard(parts_->mutex);
  parts_->desk.set_links(std::move(states));
}

bool Panel::frozen() const { return parts_->desk.plant_operator().frozen(); }

const scenario::Scenario* Panel::playing() const { return parts_->desk.playing(); }

}  // namespace symplant::panel
