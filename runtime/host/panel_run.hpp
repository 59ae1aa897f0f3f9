// The panel of a run: opens it from the options, and reports links and cycles to it.
#pragma once

#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "symplant/exec/cycle_meter.hpp"
#include "symplant/host/console.hpp"
#include "symplant/host/links.hpp"
#include "symplant/host/stage.hpp"
#include "symplant/panel/panel.hpp"

namespace symplant::host {

/// What the panel of a run is opened with. All must outlive the panel.
struct PanelInput {
  const PlantProgram& program;
  const RunOptions& options;
  const trace::PlantNames& names;
  const std::vector<bool>& carried;
  const scenario::Scenario* scenario;  ///< may be null
  const Links& links;
  bool with_plc;
  bool by_plc_clock;
  bool real;            ///< in real time; else the panel sets the speed
  std::string resumed;  ///< the name of the snapshot; empty: none
  Console& console;     ///< for messages while it serves
};

/// Opens the panel and prints its link on `out`; 0, or the exit code of a failure with a message on `err`. Without
/// `--panel` it does nothing and returns 0.
int open_panel(const PanelInput& input, Stage& stage, std::ostream& out, std::ostream& err,
               std::unique_ptr<panel::Panel>& panel);

/// The links and the cycle of a run, for its panel. The meter may be null.
class PanelStatus {
 public:
  PanelStatus(const Links& links, const exec::CycleMeter* meter) : links_(links), meter_(meter) {}

  /// The JSON members `links` and `cycle` of the stream. To be called about once a second, by one thread. O(links and
  /// buckets).
  std::string text();
  /// The states of the links in the last cycle, as far as the meter has them. For any thread.
  std::vector<exec::LinkState> states() const;

 private:
  const Links& links_;
  const exec::CycleMeter* meter_;
  std::vector<std::uint64_t> requests_;  ///< at the last call
  std::vector<double> since_;            ///< of each link: seconds without a request
};

}  // namespace symplant::host
