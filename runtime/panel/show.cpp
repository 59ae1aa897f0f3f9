// Shows a trace file in the panel's page.
#include "symplant/panel/show.hpp"

#include <chrono>
#include <thread>
#include <utility>

#include "symplant/panel/recording/recording.hpp"
#include "symplant/panel/web/open_port.hpp"
#include "symplant/panel/web/server.hpp"

namespace symplant::panel {

std::optional<link::LinkError> show(const PanelOptions& options, trace::ReadTrace trace, const trace::PlantNames& names,
                                    const View& view, std::uint64_t model_hash,
                                    const std::function<void(const std::string& link)>& begun,
                                    const std::function<bool()>& stop, PanelLog log) {
  auto opened = open_port(options);
  if (auto* error = std::get_if<link::LinkError>(&opened)) return std::move(*error);
  auto& open = std::get<OpenPort>(opened);
  Recording recording(std::move(trace), names, view, model_hash, SceneFiles({options.files, std::string(view.folder)}));
  Routes routes(recording, open.access);
  Guard guard(std::move(log));
  const Server server(std::move(open.listener), routes, recording, guard, options.patience, [] {});
  begun(open.access.link(Role::trainer));
  while (!stop()) std::this_thread::sleep_for(std::chrono::milliseconds(100));
  return std::nullopt;
}

}  // namespace symplant::panel
