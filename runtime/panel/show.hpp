// Shows a trace file in the panel's page.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "symplant/link/link.hpp"
#include "symplant/panel/options.hpp"
#include "symplant/panel/view.hpp"
#include "symplant/panel/web/guard.hpp"
#include "symplant/trace/plant_names.hpp"
#include "symplant/trace/read_trace.hpp"

namespace symplant::panel {

/// Serves a recording. `begun` gets the link; `stop` is asked ten times a second whether to end; `log` gets errors of
/// symplant that requests caused, from another thread.
/// Returns an error, or nothing after the end.
std::optional<link::LinkError> show(const PanelOptions& options, trace::ReadTrace trace, const trace::PlantNames& names,
                                    const View& view, std::uint64_t model_hash,
                                    const std::function<void(const std::string& link)>& begun,
                                    const std::function<bool()>& stop, PanelLog log);

}  // namespace symplant::panel
