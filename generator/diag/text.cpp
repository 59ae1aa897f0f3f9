// Findings as text for people.
#include "diag/text.hpp"

#include <algorithm>
#include <map>
#include <string_view>

#include "diag/visible_text.hpp"
#include "text/utf8.hpp"

namespace symplant::diag {

namespace {

constexpr std::size_t kWindow = 120;         ///< the most columns shown of a row
constexpr std::size_t kBeforeLocation = 40;  ///< characters shown before the location in a long row
constexpr std::size_t kTabStop = 4;
constexpr std::string_view kEllipsis = "…";

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

  std::string render(std::span<const Diagnostic> findings) {
    std::map<std::string_view, Count> counts;
    for (const Diagnostic& finding : findings) {
      Count& count = counts[finding.rule->id];
      count.rule = finding.rule;
      if (options_.fold_after != 0 && count.shown >= most(finding.severity)) {
        ++count.left;
        continue;
      }
      one(finding);
      ++count.shown;
    }
    for (const auto& [id, count] : counts) {
      if (count.left == 0) continue;
      text_ += "... and " + std::to_string(count.left) + " more of ";
      text_.append(id).append(" ").append(count.rule->slug).append("; --format json lists all\n");
    }
    return std::move(text_);
  }

 private:
  struct Count {
    const RuleInfo* rule = nullptr;
    std::size_t shown = 0;
    std::size_t left = 0;
  };

  std::size_t most(Severity severity) const {
    return severity == Severity::note ? std::min(options_.fold_after, options_.fold_notes_after) : options_.fold_after;
  }

  void one(const Diagnostic& finding) {
    head(finding.location, finding.severity, finding.message);
    text_.append(" [").append(finding.rule->id).append(" ").append(finding.rule->slug).append("]\n");
    row(finding.location);
    const Location* shown = &finding.location;
    const std::size_t most = options_.fold_after == 0 ? finding.related.size() : options_.fold_related_after;
    for (std::size_t i = 0; i < std::min(most, finding.related.size()); ++i) {
      const Related& related = finding.related[i];
      head(related.location, Severity::note, related.message);
      text_ += '\n';
      if (!same(*shown, related.location)) row(related.location);
      shown = &related.location;
    }
    if (finding.related.size() > most) {
      text_ +=
          "... and " + std::to_string(finding.related.size() - most) + " more related rows; --format json lists all\n";
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
  std::string text_;
};

}  // namespace

std::string render_text(std::span<const Diagnostic> findings, const TextOptions& options) {
  return TextRenderer(options).render(findings);
}

}  // namespace symplant::diag
