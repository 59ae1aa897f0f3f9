// Moves of units from their views.
#include "property/recordings/true_moves.hpp"

namespace symplant::property {

TrueMoves::TrueMoves(const plant::Plant& plant) : plant_(plant), last_(plant.tables().units.size()) {
  for (std::uint32_t u = 0; u < last_.size(); ++u) last_[u].view = plant.unit(u);
}

void TrueMoves::look(std::uint32_t unit, tables::Time now) {
  Last& last = last_[unit];
  const plant::UnitView before = last.view;
  const plant::UnitView view = plant_.unit(unit);
  const bool same = before.moving && view.moving && before.state == view.state && before.target == view.target;
  const bool reversed = before.moving && view.moving && before.state == view.target && before.target == view.state;
  if (reversed && now != last.due) {
    moves_[last.move].turned = true;
    moves_[last.move].to = view.target;
  } else if (before.moving && !(same && now != last.due)) {
    moves_[last.move].arrived = now;
  }
  const bool starts = view.moving && (!before.moving || now == last.due) && !(reversed && now != last.due);
  if (starts) {
    last.move = moves_.size();
    moves_.push_back({unit, view.state, view.target, now, -1, false});
  } else if (!view.moving && !before.moving && view.state != before.state) {
    moves_.push_back({unit, before.state, view.state, now, now, false});
  }
  last.due = view.moving ? now + view.remaining : -1;
  last.view = view;
}

}  // namespace symplant::property
