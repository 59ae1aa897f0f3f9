// Findings as text for people.
#include "diag/text.hpp"

#include <algorithm>
#include <map>
#include <string_view>
#include <vector>

#include "diag/importance.hpp"
#include "diag/visible_text.hpp"
#include "text/utf8.hpp"

namespace symplant::diag {

namespace {

constexpr std::size_t kWindow = 120;         ///< the most columns shown of a row
constexpr std::size_t kBeforeLocation = 40;  ///< characters shown before the location in a long row
constexpr std::size_t kTabStop = 4;
constexpr std::string_view kEllipsis = "…";
constexpr std::size_t kFewOfRule = 3;  ///< warnings or notes
constexpr std::size_t kErrorsOfRule = 5;
constexpr std::size_t kFewRelated = 3;  ///< related rows of one finding

struct Colours {
  std::string_view bold, error, warning, note, mark, reset;
};
constexpr Colours kPlain{};
constexpr Colours kAnsi{"\x1b[1m", "\x1b[1;31m", "\x1b[1;35m", "\x1b[1;36m", "\x1b[1;32m", "\x1b[0m"};

std::string_view colour_of(const Colours& colours, Severity severity) {
  switch (severity) {
    case Severity::error:
      return colours.error;
    case Severity::warning:
      return colours.warning;
    case Severity::note:
      return colours.note;
  }
  return {};
}

/// A line as shown, and the location in it in columns of the terminal.
struct Excerpt {
  std::string shown;
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// The offset at which the shown part begins, so that the location is in the window.
std::size_t window_begin(std::string_view line, std::size_t location) {
  // A character takes at most eight columns (usually <U+XXXX>); a short line is shown from its beginning.
  if (location <= kWindow / 2) return 0;
  std::size_t begin = location;
  for (std::size_t left = kBeforeLocation; begin > 0 && left > 0; --left) {
    do --begin;
    while (begin > 0 && text::is_continuation(line[begin]));
  }
  return begin;
}

/// `location` is in bytes of `line`. Reads only the part of the line that it shows.
Excerpt cut_out(std::string_view line, text::Span location) {
  Excerpt excerpt;
  std::size_t at = line.size() <= kWindow ? 0 : window_begin(line, location.begin);
  std::size_t column = 0;
  if (at > 0) {
    excerpt.shown += kEllipsis;
    column = 1;
  }
  bool begun = false;
  bool ended = false;
  for (;;) {
    if (!begun && at >= location.begin) {
      excerpt.begin = column;
      begun = true;
    }
    if (!ended && at >= location.end) {
      excerpt.end = column;
      ended = true;
    }
    if (at >= line.size()) break;
    if (column >= kWindow) {
      excerpt.shown += kEllipsis;
      break;
    }
    const text::CodePoint point = text::code_point_at(line, at);
    at += point.length;
    if (point.value == U'\t') {
      const std::size_t blanks = kTabStop - column % kTabStop;
      excerpt.shown.append(blanks, ' ');
      column += blanks;
    } else if (is_unsafe(point.value)) {
      const std::string text = escaped(point.value);
      excerpt.shown += text;
      column += text.size();
    } else {
      text::append_utf8(excerpt.shown, point.value);
      column += static_cast<std::size_t>(display_width(point.value));
    }
  }
  if (!begun) excerpt.begin = column;
  if (!ended) excerpt.end = column;
  return excerpt;
}

bool same(const Location& a, const Location& b) {
  return a.source == b.source && a.span.begin == b.span.begin && a.span.end == b.span.end;
}

class TextRenderer {
 public:
  explicit TextRenderer(const TextOptions& options) : options_(options), colours_(options.colour ? kAnsi : kPlain) {}

  std::string render_all(std::span<const Diagnostic> findings) {
    for (const Diagnostic& finding : findings) {
      one(finding);
      const Location* shown = &finding.location;
      for (const Related& related : finding.related) {
        head(related.location, Severity::note, related.message);
        text_ += '\n';
        if (!same(*shown, related.location)) row(related.location);
        shown = &related.location;
      }
    }
    return std::move(text_);
  }

  std::string render_first(std::span<const Diagnostic> findings) {
    std::size_t shown = 0;
    std::map<std::string_view, std::size_t> of_rule;
    for (const Diagnostic* finding : by_importance(findings)) {
      const bool error = finding->severity == Severity::error;
      std::size_t& of_this = of_rule[finding->rule->slug];
      if (finding->severity < options_.least || shown >= (error ? options_.most_errors : options_.most) ||
          of_this == (error ? kErrorsOfRule : kFewOfRule)) {
        leave_out(*finding);
        continue;
      }
      const std::size_t before = text_.size();
      one(*finding);
      if (finding->count == 1) first_related(*finding);
      if (shown > 0 && static_cast<std::size_t>(std::count(text_.begin(), text_.end(), '\n')) > options_.most_lines) {
        text_.resize(before);
        leave_out(*finding);
        continue;
      }
      ++shown;
      ++of_this;
    }
    report_left_out();
    return std::move(text_);
  }

 private:
  struct LeftOutOfRule {
    const RuleInfo* rule;
    Severity severity;
    std::size_t count;
  };

  void leave_out(const Diagnostic& finding) {
    for (LeftOutOfRule& left : left_out_) {
      if (left.rule != finding.rule || left.severity != finding.severity) continue;
      left.count += finding.count;
      return;
    }
    left_out_.push_back({finding.rule, finding.severity, finding.count});
  }

  void report_left_out() {
    for (const Severity severity : {Severity::error, Severity::warning, Severity::note}) {
      std::string rules;
      for (const LeftOutOfRule& left : left_out_) {
        if (left.severity != severity) continue;
        rules.append(rules.empty() ? "" : ", ").append(std::to_string(left.count)).append(" ").append(left.rule->slug);
      }
      if (rules.empty()) continue;
      text_.append("... and ").append(severity < options_.least ? "" : "more ").append(severity_name(severity));
      text_.append("s: ").append(rules).append("; --verbose shows all\n");
    }
  }

  void one(const Diagnostic& finding) {
    head(finding.location, finding.severity, finding.message);
    text_.append(" [").append(finding.rule->id).append(" ").append(finding.rule->slug).append("]\n");
    row(finding.location);
  }

  /// On one line each: where to look. An error shows the rows as well.
  void first_related(const Diagnostic& finding) {
    const std::size_t shown = std::min(kFewRelated, finding.related.size());
    for (std::size_t i = 0; i < shown; ++i) {
      head(finding.related[i].location, Severity::note, finding.related[i].message);
      text_ += '\n';
      if (finding.severity == Severity::error) row(finding.related[i].location);
    }
    if (finding.related.size() > shown) {
      text_ +=
          "... and " + std::to_string(finding.related.size() - shown) + " more related rows; --verbose shows all\n";
    }
  }

  void head(const Location& location, Severity severity, std::string_view message) {
    text_ += colours_.bold;
    if (location.source) {
      text_ += visible(location.source->path()) + ":";
      if (!location.source->text().empty()) {
        const text::Position position = location.source->position(location.span.begin);
        text_ += std::to_string(position.line) + ":" + std::to_string(position.column) + ":";
      }
      text_ += ' ';
    }
    text_ += colours_.reset;
    text_.append(colour_of(colours_, severity)).append(severity_name(severity)).append(":").append(colours_.reset);
    text_ += ' ' + visible(message);
  }

  void row(const Location& location) {
    if (!location.source || location.source->text().empty()) return;
    const text::SourceFile& source = *location.source;
    const std::string_view line = source.line_at(location.span.begin);
    const std::size_t line_begin = source.span_of(line).begin;
    const std::size_t begin = std::min(location.span.begin - line_begin, line.size());
    const std::size_t end = std::clamp(location.span.end, line_begin + begin, line_begin + line.size()) - line_begin;
    const Excerpt excerpt = cut_out(line, {begin, end});
    const std::string number = std::to_string(source.position(location.span.begin).line);
    const std::size_t margin = std::max<std::size_t>(number.size(), 5);
    text_ += std::string(margin - number.size(), ' ') + number + " | " + excerpt.shown + '\n';
    text_ += std::string(margin, ' ') + " | " + std::string(excerpt.begin, ' ');
    text_.append(colours_.mark).append("^");
    if (excerpt.end > excerpt.begin + 1) text_.append(excerpt.end - excerpt.begin - 1, '~');
    text_.append(colours_.reset).append("\n");
  }

  const TextOptions& options_;
  const Colours& colours_;
  std::vector<LeftOutOfRule> left_out_;
  std::string text_;
};

}  // namespace

std::string render_text(std::span<const Diagnostic> findings, const TextOptions& options) {
  TextRenderer renderer(options);
  return options.all ? renderer.render_all(findings) : renderer.render_first(findings);
}

}  // namespace symplant::diag
