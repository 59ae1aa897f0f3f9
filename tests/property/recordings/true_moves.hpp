// What the units of a running plant really do.
#pragma once

#include <cstdint>
#include <vector>

#include "symplant/plant/plant.hpp"

namespace symplant::property {

/// A move of a unit from one state to another.
struct TrueMove {
  std::uint32_t unit = 0;
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  tables::Time left = 0;
  tables::Time arrived = -1;  ///< < 0: not yet
  bool turned = false;        ///< it reversed before it arrived
};

/// Follows the units by what the engine says of them after each instant. Of several moves in one instant it sees the
/// first state and the last one.
class TrueMoves {
 public:
  /// Call after reset(), before the first instant.
  explicit TrueMoves(const plant::Plant& plant);
  /// After an instant that may have changed the unit.
  void look(std::uint32_t unit, tables::Time now);

  const std::vector<TrueMove>& moves() const { return moves_; }

 private:
  struct Last {
    plant::UnitView view{};
    tables::Time due = 0;
    std::size_t move = 0;  ///< index of the present move
  };
  const plant::Plant& plant_;
  std::vector<Last> last_;
  std::vector<TrueMove> moves_;
};

}  // namespace symplant::property
