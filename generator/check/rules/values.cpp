// Rules: values, and the numbers of a plant that has values or signals.
#include <algorithm>
#include <unordered_map>

#include "check/rule.hpp"
#include "elements/value/readers.hpp"
#include "text/shape.hpp"

namespace symplant::check {
namespace {

using model::Read;
using model::Value;
using tables::ValueKind;

constexpr std::size_t kMostNames = 10;  // in one message

/// At a value in plant.json. Findings about the values of one `for` have one shape.
Finding at(const Find& find, std::uint32_t value) {
  const Value& of = find.plant.values[value];
  const std::string& name = find.plant.description->values[of.given].name;
  return find.at(location_of(description::Pointer("/values") / std::string_view(name)),
                 {{{Kind::value, of.name}}, {}, {}, text::shape_of(of.name)});
}

/// What each value's formulas read; jumps are no part of the dynamics.
class ReadsOfFormulas {
 public:
  explicit ReadsOfFormulas(const PlantModel& plant) : plant_(plant), reads_(plant.values.size()) {
    const std::vector<std::uint32_t> value_of = model::values_of_outputs(plant);
    for (std::uint32_t v = 0; v < plant.values.size(); ++v) {
      for (const condition::Formula& formula : plant.values[v].formulas) {
        for (const condition::FormulaInput& input : formula.inputs) {
          if (input.kind == condition::FormulaInput::Kind::output) reads_[v].push_back(value_of[input.of]);
        }
      }
    }
  }

  /// The sets of values that all depend on each other, with two values or more; each ascending, by its first one
  /// (Tarjan 1972, without recursion).
  std::vector<std::vector<std::uint32_t>> circles() const {
    struct Open {
      std::uint32_t value;
      std::size_t next = 0;
    };
    const std::size_t count = reads_.size();
    std::vector<std::uint32_t> number(count, kNone);
    std::vector<std::uint32_t> least(count);
    std::vector<bool> waits(count);
    std::vector<std::uint32_t> waiting;
    std::vector<std::vector<std::uint32_t>> found;
    std::uint32_t numbers = 0;
    for (std::uint32_t first = 0; first < count; ++first) {
      if (number[first] != kNone) continue;
      std::vector<Open> open;
      const auto enter = [&](std::uint32_t value) {
        number[value] = least[value] = numbers++;
        waits[value] = true;
        waiting.push_back(value);
        open.push_back({value});
      };
      enter(first);
      while (!open.empty()) {
        Open& top = open.back();
        const std::uint32_t value = top.value;
        if (top.next < reads_[value].size()) {
          const std::uint32_t read = reads_[value][top.next++];
          if (number[read] == kNone) {
            enter(read);
          } else if (waits[read]) {
            least[value] = std::min(least[value], number[read]);
          }
          continue;
        }
        open.pop_back();
        if (!open.empty()) least[open.back().value] = std::min(least[open.back().value], least[value]);
        if (least[value] != number[value]) continue;
        auto begin = waiting.end();  // of its circle: the last ones
        do --begin;
        while (*begin != value);
        std::vector<std::uint32_t> circle(begin, waiting.end());
        waiting.erase(begin, waiting.end());
        for (const std::uint32_t each : circle) waits[each] = false;
        if (circle.size() < 2) continue;
        std::ranges::sort(circle);
        found.push_back(std::move(circle));
      }
    }
    std::ranges::sort(found);
    return found;
  }

  /// The shortest circle through a value: the value, what it reads, what that reads and so on, up to the value again.
  /// Empty without a circle. All are among some values, which ascend; `only_computed`: all others are computed at once
  /// from what they read.
  std::vector<std::uint32_t> circle_of(std::uint32_t value, const std::vector<std::uint32_t>& among,
                                       bool only_computed) const {
    std::unordered_map<std::uint32_t, std::uint32_t> read_by;
    std::vector<std::uint32_t> open{value};
    for (std::size_t i = 0; i < open.size(); ++i) {
      for (const std::uint32_t read : reads_[open[i]]) {
        if (read == value) {
          std::vector<std::uint32_t> circle{value};
          for (std::uint32_t at = open[i]; at != value; at = read_by.at(at)) circle.push_back(at);
          circle.push_back(value);
          std::ranges::reverse(circle);
          return circle;
        }
        if (only_computed && plant_.values[read].row.kind != ValueKind::is) continue;
        if (!std::ranges::binary_search(among, read) || !read_by.try_emplace(read, open[i]).second) continue;
        open.push_back(read);
      }
    }
    return {};
  }

 private:
  const PlantModel& plant_;
  std::vector<std::vector<std::uint32_t>> reads_;
};

/// Where only integrals depend on each other and none reads itself, the eigenvalues of the linear part have the sum 0:
/// without one that grows by itself all are imaginary, and an explicit step makes each of these grow.
void integrals_undamped(const Find& find) {
  if (find.plant.values.empty() || !find.evidence.faults.empty()) return;
  const ReadsOfFormulas reads(find.plant);
  const auto kind = [&](std::uint32_t value) { return find.plant.values[value].row.kind; };
  const auto is_integral = [&](std::uint32_t value) { return kind(value) == ValueKind::integral; };
  for (const std::vector<std::uint32_t>& values : reads.circles()) {
    const bool others = std::ranges::any_of(
        values, [&](std::uint32_t value) { return !is_integral(value) && kind(value) != ValueKind::is; });
    if (others || std::ranges::count_if(values, is_integral) < 2) continue;
    const bool damped = std::ranges::any_of(values, [&](std::uint32_t value) {
      return is_integral(value) && !reads.circle_of(value, values, true).empty();
    });
    if (damped) continue;
    const std::uint32_t first = *std::ranges::find_if(values, is_integral);
    const std::vector<std::uint32_t> circle = reads.circle_of(first, values, false);
    std::string text = fmt::format("`{}`", find.plant.values[first].name);
    for (std::size_t i = 1; i < circle.size(); ++i) {
      if (i > kMostNames && i + 1 < circle.size()) continue;
      text += fmt::format("{} reads `{}`", i + 1 == circle.size() && i > kMostNames ? ", ..." : "",
                          find.plant.values[circle[i]].name);
    }
    at(find, first)
        .say("{}: integrals in a circle without damping grow with each step; use `linear`, or a shorter `step`", text);
  }
}

void number_not_driven(const Find& find) {
  if (find.plant.values.empty() && find.plant.signals.empty()) return;
  std::vector<const Symbol*> left;
  for (const Symbol& symbol : find.symbols) {
    const bool is_number = symbol.direction == Direction::event && symbol.type != tables::DataType::boolean;
    if (!is_number || symbol.account != model::Account::numeric || symbol.leader != kNone) continue;
    const std::uint32_t unit = symbol.unit_of_device();
    if (symbol.initial != 0 || (unit != kNone && find.units[unit].has_behaviour())) continue;
    left.push_back(&symbol);
  }
  if (left.empty()) return;
  std::string names;
  for (std::size_t i = 0; i < std::min(left.size(), kMostNames); ++i) {
    names += fmt::format("{}`{}`", i == 0 ? "" : ", ", left[i]->name());
  }
  if (left.size() > kMostNames) names += fmt::format(" and {} more", left.size() - kMostNames);
  Finding finding = find.at(*left.front());
  finding.as.subjects.shape.clear();  // it is the only one
  finding.say("nothing gives {} a number: add {} to `signals`", names, left.size() == 1 ? "it" : "them");
}

void value_not_read(const Find& find) {
  if (find.plant.values.empty() || !find.evidence.faults.empty()) return;
  std::vector<bool> is_read(find.plant.values.size());
  for (const Read& read : model::reads_of(find.plant)) {
    const bool by_itself = read.reader == Read::Reader::value && read.by == read.of;
    if (read.what == Read::What::value && !by_itself) is_read[read.of] = true;
  }
  for (std::uint32_t v = 0; v < is_read.size(); ++v) {
    if (is_read[v] || find.plant.description->values[find.plant.values[v].given].trace.value_or(0) != 0) continue;
    at(find, v).say("nothing reads `{}`: remove it, or give it a `trace` if it is only for the trace and the panel",
                    find.plant.values[v].name);
  }
}

constexpr Rule kValueRules[] = {
    {"SP640", "integrals-undamped", kNote, integrals_undamped, "integrals read each other in a circle without damping",
     "Two integrals or more depend on each other, directly or through values with `is`, no value of another kind is in "
     "the circle, and no integral reads itself: a mass on a spring, an undamped pendulum.",
     "A step is explicit (Euler): x'' = -4 x grows 3.3 times in 60 s with a step of 10 ms, 1.1 times with 1 ms.",
     "Use `linear` with a discrete model, a shorter `step`, or add the friction that the plant has."},
    {"SP641", "number-not-driven", kNote, number_not_driven, "numeric inputs of the PLC without a source",
     "The plant has values or signals, and no signal, no sensor and no custom behavior gives these inputs a number. "
     "Inputs with an Initial other than 0 are not reported. One finding names them all.",
     "The PLC reads 0 until a scenario, a link or a person sets a number.",
     "Add them to `signals`, or write the number in the column Initial."},
    {"SP642", "value-not-read", kNote, value_not_read, "a value that nothing reads",
     "No other value, signal, condition, drive or travel time reads it. A value whose `trace` is given, and is not "
     "`false`, is not reported: it is there to be looked at.",
     "Nothing. But a formula or condition that should read it may name another value.",
     "Name it where it is meant, give it a `trace`, or remove it."},
};

}  // namespace

std::span<const Rule> value_rules() { return kValueRules; }

}  // namespace symplant::check
