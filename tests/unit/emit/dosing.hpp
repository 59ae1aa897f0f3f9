// The plant of examples/scale as a description in code: two scales with a behavior, a hopper.
#pragma once

#include <string>

#include "emit_support.hpp"
#include "lower/lower.hpp"

namespace symplant::test {

inline description::Description dosing_description() {
  description::Description description;
  for (const char* path : {"L1_DOSE_SCALE1", "L1_DOSE_SCALE2"}) {
    description::DeviceDescription scale;
    scale.path = path;
    scale.type = "Scale";
    scale.behaviour = "WeighingScale";
    scale.inputs = {{"hopper_open", "L1_DOSE_HOPPER.OPEN"}};
    description::GivenTransition emptying;
    emptying.from = "FULL2";
    emptying.to = "EMPTY1";
    emptying.takes = description::Duration::fixed(1500 * tables::kMillisecond);
    scale.transitions = {emptying};
    description.devices.push_back(std::move(scale));
  }
  return description;
}

inline CompiledText dosing() {
  const std::string list = read_bytes(kSource + "/examples/scale/dosing.csv");
  Analysed analysed = analyse_lists({{"dosing.csv", list}}, dosing_description());
  analysed.derived->plant.name = "dosing";
  return lower_analysed(std::move(analysed));
}

}  // namespace symplant::test
