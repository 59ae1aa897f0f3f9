// A malfunction of a plant with resolved names (docs/malfunctions.md).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "description/duration.hpp"
#include "elements/malfunction/given.hpp"
#include "symplant/condition/tree.hpp"
#include "symplant/tables/malfunction.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::model {

struct Effect {
  tables::MalfunctionKind kind = tables::MalfunctionKind::stuck;
  std::vector<tables::MalfunctionUnit> units;    ///< `slower`, `stuck`: ascending by unit
  std::vector<std::uint32_t> tracks;             ///< `slower`, `stuck`: ascending
  std::vector<tables::MalfunctionForce> forces;  ///< `force`: ascending by symbol
  std::vector<tables::MalfunctionSet> sets;      ///< `set`: ascending by value
  std::uint32_t factor = 0;                      ///< `slower`: in thousandths
  std::uint32_t subject = tables::kNone;         ///< `flicker`: a symbol; `lose`: a controller; `distort`: a signal
  std::optional<description::Duration> every;    ///< `flicker`
  tables::Time shows = 0;                        ///< `flicker`
  description::GivenDistort distort;
};

struct Malfunction {
  std::string name;
  std::vector<Effect> effects;
  std::optional<condition::Tree> condition;  ///< `when`, or `while`
  bool during = false;                       ///< the condition is that of `while`
  std::optional<description::Duration> chance;
  std::optional<description::Duration> lasts;
  tables::Time after = 0;                 ///< of `becomes`
  std::uint32_t next = tables::kNone;     ///< of `becomes`: a malfunction; kNone: it becomes no other
  std::optional<condition::Tree> unless;  ///< of `becomes`
};

}  // namespace symplant::model
