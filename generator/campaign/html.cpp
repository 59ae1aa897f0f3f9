// The results of a campaign as one page for a browser.
#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <unordered_map>

#include "base/frame.hpp"
#include "campaign/report.hpp"
#include "compare/formats.hpp"
#include "diag/encode.hpp"
#include "diag/visible_text.hpp"
#include "view/json_writer.hpp"

namespace symplant::campaign {

// The texts of generator/campaign/page, embedded in the tool.
std::string_view campaign_frame();
std::string_view campaign_style();
std::string_view campaign_script();

namespace {

using Json = nlohmann::ordered_json;
using diag::visible;

constexpr std::size_t kMostChartBytes = std::size_t{48}
                                        << 20U;  ///< the worst rows have charts, so that a browser opens the page

/// The classes, worst first, in words that need no knowledge of the tool.
struct ClassWords {
  Class is;
  std::string_view words;
};
constexpr std::array<ClassWords, kClasses> kClassWords{{
    {Class::error, "The run has no result: the program crashed, or it could not run."},
    {Class::violated, "A requirement of the plant is violated."},
    {Class::undetected, "The program reads something else than without the fault, and its outputs stay the same."},
    {Class::stopped, "No alarm comes on, and the outputs stop changing. Those that stay on are in the last column."},
    {Class::other, "No alarm comes on, and the outputs differ from those without the fault."},
    {Class::detected, "An alarm comes on that is off without the fault."},
    {Class::no_effect,
     "What the program reads is the same as without the fault: the base case does not need what fails, or the program "
     "does not read it. This does not mean that the fault is harmless."},
}};

class Page {
 public:
  Page(const Results& results, const Overview& overview, base::TextSink& sink)
      : results_(results), overview_(overview), json_(sink, view::JsonWriter::Form::compact) {}

  void write() {
    json_.begin_object();
    json_.member("plant", visible(results_.header().of));
    json_.key("run");
    json_.literal(results_.header().more);
    json_.member("summary", summary(overview_));
    json_.key("classes");
    json_.array(kClassWords,
                [&](const ClassWords& one) { json_.row(class_name(one.is), one.words, overview_.count(one.is)); });
    json_.key("chart");
    json_.value(base::text_of(
        [](base::TextSink& page) { compare::write_chart_page("symplant", base::whole("@data@"), page); }));
    json_.key("rows");
    json_.begin_array();
    for (const std::size_t number : overview_.numbers) write_row(results_.read(number));
    json_.end_array();
    json_.key("base");
    json_.begin_array();
    for (const std::string* const changes : base_in_order_) json_.literal(*changes);
    json_.end_array();
    json_.end_object();
    json_.finish();
  }

 private:
  void write_row(const Result& result) {
    json_.begin_object();
    json_.member("item", visible(result.item));
    json_.member("more", visible(result.more));
    json_.member("mode", visible(result.mode));
    json_.member("phase", visible(result.phase));
    json_.member("at", result.at);
    json_.member("class", class_name(result.is));
    json_.member("seen", visible(result.seen));
    json_.member("seen_at", result.seen_at);
    json_.member("reaction", visible(result.reaction));
    json_.member("requirement", visible(result.requirement));
    json_.member("violated_at", result.violated_at);
    json_.member("step", visible(result.failed_step));
    write_names("alarms", result.alarms);
    json_.member("detection", result.detection);
    write_names("on", result.on);
    json_.member("end", visible(result.end));
    json_.member("ran", result.ran);
    json_.member("command", visible(result.command));
    chart_bytes_ += result.chart.size();
    const Json chart = chart_bytes_ > kMostChartBytes ? Json() : Json::parse(result.chart, nullptr, false);
    if (chart.is_object()) write_chart(chart);
    json_.member("no_room", chart_bytes_ > kMostChartBytes);
    json_.end_object();
  }

  void write_names(std::string_view key, const std::vector<std::string>& names) {
    json_.key(key);
    json_.array(names, [&](const std::string& name) { json_.value(visible(name)); });
  }

  /// The changes of the base case are written once for all rows.
  void write_chart(const Json& chart) {
    json_.key("chart");
    json_.begin_object();
    json_.key("series");
    json_.array(chart.at("series"), [&](const Json& series) {
      const auto [found, is_new] = base_.try_emplace(series.at("base").dump(), base_.size());
      if (is_new) base_in_order_.push_back(&found->first);
      json_.begin_array();
      json_.value(series.at("name").get<std::string>());
      json_.value(found->second);
      json_.literal(series.at("run").dump());
      json_.end_array();
    });
    for (const char* const key : {"differences", "end", "left_out", "cut"}) {
      json_.key(key);
      json_.literal(chart.at(key).dump());
    }
    json_.end_object();
  }

  const Results& results_;
  const Overview& overview_;
  view::JsonWriter json_;
  std::size_t chart_bytes_ = 0;                        ///< of the rows so far
  std::unordered_map<std::string, std::size_t> base_;  ///< the number of each list of changes of the base case
  std::vector<const std::string*> base_in_order_;
};

}  // namespace

void write_html(const Results& results, const Overview& overview, base::TextSink& sink) {
  const auto data = [&](base::TextSink& out) {
    out.put(diag::script_json(base::text_of([&](base::TextSink& text) { Page(results, overview, text).write(); })));
  };
  base::put_framed(campaign_frame(),
                   {{"@title@", base::whole(diag::markup_text("Fault campaign of " + results.header().of))},
                    {"@style@", [](base::TextSink& out) { out.put(campaign_style()); }},
                    {"@data@", data},
                    {"@script@", [](base::TextSink& out) { out.put(campaign_script()); }}},
                   sink);
}

}  // namespace symplant::campaign
