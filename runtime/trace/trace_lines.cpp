// The lines of a trace file, one by one.
#include "symplant/trace/trace_lines.hpp"

#include <istream>
#include <nlohmann/json.hpp>

namespace symplant::trace {

bool TraceLines::next(nlohmann::json& line) { return next_text() && parse(line); }

bool TraceLines::next(nlohmann::json& line, std::optional<PlainChange>& change) {
  change.reset();
  if (!next_text()) return false;
  if (begun_) change = plain_change(text_);
  if (!change) return parse(line);
  is_header_ = is_set_back_ = false;
  error_ = check_time(change->time);
  return error_.empty();
}

bool TraceLines::next_text() {
  while (error_.empty() && std::getline(file_, text_)) {
    ++number_;
    if (!text_.empty() && text_.back() == '\r') text_.pop_back();
    if (!text_.empty()) return true;
  }
  if (number_ == 0 && error_.empty()) {
    number_ = 1;
    error_ = "the file is empty";
  }
  return false;
}

bool TraceLines::parse(nlohmann::json& line) {
  line = nlohmann::json::parse(text_, nullptr, false);
  if (!line.is_object() && file_.eof() && (begun_ || text_.starts_with('{'))) {
    cut_off_ = begun_;
    if (!begun_) error_ = "the file ends within its first line, so it has no changes";
    return false;
  }
  error_ = check(line);
  return error_.empty();
}

std::string TraceLines::check(const nlohmann::json& line) {
  if (!line.is_object()) return "this is not a line of a trace";
  is_header_ = line.contains("symplant-trace");
  if (is_header_ && line["symplant-trace"] != 1) return "this symplant reads version 1 of traces";
  if (!is_header_ && !begun_) return "a trace begins with a line with `symplant-trace`";
  const auto time = line.find("t");
  if (time == line.end() && is_header_) {
    if (begun_) return "another trace begins here: read one at a time";
    begun_ = true;
    return "";
  }
  if (time == line.end() || !time->is_number_unsigned() ||
      time->get<std::uint64_t>() >= static_cast<std::uint64_t>(tables::kNever)) {
    return "the key `t` is not a time in ns";
  }
  const auto at = static_cast<tables::Time>(time->get<std::uint64_t>());
  is_set_back_ = line.contains("reset") || line.contains("restored");
  return check_time(at);
}

std::string TraceLines::check_time(tables::Time time) {
  if (time < time_ && begun_ && !is_set_back_) return "this time is before that of the line above";
  begun_ = true;
  time_ = time;
  return "";
}

}  // namespace symplant::trace
