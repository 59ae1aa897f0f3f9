// Folds by subject, and joins by shape.
#include "findings/finish.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>
#include <vector>

#include "text/ascii.hpp"

namespace symplant::findings {
namespace {

using diag::Subject;

/// Two names with a common key differ in one level at most, or only in their separators. The keys are the name without
/// separators and illegal characters, and the levels with and without each one of them.
std::vector<std::string> near_keys(std::string_view name) {
  std::vector<std::string> levels(1);
  for (const char c : text::to_upper(name)) {
    if (c == '_') {
      levels.emplace_back();
    } else if (text::is_digit(c) || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80) {
      levels.back() += c;
    }
  }
  std::vector<std::string> keys(levels.size() + 2);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    for (std::size_t left_out = 0; left_out <= levels.size(); ++left_out) {
      if (i != left_out) keys[left_out] += '_' + levels[i];
    }
    keys.back() += levels[i];
  }
  return keys;
}

/// Two subjects with a common key are one; a name that breaks the naming rule may be any near one that is missing.
std::vector<std::string> keys_of(const Subject& subject, bool near_missing) {
  const bool name = subject.kind == Subject::Kind::name;
  std::vector<std::string> keys;
  if (name || (near_missing && subject.kind == Subject::Kind::missing)) keys = near_keys(subject.name);
  if (!name) keys.push_back(static_cast<char>(subject.kind) + text::to_upper(subject.name));
  return keys;
}

void join(diag::Diagnostic& first, diag::Diagnostic finding) {
  ++first.count;
  first.severity = std::max(first.severity, finding.severity);
  first.shown_consequences += finding.shown_consequences;
  first.related.push_back({std::move(finding.location), "also: " + finding.message});
  std::ranges::move(finding.related, std::back_inserter(first.related));
  std::ranges::move(finding.renames, std::back_inserter(first.renames));
}

}  // namespace

diag::Diagnostics finish(diag::Diagnostics findings, const description::GivenCheck& settings, std::string_view today,
                         const Selection& selection, const Known& known) {
  fold(findings);
  if (!settings.severity.empty() || !settings.ignore.empty() || !selection.takes_all()) {
    findings = sift(findings, settings, today, selection);
    fold(findings);
  }
  findings.show_consequences();
  if (known.baseline != nullptr) findings = known.baseline->apply(known.plant, std::move(findings));
  return roll_up(std::move(findings));
}

void fold(diag::Diagnostics& diagnostics) {
  const std::span<const diag::Diagnostic> all = diagnostics.all();
  const auto keep_better = [&](std::uint32_t& best, std::uint32_t other) {
    if (all[other].rule->rank < all[best].rule->rank) best = other;
  };
  std::unordered_map<std::string, std::uint32_t> causes;  // the best one of each key
  bool names = false;
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    for (const Subject& subject : all[i].subjects.explains) {
      names = names || subject.kind == Subject::Kind::name;
      for (const std::string& key : keys_of(subject, false)) keep_better(causes.try_emplace(key, i).first->second, i);
    }
  }
  std::vector<std::uint32_t> into(all.size());
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    into[i] = i;
    for (const Subject& subject : all[i].subjects.follows) {
      for (const std::string& key : keys_of(subject, names)) {
        if (const auto cause = causes.find(key); cause != causes.end()) keep_better(into[i], cause->second);
      }
    }
  }
  for (std::uint32_t& cause : into) {  // ranks fall from step to step
    while (into[cause] != cause) cause = into[cause];
  }
  diagnostics.fold(into);
}

diag::Diagnostics roll_up(diag::Diagnostics findings) {
  constexpr std::size_t kExamples = 3;
  std::unordered_map<std::string, std::size_t> index_of;  // of the first of a rule and shape
  std::vector<diag::Diagnostic> kept;
  std::vector<std::vector<std::string>> examples;
  for (diag::Diagnostic& finding : findings.take()) {
    const diag::Subjects& subjects = finding.subjects;
    const bool single = subjects.about.empty() || subjects.shape.find('#') == std::string::npos;
    const std::string group = text::to_upper(fmt::format("{} {}", finding.rule->id, subjects.shape));
    const std::size_t first = single ? kept.size() : index_of.try_emplace(group, kept.size()).first->second;
    if (first == kept.size()) {
      kept.push_back(std::move(finding));
      examples.emplace_back();
    } else {
      if (examples[first].size() < kExamples) examples[first].push_back(subjects.about.front().name);
      join(kept[first], std::move(finding));
    }
  }
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (const std::size_t more = kept[i].count - 1; more != 0) {
      kept[i].message +=
          fmt::format("; {} more like `{}`: `{}`{}", more, kept[i].subjects.shape, fmt::join(examples[i], "`, `"),
                      more <= kExamples ? "" : fmt::format(" and {} more", more - kExamples));
    }
    findings.add(std::move(kept[i]));
  }
  return findings;
}

}  // namespace symplant::findings
