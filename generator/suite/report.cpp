// Shows the results of a suite.
#include "suite/report.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "base/frame.hpp"
#include "compare/formats.hpp"
#include "compare/words.hpp"
#include "diag/encode.hpp"
#include "diag/visible_text.hpp"
#include "symplant/trace/junit_xml.hpp"
#include "view/json_writer.hpp"

namespace symplant::suite {

// The texts of generator/suite/page, embedded in the tool.
std::string_view suite_frame();
std::string_view suite_style();
std::string_view suite_script();

namespace {

using Verdict = Result::Verdict;
using Reference = Result::Reference;

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line;
  return text;
}

std::string reference_words(Reference reference) {
  switch (reference) {
    case Reference::none:
      return "no reference trace";
    case Reference::same:
      return "as the reference trace";
    case Reference::differs:
      return "differs from the reference trace";
    case Reference::added:
      return "reference trace written";
    case Reference::updated:
      return "reference trace updated";
  }
  return "";
}

}  // namespace

void write_result(const Result& result, std::ostream& out) {
  const bool well = result.verdict == Verdict::passed;
  out << (well                                ? "passed "
          : result.verdict == Verdict::failed ? "FAILED "
                                              : "ERROR  ")
      << diag::visible(result.title());
  const bool special = result.reference == Reference::added || result.reference == Reference::updated;
  if (special) out << ": " << reference_words(result.reference);
  out << "\n";
  if (well && !special) return;
  for (const std::string& message : result.messages) out << "    " << diag::visible(message) << "\n";
}

void Counts::add(const Result& result) {
  ++(result.verdict == Verdict::passed ? passed : result.verdict == Verdict::failed ? failed : errors);
  if (result.reference == Reference::none && result.verdict != Verdict::error) ++without_reference;
  if (result.reference == Reference::added || result.reference == Reference::updated) ++written;
}

std::string summary(const Counts& counts) {
  std::string text =
      fmt::format("{}: {} passed, {} failed", compare::counted(counts.passed + counts.failed + counts.errors, "case"),
                  counts.passed, counts.failed);
  if (counts.errors != 0) text += ", " + compare::counted(counts.errors, "error");
  if (counts.missing != 0) text += fmt::format(", {} without a result", counts.missing);
  if (counts.written != 0) text += "; " + compare::counted(counts.written, "reference trace") + " written";
  if (counts.without_reference != 0) text += fmt::format("; {} without a reference trace", counts.without_reference);
  return text;
}

std::string missing_text(const Results& results, const Counts& counts) {
  if (counts.missing == 0) return "";
  constexpr std::size_t kMostNamed = 20;
  std::string numbers;
  std::size_t lacking = 0;
  for (std::size_t number = 0; number < results.header().count; ++number) {
    if (results.has(number)) continue;
    if (lacking < kMostNamed) numbers += fmt::format("{}{}", lacking == 0 ? "" : ", ", number + 1);
    ++lacking;
  }
  if (lacking > kMostNamed) numbers += ", ...";
  // Of one part of a suite the others are not missed.
  const std::string which = lacking == counts.missing ? fmt::format(" (of the suite: number {})", numbers) : "";
  return fmt::format("{} without a result{}: a part is missing, or a run was interrupted",
                     compare::counted(counts.missing, "case"), which);
}

std::string junit_text(const Results& results, const Counts& counts) {
  std::vector<trace::TestCase> cases;
  double wall = 0;
  for (std::size_t number = 0; number < results.header().count; ++number) {
    if (!results.has(number)) continue;
    const Result result = results.read(number);
    wall += result.seconds;
    const auto time = static_cast<tables::Time>(result.seconds * 1e9);
    const std::string why = joined(result.messages);
    const bool failed = result.verdict == Verdict::failed;
    const bool error = result.verdict == Verdict::error;
    cases.push_back({result.title(), time, failed ? why : "", error ? why : ""});
  }
  if (std::string missing = missing_text(results, counts); !missing.empty()) {
    cases.push_back({"every case has a result", 0, "", std::move(missing)});
  }
  return trace::junit_xml(results.header().of, cases, static_cast<tables::Time>(wall * 1e9));
}

void write_html(const Results& results, const Counts& counts, base::TextSink& sink) {
  const auto data = [&](base::TextSink& out) {
    const auto json_text = [&](base::TextSink& text) {
      view::JsonWriter json(text, view::JsonWriter::Form::compact);
      json.begin_object();
      json.member("summary", summary(counts));
      json.key("chart");
      json.value(base::text_of(
          [](base::TextSink& page) { compare::write_chart_page("symplant", base::whole("@data@"), page); }));
      json.key("cases");
      json.begin_array();
      for (std::size_t number = 0; number < results.header().count; ++number) {
        if (!results.has(number)) continue;
        const Result result = results.read(number);
        json.begin_object();
        json.member("title", diag::visible(result.title()));
        json.member("verdict", std::string(verdict_name(result.verdict)));
        json.member("reference", reference_words(result.reference));
        json.member("seconds", fmt::format("{:.3f}", result.seconds));
        json.key("messages");
        json.array(result.messages, [&](const std::string& message) { json.value(diag::visible(message)); });
        json.member("chart", result.chart);
        json.end_object();
      }
      json.end_array();
      json.end_object();
      json.finish();
    };
    out.put(diag::script_json(base::text_of(json_text)));
  };
  base::put_framed(suite_frame(),
                   {{"@title@", base::whole(diag::markup_text(results.header().of))},
                    {"@style@", [](base::TextSink& out) { out.put(suite_style()); }},
                    {"@data@", data},
                    {"@script@", [](base::TextSink& out) { out.put(suite_script()); }}},
                   sink);
}

}  // namespace symplant::suite
