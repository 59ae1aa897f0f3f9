// Runs the automaton of a pattern.
#include <algorithm>

#include "name/pattern.hpp"
#include "text/utf8.hpp"

namespace symplant::name {
namespace {

using Step = Pattern::Step;

/// One match. Each pair of a step and an offset is tried once.
class Match {
 public:
  Match(const std::vector<Step>& steps, const PreparedText& text, const FieldTest& test, Captures& captures)
      : steps_(steps), text_(text), test_(test), captures_(captures), columns_(text.size() + 1) {
    tried_.resize((steps.size() * columns_ + 63) / 64);
  }

  bool from(std::uint32_t index, std::size_t at) {
    const std::size_t key = index * columns_ + at;
    std::uint64_t& word = tried_[key / 64];
    const std::uint64_t bit = std::uint64_t{1} << (key % 64);
    if ((word & bit) != 0) return false;
    word |= bit;
    const Step& step = steps_[index];
    switch (step.kind) {
      case Step::Kind::end:
        return at == text_.size();
      case Step::Kind::literal:
        return text_.folded().substr(at).starts_with(step.literal) && from(step.next, at + step.literal.size());
      case Step::Kind::separator:
        return separator(step, at);
      case Step::Kind::split:
        return std::any_of(step.alternatives.begin(), step.alternatives.end(),
                           [&](std::uint32_t alternative) { return from(alternative, at); });
      case Step::Kind::any:
        for (std::size_t end = at; end <= text_.size(); ++end) {
          if (begins_character(end) && from(step.next, end)) return true;
        }
        return false;
      case Step::Kind::field:
        return field(step, at);
    }
    return false;
  }

 private:
  bool begins_character(std::size_t at) const {
    return at == text_.size() || !text::is_continuation(text_.shown()[at]);
  }

  bool separator(const Step& step, std::size_t at) {
    if (at < text_.size() && text_.is_separator(at)) return from(step.next, text_.run_end(at));
    const bool nothing_left = at == 0 || at == text_.size() || text_.is_separator(at - 1);
    return nothing_left && from(step.next, at);
  }

  bool field(const Step& step, std::size_t at) {
    if (step.may_be_empty) return run(step, at, at, text_.size());
    if (at == text_.size() || text_.is_separator(at)) return false;
    if (step.fused) return run(step, at, at + 1, step.tail ? text_.size() : text_.run_end(at));
    for (std::size_t end = text_.run_end(at);;) {  // at ends of words
      if (take(step, at, end)) return true;
      if (!(step.tail || step.known) || end == text_.size()) return false;
      end = text_.run_end(text_.run_end(end));
    }
  }

  /// The ends of characters in [first, last].
  bool run(const Step& step, std::size_t at, std::size_t first, std::size_t last) {
    for (std::size_t end = first; end <= last; ++end) {
      if (!begins_character(end)) continue;
      if (end > at && !step.may_be_empty && text_.is_separator(end - 1)) continue;
      if (take(step, at, end)) return true;
    }
    return false;
  }

  bool take(const Step& step, std::size_t begin, std::size_t end) {
    if (!test_.fits(step.field, text_, begin, end, step.known, step.fused)) return false;
    Capture& capture = captures_[static_cast<std::size_t>(step.field)];
    const Capture before = capture;
    capture = {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end), true, step.fused};
    if (from(step.next, end)) return true;
    capture = before;
    return false;
  }

  const std::vector<Step>& steps_;
  const PreparedText& text_;
  const FieldTest& test_;
  Captures& captures_;
  std::size_t columns_;
  std::vector<std::uint64_t> tried_;
};

}  // namespace

bool Pattern::match(const PreparedText& text, const FieldTest& test, Captures& captures) const {
  captures = {};
  return Match(steps_, text, test, captures).from(first_, 0);
}

}  // namespace symplant::name
