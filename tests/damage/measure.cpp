// Counts the findings in damaged lists.
#include "damage/measure.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "support/compile.hpp"

namespace symplant::damage {
namespace {

/// One finding, or one of those that a finding of many includes.
struct Single {
  std::string_view rule;
  std::string key;  ///< row numbers change when rows are added or removed; the words stay the same
  std::size_t line = 0;
};

Single single(const diag::Diagnostic& of, std::string_view message, const diag::Location& location) {
  const std::size_t line = location.source == nullptr ? 0 : location.source->position(location.span.begin).line;
  return {of.rule->slug, fmt::format("{}: {}", of.rule->slug, message), line};
}

std::vector<Single> singles_of(const diag::Diagnostics& diagnostics) {
  constexpr std::string_view kAlso = "also: ";
  std::vector<Single> singles;
  for (const diag::Diagnostic& finding : diagnostics.all()) {
    const std::string others = fmt::format("; {} more like `", finding.count - 1);
    singles.push_back(
        single(finding, std::string_view(finding.message).substr(0, finding.message.rfind(others)), finding.location));
    for (const diag::Related& related : finding.related) {
      if (related.message.compare(0, kAlso.size(), kAlso) != 0) continue;
      singles.push_back(single(finding, std::string_view(related.message).substr(kAlso.size()), related.location));
    }
  }
  return singles;
}

std::vector<std::string> sorted_keys(const diag::Diagnostics& diagnostics) {
  std::vector<std::string> keys;
  for (const Single& finding : singles_of(diagnostics)) keys.push_back(finding.key);
  std::sort(keys.begin(), keys.end());
  return keys;
}

}  // namespace

Clean::Clean(const ShopList& list) : findings_(sorted_keys(test::analyse_text(list.text()).diagnostics)) {}

Trial Clean::compare(const Kind& kind, const Damaged& damaged) const {
  const test::Analysed analysed = test::analyse_text(damaged.list.text());
  std::vector<std::string> left = findings_;
  Trial trial;
  for (const Single& finding : singles_of(analysed.diagnostics)) {
    const auto [begin, end] = std::equal_range(left.begin(), left.end(), finding.key);
    if (begin != end) {
      left.erase(begin);
      continue;
    }
    const bool at_root = std::any_of(damaged.roots.begin(), damaged.roots.end(),
                                     [&](std::size_t row) { return row + 2 == finding.line; });
    const bool right = at_root && finding.rule == kind.rule;
    trial.found = trial.found || right;
    ++trial.findings;
    trial.others += right ? 0U : 1U;
    trial.reported += fmt::format("  {} line {}: {}\n", right ? "+" : "-", finding.line, finding.key);
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
