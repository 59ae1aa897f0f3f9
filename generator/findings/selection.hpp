// Which rules the user wants to hear of in one run: `--select` and `--ignore`.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "diag/diagnostic.hpp"

namespace symplant::findings {

/// Rules chosen by id, slug or the beginning of an id. The more exact word counts: `SP401` more than `SP40`, that more
/// than `SP4`; of equal ones `--ignore` counts. Errors after which nothing sound is left (is_binding) are told whatever
/// is chosen.
class Selection {
 public:
  enum class Verdict { reported, not_selected, ignored };

  /// Every rule.
  Selection() = default;

  /// Of the words behind the two options; an empty `select` takes every rule. Else what is wrong with a word, for a
  /// message: no rule has it, or it ignores an error that cannot be ignored.
  static base::Result<Selection, std::string> of(std::span<const std::string> select,
                                                 std::span<const std::string> ignore);

  Verdict verdict(const diag::RuleInfo& rule) const;
  bool takes_all() const { return select_.empty() && ignore_.empty(); }
  /// The former slugs among the words, each once. They work, with a warning.
  const std::vector<std::string>& renamed() const { return renamed_; }

 private:
  void use_current_slug(std::string& word);

  std::vector<std::string> select_;
  std::vector<std::string> ignore_;
  std::vector<std::string> renamed_;
};

/// What is left of the findings, and how many were left out; of those that plant.json ignores none is counted where it
/// goes. Comes after apply_settings(), so that an entry of plant.json has hidden something whatever is chosen, and
/// before fold_consequences(), so that nothing is hidden under a finding that is not told. O(findings).
diag::Diagnostics select(diag::Diagnostics findings, const Selection& selection);

}  // namespace symplant::findings
