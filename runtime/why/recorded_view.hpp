// The state of a plant from the records of its run.
#pragma once

#include "symplant/trace/history.hpp"
#include "symplant/why/state_view.hpp"

namespace symplant::why {

/// States, values and times are those of the history. What records do not have, such as times that run and positions of
/// parts, is read from the plant, if one is given and it is still at that time and, for a unit, in that state.
class RecordedView : public StateView {
 public:
  /// `now` is the time of the records. `plant` may be null, and must be while another thread runs it.
  RecordedView(const trace::History& history, tables::Time now, const plant::Plant* plant)
      : history_(history), now_(now), plant_(plant != nullptr && plant->now() == now ? plant : nullptr) {}

  tables::Time now() const override { return now_; }
  plant::UnitView unit(std::uint32_t unit) const override { return history_.unit(unit); }
  tables::Time unit_since(std::uint32_t unit) const override { return history_.unit_since(unit); }
  std::uint64_t value(std::uint32_t symbol) const override { return history_.value(symbol); }
  tables::Time since(std::uint32_t symbol) const override { return history_.since(symbol); }
  tables::Time rose(std::uint32_t operation) const override { return history_.rose(operation); }
  std::vector<PartState> parts(std::uint32_t location) const override;

  std::span<const trace::History::Malfunction> malfunctions() const override {
    if (!shows_malfunctions()) return {};
    return history_.malfunctions();
  }

  std::optional<double> output(std::uint32_t output) const override;
  std::optional<double> weight(std::uint32_t location) const override;

  std::optional<tables::Time> remaining(std::uint32_t unit) const override;
  std::optional<tables::Time> after_left(std::uint32_t unit, std::uint16_t transition) const override;
  std::optional<bool> is_armed(std::uint32_t operation) const override;
  std::optional<bool> is_pending(std::uint32_t requirement) const override;
  std::optional<bool> is_frozen_track(std::uint32_t track) const override;
  std::optional<plant::TransferView> transfer(std::uint32_t transfer) const override;
  std::optional<plant::SourceView> source(std::uint32_t source) const override;
  std::string forced(std::uint32_t symbol) const override;

 private:
  bool is_exact(std::uint32_t unit) const;

  const trace::History& history_;
  tables::Time now_;
  const plant::Plant* plant_;  ///< null: it is not at that time
};

}  // namespace symplant::why
