// The compiled parts of a naming rule.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "name/naming.hpp"
#include "name/naming_fault.hpp"
#include "name/normaliser.hpp"
#include "name/pattern.hpp"
#include "name/prepared_text.hpp"
#include "name/required_words.hpp"
#include "name/vocabulary.hpp"

namespace re2 {
class RE2;
}

namespace symplant::name {

/// What a field of one rule may hold.
class RuleFields : public FieldTest {
 public:
  RuleFields(const SymbolRule& rule, const Vocabulary& vocabulary);
  ~RuleFields() override;
  RuleFields(RuleFields&&) noexcept;

  /// Adds the regular expression of a field; returns RE2's message if it is not valid, else an empty text.
  std::string add_expression(Field field, std::string_view expression);
  bool fits(Field field, const PreparedText& text, std::size_t begin, std::size_t end, bool known,
            bool fused) const override;
  /// What a word of the direction field or of the class field says; nothing for another word.
  std::optional<Said> direction_said(std::string_view shown, std::string_view folded, bool fused) const;
  std::optional<Said> class_said(std::string_view folded) const;

 private:
  bool fits_direction(const PreparedText& text, std::size_t begin, std::size_t end, bool fused) const;
  bool fits_known(const PreparedText& text, std::size_t begin, std::size_t end) const;

  const Vocabulary* vocabulary_;
  std::unordered_map<std::string, Said> directions_;         // as written
  std::unordered_map<std::string, Said> folded_directions_;  // folded
  std::unordered_map<std::string, Said> classes_;            // folded; empty: the vocabulary's
  std::array<std::unique_ptr<re2::RE2>, kFields> expressions_;
};

struct CompiledPattern {
  Source source = Source::name_then_comment;
  Pattern pattern;
};

struct CompiledRule {
  std::vector<CompiledPattern> patterns;
  std::optional<LevelRule> levels;  ///< of an exact rule, which has no patterns
  RuleFields fields;
  Replacements replace;
  RequiredWords has;
};

/// A naming rule as the reader uses it.
struct NamingParts {
  explicit NamingParts(const Naming& naming);

  std::vector<NamingFault> faults;
  Separators separators;
  Vocabulary vocabulary;
  Replacements replace;
  std::vector<std::string> ignore;  ///< folded patterns with `*` and `?`
  std::vector<std::string>
      ignore_written;  ///< those that begin or end with a separator, which a prepared text does not
  std::vector<CompiledRule> rules;
  std::vector<CompiledRule> rest;
  std::vector<std::vector<Pattern>> archetypes;  ///< by archetype, then by text
  std::array<std::string, 3> fixed;              ///< line, process, device
};

}  // namespace symplant::name
