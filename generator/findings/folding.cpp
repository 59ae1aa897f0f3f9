// Folding by subject.
#include "findings/folding.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "text/ascii.hpp"

namespace symplant::findings {
namespace {

using diag::Subject;

constexpr char kSeparator = '_';

bool is_word(char c) {
  const char upper = text::upper(c);
  return text::is_digit(c) || (upper >= 'A' && upper <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
}

/// Two names with a common key differ in one level at most, or only in their separators. The keys are the name without
/// separators and illegal characters, and the levels with and without each one of them.
std::vector<std::string> near_keys(std::string_view name) {
  std::vector<std::string> levels(1);
  for (const char c : name) {
    if (c == kSeparator) {
      levels.emplace_back();
    } else if (is_word(c)) {
      levels.back() += text::upper(c);
    }
  }
  std::vector<std::string> keys(levels.size() + 2);
  for (std::size_t left_out = 0; left_out <= levels.size(); ++left_out) {
    for (std::size_t i = 0; i < levels.size(); ++i) {
      if (i != left_out) keys[left_out] += kSeparator + levels[i];
    }
  }
  for (const std::string& level : levels) keys.back() += level;
  return keys;
}

class Folding {
 public:
  explicit Folding(std::span<const diag::Diagnostic> findings) : findings_(findings) {}

  /// For each finding the one that it follows from, or itself; empty if none follows.
  std::vector<std::uint32_t> find() {
    for (std::uint32_t i = 0; i < findings_.size(); ++i) add_cause(i);
    if (!any_) return {};
    std::vector<std::uint32_t> into(findings_.size());
    bool folded = false;
    for (std::uint32_t i = 0; i < findings_.size(); ++i) {
      into[i] = cause_of(i).value_or(i);
      folded = folded || into[i] != i;
    }
    if (!folded) return {};
    for (std::uint32_t& cause : into) {  // ranks fall from step to step
      while (into[cause] != cause) cause = into[cause];
    }
    return into;
  }

 private:
  diag::Rank rank_of(std::uint32_t finding) const { return findings_[finding].rule->rank; }

  /// Keeps the better cause of a subject.
  template <class Map>
  void add(Map& map, const std::string& key, std::uint32_t finding) {
    any_ = true;
    const auto [found, added] = map.try_emplace(key, finding);
    if (!added && rank_of(finding) < rank_of(found->second)) found->second = finding;
  }

  void add_cause(std::uint32_t finding) {
    for (const Subject& subject : findings_[finding].subjects.explains) {
      if (subject.kind == Subject::Kind::name) {
        for (const std::string& key : near_keys(subject.name)) add(near_names_, key, finding);
      } else {
        add(causes_[static_cast<std::size_t>(subject.kind)], subject.name, finding);
      }
    }
  }

  std::optional<std::uint32_t> cause_of(std::uint32_t finding) const {
    std::optional<std::uint32_t> best;
    const auto consider = [&](const auto& map, std::string_view key) {
      const auto found = map.find(key);
      if (found == map.end()) return;
      if (rank_of(found->second) < rank_of(best.value_or(finding))) best = found->second;
    };
    for (const Subject& subject : findings_[finding].subjects.follows) {
      consider(causes_[static_cast<std::size_t>(subject.kind)], subject.name);
      if (subject.kind != Subject::Kind::missing || near_names_.empty()) continue;
      for (const std::string& key : near_keys(subject.name)) consider(near_names_, key);
    }
    return best;
  }

  std::span<const diag::Diagnostic> findings_;
  std::array<text::ByName<std::uint32_t>, diag::kSubjectKinds> causes_;  ///< by kind, then by name
  std::unordered_map<std::string, std::uint32_t, text::HashIgnoringCase, text::EqualIgnoringCase>
      near_names_;  ///< by near_keys()
  bool any_ = false;
};

}  // namespace

void fold(diag::Diagnostics& diagnostics) {
  const std::vector<std::uint32_t> into = Folding(diagnostics.all()).find();
  if (!into.empty()) diagnostics.fold(into);
}

}  // namespace symplant::findings
