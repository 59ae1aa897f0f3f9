// A case that shows a disagreement, made as small as it goes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>

#include "property/plant_text.hpp"

namespace symplant::property {

/// Takes away actions, then units, then what is said of them, as long as `disagrees` says that the case still shows
/// what is wanted; at most `most_runs` questions are asked.
Case shrink(Case the_case, const std::function<bool(const Case&)>& disagrees, int most_runs = 4000);

/// Takes away pieces of the list that `list_of` finds in `best`, larger ones first. `keep` is given each candidate, and
/// makes it `best` where it still shows what is wanted.
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
