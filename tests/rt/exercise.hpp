// A plant and its actions, prepared so that running the actions uses only the plant.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "property/plant_text.hpp"
#include "symplant/plant/plant.hpp"

namespace symplant::test {

/// What happened, so that a test can check that something happened.
struct Happened {
  long instants = 0;
  long restores = 0;
  long restores_elsewhere = 0;
  long refused_blocks = 0;
  std::array<long, tables::kFindingKinds> findings{};
  std::array<long, tables::kFindingKinds> findings_reported{};
  std::uint64_t digest = 0;  ///< of all values read after every action

  Happened& operator+=(const Happened& other);
};

class Exercise final : private engine::Observer {
 public:
  /// `tables` and `model` must outlive this object.
  Exercise(const model::PlantModel& model, const tables::PlantTables& tables, std::vector<engine::Behaviour> behaviours,
           const std::vector<property::Action>& actions);

  /// Makes two plants in the allocated memory, applies the actions to one or the other, and calls every reader
  /// after each. Calls every member of Plant. The first run advances from instant to instant, a later one advances
  /// through all due instants in one call; all else is the same.
  void run() noexcept;

  const Happened& happened() const { return happened_; }

 private:
  struct Step {
    property::Action::Kind kind;
    std::uint32_t what;
    std::uint64_t value;
    tables::Time time;
    bool at_once;  ///< an advance that is known to end
  };
  using Memory = std::vector<std::max_align_t>;

  static std::span<std::byte> bytes(Memory& memory) { return std::as_writable_bytes(std::span(memory)); }

  void instant(const engine::Instant& instant) noexcept override;
  void finding(const tables::Finding& finding) noexcept override;
  void act(Step& step) noexcept;
  static engine::MalfunctionChange::By by(const Step& step) noexcept;
  void set(const Step& step) noexcept;
  void save() noexcept;
  void restore(const Step& step) noexcept;
  void advance(Step& step) noexcept;
  void read_all() noexcept;
  void add(std::uint64_t value) noexcept;

  const tables::PlantTables& tables_;
  std::vector<engine::Behaviour> behaviours_;
  std::vector<Step> steps_;
  std::vector<tables::PartLocation> locations_;  ///< of put and take, by Step::what
  std::array<Memory, 2> memory_;
  std::vector<std::vector<std::byte>> saves_;
  std::size_t saved_ = 0;
  std::array<std::optional<plant::Plant>, 2> plants_;
  plant::Plant* plant_ = nullptr;
  Happened happened_;
};

}  // namespace symplant::test
