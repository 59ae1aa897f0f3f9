// What a plant did that its model does not expect.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "observe/observer.hpp"
#include "watch/limits.hpp"

namespace symplant::watch {

struct Anomaly {
  enum class Kind : std::uint8_t {
    late,           ///< left or arrived after the longest time and the margin
    early,          ///< left or arrived before the shortest time less the margin
    missing,        ///< did not leave or arrive within three times the longest time, or while it was commanded to
    unexpected,     ///< left or arrived, and nothing caused it
    contradiction,  ///< the events of several states are on, or of none for longer than any move takes
    silent,         ///< nothing was read
    drift,          ///< takes another time on average than learned
  };
  /// What of the move is meant.
  enum class Part : std::uint8_t { leaving, arriving };

  Kind kind = Kind::late;
  Part part = Part::arriving;
  Time time = 0;               ///< when it was noticed
  std::uint32_t unit = kNone;  ///< kNone: what was read, not a unit
  observe::Move move;          ///< as far as it is known
  Time took = 0;               ///< the time that was measured; of `silent` the length; of `drift` the mean
  Range allowed;               ///< by the model, without the margin
  Time margin = 0;
  std::vector<std::uint32_t> symbols;  ///< the operation of its cause, then events that show it
  std::vector<std::uint32_t> on;       ///< of `contradiction`: the events that are on
  Time learned = 0;                    ///< of `drift`: the mean, of `learned_moves`
  std::uint64_t learned_moves = 0;
  std::size_t failed = 0;   ///< of `missing`: moves to that state in a row that did not arrive
  std::size_t number = 0;   ///< from 1 on
  std::size_t follows = 0;  ///< the number of the anomaly that it follows from; 0: none

  bool is_first() const { return follows == 0; }
};

inline constexpr std::array<std::string_view, 7> kKindNames{"late",          "early",  "missing", "unexpected",
                                                            "contradiction", "silent", "drift"};
inline std::string_view kind_name(Anomaly::Kind kind) { return kKindNames[static_cast<std::size_t>(kind)]; }

}  // namespace symplant::watch
