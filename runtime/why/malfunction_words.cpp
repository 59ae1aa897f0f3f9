// Active malfunctions in explanations.
#include "symplant/why/malfunction_words.hpp"

#include <fmt/format.h>

#include "symplant/trace/finding_words.hpp"

namespace symplant::why {

void add_malfunctions(Explanation& explanation, const trace::PlantNames& names, trace::ActiveMalfunctions active) {
  const std::string said = in_one_line(explanation);
  for (const trace::History::Malfunction& one : active) {
    const std::string named = trace::malfunction_words(one.number, names);
    if (said.find(named) != std::string::npos) continue;
    explanation.because.push_back({fmt::format("{} is active {}", named, trace::since_words(one.since))});
  }
}

}  // namespace symplant::why
