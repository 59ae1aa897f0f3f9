// Passes on each finding, or ignores it.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "check/catalogue.hpp"
#include "check/rule.hpp"
#include "findings/finish.hpp"
#include "text/ascii.hpp"
#include "text/pattern.hpp"

namespace symplant::findings {
namespace {

using description::Pointer;
using Verdict = Selection::Verdict;

bool is_date(const std::string& text) {
  const bool digits = text.find_first_not_of("0123456789-") == std::string::npos;
  if (text.size() != 10 || text[4] != '-' || text[7] != '-' || !digits) return false;
  const std::chrono::year_month_day date{std::chrono::year(std::stoi(text)),
                                         std::chrono::month(static_cast<unsigned>(std::stoi(text.substr(5)))),
                                         std::chrono::day(static_cast<unsigned>(std::stoi(text.substr(8))))};
  return date.ok();
}

/// An entry of GivenCheck::ignore.
struct Entry {
  const description::GivenCheck::Ignore& given;
  Pointer pointer;
  const diag::RuleInfo* rule;
  bool over = false;
  bool used = false;
};

class Sieve {
 public:
  Sieve(const description::GivenCheck& settings, std::string_view today, const Selection& selection)
      : settings_(settings), today_(today), selection_(selection) {}

  diag::Diagnostics sift(const diag::Diagnostics& findings) {
    left_out_ = findings.left_out();
    for (const auto& [rule, level] : settings_.severity) set_level(rule, level);
    for (std::size_t i = 0; i < settings_.ignore.size(); ++i) add_entry(i);
    for (const diag::Diagnostic& finding : findings.all()) pass_on(finding);
    for (const diag::Ignored& ignored : findings.ignored()) ignore(ignored.finding, ignored.why);
    for (const Entry& entry : entries_) report_idle(entry);
    result_.leave_out(left_out_);
    return std::move(result_);
  }

 private:
  void report(std::string_view id, const Pointer& pointer, std::string message) {
    const diag::RuleInfo& rule = *check::find_rule(id);
    if (selection_.verdict(rule) == Verdict::reported) {
      result_.add(rule, std::move(message), check::location_of(pointer));
    }
  }

  const diag::RuleInfo* rule_of(const std::string& name, const Pointer& pointer) {
    const diag::RuleInfo* rule = check::find_rule(name);
    const std::string former = check::former_rule(name);
    if (rule == nullptr && former.empty()) report("SP622", pointer, check::no_such_rule(name));
    if (!former.empty() && formers_.insert(text::to_upper(name)).second) {
      report("SP620", pointer, former + (rule != nullptr ? "; write the new name" : "; remove this entry"));
    }
    return rule;
  }

  void set_level(const std::string& name, const std::string& text) {
    const Pointer pointer = Pointer("/check/severity") / std::string_view(name);
    const diag::RuleInfo* rule = rule_of(name, pointer);
    const auto level = diag::severity_of_name(text);
    if (rule == nullptr || !level) return;  // a description with another word does not fit the schema
    if (is_binding(*rule) && *level != diag::Severity::error) {
      report("SP622", pointer, binding_text(*rule, "lowered"));
    } else {
      levels_.try_emplace(rule, *level);
    }
  }

  void add_entry(std::size_t index) {
    const description::GivenCheck::Ignore& given = settings_.ignore[index];
    const Pointer pointer = Pointer("/check/ignore") / index;
    const bool of_run = !given.finding.empty();
    const diag::RuleInfo* rule = of_run ? nullptr : rule_of(given.rule, pointer / "rule");
    if (!given.until.empty() && !is_date(given.until)) {
      report("SP622", pointer / "until", fmt::format("`{}` is not a date: write it as `2027-06-30`", given.until));
    } else if (rule != nullptr && is_binding(*rule)) {
      report("SP622", pointer / "rule", binding_text(*rule, "ignored"));
    } else if (rule != nullptr) {
      entries_.push_back({given, pointer, rule, !given.until.empty() && !today_.empty() && given.until < today_});
    }
  }

  /// Reports a finding, ignores it, or leaves it out, and what follows from it.
  void pass_on(diag::Diagnostic finding) {
    std::vector<diag::Diagnostic> consequences = std::exchange(finding.consequences, {});
    const Entry* entry = entry_of(finding);
    const bool reported = entry == nullptr && is_reported(finding);
    const bool not_selected = !reported && selection_.verdict(*finding.rule) == Verdict::not_selected;
    for (diag::Diagnostic& consequence : consequences) {
      const Entry* own = entry_of(consequence);
      if (own != nullptr) {
        ignore(std::move(consequence), own->given.why);
      } else if (is_reported(consequence)) {
        const bool independent = (entry == nullptr && not_selected) || consequence.severity > finding.severity;
        if (reported || !independent) {
          finding.consequences.push_back(std::move(consequence));
        } else {
          result_.add(std::move(consequence));
        }
      }
    }
    if (reported) return result_.add(std::move(finding));
    if (entry != nullptr) return ignore(std::move(finding), entry->given.why);
    left_out_.consequences += finding.consequences.size();
  }

  /// What plant.json ignores is not counted if it is not selected.
  void ignore(diag::Diagnostic finding, std::string why) {
    if (selection_.verdict(*finding.rule) == Verdict::reported) result_.ignore(std::move(finding), std::move(why));
  }

  /// Counts what is not reported.
  bool is_reported(const diag::Diagnostic& finding) {
    const Verdict verdict = selection_.verdict(*finding.rule);
    left_out_.ignored += verdict == Verdict::ignored ? 1U : 0U;
    left_out_.not_selected += verdict == Verdict::not_selected ? 1U : 0U;
    return verdict == Verdict::reported;
  }

  /// Sets the severity of a finding. The first entry that ignores it; null if none does.
  const Entry* entry_of(diag::Diagnostic& finding) {
    if (const auto level = levels_.find(finding.rule); level != levels_.end()) finding.severity = level->second;
    for (Entry& entry : entries_) {
      const std::vector<diag::Subject>& about = finding.subjects.about;
      const bool fits = entry.rule == finding.rule &&
                        (entry.given.symbols.empty() || std::ranges::any_of(about, [&](const diag::Subject& subject) {
                           return text::matches_pattern(subject.name, entry.given.symbols);
                         }));
      entry.used = entry.used || fits;
      if (fits && !entry.over) return &entry;
    }
    return nullptr;
  }

  /// Reports an entry that ignores nothing: it has expired, or no finding matches it.
  void report_idle(const Entry& entry) {
    if (!entry.used) {
      report("SP620", entry.pointer,
             fmt::format("`{}`{} has no finding: remove this entry", entry.given.rule,
                         entry.given.symbols.empty() ? "" : fmt::format(" of `{}`", entry.given.symbols)));
    } else if (entry.over) {
      report("SP620", entry.pointer / "until",
             fmt::format("this entry was valid until {}, its findings are reported again: fix them, or set a new date",
                         entry.given.until));
    }
  }

  const description::GivenCheck& settings_;
  std::string_view today_;
  const Selection& selection_;
  std::map<const diag::RuleInfo*, diag::Severity> levels_;
  std::vector<Entry> entries_;
  std::set<std::string> formers_;  ///< former names that are reported, in capitals
  diag::LeftOutByOption left_out_;
  diag::Diagnostics result_;
};

}  // namespace

diag::Diagnostics sift(const diag::Diagnostics& findings, const description::GivenCheck& settings,
                       std::string_view today, const Selection& selection) {
  return Sieve(settings, today, selection).sift(findings);
}

}  // namespace symplant::findings
