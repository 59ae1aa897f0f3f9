// How much of a list a naming rule explains.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "name/compiled_naming.hpp"
#include "name/reading.hpp"
#include "name/symbol_reader.hpp"
#include "pairing/pairing.hpp"

namespace symplant::infer {

/// An I/O symbol of the lists from which a rule is inferred. Views point into the lists.
struct Sample {
  name::SymbolText text;
  name::Direction side{};
  bool boolean = true;
  std::uint32_t controller = 0;
};

/// Counts BOOL symbols.
name::Counts score_of(const pairing::Pairing& pairing, std::span<const Sample> samples);

/// A rule applied to samples.
struct Applied {
  std::unique_ptr<name::SymbolReader> reader;  ///< keeps the texts of the readings
  std::vector<name::Reading> readings;         ///< one for each sample
  pairing::Pairing pairing;
  name::Counts score;
};

/// O(samples) for usual rules.
Applied apply_rule(const std::shared_ptr<const name::CompiledNaming>& naming, std::span<const Sample> samples);

}  // namespace symplant::infer
