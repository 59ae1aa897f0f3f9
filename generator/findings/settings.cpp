// Applies the user's settings to findings.
#include "findings/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "check/catalogue.hpp"
#include "check/rules.hpp"
#include "text/ascii.hpp"
#include "text/pattern.hpp"

namespace symplant::findings {
namespace {

/// Errors that leave a valid plant: of two rows of one name the first counts; a plant without devices has its symbols.
constexpr std::array<std::string_view, 2> kErrorsToChooseFrom{"SP302", "SP415"};

/// The value of a text of digits; nothing if it has other characters.
std::optional<int> number(std::string_view text) {
  int value = 0;
  for (const char c : text) {
    if (c < '0' || c > '9') return std::nullopt;
    value = value * 10 + (c - '0');
  }
  return value;
}

int days_of(int year, int month) {
  constexpr std::array kDays{31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  const bool leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
  return month == 2 && leap ? 29 : kDays[static_cast<std::size_t>(month - 1)];
}

bool is_date(std::string_view text) {
  if (text.size() != 10 || text[4] != '-' || text[7] != '-') return false;
  const auto year = number(text.substr(0, 4));
  const auto month = number(text.substr(5, 2));
  const auto day = number(text.substr(8, 2));
  return year && month && day && *month >= 1 && *month <= 12 && *day >= 1 && *day <= days_of(*year, *month);
}

/// The location of the entry of `ignore` at an index, or of a key in it.
diag::Location location_of_ignore(std::size_t index, std::string_view key = {}) {
  const description::Pointer here = description::Pointer("/check/ignore") / index;
  return check::location_of({}, key.empty() ? here : here / key);
}

class Settings {
 public:
  Settings(const diag::Diagnostics& findings, const description::GivenCheck& settings, std::string_view today)
      : findings_(findings), settings_(settings), today_(today) {}

  diag::Diagnostics apply() {
    for (const auto& [rule, level] : settings_.severity) set_level(rule, level);
    for (std::size_t i = 0; i < settings_.ignore.size(); ++i) ignore(i);
    for (const diag::Diagnostic& finding : findings_.all()) pass_on(finding);
    for (const Ignoring& ignoring : ignoring_) report_idle(ignoring);
    return std::move(result_);
  }

 private:
  struct Ignoring {
    std::size_t entry;  ///< an index in GivenCheck::ignore
    const diag::RuleInfo* rule;
    bool over = false;
    bool used = false;
  };
  struct Level {
    const diag::RuleInfo* rule;
    diag::Severity level;
  };

  const diag::RuleInfo* rule_of(const std::string& name, const diag::Location& location) {
    const diag::RuleInfo* rule = check::find_rule(name);
    if (rule == nullptr) result_.add(check::kUnknownRule.info, check::no_such_rule(name), location);
    if (!check::slug_now(name).empty() && renamed_.insert(text::to_upper(name)).second) {
      result_.add(check::kRuleRenamed.info,
                  fmt::format("{}: write the new name, the next version no longer reads the old one",
                              check::renamed_rule(name)),
                  location);
    }
    return rule;
  }

  void refuse(const diag::RuleInfo& rule, std::string_view wish, const diag::Location& location) {
    result_.add(check::kBindingRule.info, binding_text(rule, wish), location);
  }

  void set_level(const std::string& name, const std::string& text) {
    const diag::Location location = check::location_of({}, description::Pointer("/check/severity") / name);
    const diag::RuleInfo* rule = rule_of(name, location);
    const auto level = diag::severity_of_name(text);
    if (rule == nullptr || !level) return;  // a description with another word does not fit the schema
    if (is_binding(*rule) && *level != diag::Severity::error) {
      refuse(*rule, "lowered", location);
    } else {
      levels_.push_back({rule, *level});
    }
  }

  void ignore(std::size_t index) {
    const description::GivenCheck::Ignore& entry = settings_.ignore[index];
    const bool of_run = !entry.finding.empty();
    const diag::RuleInfo* rule = of_run ? nullptr : rule_of(entry.rule, location_of_ignore(index, "rule"));
    if (!entry.until.empty() && !is_date(entry.until)) {
      result_.add(check::kDateNotUnderstood.info,
                  fmt::format("`{}` is not a date: write it as `2027-06-30`", entry.until),
                  location_of_ignore(index, "until"));
      return;
    }
    if (rule == nullptr) return;
    if (is_binding(*rule)) {
      refuse(*rule, "ignored", location_of_ignore(index, "rule"));
      return;
    }
    const bool over = !entry.until.empty() && !today_.empty() && entry.until < today_;
    ignoring_.push_back({index, rule, over});
  }

  /// Ignores a finding, or its consequences, or keeps them.
  void pass_on(diag::Diagnostic finding) {
    set_severity(finding);
    std::vector<diag::Diagnostic> kept;
    for (diag::Diagnostic& consequence : finding.consequences) {
      set_severity(consequence);
      if (const Ignoring* entry = entry_of(consequence)) {
        result_.ignore(std::move(consequence), settings_.ignore[entry->entry].why);
      } else {
        kept.push_back(std::move(consequence));
      }
    }
    finding.consequences = std::move(kept);
    if (const Ignoring* entry = entry_of(finding)) {
      for (diag::Diagnostic& consequence : take_independent(finding)) result_.add(std::move(consequence));
      result_.ignore(std::move(finding), settings_.ignore[entry->entry].why);
    } else {
      result_.add(std::move(finding));
    }
  }

  void set_severity(diag::Diagnostic& finding) const {
    const auto level =
        std::find_if(levels_.begin(), levels_.end(), [&](const Level& l) { return l.rule == finding.rule; });
    if (level != levels_.end()) finding.severity = level->level;
  }

  /// The first entry that ignores the finding; null if none does.
  const Ignoring* entry_of(const diag::Diagnostic& finding) {
    for (Ignoring& ignoring : ignoring_) {
      if (!fits(ignoring, finding)) continue;
      ignoring.used = true;
      if (!ignoring.over) return &ignoring;
    }
    return nullptr;
  }

  bool fits(const Ignoring& ignoring, const diag::Diagnostic& finding) const {
    if (ignoring.rule != finding.rule) return false;
    const std::string& pattern = settings_.ignore[ignoring.entry].symbols;
    const std::vector<diag::Subject>& about = finding.subjects.about;
    return pattern.empty() || std::any_of(about.begin(), about.end(), [&](const diag::Subject& subject) {
             return text::matches_pattern(subject.name, pattern);
           });
  }

  /// Reports an entry that ignores nothing: it has expired, or no finding matches it.
  void report_idle(const Ignoring& ignoring) {
    const description::GivenCheck::Ignore& entry = settings_.ignore[ignoring.entry];
    if (!ignoring.used) {
      result_.add(check::kIgnoreWithoutFinding.info,
                  fmt::format("`{}`{} has no finding: remove this entry", entry.rule,
                              entry.symbols.empty() ? "" : fmt::format(" of `{}`", entry.symbols)),
                  location_of_ignore(ignoring.entry));
    } else if (ignoring.over) {
      result_.add(
          check::kIgnoreIsOver.info,
          fmt::format("this entry was valid until {}, its findings are reported again: fix them, or set a new date",
                      entry.until),
          location_of_ignore(ignoring.entry, "until"));
    }
  }

  const diag::Diagnostics& findings_;
  const description::GivenCheck& settings_;
  std::string_view today_;
  std::vector<Level> levels_;
  std::vector<Ignoring> ignoring_;
  std::set<std::string> renamed_;  ///< former slugs that are reported, in capitals
  diag::Diagnostics result_;
};

}  // namespace

bool is_binding(const diag::RuleInfo& rule) {
  return rule.severity == diag::Severity::error &&
         std::find(kErrorsToChooseFrom.begin(), kErrorsToChooseFrom.end(), rule.id) == kErrorsToChooseFrom.end();
}

std::vector<diag::Diagnostic> take_independent(diag::Diagnostic& ignored) {
  std::vector<diag::Diagnostic> all = std::move(ignored.consequences);
  ignored.consequences.clear();
  std::vector<diag::Diagnostic> independent;
  for (diag::Diagnostic& consequence : all) {
    const bool stays = consequence.severity > ignored.severity || is_binding(*consequence.rule);
    (stays ? independent : ignored.consequences).push_back(std::move(consequence));
  }
  return independent;
}

std::string binding_text(const diag::RuleInfo& rule, std::string_view wish) {
  return fmt::format("`{}` cannot be {}: with this error there is no valid plant; fix its cause", rule.slug, wish);
}

diag::Diagnostics apply_settings(const diag::Diagnostics& findings, const description::GivenCheck& settings,
                                 std::string_view today) {
  return Settings(findings, settings, today).apply();
}

}  // namespace symplant::findings
