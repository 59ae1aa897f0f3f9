// Roots and what follows from them, by device.
#include "findings/causes.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "findings/follows.hpp"
#include "findings/name_guess.hpp"
#include "name/name_parser.hpp"
#include "text/ascii.hpp"

namespace symplant::findings {
namespace {

using LocationsByName =
    std::unordered_map<std::string, std::vector<std::uint32_t>, text::HashIgnoringCase, text::EqualIgnoringCase>;

class Folding {
 public:
  Folding(const model::PlantModel& plant, const diag::Diagnostics& diagnostics)
      : plant_(plant), findings_(diagnostics.all()), parser_(*plant.rule), facts_(plant) {}

  /// For each finding the one that it follows from, or itself; empty where none follows.
  std::vector<std::uint32_t> find() {
    bool any_root = false;
    bool any_effect = false;
    for (const diag::Diagnostic& finding : findings_) {
      const RuleRole role = role_of(finding);
      any_root = any_root || role.explains;
      any_effect = any_effect || role.follows();
    }
    if (!any_root || !any_effect) return {};
    for (std::uint32_t i = 0; i < findings_.size(); ++i) {
      if (role_of(findings_[i]).explains) add_root(i);
    }
    std::vector<std::uint32_t> into(findings_.size());
    bool folded = false;
    for (std::uint32_t i = 0; i < findings_.size(); ++i) {
      into[i] = role_of(findings_[i]).follows() ? root_of(i) : i;
      folded = folded || into[i] != i;
    }
    if (!folded) return {};
    for (std::uint32_t& root : into) {  // ranks fall from step to step
      while (into[root] != root) root = into[root];
    }
    return into;
  }

 private:
  /// role_of(), quick for findings of one rule in succession.
  const RuleRole& role_of(const diag::Diagnostic& finding) {
    if (finding.rule != rule_) {
      rule_ = finding.rule;
      role_ = findings::role_of(*rule_);
    }
    return role_;
  }

  /// `lost` is missing in the device of that path.
  void add_path(std::uint32_t finding, std::string_view path, std::optional<Lost> lost) {
    if (path.empty()) return;
    by_path_[std::string(path)].push_back(static_cast<std::uint32_t>(roots_.size()));
    const diag::Diagnostic& reported = findings_[finding];
    roots_.push_back({finding, role_of(reported), reported.about.front(), std::move(lost)});
  }

  void add_root(std::uint32_t i) {
    const diag::Diagnostic& finding = findings_[i];
    const std::vector<std::string>& about = finding.about;
    if (about.empty()) return;
    const RuleRole role = role_of(finding);
    if (role.subject == RuleRole::Of::one_sided) {
      one_sided_.emplace(about.back(), i);
      return;
    }
    by_symbol_[about.front()].push_back(i);
    switch (role.subject) {
      case RuleRole::Of::device:
        add_path(i, about.back(), {});
        break;
      case RuleRole::Of::device_and_lacks:
        for (std::size_t lack = 1; lack < about.size(); ++lack) add_path(i, about.front(), lost_of(about[lack]));
        break;
      case RuleRole::Of::slip:
        add_slip(i);
        break;
      case RuleRole::Of::row: {
        const name::NameReading reading = parser_.parse(about.front());
        if (reading.fault == name::NameFault::none) add_path(i, reading.device_path, {});
        break;
      }
      case RuleRole::Of::lost_row:
        add_path(i, path_of(about.front()), lost_of(about.front()));
        break;
      case RuleRole::Of::name:
        add_guesses(i);
        break;
      case RuleRole::Of::symbol:
      case RuleRole::Of::one_sided:
        break;  // by_symbol_ and one_sided_ have them
    }
  }

  /// What is told of the device as misspelt follows; of the one that is meant, what its missing symbol brings.
  void add_slip(std::uint32_t i) {
    const std::vector<std::string>& about = findings_[i].about;
    if (about.size() < 3) return;
    add_path(i, about[1], {});
    if (text::equal_ignoring_case(about[1], about[2])) return;
    add_path(i, about[2], lost_of(about[0]));
    for (std::size_t other = 3; other < about.size(); other += 2) add_path(i, about[2], lost_of(about[other]));
  }

  void add_guesses(std::uint32_t i) {
    for (const NameGuess& guess : guess_names(findings_[i].about.front(), *plant_.rule)) {
      by_name_[guess.name()].push_back(i);
      add_path(i, guess.path(), Lost::of_words(guess.levels[3], guess.levels[4]));
    }
  }

  std::string_view path_of(std::string_view name) {
    const name::NameReading reading = parser_.parse(name);
    return reading.fault == name::NameFault::none ? reading.device_path : std::string_view();
  }

  std::optional<Lost> lost_of(std::string_view name) {
    const name::NameReading reading = parser_.parse(name);
    if (reading.fault != name::NameFault::none) return std::nullopt;
    return Lost{reading.direction, std::string(reading.task)};
  }

  std::uint32_t root_of(std::uint32_t i) {
    const diag::Diagnostic& finding = findings_[i];
    const RuleRole role = role_of(finding);
    if (finding.about.empty()) return i;
    if (!role.follows_device) return named_root_of(i);
    const Root* best = nullptr;
    const std::string& path =
        role.subject == RuleRole::Of::device_and_lacks ? finding.about.front() : finding.about.back();
    if (const auto found = by_path_.find(path); found != by_path_.end()) {
      for (const std::uint32_t location : found->second) {
        const Root& root = roots_[location];
        if (root.finding == i || root.role.rank >= role.rank ||
            (best != nullptr && best->role.rank <= root.role.rank)) {
          continue;
        }
        if (facts_.follows(finding, path, root)) best = &root;
      }
    }
    if (best != nullptr) return best->finding;
    if (role.reports_rest_state()) {
      const auto found = one_sided_.find(path);
      return found == one_sided_.end() ? i : found->second;
    }
    return named_root_of(i);
  }

  /// A root that tells of the same symbol, or of a name that may be meant to be the one that is missing here.
  std::uint32_t named_root_of(std::uint32_t i) {
    const diag::Diagnostic& finding = findings_[i];
    const RuleRole role = role_of(finding);
    if (role.subject == RuleRole::Of::device_and_lacks) {
      for (std::size_t lack = 1; lack < finding.about.size(); ++lack) {
        if (const auto root = guessed_root(finding.about[lack])) return *root;
      }
    } else if (role.lacks_side()) {
      if (const auto lost = lost_of(finding.about.front())) {
        std::string name =
            finding.about.back() + (lost->direction == name::Direction::event ? "_O_" : "_I_") + lost->task;
        if (const auto root = guessed_root(name)) return *root;
      }
    } else if (role.follows_symbol) {
      for (const std::string& about : finding.about) {
        const auto found = by_symbol_.find(about);
        if (found == by_symbol_.end()) continue;
        for (const std::uint32_t root : found->second) {
          const RuleRole cause = role_of(findings_[root]);
          if (cause.subject == RuleRole::Of::name) continue;  // a wrong name moves no address
          if (cause.rank < role.rank) return root;
        }
      }
    }
    return i;
  }

  /// By the name itself, or with any one of its levels unknown.
  std::optional<std::uint32_t> guessed_root(const std::string& name) const {
    if (by_name_.empty()) return std::nullopt;
    if (const auto found = by_name_.find(name); found != by_name_.end()) return found->second.front();
    for (std::size_t begin = 0; begin <= name.size();) {
      const std::size_t end = std::min(name.find('_', begin), name.size());
      std::string unknown = name;
      unknown.replace(begin, end - begin, "*");
      if (const auto found = by_name_.find(unknown); found != by_name_.end()) return found->second.front();
      begin = end + 1;
    }
    return std::nullopt;
  }

  const model::PlantModel& plant_;
  std::span<const diag::Diagnostic> findings_;
  name::NameParser parser_;
  Facts facts_;
  const diag::RuleInfo* rule_ = nullptr;  ///< whose role is role_
  RuleRole role_;
  std::vector<Root> roots_;
  LocationsByName by_path_;  ///< device -> places in roots_
  LocationsByName by_name_;  ///< what a name that breaks the rule may be meant to be, with `*` -> findings
  text::ByName<std::uint32_t> one_sided_;  ///< device -> finding, a place in findings_
  LocationsByName by_symbol_;              ///< symbol -> roots, places in findings_
};

}  // namespace

void fold_consequences(const model::PlantModel& plant, diag::Diagnostics& diagnostics) {
  const std::vector<std::uint32_t> into = Folding(plant, diagnostics).find();
  if (!into.empty()) diagnostics.fold(into);
}

}  // namespace symplant::findings
