// Results as lines of JSON.
#include "suite/result.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

namespace symplant::suite {
namespace {

using Json = nlohmann::json;

template <class Value, std::size_t kCount>
using Names = std::array<std::pair<Value, std::string_view>, kCount>;

constexpr Names<Result::Verdict, 3> kVerdicts{
    {{Result::Verdict::passed, "passed"}, {Result::Verdict::failed, "failed"}, {Result::Verdict::error, "error"}}};
constexpr Names<Result::Reference, 5> kReferences{{{Result::Reference::none, "none"},
                                                   {Result::Reference::same, "same"},
                                                   {Result::Reference::differs, "differs"},
                                                   {Result::Reference::added, "added"},
                                                   {Result::Reference::updated, "updated"}}};

template <class Value, std::size_t kCount>
std::string_view name_in(const Names<Value, kCount>& names, Value value) {
  return std::find_if(names.begin(), names.end(), [&](const auto& one) { return one.first == value; })->second;
}

template <class Value, std::size_t kCount>
std::optional<Value> value_in(const Names<Value, kCount>& names, const std::string& name) {
  const auto found = std::find_if(names.begin(), names.end(), [&](const auto& one) { return one.second == name; });
  return found == names.end() ? std::nullopt : std::optional(found->first);
}

}  // namespace

std::string Result::title() const {
  return speed == Speed::normal ? name : name + " on the " + std::string(speed_name(speed)) + " plant";
}

std::vector<std::string> message_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::size_t more = 0;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    lines.size() < kMostMessages ? lines.push_back(line) : static_cast<void>(++more);
  }
  if (more != 0) lines.push_back("... and " + std::to_string(more) + " more lines");
  return lines;
}

std::string_view verdict_name(Result::Verdict verdict) { return name_in(kVerdicts, verdict); }

std::string Result::line() const {
  const Json json = {{"case", name},
                     {"plant", speed_name(speed)},
                     {"verdict", verdict_name(verdict)},
                     {"reference", name_in(kReferences, reference)},
                     {"seconds", seconds},
                     {"messages", messages},
                     {"chart", chart}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<Result> Result::of_line(std::string_view line) try {
  const Json json = Json::parse(line, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  const auto speed = speed_of(json.at("plant").get<std::string>());
  const auto verdict = value_in(kVerdicts, json.at("verdict").get<std::string>());
  const auto reference = value_in(kReferences, json.at("reference").get<std::string>());
  if (!speed || !verdict || !reference) return std::nullopt;
  return Result{json.at("case"),     *speed,          *verdict, *reference, json.at("seconds"),
                json.at("messages"), json.at("chart")};
} catch (const Json::exception&) {
  return std::nullopt;
}

}  // namespace symplant::suite
