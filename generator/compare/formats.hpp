// The forms in which a comparison is shown.
#pragma once

#include <functional>
#include <string>

#include "base/text_source.hpp"
#include "compare/difference.hpp"

namespace symplant::view {
class JsonWriter;
}

namespace symplant::compare {

inline constexpr int kJsonVersion = 1;

/// The first differences, then counts.
void write_text(const Comparison& comparison, base::TextSink& sink);
/// Every difference, for programs.
void write_json(const Comparison& comparison, base::TextSink& sink);
/// The same with further members, which `more` writes.
void write_json(const Comparison& comparison, const std::function<void(view::JsonWriter&)>& more, base::TextSink& sink);
/// A test case for each symbol, for build servers.
void write_junit(const Comparison& comparison, base::TextSink& sink);
/// Both traces as one chart with the differences marked: one page that needs no network.
void write_html(const Comparison& comparison, base::TextSink& sink);
/// The same with a section of HTML above the chart.
void write_html(const Comparison& comparison, const std::string& section, base::TextSink& sink);

/// The data of the page of write_html(), as JSON.
std::string chart_data(const Comparison& comparison);
/// Writes the page of write_html() with chart data that is encoded by diag::script_json(), and with a section of HTML.
void write_chart_page(const std::string& title, const base::TextSource& data, base::TextSink& sink,
                      const std::string& section = {});

}  // namespace symplant::compare
