// Folding by subject.
#include "findings/folding.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/index_table.hpp"
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

/// The best cause of each subject. The subjects must outlive it.
class Causes {
 public:
  /// The cause of a subject; `finding` if it has none yet.
  std::uint32_t& find_or_add(const Subject& subject, std::uint32_t finding) {
    const auto next = static_cast<std::uint32_t>(known_.size());
    const std::uint32_t index = table_.find_or_add(hash_of(subject), next, [&](auto at) { return is_at(at, subject); });
    if (index == next) known_.push_back({&subject, finding});
    return known_[index].finding;
  }
  /// Null if the subject has no cause.
  const std::uint32_t* find(const Subject& subject) const {
    const std::uint32_t index = table_.find(hash_of(subject), [&](auto at) { return is_at(at, subject); });
    return index == base::IndexTable::kNothing ? nullptr : &known_[index].finding;
  }

 private:
  struct Known {
    const Subject* subject;
    std::uint32_t finding;
  };

  static std::uint64_t hash_of(const Subject& subject) {
    return text::hash_ignoring_case(subject.name) + static_cast<std::uint64_t>(subject.kind);
  }
  bool is_at(std::uint32_t index, const Subject& subject) const {
    const Subject& known = *known_[index].subject;
    return known.kind == subject.kind && text::equal_ignoring_case(known.name, subject.name);
  }

  base::IndexTable table_;
  std::vector<Known> known_;
};

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
  void improve(std::uint32_t& cause, std::uint32_t finding) {
    any_ = true;
    if (rank_of(finding) < rank_of(cause)) cause = finding;
  }

  void add_cause(std::uint32_t finding) {
    for (const Subject& subject : findings_[finding].subjects.explains) {
      if (subject.kind == Subject::Kind::name) {
        for (std::string& key : near_keys(subject.name)) {
          improve(near_names_.try_emplace(std::move(key), finding).first->second, finding);
        }
      } else {
        improve(causes_.find_or_add(subject, finding), finding);
      }
    }
  }

  std::optional<std::uint32_t> cause_of(std::uint32_t finding) const {
    std::optional<std::uint32_t> best;
    const auto consider = [&](std::uint32_t cause) {
      if (rank_of(cause) < rank_of(best.value_or(finding))) best = cause;
    };
    for (const Subject& subject : findings_[finding].subjects.follows) {
      if (const std::uint32_t* cause = causes_.find(subject); cause != nullptr) consider(*cause);
      if (subject.kind != Subject::Kind::missing || near_names_.empty()) continue;
      for (const std::string& key : near_keys(subject.name)) {
        if (const auto found = near_names_.find(key); found != near_names_.end()) consider(found->second);
      }
    }
    return best;
  }

  std::span<const diag::Diagnostic> findings_;
  Causes causes_;
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
