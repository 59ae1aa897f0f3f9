// Explanations as text and as JSON.
#include "symplant/why/explanation.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "symplant/trace/value_text.hpp"

namespace symplant::why {
namespace {

/// By Reference::Kind.
constexpr std::array<std::string_view, 9> kKeys = {"device", "symbol", "requirement", "location", "transfer",
                                                   "work",   "source", "part",        "value"};

template <class Use>
void for_each_sentence(const Explanation& explanation, std::size_t depth, Use& use) {
  use(explanation.sentence, depth);
  for (const Explanation& cause : explanation.because) for_each_sentence(cause, depth + 1, use);
}

}  // namespace

std::vector<std::string> lines_of(const Explanation& explanation) {
  std::vector<std::string> lines;
  const auto add = [&](const std::string& sentence, std::size_t depth) {
    lines.push_back(std::string(4 * depth, ' ') + sentence);
  };
  for_each_sentence(explanation, 0, add);
  return lines;
}

std::string in_one_line(const Explanation& explanation) {
  std::string text;
  const auto add = [&](const std::string& sentence, std::size_t depth) {
    text.append(depth == 0 ? "" : "; ").append(sentence);
  };
  for_each_sentence(explanation, 0, add);
  return text;
}

std::string name_of(const Reference& reference, const trace::PlantNames& names) {
  switch (reference.kind) {
    case Reference::Kind::unit:
      return std::string(names.unit(reference.index));
    case Reference::Kind::symbol:
      return std::string(names.symbol(reference.index));
    case Reference::Kind::requirement:
      return std::string(names.requirement(reference.index));
    case Reference::Kind::location:
      return std::string(names.location(reference.index));
    case Reference::Kind::transfer:
      return std::string(names.transfer(reference.index));
    case Reference::Kind::work:
      return std::string(names.work(reference.index));
    case Reference::Kind::source:
      return std::string(names.source(reference.index));
    case Reference::Kind::value:
      return names.output(reference.index);
    case Reference::Kind::part:
      break;
  }
  return std::to_string(reference.index);
}

std::string json_of(const Explanation& explanation, const trace::PlantNames& names) {
  std::string about;
  for (const Reference& reference : explanation.about) {
    about += fmt::format(R"({}{{"{}":{}}})", about.empty() ? "" : ",", kKeys[static_cast<std::size_t>(reference.kind)],
                         trace::json_string(name_of(reference, names)));
  }
  std::string because;
  for (const Explanation& cause : explanation.because) {
    because.append(because.empty() ? "" : ",").append(json_of(cause, names));
  }
  return fmt::format(R"({{"sentence":{},"about":[{}],"because":[{}]}})", trace::json_string(explanation.sentence),
                     about, because);
}

}  // namespace symplant::why
