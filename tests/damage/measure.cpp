// Counts the findings in damaged lists.
#include "damage/measure.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "support/compile.hpp"

namespace symplant::damage {
namespace {

/// Row numbers change when rows are added or removed; the words stay the same.
std::string key_of(const diag::Diagnostic& finding) { return std::string(finding.rule->slug) + ": " + finding.message; }

std::size_t line_of(const diag::Diagnostic& finding) {
  return finding.location.source == nullptr ? 0 : finding.location.source->position(finding.location.span.begin).line;
}

std::vector<std::string> sorted_keys(const diag::Diagnostics& diagnostics) {
  std::vector<std::string> keys;
  for (const diag::Diagnostic& finding : diagnostics.all()) keys.push_back(key_of(finding));
  std::sort(keys.begin(), keys.end());
  return keys;
}

}  // namespace

Clean::Clean(const ShopList& list) : findings_(sorted_keys(test::analyse_text(list.text()).diagnostics)) {}

Trial Clean::compare(const Kind& kind, const Damaged& damaged) const {
  const test::Analysed analysed = test::analyse_text(damaged.list.text());
  std::vector<std::string> left = findings_;
  Trial trial;
  for (const diag::Diagnostic& finding : analysed.diagnostics.all()) {
    const auto [begin, end] = std::equal_range(left.begin(), left.end(), key_of(finding));
    if (begin != end) {
      left.erase(begin);
      continue;
    }
    const std::size_t line = line_of(finding);
    const bool at_root =
        std::any_of(damaged.roots.begin(), damaged.roots.end(), [&](std::size_t row) { return row + 2 == line; });
    const bool right = at_root && finding.rule->slug == kind.rule;
    trial.found = trial.found || right;
    ++trial.findings;
    trial.others += right ? 0U : 1U;
    trial.reported += fmt::format("  {} line {}: {}\n", right ? "+" : "-", line, key_of(finding));
    for (const diag::Related& related : finding.related) trial.reported += "      " + related.message + "\n";
  }
  return trial;
}

std::vector<Figures> measure(const Shop& shop, std::size_t copies, std::uint64_t seed) {
  const Clean clean(shop.list);
  std::vector<Figures> all;
  for (const Kind& kind : kinds()) {
    Figures figures;
    figures.kind = &kind;
    for (std::size_t i = 0; i < copies; ++i) {
      Dice dice(seed + 1'000'003 * all.size() + i);
      const Trial trial = clean.compare(kind, kind.apply(shop, dice));
      ++figures.copies;
      figures.found += trial.found ? 1U : 0U;
      figures.findings += trial.findings;
      figures.others += trial.others;
      if (!trial.found || trial.others != 0) figures.missed += fmt::format("seed {}\n{}", i, trial.reported);
    }
    all.push_back(figures);
  }
  return all;
}

std::string table(const std::vector<Figures>& all) {
  std::string text = "| damage | rule | copies | found | findings | of others |\n|---|---|---|---|---|---|\n";
  Figures sum{};
  for (const Figures& figures : all) {
    text += fmt::format("| {} | `{}` | {} | {} | {} | {} |\n", figures.kind->what, figures.kind->rule, figures.copies,
                        figures.found, figures.findings, figures.others);
    sum.copies += figures.copies;
    sum.found += figures.found;
    sum.findings += figures.findings;
    sum.others += figures.others;
  }
  return text + fmt::format("| **all {} kinds** | | {} | {} | {} | {} |\n", all.size(), sum.copies, sum.found,
                            sum.findings, sum.others);
}

}  // namespace symplant::damage
