// Counts the features of random plants, and what happened in them.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "property/compare.hpp"
#include "property/random_plant.hpp"
#include "support/reference/counters.hpp"

namespace symplant::property {

class Tally {
 public:
  void add_plant(const DrawnPlant& drawn);
  void print(std::ostream& out, double seconds) const;
  /// Whether something happened less often than `minimum`; prints it.
  bool missed(std::ostream& out, long minimum) const;

  reference::Counters counters;
  RunCounts run;

 private:
  long plants_ = 0;
  long refused_ = 0;
  std::vector<std::string> refusals_;  ///< the first few
  std::vector<std::size_t> sizes_;     ///< units of a plant
  long behaviours_ = 0;                ///< units with one
  long inverted_ = 0;                  ///< symbols
  long following_ = 0;                 ///< symbols that follow a condition
  long with_material_ = 0;             ///< plants
  long with_malfunctions_ = 0;         ///< plants
  long with_values_ = 0;               ///< plants
  long shared_ = 0;                    ///< symbols that follow another
};

}  // namespace symplant::property
