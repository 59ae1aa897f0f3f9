// Small single edits of values and signals.
#include <algorithm>
#include <functional>

#include "property/simpler.hpp"

namespace symplant::property {
namespace {

using description::GivenChange;
using description::GivenSignal;
using description::GivenValue;

/// A name or a number is as small as can be.
bool is_operand(const std::string& formula) { return formula.find_first_of(" (") == formula.npos; }

/// What is in brackets, without commas outside of further brackets.
std::vector<std::string> parts_of(const std::string& formula) {
  std::vector<std::string> parts;
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < formula.size(); ++i) {
    if (formula[i] == '(' || formula[i] == ',') {
      if (formula[i] == ',' && !open.empty()) {
        parts.push_back(formula.substr(open.back(), i - open.back()));
        open.back() = i + 1;
      }
      if (formula[i] == '(') open.push_back(i + 1);
    } else if (formula[i] == ')' && !open.empty()) {
      parts.push_back(formula.substr(open.back(), i - open.back()));
      open.pop_back();
    }
  }
  return parts;
}

using Visit = std::function<void(const std::function<void()>&)>;

void simpler_formula(std::string& formula, const Visit& visit) {
  if (formula.empty()) return;
  if (formula != "0") visit([&] { formula = "0"; });
  if (formula != "0" && formula != "1") visit([&] { formula = "1"; });
  if (is_operand(formula)) return;
  for (std::size_t at = formula.find(' '); at != formula.npos; at = formula.find(' ', at + 1)) {
    visit([&formula, at] { formula = formula.substr(0, at); });
    visit([&formula, at] { formula = formula.substr(at + 1); });
  }
  for (const std::string& part : parts_of(formula)) visit([&formula, part] { formula = part; });
}

template <class Member>
void without(Member& member, const Visit& visit) {
  if (member != Member{}) visit([&member] { member = Member{}; });
}

template <class Times>
void plain_step(Times& step, const Visit& visit) {
  if (step && *step != 10 * tables::kMillisecond) visit([&step] { step = 10 * tables::kMillisecond; });
}

std::vector<std::string*> formulas_of(GivenValue& given) {
  std::vector<std::string*> formulas;
  if (given.kind != tables::ValueKind::position) formulas.push_back(&given.formula);
  formulas.insert(formulas.end(), {&given.up, &given.down, &given.of, &given.to});
  for (std::string& u : given.u) formulas.push_back(&u);
  for (GivenChange& change : given.changes) formulas.push_back(&change.to);
  return formulas;
}

}  // namespace

std::size_t values_size(const description::Description& description) {
  std::size_t size = 0;
  for (GivenValue given : description.values) {
    const auto one = [&size](bool is_given) { size += is_given ? 1 : 0; };
    size += 20 + 5 * given.changes.size() + given.start_states.size();
    for (const auto* number : {&given.min, &given.max, &given.start}) one(number->has_value());
    for (const auto* time : {&given.step, &given.trace, &given.ti}) one(time->has_value());
    one(given.td != 0);
    one(given.step && *given.step != 10 * tables::kMillisecond);
    for (const std::string* formula : formulas_of(given)) size += 2 * formula->size() + (*formula == "0" ? 0 : 1);
    for (const GivenChange& change : given.changes) size += change.when.size();
  }
  for (const GivenSignal& given : description.signals) {
    size += 10 + 2 * given.of.size() + (given.of == "0" ? 0 : 1) + (given.from ? 1 : 0) + (given.limit ? 1 : 0) +
            (given.noise != 0 ? 1 : 0) + (given.every ? 1 : 0);
  }
  return size;
}

void each_condition(description::Description& description, const std::function<void(std::string&, bool)>& visit) {
  for (GivenValue& given : description.values) {
    for (GivenChange& change : given.changes) visit(change.when, false);
  }
}

void each_edit(description::Description& description, const Visit& visit) {
  for (GivenValue& given : description.values) {
    for (std::string* formula : formulas_of(given)) simpler_formula(*formula, visit);
    without(given.min, visit);
    without(given.max, visit);
    without(given.start, visit);
    plain_step(given.step, visit);
    without(given.step, visit);
    without(given.trace, visit);
    without(given.ti, visit);
    without(given.td, visit);
    without(given.start_states, visit);
    for (std::size_t i = 0; i < given.changes.size(); ++i) {
      visit([&given, i] { given.changes.erase(given.changes.begin() + static_cast<std::ptrdiff_t>(i)); });
    }
  }
  for (GivenSignal& given : description.signals) {
    simpler_formula(given.of, visit);
    if (given.from) visit([&] { given.from.reset(), given.to.reset(); });
    without(given.limit, visit);
    without(given.noise, visit);
    without(given.every, visit);
  }
}

}  // namespace symplant::property
