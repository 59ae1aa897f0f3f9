// Every rule of the tool.
#include "check/catalogue.hpp"

#include <algorithm>
#include <array>

#include "base/parallel.hpp"
#include "check/rule.hpp"
#include "description/description_rules.hpp"
#include "lower/limits.hpp"
#include "naming/rules.hpp"
#include "read/rules.hpp"
#include "symplant/tables/nearest.hpp"
#include "text/ascii.hpp"

namespace symplant::check {
namespace {

constexpr std::array kSubjects{name_rules,    convention_rules, spelling_rules, text_rules,        row_rules,
                               address_rules, feedback_rules,   device_rules,   description_rules, value_rules};

/// The ids and slugs of earlier versions whose findings a rule reports now; without a rule: none does.
struct Former {
  std::string_view now;
  std::string_view names;
};
constexpr auto kFormer = std::to_array<Former>({
    {"SP206", "path-ambiguous SP207 role-taken"},
    {"SP304", "event-moved-twice"},
    {"SP305", "SP209 direction-conflict SP407 task-claimed-twice"},
    {"SP315", "SP314 radix-disagrees"},
    {"SP316", "places-overlap"},
    {"SP319", "SP320 word-and-bits"},
    {"SP402", "SP409 sequence-ambiguous"},
    {"SP404", "nobody-moves SP630 part-sensor-not-described"},
    {"SP414", "SP413 one-task-alone SP417 end-without-sensor"},
    {"SP614", "condition-never-holds SP615 condition-always-holds SP616 requirement-decided"},
    {"SP620", "ignore-without-finding SP621 ignore-is-over SP625 rule-renamed"},
    {"SP622", "unknown-rule SP623 binding-rule SP624 date-not-understood"},
    {"", "SP312 byte-on-no-register SP403 unit-without-events"},
    {"", "SP410 initial-by-row-order SP416 tasks-look-parallel SP5 SP50 SP501 inferred-rest-state"},
    {"", "SP502 inferred-single-solenoid SP503 inferred-sequence SP611 state-never-left SP612 zero-time-loop"},
    {"", "SP613 cycle-of-disables SP617 condition-not-examined"},
    {"", "SP631 track-never-moves SP632 transfer-without-parts SP633 parts-never-leave"},
});

/// Null if no earlier version had the name.
const Former* find_former(std::string_view name) {
  const auto has_name = [&](const Former& former) {
    for (std::string_view rest = former.names; !rest.empty();) {
      const std::size_t end = std::min(rest.find(' '), rest.size());
      if (text::equal_ignoring_case(rest.substr(0, end), name)) return true;
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return false;
  };
  const auto* found = std::ranges::find_if(kFormer, has_name);
  return found == kFormer.end() ? nullptr : found;
}

}  // namespace

void check_plant(const PlantModel& plant, const model::Evidence& evidence, diag::Diagnostics& diagnostics,
                 std::size_t threads) {
  const std::vector<bool> otherwise = lists_named_otherwise(plant);
  const bool named = std::ranges::find(otherwise, false) != otherwise.end();
  const bool has_levels = plant.levels() != nullptr && plant.levels()->has_path && plant.pairing == nullptr;
  std::vector<const Rule*> rules;
  for (const auto subject : kSubjects) {
    for (const Rule& rule : subject()) {
      const bool fits = rule.plants == For::all || (named && (rule.plants == For::named || has_levels));
      if (fits) rules.push_back(&rule);
    }
  }
  std::vector<diag::Diagnostics> found(rules.size());
  base::for_each_number(rules.size(), threads == 0 ? base::threads_for(plant.symbols.size()) : threads, [&](auto i) {
    const Find find{*rules[i], plant, plant.symbols, plant.units, evidence, otherwise, found[i]};
    if (const auto* of_plant = std::get_if<Rule::OfPlant>(&rules[i]->check)) (*of_plant)(find);
    if (const auto* of_symbol = std::get_if<Rule::OfSymbol>(&rules[i]->check)) {
      for (const Symbol& symbol : plant.symbols) (*of_symbol)(find, symbol);
    }
    if (const auto* of_unit = std::get_if<Rule::OfUnit>(&rules[i]->check)) {
      for (const Unit& unit : plant.units) (*of_unit)(find, unit);
    }
  });
  for (diag::Diagnostics& of_rule : found) diagnostics.add(std::move(of_rule));
}

const std::vector<const diag::RuleInfo*>& catalogue() {
  static const std::vector<const diag::RuleInfo*> all = [] {
    std::vector<const diag::RuleInfo*> infos{&lower::kPlantTooLarge};
    for (const auto subject : kSubjects) {
      for (const Rule& rule : subject()) infos.push_back(&rule);
    }
    for (const auto floor : {read::rules(), description::rules(), naming::rules()}) {
      infos.insert(infos.end(), floor.begin(), floor.end());
    }
    std::ranges::sort(infos, [](const auto* a, const auto* b) { return a->id < b->id; });
    return infos;
  }();
  return all;
}

const diag::RuleInfo* find_rule(std::string_view id_or_slug) {
  if (const Former* former = find_former(id_or_slug)) id_or_slug = former->now;
  const auto found = std::ranges::find_if(catalogue(), [&](const diag::RuleInfo* rule) {
    return text::equal_ignoring_case(rule->id, id_or_slug) || text::equal_ignoring_case(rule->slug, id_or_slug);
  });
  return found == catalogue().end() ? nullptr : *found;
}

std::string former_rule(std::string_view name) {
  if (find_former(name) == nullptr) return {};
  const diag::RuleInfo* now = find_rule(name);
  return now == nullptr ? fmt::format("the rule `{}` no longer exists", name)
                        : fmt::format("`{}` is now `{}`", name, now->slug);
}

std::string no_such_rule(std::string_view name) {
  tables::NearestName nearest(name);
  for (const diag::RuleInfo* rule : catalogue()) {
    nearest.offer(rule->slug);
    nearest.offer(rule->id);
  }
  return fmt::format("unknown rule `{}`; {}", name,
                     nearest.name().empty() ? std::string("`symplant rules` lists all")
                                            : fmt::format("did you mean `{}`?", nearest.name()));
}

bool is_stopping(const diag::Diagnostic& finding) {
  return finding.severity == diag::Severity::error && finding.rule->effect != diag::Effect::served;
}

bool has_stopping_errors(const diag::Diagnostics& findings) {
  const auto all = findings.all();
  return findings.has_errors() && std::ranges::any_of(all, is_stopping);
}

}  // namespace symplant::check
