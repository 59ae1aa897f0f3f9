// The parts of a report that count texts by their shapes.
#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "infer/report_parts.hpp"
#include "infer/words.hpp"

namespace symplant::infer {
namespace {

constexpr std::size_t kMostShapes = 20;
constexpr std::size_t kMostQuestions = 30;

/// Counts symbols by side, source and shape.
class ShapeCounter {
 public:
  explicit ShapeCounter(const ReportInput& input) : input_(input) {}

  void add(std::uint32_t sample) {
    const std::string text = input_.texts.normal(sample);
    const name::Direction side = input_.is_operation(sample) ? name::Direction::operation : name::Direction::event;
    const name::Source source = input_.texts.source(sample);
    const auto [known, added] = shapes_.emplace(std::make_tuple(shape_of(text), side, source), Found{0, sample});
    Found& found = known->second;
    ++found.count;
    if (input_.samples[sample].text.name < input_.samples[found.example].text.name) found.example = sample;
  }

  /// The commonest first.
  std::vector<TextShape> take() const {
    std::vector<TextShape> all;
    for (const auto& [key, found] : shapes_) {
      all.push_back(
          {std::get<0>(key), found.count, input_.texts.shown(found.example), std::get<1>(key), std::get<2>(key)});
    }
    std::stable_sort(all.begin(), all.end(), [](const TextShape& a, const TextShape& b) { return a.count > b.count; });
    return all;
  }

 private:
  struct Found {
    std::size_t count;
    std::uint32_t example;
  };

  const ReportInput& input_;
  std::map<std::tuple<std::string, name::Direction, name::Source>, Found> shapes_;
};

Shapes first_of(std::vector<TextShape> all) {
  Shapes shapes;
  for (std::size_t i = kMostShapes; i < all.size(); ++i) shapes.more_symbols += all[i].count;
  shapes.more_shapes = all.size() > kMostShapes ? all.size() - kMostShapes : 0;
  if (all.size() > kMostShapes) all.resize(kMostShapes);
  shapes.shown = std::move(all);
  return shapes;
}

name::SymbolRule constant_rule(const TextShape& shape, bool all_have_addresses) {
  name::SymbolRule rule;
  rule.name = "healthy " + shape.text;
  rule.patterns.push_back({shape.source, "{device...}"});
  rule.fields.push_back({"device", expression_of_shape(shape.text), {}});
  if (all_have_addresses) rule.side = name::Direction::event;
  rule.role = name::Role::constant;
  rule.value = true;
  return rule;
}

}  // namespace

void add_left_over(const ReportInput& input, Report& report) {
  ShapeCounter shapes(input);
  for (std::uint32_t i = 0; i < input.samples.size(); ++i) {
    if (input.is_left_over(i) && !input.is_asked(i)) shapes.add(i);
  }
  report.left_over = first_of(shapes.take());
}

void add_direction_conflicts(const ReportInput& input, Report& report) {
  ShapeCounter shapes(input);
  for (std::uint32_t i = 0; i < input.samples.size(); ++i) {
    const auto address = input.samples[i].text.address;
    const auto said = input.applied.readings[i].direction_of_name;
    if (address && said && *said != *address) shapes.add(i);
  }
  report.direction_conflicts = first_of(shapes.take());
}

namespace {

/// The question about interlocks, the last one.
void add_interlocks(const ReportInput& input, Report& report) {
  ShapeCounter shapes(input);
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < input.samples.size(); ++i) {
    if (input.applied.pairing.accounts[i] != name::Account::interlock) continue;
    shapes.add(i);
    ++count;
  }
  name::SymbolRule rule;
  rule.role = name::Role::interlock;
  for (const name::SymbolRule& one : input.naming.naming().rules) {
    if (one.role == name::Role::interlock) rule.has.insert(rule.has.end(), one.has.begin(), one.has.end());
  }
  if (count == 0 || rule.has.empty()) return;
  TextShape shape = shapes.take().front();
  shape.count = count;
  report.questions.push_back({std::move(shape), std::move(rule)});
}

}  // namespace

void add_questions(const ReportInput& input, Report& report) {
  ShapeCounter shapes(input);
  bool all_have_addresses = true;
  for (std::uint32_t i = 0; i < input.samples.size(); ++i) {
    if (!input.is_asked(i)) continue;
    shapes.add(i);
    ++report.asked;
    all_have_addresses = all_have_addresses && input.samples[i].text.address.has_value();
  }
  for (TextShape& shape : shapes.take()) {
    if (report.questions.size() == kMostQuestions) {
      ++report.more_questions;
      continue;
    }
    name::SymbolRule rule = constant_rule(shape, all_have_addresses);
    report.questions.push_back({std::move(shape), std::move(rule)});
  }
  add_interlocks(input, report);
}

}  // namespace symplant::infer
