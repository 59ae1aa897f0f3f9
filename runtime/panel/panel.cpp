// The panel of a run.
#include "symplant/panel/panel.hpp"

#include <chrono>
#include <utility>

#include "symplant/panel/live_source.hpp"
#include "symplant/panel/operate/desk.hpp"
#include "symplant/panel/scene/files.hpp"
#include "symplant/panel/scene/scene.hpp"
#include "symplant/panel/web/open_port.hpp"
#include "symplant/panel/web/routes.hpp"
#include "symplant/panel/web/server.hpp"

namespace symplant::panel {
using link::LinkError;

struct Panel::Parts {
  Parts(const PanelOptions& chosen, PanelPlant of, Access granted)
      : options(chosen),
        plant(std::move(of)),
        access(std::move(granted)),
        guard(plant.log),
        scene(plant.names, plant.view, options.files),
        files({options.files, std::string(plant.view.folder)}),
        desk({plant.names,
              plant.plant,
              plant.recorder,
              plant.history,
              plant.utilization,
              plant.explainer,
              plant.behaviours,
              plant.carried,
              plant.exercises,
              plant.scenario,
              plant.player,
              plant.programs,
              plant.scenario_name,
              options.files,
              plant.seed,
              plant.cycle,
              plant.with_plc,
              plant.by_plc_clock,
              plant.paced,
              !options.view_only,
              plant.resumed,
              plant.view,
              scene}),
        source(desk, mutex, plant.names, scene, files, [this](Role role) { return description_of(plant, role); }),
        routes(source, access) {}

  static std::string description_of(const PanelPlant& plant, Role role) {
    std::string json;
    put_plant(json, plant.names, plant.view, plant.links, role);
    return json;
  }

  void each_second() {
    const std::lock_guard lock(mutex);
    desk.look_at_time(plant.programs == nullptr ? options.backtrack : 0);  // no state of a program can be kept
    const auto now = std::chrono::steady_clock::now();
    const tables::Time time = desk.plant_operator().now();
    const std::chrono::duration<double> passed = now - last_look;
    if (time >= last_time) desk.note_real_speed(static_cast<double>(time - last_time) / 1e9 / passed.count());
    last_look = now;
    last_time = time;
    source.refresh(ask_status);
  }

  const PanelOptions options;
  const PanelPlant plant;
  const Access access;
  Guard guard;
  std::mutex mutex;
  Scene scene;
  SceneFiles files;
  Desk desk;
  LiveSource source;
  Routes routes;
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
  all.server.emplace(std::move(open.listener), all.routes, all.source, all.guard, options.patience,
                     [&all] { all.each_second(); });
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

std::string Panel::link(Role role) const { return parts_->access.link(role); }

bool Panel::has_trainees() const { return parts_->access.has_role(Role::trainee); }

exec::Stepper& Panel::stepper() { return parts_->desk.plant_operator(); }

tables::Time Panel::next_step() const noexcept { return parts_->desk.plant_operator().next(); }

double Panel::speed() const noexcept { return parts_->desk.speed(); }

Stepping Panel::stepping() const noexcept { return parts_->desk.plant_operator().stepping(); }

std::unique_lock<std::mutex> Panel::lock() { return std::unique_lock(parts_->mutex); }

void Panel::before(const trace::Record& record) { parts_->desk.before(record); }

void Panel::after(const trace::Record& record) { parts_->desk.after(record); }

std::optional<Jump> Panel::note(const trace::Record& record) {
  std::optional<SetBack> back;
  parts_->guard.run("an act", [&] { back = parts_->desk.note(record); });
  if (!back) return std::nullopt;
  return Jump{back->what, std::move(back->name), back->time};
}

std::vector<std::string> Panel::take_acts() { return parts_->desk.take_acts(); }

std::vector<AlarmAct> Panel::take_alarm_acts() { return parts_->desk.take_alarm_acts(); }

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
