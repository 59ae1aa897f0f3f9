// What a client of a link asks of the run.
#pragma once

#include <cstdint>

namespace symplant::link {

struct LinkCommand {
  enum class Kind : std::uint8_t {
    start_malfunction,  ///< `of`: its number, as tables::MalfunctionNumbers has it
    end_malfunction,
    freeze,
    run,   ///< ends a freeze by a command
    step,  ///< `of`: number of cycles, >= 1; the plant runs for them and is then frozen
  };
  Kind kind = Kind::freeze;
  std::uint32_t of = 0;
};

}  // namespace symplant::link
