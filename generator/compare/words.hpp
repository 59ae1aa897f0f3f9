// Words about differences that all forms share.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "compare/difference.hpp"

namespace symplant::compare {

/// `missing`, `expected ends`: the key in JSON with `_` for the blank.
std::string_view kind_name(Difference::Kind kind);

/// `X`; for parts `body at BELT`.
std::string name_of(const Series& series);

/// What differs, without time and name: `late by 1 s: on`, `missing: on for 0.5 s`, `deviates for 2 s: 4, not 5`.
std::string difference_words(const Difference& difference);

/// difference_words() with name and time: `at 1.5 s: `X` late by 1 s: on`.
std::string sentence(const Difference& difference);

/// `1 change`, `2 changes`.
std::string counted(std::size_t count, std::string_view word);

/// The differences of each element, elements with the most differences first. O(differences * log(differences)).
std::vector<std::pair<const Series*, std::vector<const Difference*>>> by_series(const Comparison& comparison);

/// `no difference: 236 changes of 8 symbols agree`, `3 differences in 2 of 8 symbols: 2 late, 1 missing`.
std::string summary(const Comparison& comparison);

}  // namespace symplant::compare
