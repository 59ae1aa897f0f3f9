// User code for units of the reference: the same members as engine::Behaviour and engine::BehaviourView, so
// that one templated test behaviour serves both.
#pragma once

#include <cstdint>

#include "symplant/tables/time.hpp"

namespace symplant::reference {

struct Round;

/// A unit as its behavior sees it. Members as in engine::BehaviourView.
class View {
 public:
  View(Round& round, std::uint32_t unit) : round_(round), unit_(unit) {}

  tables::Time now() const noexcept;
  std::uint8_t state() const noexcept;
  std::uint8_t target() const noexcept;
  bool moving() const noexcept;
  bool operation(std::uint8_t operation) const noexcept;
  bool event(std::uint8_t event) const noexcept;
  bool input(std::uint32_t input) const noexcept;
  std::uint64_t value(std::uint32_t value) const noexcept;
  bool quality() const noexcept;

  void set_event(std::uint8_t event, bool on) noexcept;
  void set_value(std::uint32_t value, std::uint64_t bits) noexcept;
  void wake_at(tables::Time time) noexcept;
  std::uint64_t draw() noexcept;
  template <class Memory>
  Memory& memory() noexcept {
    return *static_cast<Memory*>(memory_bytes());
  }

 private:
  void* memory_bytes() noexcept;

  Round& round_;
  std::uint32_t unit_;
};

/// Null: the model's own rule.
struct Behaviour {
  std::uint32_t memory_size = 0;                                              ///< a multiple of 8
  tables::Time (*takes)(View&, std::uint16_t transition) noexcept = nullptr;  ///< 0xFFFF: spring return
  tables::Time (*after)(View&, std::uint16_t transition) noexcept = nullptr;
  std::uint8_t (*wanted)(View&) noexcept = nullptr;  ///< tables::kNoState: none
  void (*entered)(View&, std::uint8_t state) noexcept = nullptr;
  void (*left)(View&, std::uint8_t state) noexcept = nullptr;
  void (*woken)(View&) noexcept = nullptr;
  void (*started)(View&) noexcept = nullptr;
};

}  // namespace symplant::reference
