// The texts of samples as a report shows and compares them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "infer/evaluate.hpp"
#include "name/normaliser.hpp"

namespace symplant::infer {

/// What the words of a text are about, as bits.
enum TextKind : std::uint8_t {
  kPanelText = 1,
  kInterlockText = 2,
  kStartText = 4,
  kDoneText = 8,
  kAnswerText = 16,   ///< an echo, an acknowledge or a reset
  kHealthyText = 32,  ///< of a contact that is on in a healthy plant, and not of an alarm
};

/// Each sample has one text: the one that its rule reads, or else the one that most rules read.
class ReportTexts {
 public:
  /// The arguments must outlive the object.
  ReportTexts(const name::CompiledNaming& naming, std::span<const Sample> samples,
              std::span<const name::Reading> readings);

  name::Source source(std::uint32_t sample) const { return sources_[sample]; }
  /// The text in normal form.
  std::string normal(std::uint32_t sample) const;
  /// The text as the list has it, on one line, at most some 80 bytes.
  std::string shown(std::uint32_t sample) const;
  /// The words of the text, folded.
  std::vector<std::string> words(std::uint32_t sample) const;
  /// Bits of TextKind.
  std::uint8_t kinds(std::uint32_t sample);

 private:
  std::string raw(std::uint32_t sample) const;

  const name::CompiledNaming& naming_;
  std::span<const Sample> samples_;
  name::Separators separators_;
  name::Replacements replacements_;
  std::vector<name::Source> sources_;
  std::vector<std::optional<std::uint8_t>> kinds_;                // of each sample, once asked for
  std::unordered_map<std::string, std::uint8_t> kinds_of_words_;  // words without digits
};

}  // namespace symplant::infer
