// Which rules the user wants to hear of in one run.
#include "findings/selection.hpp"

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <utility>

#include "check/catalogue.hpp"
#include "findings/settings.hpp"
#include "text/ascii.hpp"

namespace symplant::findings {
namespace {

constexpr std::size_t kIdSize = 5;        // "SP201"
constexpr std::size_t kShortestWord = 2;  // "SP", every rule

bool names_exactly(std::string_view word, const diag::RuleInfo& rule) {
  return text::equal_ignoring_case(word, rule.id) || text::equal_ignoring_case(word, rule.slug) ||
         text::equal_ignoring_case(check::slug_now(word), rule.slug);
}

/// How exactly a word means a rule; 0: not at all.
std::size_t weight(std::string_view word, const diag::RuleInfo& rule) {
  if (names_exactly(word, rule)) return kIdSize;
  const bool begins = word.size() >= kShortestWord && word.size() < rule.id.size() &&
                      text::equal_ignoring_case(word, rule.id.substr(0, word.size()));
  return begins ? word.size() : 0;
}

std::size_t weight(const std::vector<std::string>& words, const diag::RuleInfo& rule) {
  std::size_t most = 0;
  for (const std::string& word : words) most = std::max(most, weight(word, rule));
  return most;
}

/// What is wrong with a word of `option`; nothing where all is well.
std::optional<std::string> fault_of(const std::string& word, bool ignores) {
  if (word.empty()) return "a rule is missing beside a comma: write ids, slugs or beginnings of ids, such as SP4";
  bool known = false;
  for (const diag::RuleInfo* rule : check::catalogue()) {
    known = known || weight(word, *rule) != 0;
    if (ignores && is_binding(*rule) && names_exactly(word, *rule)) return binding_text(*rule, "ignored");
  }
  return known ? std::nullopt : std::optional(check::no_such_rule(word));
}

}  // namespace

base::Result<Selection, std::string> Selection::of(std::span<const std::string> select,
                                                   std::span<const std::string> ignore) {
  for (const std::string& word : select) {
    if (auto fault = fault_of(word, false)) return std::move(*fault);
  }
  for (const std::string& word : ignore) {
    if (auto fault = fault_of(word, true)) return std::move(*fault);
  }
  Selection selection;
  selection.select_.assign(select.begin(), select.end());
  selection.ignore_.assign(ignore.begin(), ignore.end());
  for (std::vector<std::string>* words : {&selection.select_, &selection.ignore_}) {
    for (std::string& word : *words) selection.use_current_slug(word);
  }
  return selection;
}

void Selection::use_current_slug(std::string& word) {
  const std::string_view now = check::slug_now(word);
  if (now.empty()) return;
  const bool known = std::any_of(renamed_.begin(), renamed_.end(), [&](const std::string& each) {
    return text::equal_ignoring_case(each, word);
  });
  if (!known) renamed_.push_back(word);
  word = now;
}

Selection::Verdict Selection::verdict(const diag::RuleInfo& rule) const {
  if (is_binding(rule)) return Verdict::reported;
  const std::size_t selected = weight(select_, rule);
  if (selected == 0 && !select_.empty()) return Verdict::not_selected;
  const std::size_t ignored = weight(ignore_, rule);
  return ignored != 0 && ignored >= selected ? Verdict::ignored : Verdict::reported;
}

diag::Diagnostics select(diag::Diagnostics findings, const Selection& selection) {
  if (selection.takes_all()) return findings;
  diag::Diagnostics result;
  diag::LeftOutByOption left_out = findings.left_out();
  std::unordered_map<const diag::RuleInfo*, Selection::Verdict> verdicts;
  const auto verdict = [&](const diag::RuleInfo* rule) {
    const auto known = verdicts.find(rule);
    return known != verdicts.end() ? known->second : verdicts[rule] = selection.verdict(*rule);
  };
  for (const diag::Diagnostic& finding : findings.all()) {
    switch (verdict(finding.rule)) {
      case Selection::Verdict::reported:
        result.add(finding);
        break;
      case Selection::Verdict::not_selected:
        ++left_out.not_selected;
        break;
      case Selection::Verdict::ignored:
        ++left_out.ignored;
        break;
    }
  }
  for (const diag::Ignored& each : findings.ignored()) {
    if (verdict(each.finding.rule) == Selection::Verdict::reported) result.ignore(each.finding, each.why);
  }
  result.leave_out(left_out);
  return result;
}

}  // namespace symplant::findings
