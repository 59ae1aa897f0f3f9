// Which rules a run reports.
#include "findings/selection.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "check/catalogue.hpp"
#include "text/ascii.hpp"

namespace symplant::findings {
namespace {

/// How exactly a word matches a rule, as an id is exact to 5 characters; 0 if it does not.
std::size_t weight(std::string_view word, const diag::RuleInfo& rule) {
  const bool begins = word.size() >= 2 && text::equal_ignoring_case(word, rule.id.substr(0, word.size()));
  return text::equal_ignoring_case(word, rule.slug) ? rule.id.size() : begins ? word.size() : 0;
}

}  // namespace

bool is_binding(const diag::RuleInfo& rule) {
  return rule.severity == diag::Severity::error && rule.effect == diag::Effect::no_plant;
}

std::string binding_text(const diag::RuleInfo& rule, std::string_view wish) {
  return fmt::format("`{}` cannot be {}: with this error there is no valid plant; fix its cause", rule.slug, wish);
}

base::Result<Selection, std::string> Selection::of(std::span<const std::string> select,
                                                   std::span<const std::string> ignore) {
  Selection selection;
  selection.all_ = select.empty();
  for (const bool ignores : {false, true}) {
    for (const std::string& word : ignores ? ignore : select) {
      if (word.empty()) {
        return std::string("a rule is missing next to a comma: write ids, slugs or beginnings of ids, such as SP4");
      }
      const diag::RuleInfo* known = check::find_rule(word);
      if (ignores && known != nullptr && is_binding(*known)) return binding_text(*known, "ignored");
      bool matches = !check::former_rule(word).empty();
      if (matches) selection.former_.insert(word);
      for (const diag::RuleInfo* rule : check::catalogue()) {
        const std::size_t exact = weight(known == nullptr ? word : known->id, *rule);
        matches = matches || exact != 0;
        std::size_t& best = selection.words_[rule][ignores ? 1 : 0];
        best = std::max(best, exact);
      }
      if (!matches) return check::no_such_rule(word);
    }
  }
  return selection;
}

Selection::Verdict Selection::verdict(const diag::RuleInfo& rule) const {
  const auto words = words_.find(&rule);
  if (words == words_.end() || is_binding(rule)) return Verdict::reported;
  const auto [selected, ignored] = words->second;
  if (selected == 0 && !all_) return Verdict::not_selected;
  return ignored != 0 && ignored >= selected ? Verdict::ignored : Verdict::reported;
}

}  // namespace symplant::findings
