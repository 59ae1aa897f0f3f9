// Which rules a run reports: `--select` and `--ignore`.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "diag/diagnostic.hpp"

namespace symplant::findings {

/// Rules chosen by id, slug or the beginning of an id. The more exact word counts: `SP401` more than `SP40`, that more
/// than `SP4`; of equally exact words `--ignore` counts. Errors that make a valid plant impossible (is_binding) are
/// always reported.
class Selection {
 public:
  enum class Verdict { reported, not_selected, ignored };

  /// Every rule.
  Selection() = default;

  /// From the words of the two options; an empty `select` takes every rule. On error, the text of a message: no rule
  /// has the word, or it ignores an error that cannot be ignored.
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

/// The selected findings, and how many are left out. The consequences of an ignored finding go with it, except those of
/// take_independent(); those of one that is not selected are reported separately if they are selected. Findings that
/// plant.json ignores are not counted if they are left out. Comes after apply_settings(), so that an entry of
/// plant.json is used whatever is selected. O(findings).
diag::Diagnostics select(const diag::Diagnostics& findings, const Selection& selection);

}  // namespace symplant::findings
