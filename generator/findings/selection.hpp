// Which rules a run reports: `--select` and `--ignore`.
#pragma once

#include <array>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>

#include "base/result.hpp"
#include "diag/diagnostic.hpp"

namespace symplant::findings {

/// Whether a rule reports an error that makes a valid plant impossible: its severity cannot be lowered, and it cannot
/// be ignored.
bool is_binding(const diag::RuleInfo& rule);
/// For a message: that a binding rule cannot be what `wish` says, for example "ignored".
std::string binding_text(const diag::RuleInfo& rule, std::string_view wish);

/// Rules chosen by id, slug or the beginning of an id. The more exact word counts: `SP401` more than `SP40`, that more
/// than `SP4`; of equally exact words `--ignore` counts. Binding rules are always reported.
class Selection {
 public:
  enum class Verdict { reported, not_selected, ignored };

  /// Selects every rule.
  Selection() = default;
  /// From the words of the two options; an empty `select` takes every rule. On error, the text of a message: no rule
  /// has the word, or it ignores a binding one.
  static base::Result<Selection, std::string> of(std::span<const std::string> select,
                                                 std::span<const std::string> ignore);

  Verdict verdict(const diag::RuleInfo& rule) const;
  bool takes_all() const { return words_.empty(); }
  /// Former names among the words: they work, or have no effect if the rule was removed.
  const std::set<std::string>& former() const { return former_; }

 private:
  bool all_ = true;                                                         ///< no word selects
  std::map<const diag::RuleInfo*, std::array<std::size_t, 2>> words_ = {};  ///< how exactly one selects, ignores
  std::set<std::string> former_;
};

}  // namespace symplant::findings
