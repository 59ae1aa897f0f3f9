// Which rules a run reports.
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

/// How exactly a word matches a rule; 0 if it does not.
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

/// What is wrong with a word of an option; nothing if it is valid.
std::optional<std::string> fault_of(const std::string& word, bool ignores) {
  if (word.empty()) return "a rule is missing next to a comma: write ids, slugs or beginnings of ids, such as SP4";
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
  const bool known = std::any_of(renamed_.begin(), renamed_.end(),
                                 [&](const std::string& each) { return text::equal_ignoring_case(each, word); });
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

namespace {

/// Leaves out what is not selected, and counts it.
class Selecting {
 public:
  explicit Selecting(const Selection& selection, const diag::LeftOutByOption& before)
      : selection_(selection), left_out_(before) {}

  void pass_on(diag::Diagnostic finding) {
    const Verdict verdict = verdict_of(finding);
    finding.consequences = reported_of(std::move(finding.consequences));
    if (verdict == Verdict::reported) {
      result_.add(std::move(finding));
      return;
    }
    leave_out(verdict);
    const bool all = verdict == Verdict::not_selected;  // such a finding is not ignored, only not selected
    for (diag::Diagnostic& each : all ? finding.consequences : take_independent(finding)) result_.add(std::move(each));
    if (!all) left_out_.consequences += finding.consequences.size();
  }

  /// What plant.json ignores is not counted if it is not selected.
  void pass_on(diag::Ignored ignored) {
    if (verdict_of(ignored.finding) != Verdict::reported) return;
    result_.ignore(std::move(ignored.finding), std::move(ignored.why));
  }

  diag::Diagnostics take() {
    result_.leave_out(left_out_);
    return std::move(result_);
  }

 private:
  using Verdict = Selection::Verdict;

  Verdict verdict_of(const diag::Diagnostic& finding) {
    const auto known = verdicts_.find(finding.rule);
    if (known != verdicts_.end()) return known->second;
    const Verdict verdict = selection_.verdict(*finding.rule);
    verdicts_.emplace(finding.rule, verdict);
    return verdict;
  }

  std::vector<diag::Diagnostic> reported_of(std::vector<diag::Diagnostic> consequences) {
    std::vector<diag::Diagnostic> reported;
    for (diag::Diagnostic& consequence : consequences) {
      const Verdict verdict = verdict_of(consequence);
      if (verdict == Verdict::reported) {
        reported.push_back(std::move(consequence));
      } else {
        leave_out(verdict);
      }
    }
    return reported;
  }

  void leave_out(Verdict verdict) { ++(verdict == Verdict::ignored ? left_out_.ignored : left_out_.not_selected); }

  const Selection& selection_;
  diag::LeftOutByOption left_out_;
  std::unordered_map<const diag::RuleInfo*, Verdict> verdicts_;
  diag::Diagnostics result_;
};

}  // namespace

diag::Diagnostics select(const diag::Diagnostics& findings, const Selection& selection) {
  if (selection.takes_all()) return findings;
  Selecting selecting(selection, findings.left_out());
  for (const diag::Diagnostic& finding : findings.all()) selecting.pass_on(finding);
  for (const diag::Ignored& ignored : findings.ignored()) selecting.pass_on(ignored);
  return selecting.take();
}

}  // namespace symplant::findings
