// The settings of real time are those of Linux; Windows refuses each one that is requested.
#include "symplant/exec/real_time.hpp"

namespace symplant::exec {

RealTimeSetup set_up_real_time(const RealTimeOptions& options) {
  RealTimeSetup setup;
  const auto refuse = [&](bool wanted, const std::string& option) {
    if (!wanted) return;
    setup.refused.push_back({option, "`--" + option +
                                         "` is refused (symplant has it on Linux only), other programs can delay the "
                                         "cycle: run the plant on Linux, or without the option"});
  };
  refuse(options.lock_memory, "lock-memory");
  refuse(options.cpu.has_value(), "cpu");
  refuse(options.priority.has_value(), "priority");
  refuse(options.stay_awake, "stay-awake");
  return setup;
}

}  // namespace symplant::exec
