// Two sessions as one page without a script.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "base/frame.hpp"
#include "compare/session.hpp"
#include "diag/encode.hpp"

namespace symplant::compare {

// The texts of generator/compare/page, embedded in the tool.
std::string_view session_frame();
std::string_view session_style();

namespace {

std::string encoded(std::string_view text) { return diag::markup_text(text); }

std::string side_line(std::string_view side, const Session& of) {
  std::string names;
  for (const std::string& name : of.names) names += (names.empty() ? "" : ", ") + name;
  return fmt::format("<p>{}: <strong>{}</strong>{}</p>\n", side, encoded(of.file),
                     names.empty() ? "" : ", " + encoded(names));
}

void put_table(std::string& html, std::string_view title, std::string_view head, const std::vector<SessionRow>& rows) {
  if (rows.empty()) return;
  html += fmt::format(
      "<section><h2>{0}</h2>\n<div class=\"wide\" tabindex=\"0\" role=\"group\" "
      "aria-label=\"{0}\"><table><thead><tr><th scope=\"col\">{1}</th><th "
      "scope=\"col\">Expert</th>"
      "<th scope=\"col\">Trainee</th><th scope=\"col\">Difference</th><th "
      "scope=\"col\">Ratio</th></tr></thead><tbody>\n",
      title, head);
  for (const SessionRow& row : rows) {
    html += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                        encoded(row.what), row.expert, row.trainee, row.difference, row.ratio);
  }
  html += "</tbody></table></div></section>\n";
}

void put_marks(std::string& html, std::string_view side, std::string_view kind,
               const std::vector<Session::Mark>& marks) {
  html += fmt::format("<div><h3>{}</h3>\n", side == "expert" ? "Expert" : "Trainee");
  if (marks.empty()) html += "<p class=\"soft\">none</p>\n";
  if (!marks.empty()) html += "<ol>\n";
  for (std::size_t i = 0; i < std::min(marks.size(), kMostMarks); ++i) {
    html += fmt::format("<li id=\"{}-{}-{}\"><span class=\"time\">{}</span> {}</li>\n", side, kind, i + 1,
                        short_seconds(marks[i].at), encoded(marks[i].words));
  }
  if (!marks.empty()) html += "</ol>\n";
  if (marks.size() > kMostMarks) html += fmt::format("<p class=\"soft\">and {} more</p>\n", marks.size() - kMostMarks);
  html += "</div>\n";
}

std::string content_of(const SessionComparison& comparison) {
  const Session& expert = *comparison.expert;
  const Session& trainee = *comparison.trainee;
  std::string html = fmt::format("<header>\n<h1>{}: expert and trainee</h1>\n",
                                 encoded(expert.exercise.empty() ? expert.plant : expert.exercise));
  html += side_line("Expert", expert) + side_line("Trainee", trainee);
  html += fmt::format("<p class=\"soft\">Plant {}. Times are plant times since the start of the exercise.</p>\n",
                      encoded(expert.plant));
  if (!comparison.warning.empty()) html += fmt::format("<p class=\"note\">{}</p>\n", encoded(comparison.warning));
  html += "</header>\n<main>\n";
  put_table(html, "Result", "Of the session", comparison.totals);
  html += "<section><h2>Course</h2>\n<div class=\"wide\" tabindex=\"0\" role=\"group\" aria-label=\"Chart\">\n" +
          session_chart(comparison) +
          "</div>\n<p class=\"soft\">Bands are steps, triangles are acts and findings. Their numbers are those of the "
          "lists below.</p></section>\n";
  put_table(html, "Steps", "Step", comparison.steps);
  put_table(html, "Reaction times", "Malfunction", comparison.reactions);
  html += "<section><h2>Acts</h2>\n<div class=\"sides\">\n";
  put_marks(html, "expert", "act", expert.acts);
  put_marks(html, "trainee", "act", trainee.acts);
  html += "</div></section>\n<section><h2>Findings</h2>\n<div class=\"sides\">\n";
  put_marks(html, "expert", "finding", expert.findings);
  put_marks(html, "trainee", "finding", trainee.findings);
  return html + "</div></section>\n</main>\n";
}

}  // namespace

void write_html(const SessionComparison& comparison, base::TextSink& sink) {
  const Session& expert = *comparison.expert;
  base::put_framed(session_frame(),
                   {{"@title@", base::whole(encoded("Expert and trainee: " +
                                                    (expert.exercise.empty() ? expert.plant : expert.exercise)))},
                    {"@style@", [](base::TextSink& out) { out.put(session_style()); }},
                    {"@content@", base::whole(content_of(comparison))}},
                   sink);
}

}  // namespace symplant::compare
