// Puts a report together, and applies the answers to it.
#include "infer/report.hpp"

#include <algorithm>

#include "infer/report_parts.hpp"

namespace symplant::infer {
namespace {

void count_accounts(const ReportInput& input, Report& report) {
  for (std::uint32_t i = 0; i < input.samples.size(); ++i) {
    if (!input.samples[i].boolean) continue;
    const name::Account account = input.applied.pairing.accounts[i];
    const bool paired = account == name::Account::modelled;
    if (account == name::Account::constant) ++report.constants;
    if (account == name::Account::operator_panel) ++report.operator_panel;
    if (account == name::Account::data) ++report.data;
    if (account == name::Account::interlock) ++report.interlocks;
    if (!input.is_operation(i) || (!paired && !input.is_left_over(i))) continue;
    ++report.operations;
    if (paired) ++report.operations_paired;
  }
}

template <class Values>
void remove_at(Values& values, const std::set<std::size_t>& indexes) {
  for (auto index = indexes.rbegin(); index != indexes.rend(); ++index) {
    values.erase(values.begin() + static_cast<std::ptrdiff_t>(*index));
  }
}

}  // namespace

bool ReportInput::is_operation(std::uint32_t sample) const {
  return applied.readings[sample].direction.value_or(samples[sample].side) == name::Direction::operation;
}

bool ReportInput::is_left_over(std::uint32_t sample) const {
  const name::Account account = applied.pairing.accounts[sample];
  return samples[sample].boolean && name::is_left_over(account) && account != name::Account::role_none;
}

bool ReportInput::is_asked(std::uint32_t sample) const {
  if (is_operation(sample) || !samples[sample].boolean) return false;
  // Role `none`: the proposal leaves these contacts to the questions.
  if (applied.pairing.accounts[sample] != name::Account::role_none && !is_left_over(sample)) return false;
  return (texts.kinds(sample) & kHealthyText) != 0;
}

bool Report::names_do_not_link() const {
  constexpr std::size_t kLeast = 5;     // outputs that are worth a sentence
  constexpr std::size_t kFewPairs = 8;  // fewer than one of this number
  return operations >= kLeast && operations_paired * kFewPairs < operations;
}

Report report_of(const name::Naming& naming, std::span<const Sample> samples) {
  Report report;
  std::vector<name::NamingFault> faults;
  const auto compiled = name::CompiledNaming::compile(naming, faults);
  if (compiled == nullptr) return report;
  const Applied applied = apply_rule(compiled, samples);
  ReportTexts texts(*compiled, samples, applied.readings);
  const ReportInput input{*compiled, samples, applied, texts};
  report.score = applied.score;
  count_accounts(input, report);
  report.correspondences = correspondences_of(input);
  add_questions(input, report);
  add_left_over(input, report);
  add_direction_conflicts(input, report);
  add_near_misses(input, report);
  return report;
}

name::Counts score_of(const name::Naming& naming, std::span<const Sample> samples) {
  std::vector<name::NamingFault> faults;
  const auto compiled = name::CompiledNaming::compile(naming, faults);
  return compiled == nullptr ? name::Counts() : apply_rule(compiled, samples).score;
}

name::Naming with_answers(const name::Naming& naming, const Report& report, const std::set<std::size_t>& refused,
                          const std::set<std::size_t>& accepted) {
  name::Naming result = naming;
  std::set<std::size_t> rules;
  std::set<std::size_t> archetypes;
  for (const std::size_t index : refused) {
    const Correspondence& one = report.correspondences[index];
    rules.insert(one.rules.begin(), one.rules.end());
    archetypes.insert(one.archetypes.begin(), one.archetypes.end());
  }
  remove_at(result.rules, rules);
  remove_at(result.archetypes, archetypes);
  auto front = result.rest.begin();
  for (const std::size_t index : accepted) {
    if (report.questions[index].about_interlocks()) continue;  // infer() answers this one
    front = std::next(result.rest.insert(front, report.questions[index].rule));
  }
  return result;
}

}  // namespace symplant::infer
