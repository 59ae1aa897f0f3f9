// A link with the state that a test sets.
#pragma once

#include <string>

#include "symplant/link/link.hpp"

namespace symplant::test {

class SetLink final : public link::Link {
 public:
  std::string url() const override { return "set:"; }
  link::LinkStatus status() const noexcept override { return {}; }
  void read_operations(plant::Plant&, tables::Time) noexcept override {}
  void write_events(const plant::Plant&, const exec::CycleStatus&) noexcept override {}
  exec::LinkState state() const noexcept override { return now; }
  void cut(bool on) noexcept override { is_cut = on; }

  exec::LinkState now = exec::LinkState::waiting;
  bool is_cut = false;
};

}  // namespace symplant::test
