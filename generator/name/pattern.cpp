// Makes an automaton of a pattern.
#include "name/pattern.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "name/pattern_syntax.hpp"
#include "symplant/tables/nearest.hpp"
#include "text/folding.hpp"

namespace symplant::name {
namespace {

using Step = Pattern::Step;

constexpr std::array<std::string_view, kFields> kFieldNames = {"line",  "process", "device", "direction",
                                                               "class", "task",    "x"};

/// Builds the steps from the last to the first.
class PatternBuilder {
 public:
  /// `whole` is the pattern, into which the tree's texts point.
  PatternBuilder(std::string_view whole, const Separators& separators, bool archetype)
      : whole_(whole.data()), separators_(separators), archetype_(archetype) {}

  std::uint32_t add(Step step) {
    steps_.push_back(std::move(step));
    return static_cast<std::uint32_t>(steps_.size() - 1);
  }

  std::uint32_t sequence(const syntax::Sequence& nodes, std::uint32_t next) {
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
      next = boost::apply_visitor(Visitor{*this, next}, *node);
    }
    return next;
  }

  std::uint32_t group(const syntax::Group& group, std::uint32_t next) {
    if (group.alternatives.size() == 1) return sequence(group.alternatives.front(), next);
    Step split;
    split.kind = Step::Kind::split;
    for (const syntax::Sequence& alternative : group.alternatives) {
      split.alternatives.push_back(sequence(alternative, next));
    }
    return add(std::move(split));
  }

  std::vector<Step> take() { return std::move(steps_); }
  const std::optional<PatternFault>& fault() const { return fault_; }
  const std::array<bool, kFields>& fields() const { return fields_; }

 private:
  struct Visitor {
    using result_type = std::uint32_t;
    PatternBuilder& builder;
    std::uint32_t next;

    std::uint32_t operator()(const syntax::Text& text) const { return builder.text(text, next); }
    std::uint32_t operator()(const syntax::Braces& braces) const { return builder.field(braces.inside, next); }
    std::uint32_t operator()(const syntax::Any&) const {
      Step any;
      any.kind = Step::Kind::any;
      any.next = next;
      return builder.add(std::move(any));
    }
    std::uint32_t operator()(const syntax::x3::forward_ast<syntax::Group>& group) const {
      return builder.group(group.get(), next);
    }
  };

  std::uint32_t text(std::string_view characters, std::uint32_t next) {
    const std::string folded = text::folded(text::normal_form(characters));
    std::vector<std::pair<bool, std::string>> runs;  // separator?, text
    for (std::size_t at = 0; at < folded.size();) {
      const std::size_t separator = separators_.length_at(folded, at);
      const bool is_separator = separator != 0;
      if (runs.empty() || runs.back().first != is_separator) runs.emplace_back(is_separator, std::string());
      const std::size_t length = std::max<std::size_t>(separator, 1);
      runs.back().second.append(folded, at, length);
      at += length;
    }
    for (auto run = runs.rbegin(); run != runs.rend(); ++run) {
      Step step;
      step.kind = run->first ? Step::Kind::separator : Step::Kind::literal;
      step.literal = run->first ? std::string() : run->second;
      step.next = next;
      next = add(std::move(step));
    }
    return next;
  }

  std::uint32_t field(std::string_view inside, std::uint32_t next) {
    Step step;
    step.kind = Step::Kind::field;
    step.next = next;
    std::string_view name = inside;
    const auto cut = [&](std::string_view mark) {
      if (!name.ends_with(mark)) return false;
      name.remove_suffix(mark.size());
      return true;
    };
    step.tail = cut("...");
    step.known = cut(":known");
    const auto found = std::find(kFieldNames.begin(), kFieldNames.end(), name);
    step.field = static_cast<Field>(found - kFieldNames.begin());
    if (found == kFieldNames.end() || archetype_ != (step.field == Field::x)) {
      fault_ = PatternFault{static_cast<std::size_t>(inside.data() - whole_), unknown(name)};
      return next;
    }
    step.tail = step.tail || archetype_;
    step.may_be_empty = archetype_;
    step.fused = archetype_ || !ends_word(next);
    fields_[static_cast<std::size_t>(step.field)] = true;
    return add(std::move(step));
  }

  std::string unknown(std::string_view name) const {
    if (archetype_) return "unknown field `{" + std::string(name) + "}`; the texts of an archetype only have `{x}`";
    tables::NearestName nearest(name);
    for (std::size_t i = 0; i < static_cast<std::size_t>(Field::x); ++i) nearest.offer(kFieldNames[i]);
    if (!nearest.name().empty()) {
      return "unknown field `{" + std::string(name) + "}`; did you mean `{" + std::string(nearest.name()) + "}`?";
    }
    return "unknown field `{" + std::string(name) +
           "}`; fields are line, process, device, direction, class and task, with `...` for several words";
  }

  /// Whether a field that is followed by the step ends at the end of a word.
  bool ends_word(std::uint32_t next) const {
    const Step& step = steps_[next];
    if (step.kind == Step::Kind::separator || step.kind == Step::Kind::end) return true;
    return step.kind == Step::Kind::split &&
           std::all_of(step.alternatives.begin(), step.alternatives.end(),
                       [this](std::uint32_t alternative) { return ends_word(alternative); });
  }

  const char* whole_;
  const Separators& separators_;
  bool archetype_;
  std::vector<Step> steps_;
  std::array<bool, kFields> fields_{};
  std::optional<PatternFault> fault_;
};

}  // namespace

std::string_view field_name(Field field) { return kFieldNames[static_cast<std::size_t>(field)]; }

base::Result<Pattern, PatternFault> Pattern::compile(std::string_view text, const Separators& separators,
                                                     Options options) {
  const auto tree = syntax::parse(text, options.archetype);
  if (!tree) return tree.error();
  PatternBuilder builder(text, separators, options.archetype);
  Pattern pattern;
  pattern.first_ = builder.group(*tree, builder.add({}));
  if (builder.fault()) return *builder.fault();
  pattern.steps_ = builder.take();
  pattern.fields_ = builder.fields();
  return pattern;
}

}  // namespace symplant::name
