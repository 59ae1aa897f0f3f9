// Makes a case that shows a difference as small as possible.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>

#include "property/plant_text.hpp"

namespace symplant::property {

/// Removes actions, then units, then parts of their description, as long as `disagrees` confirms that the case still
/// shows the difference; calls it at most `most_runs` times.
Case shrink(Case the_case, const std::function<bool(const Case&)>& disagrees, int most_runs = 4000);

/// Removes parts of the list that `list_of` finds in `best`, larger ones first. `keep` receives each candidate, and
/// makes it `best` if it still shows the difference.
template <class Whole, class ListOf, class Keep>
void remove_pieces(const Whole& best, ListOf&& list_of, Keep&& keep) {
  const auto size = [&] {
    Whole copy = best;
    return list_of(copy).size();
  };
  for (std::size_t piece = std::max<std::size_t>(size() / 2, 1);; piece /= 2) {
    for (std::size_t end = size(); end > 0;) {
      const std::size_t begin = end > piece ? end - piece : 0;
      Whole candidate = best;
      auto& list = list_of(candidate);
      list.erase(list.begin() + static_cast<std::ptrdiff_t>(begin), list.begin() + static_cast<std::ptrdiff_t>(end));
      keep(std::move(candidate));
      end = begin;
    }
    if (piece <= 1) return;
  }
}

}  // namespace symplant::property
