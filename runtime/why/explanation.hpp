// Why a device, a symbol or a part is as it is: a sentence, and below it what causes it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "symplant/trace/plant_names.hpp"

namespace symplant::why {

/// A thing of a plant, by its index in the plant's tables; a part by its number, a value by its output.
struct Reference {
  enum class Kind : std::uint8_t { unit, symbol, requirement, location, transfer, work, source, part, value };
  Kind kind;
  std::uint32_t index;

  friend bool operator==(const Reference&, const Reference&) = default;
  friend bool operator<(const Reference& a, const Reference& b) {
    return a.kind != b.kind ? a.kind < b.kind : a.index < b.index;
  }
};

struct Explanation {
  std::string sentence;               ///< without a full stop
  std::vector<Reference> about = {};  ///< what the sentence names; first what it explains
  std::vector<Explanation> because = {};
};

/// The sentence, then those of its causes, each indented by four blanks more than what it causes.
std::vector<std::string> lines_of(const Explanation& explanation);

/// The same sentences, joined by `; `.
std::string in_one_line(const Explanation& explanation);

/// `{"sentence":"...","about":[{"device":"EXLINE_MB_AGV"}],"because":[...]}`
std::string json_of(const Explanation& explanation, const trace::PlantNames& names);

/// The name of a thing; of a part its number.
std::string name_of(const Reference& reference, const trace::PlantNames& names);

}  // namespace symplant::why
