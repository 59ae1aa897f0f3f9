// Severities, and the collection of findings.
#include "diag/diagnostic.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace symplant::diag {

std::string_view severity_name(Severity severity) {
  switch (severity) {
    case Severity::note:
      return "note";
    case Severity::warning:
      return "warning";
    case Severity::error:
      return "error";
  }
  return {};
}

std::optional<Severity> severity_of_name(std::string_view name) {
  for (const Severity severity : {Severity::note, Severity::warning, Severity::error}) {
    if (severity_name(severity) == name) return severity;
  }
  return std::nullopt;
}

std::string manual_page(const RuleInfo& rule) {
  if (rule.page.ends_with('\n')) return std::string(rule.page);
  std::string text(rule.page);
  if (!rule.loses.empty()) text.append("\n\n**What the model loses.** ").append(rule.loses);
  if (!rule.fix.empty()) text.append("\n\n**How to fix it.** ").append(rule.fix);
  std::size_t begin = 0;  // of the line
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '\n') begin = at + 1;
    if (at - begin < 120) continue;
    const std::size_t blank = text.rfind(' ', at);
    if (blank == std::string::npos || blank < begin) continue;
    text[blank] = '\n';
    begin = blank + 1;
  }
  return text + "\n";
}

void Diagnostics::add(const RuleInfo& rule, std::string message, Location location, std::vector<Related> related) {
  add(rule, {}, std::move(message), std::move(location), std::move(related));
}

Diagnostic& Diagnostics::add(const RuleInfo& rule, Subjects subjects, std::string message, Location location,
                             std::vector<Related> related) {
  add({&rule, rule.severity, std::move(message), std::move(location), std::move(related), std::move(subjects)});
  return all_.back();
}

void Diagnostics::add(Diagnostic finding) {
  ++counts_[static_cast<std::size_t>(finding.severity)];
  all_.push_back(std::move(finding));
}

void Diagnostics::add(Diagnostics&& others) {
  for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += others.counts_[i];
  all_.insert(all_.end(), std::move_iterator(others.all_.begin()), std::move_iterator(others.all_.end()));
  ignored_.insert(ignored_.end(), std::move_iterator(others.ignored_.begin()),
                  std::move_iterator(others.ignored_.end()));
  leave_out(others.left_out_);
}

void Diagnostics::ignore(Diagnostic finding, std::string why) {
  ignored_.push_back({std::move(finding), std::move(why)});
}

void Diagnostics::fold(std::span<const std::uint32_t> into) {
  for (std::size_t i = 0; i < all_.size(); ++i) {
    if (into[i] == i) continue;
    std::vector<Diagnostic>& consequences = all_[into[i]].consequences;
    std::vector<Diagnostic> further = std::move(all_[i].consequences);
    all_[i].consequences.clear();
    consequences.push_back(std::move(all_[i]));
    std::move(further.begin(), further.end(), std::back_inserter(consequences));
  }
  counts_ = {};
  std::size_t kept = 0;
  for (std::size_t i = 0; i < all_.size(); ++i) {
    if (into[i] != i) continue;
    ++counts_[static_cast<std::size_t>(all_[i].severity)];
    if (kept != i) all_[kept] = std::move(all_[i]);
    ++kept;
  }
  all_.resize(kept);
}

namespace {

void show(Diagnostic& finding) {
  for (Diagnostic& consequence : finding.consequences) {
    finding.severity = std::max(finding.severity, consequence.severity);
    std::string message("follows from this (");
    message.append(consequence.rule->slug).append("): ").append(consequence.message);
    finding.related.push_back({std::move(consequence.location), std::move(message)});
    std::move(consequence.related.begin(), consequence.related.end(), std::back_inserter(finding.related));
  }
  finding.shown_consequences += finding.consequences.size();
  finding.consequences.clear();
}

}  // namespace

void Diagnostics::show_consequences() {
  counts_ = {};
  for (Diagnostic& finding : all_) {
    show(finding);
    ++counts_[static_cast<std::size_t>(finding.severity)];
  }
  for (Ignored& ignored : ignored_) show(ignored.finding);
}

std::vector<std::string> Diagnostics::pointers() const {
  std::vector<std::string> pointers;
  const auto add_one = [&](const Location& location) {
    if (!location.pointer.empty()) pointers.push_back(location.pointer);
  };
  const auto add_all = [&](const Diagnostic& finding) {
    add_one(finding.location);
    for (const Related& related : finding.related) add_one(related.location);
  };
  for (const Diagnostic& finding : all_) add_all(finding);
  for (const Ignored& ignored : ignored_) add_all(ignored.finding);
  std::sort(pointers.begin(), pointers.end());
  pointers.erase(std::unique(pointers.begin(), pointers.end()), pointers.end());
  return pointers;
}

void Diagnostics::locate(std::span<const Location> locations) {
  const std::vector<std::string> known = pointers();
  const auto locate_one = [&](Location& location) {
    if (location.pointer.empty()) return;
    const auto found = std::lower_bound(known.begin(), known.end(), location.pointer);
    const auto index = static_cast<std::size_t>(found - known.begin());
    location = locations[index];
  };
  const auto locate_all = [&](Diagnostic& finding) {
    locate_one(finding.location);
    for (Related& related : finding.related) locate_one(related.location);
  };
  for (Diagnostic& finding : all_) locate_all(finding);
  for (Ignored& ignored : ignored_) locate_all(ignored.finding);
}

void Diagnostics::sort_by_location(std::span<const text::SourceFile* const> files) {
  const std::unordered_set<const text::SourceFile*> given(files.begin(), files.end());
  std::unordered_map<const text::SourceFile*, std::size_t> ranks;  // never iterated, so that no pointer value shows
  for (const Diagnostic& diagnostic : all_) {
    const text::SourceFile* const file = diagnostic.location.source.get();
    if (file != nullptr && given.count(file) == 0) ranks.try_emplace(file, ranks.size() + 1);
  }
  for (const text::SourceFile* file : files) ranks.try_emplace(file, ranks.size() + 1);
  struct Key {
    std::size_t rank;
    std::size_t begin;
    std::size_t found;  ///< the number of the finding; unique

    bool operator<(const Key& other) const {
      return std::tie(rank, begin, found) < std::tie(other.rank, other.begin, other.found);
    }
  };
  std::vector<Key> keys;
  keys.reserve(all_.size());
  for (const Diagnostic& diagnostic : all_) {
    const text::SourceFile* const file = diagnostic.location.source.get();
    keys.push_back(
        {file == nullptr ? 0 : ranks[file], file == nullptr ? 0 : diagnostic.location.span.begin, keys.size()});
  }
  if (std::is_sorted(keys.begin(), keys.end())) return;
  std::sort(keys.begin(), keys.end());
  std::vector<Diagnostic> sorted;
  sorted.reserve(all_.size());
  for (const Key& key : keys) sorted.push_back(std::move(all_[key.found]));
  all_ = std::move(sorted);
}

}  // namespace symplant::diag
