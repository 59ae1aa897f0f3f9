// The cycle's side of a link that keeps images.
#include "symplant/link/image/cycle_side.hpp"

#include <utility>

namespace symplant::link::image {

CycleSide::CycleSide(const tables::PlantTables& tables, const Map& map, const LinkSettings& settings,
                     const plant::Plant* plant, RequestWatch* watch)
    : freezes_(settings.plant_on_loss == PlantOnLoss::freeze),
      health_(settings.loss_after, settings.resync),
      images_(tables, map, watch) {
  status_.map_hash = map.hash;
  if (plant != nullptr) images_.write_events(*plant, {.map_hash = status_.map_hash});
}

bool CycleSide::read_operations(plant::Plant& plant, tables::Time now, std::uint64_t signs) noexcept {
  now_ = now;
  images_.take_operations();
  const bool heard = std::exchange(signs_, signs) != signs;
  const Verdict verdict = health_.look(now, heard, images_.is_complete(health_.losses()));
  if (verdict == Verdict::apply) images_.apply_operations(plant);
  if (verdict == Verdict::lose) images_.zero_operations(plant);
  if (health_.state() == exec::LinkState::lost) ++status_.lost_exchanges;
  return verdict == Verdict::lose;
}

void CycleSide::write_events(const plant::Plant& plant, const exec::CycleStatus& status) noexcept {
  status_.cycles = status.cycles + 1;  // this one included
  status_.overruns = status.overruns;
  status_.live = status.live;
  status_.state = plant_state(health_.state(), status.frozen, false);
  images_.write_events(plant, status_, now_);
}

void CycleSide::leave() noexcept {
  status_.state = PlantState::stopping;
  images_.write_status(status_);
}

}  // namespace symplant::link::image
