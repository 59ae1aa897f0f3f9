// Two sessions on one time axis, as SVG.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "compare/session.hpp"
#include "diag/encode.hpp"

namespace symplant::compare {
namespace {

using tables::Time;

constexpr double kLeft = 74;    ///< of the axis
constexpr double kWidth = 910;  ///< of the axis
constexpr double kLane = 118;   ///< height of a session
constexpr double kTop = 12;
constexpr double kHeight = kTop + 2 * kLane + 26;

/// A round time so that at most eleven ticks fit.
Time tick_of(Time end) {
  Time tick = tables::kMillisecond;
  for (int i = 0; end / tick > 10; ++i) tick = i % 3 == 1 ? tick / 2 * 5 : tick * 2;
  return tick;
}

class Chart {
 public:
  explicit Chart(const SessionComparison& of)
      : of_(of), end_(std::max({of.expert->end, of.trainee->end, tables::kMillisecond})) {}

  std::string text() {
    put(R"(<svg viewBox="0 0 1000 {}" role="group" aria-label="Steps, acts and findings of both sessions on one time axis">)",
        kHeight);
    axis();
    lane(*of_.expert, "expert", kTop);
    lane(*of_.trainee, "trainee", kTop + kLane);
    svg_ += "</svg>\n";
    return std::move(svg_);
  }

 private:
  template <class... Values>
  void put(fmt::format_string<Values...> form, Values&&... values) {
    fmt::format_to(std::back_inserter(svg_), form, std::forward<Values>(values)...);
    svg_ += '\n';
  }

  double x(Time time) const {
    return kLeft + kWidth * static_cast<double>(std::min(time, end_)) / static_cast<double>(end_);
  }

  void axis() {
    const Time tick = tick_of(end_);
    for (Time at = 0; at <= end_; at += tick) {
      put(R"(<line class="grid" x1="{0:.1f}" x2="{0:.1f}" y1="{1}" y2="{2}"/>)", x(at), kTop, kTop + 2 * kLane);
      put(R"(<text class="soft" x="{:.1f}" y="{}" text-anchor="middle">{}</text>)", x(at), kHeight - 8,
          short_seconds(at));
    }
  }

  void lane(const Session& session, std::string_view side, double top) {
    put(R"(<g class="of-{}">)", side);
    put(R"(<text x="0" y="{}" font-weight="600">{}</text>)", top + 14, side);
    label("steps", top + 40);
    steps(session, top + 24);
    label("acts", top + 74);
    marks(session.acts, side, "act", top + 62);
    label("findings", top + 102);
    marks(session.findings, side, "finding", top + 90);
    put(R"(<line class="grid" x1="0" x2="1000" y1="{0}" y2="{0}"/>)", top + kLane - 4);
    svg_ += "</g>\n";
  }

  void label(std::string_view text, double y) { put(R"(<text class="soft" x="0" y="{}">{}</text>)", y, text); }

  void steps(const Session& session, double top) {
    for (std::size_t i = 0; i < session.steps.size(); ++i) {
      const Session::Step& step = session.steps[i];
      if (!step.at || *step.took == 0) continue;
      const double from = x(*step.at - *step.took);
      const double width = std::max(1.0, x(*step.at) - from);
      const bool has_failed = step.state == "failed";
      put(R"(<g><title>step {}: {}, {}{}</title>)", i + 1, diag::markup_text(step.words), short_seconds(*step.took),
          has_failed ? ", failed" : "");
      put(R"(<rect class="step{}" x="{:.1f}" y="{}" width="{:.1f}" height="24" rx="3"/>)", has_failed ? " failed" : "",
          from, top, width);
      const std::string number = std::to_string(i + 1) + (has_failed ? " ✗" : "");
      if (width > 10 + 8 * static_cast<double>(number.size())) {
        put(R"(<text x="{:.1f}" y="{}" text-anchor="middle">{}</text>)", from + width / 2, top + 16, number);
      }
      svg_ += "</g>\n";
    }
  }

  /// Each links to its words. A number that has no room is left out.
  void marks(const std::vector<Session::Mark>& marks, std::string_view side, std::string_view kind, double top) {
    double free = 0;
    for (std::size_t i = 0; i < std::min(marks.size(), kMostMarks); ++i) {
      const double at = x(marks[i].at);
      put(R"(<a href="#{}-{}-{}"><title>{}: {}</title>)", side, kind, i + 1, short_seconds(marks[i].at),
          diag::markup_text(marks[i].words));
      put(R"(<path class="{}" d="M{:.1f} {}l5 9h-10z"/>)", kind, at, top);
      const std::string number = std::to_string(i + 1);
      const double width = 8 * static_cast<double>(number.size());
      if (at - width / 2 > free) {
        put(R"(<text x="{:.1f}" y="{}" text-anchor="middle">{}</text>)", at, top + 21, number);
        free = at + width / 2 + 2;
      }
      svg_ += "</a>\n";
    }
  }

  const SessionComparison& of_;
  Time end_;
  std::string svg_;
};

}  // namespace

std::string session_chart(const SessionComparison& comparison) { return Chart(comparison).text(); }

}  // namespace symplant::compare
