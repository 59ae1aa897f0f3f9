// How much of a list a naming rule explains.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "name/compiled_naming.hpp"
#include "name/rule_reading.hpp"
#include "name/symbol_reader.hpp"
#include "pairing/pairing.hpp"

namespace symplant::infer {

/// An I/O symbol of the lists from which a rule is inferred. Views point into the lists.
struct Sample {
  name::SymbolText text;
  name::Side side{};
  bool boolean = true;
  std::uint32_t controller = 0;
};

/// Counts of BOOL symbols that the rule does not ignore.
struct Score {
  std::size_t counted = 0;
  std::size_t paired = 0;     ///< symbols that an operation drives, or that drive an event
  std::size_t accounted = 0;  ///< paired, constant, operator's or data

  double paired_share() const { return share(paired); }
  double accounted_share() const { return share(accounted); }

 private:
  double share(std::size_t part) const {
    return counted == 0 ? 0 : static_cast<double>(part) / static_cast<double>(counted);
  }
};

Score score_of(const pairing::Pairing& pairing, std::span<const Sample> samples);

/// A rule applied to samples.
struct Applied {
  std::unique_ptr<name::SymbolReader> reader;  ///< keeps the texts of the readings
  std::vector<name::RuleReading> readings;     ///< one a sample
  pairing::Pairing pairing;
  Score score;
};

/// O(samples) for usual rules.
Applied apply_rule(const std::shared_ptr<const name::CompiledNaming>& naming, std::span<const Sample> samples);

}  // namespace symplant::infer
