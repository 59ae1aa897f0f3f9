// Findings made by hand.
#pragma once

#include <string>
#include <vector>

#include "diag/diagnostic.hpp"

namespace symplant::test {

/// The subjects of a finding about these symbols.
inline diag::Subjects about(const std::vector<std::string>& symbols) {
  diag::Subjects subjects;
  for (const std::string& name : symbols) subjects.about.push_back({diag::Subject::Kind::symbol, name});
  return subjects;
}

}  // namespace symplant::test
