// What a trainer sees of the trainees.
#include "symplant/panel/training/training.hpp"

#include <algorithm>
#include <optional>

#include "symplant/panel/picture/json_text.hpp"
#include "symplant/trace/csv_text.hpp"

namespace symplant::panel {
namespace {

/// `"key":TIME`, or null for one that is not there.
void put_time(std::string& json, std::string_view key, tables::Time time) {
  put_key(json, key);
  json += time == kNotYet ? "null" : std::to_string(time);
}

}  // namespace

void Training::Summary::add(tables::Time time) {
  least = count == 0 ? time : std::min(least, time);
  greatest = std::max(greatest, time);
  sum += static_cast<double>(time);
  ++count;
}

void Training::set_back(tables::Time after) {
  runs_.set_back(after);
  trainees_.set_back(after);
}

bool Training::seen(const Sender& sender, tables::Time now) {
  return !is_listed(sender) || trainees_.find_or_add(sender.name, now).has_value();
}

void Training::acted(const Sender& sender, tables::Time time) {
  if (!is_listed(sender)) return;
  const std::optional<std::uint32_t> trainee = trainees_.find_or_add(sender.name, time);
  if (!trainee) return;
  trainees_.acted(*trainee, time);
  runs_.acted(*trainee, time);
}

void Training::answered(const Sender& sender, int status, tables::Time now) {
  if (!is_listed(sender) || (status != 403 && status != 422)) return;
  if (const std::optional<std::uint32_t> trainee = trainees_.find(sender.name)) trainees_.refused(*trainee, now);
}

Training::Summary Training::summary_of(std::uint32_t trainee) const {
  Summary summary;
  for (const MalfunctionRun& run : runs_.runs()) {
    for (const MalfunctionRun::Reaction& reaction : run.reactions) {
      if (reaction.trainee == trainee) summary.add(reaction.at - run.effect);
    }
  }
  return summary;
}

void Training::put_trainee(std::string& json, std::uint32_t trainee) const {
  const Trainee& of = trainees_.all()[trainee];
  const Summary times = summary_of(trainee);
  const bool any = times.count != 0;
  json += '{';
  put_member(json, "name", of.name);
  put_time(json, "since", of.since);
  put_time(json, "last", of.acts.last().value_or(kNotYet));
  panel::put(json, R"(,"acts":{},"refused":{},"reactions":{})", of.acts.count(), of.refusals.count(), times.count);
  put_time(json, "least", any ? times.least : kNotYet);
  put_time(json, "mean", any ? times.mean() : kNotYet);
  put_time(json, "greatest", any ? times.greatest : kNotYet);
  json += '}';
}

void Training::put_run(std::string& json, const MalfunctionRun& run) const {
  panel::put(json, "{{\"n\":{}", run.n);
  put_member(json, "name", names_.malfunction(run.malfunction));
  put_time(json, "start", run.start);
  put_time(json, "effect", run.effect);
  put_time(json, "end", run.end);
  put_key(json, "reactions");
  json += '[';
  for (const MalfunctionRun::Reaction& reaction : run.reactions) {
    put_comma(json);
    panel::put(json, "[{},{}]", reaction.trainee, reaction.at - run.effect);
  }
  json += "]}";
}

void Training::put(std::string& json, std::size_t most) const {
  json += "{\"trainees\":[";
  for (std::uint32_t i = 0; i < trainees_.all().size(); ++i) {
    put_comma(json);
    put_trainee(json, i);
  }
  json += "],\"malfunctions\":[";
  const auto& runs = runs_.runs();
  for (std::size_t i = runs.size() - std::min(most, runs.size()); i < runs.size(); ++i) {
    put_comma(json);
    put_run(json, runs[i]);
  }
  json += "]}";
}

std::string Training::trainees_csv() const {
  std::string csv =
      "name,first seen [s],last act [s],acts,refused,reactions,least reaction [s],mean reaction [s],greatest reaction "
      "[s]\r\n";
  for (std::uint32_t i = 0; i < trainees_.all().size(); ++i) {
    const Trainee& of = trainees_.all()[i];
    const Summary times = summary_of(i);
    const auto seconds = [&](tables::Time time) { return trace::csv_seconds(times.count != 0 ? time : kNotYet); };
    panel::put(csv, "{},{},{},{},{},{},{},{},{}\r\n", trace::csv_cell(of.name), trace::csv_seconds(of.since),
               trace::csv_seconds(of.acts.last().value_or(kNotYet)), of.acts.count(), of.refusals.count(), times.count,
               seconds(times.least), seconds(times.count != 0 ? times.mean() : kNotYet), seconds(times.greatest));
  }
  return csv;
}

std::string Training::reactions_csv() const {
  std::string csv = "malfunction,start [s],first effect [s],end [s],trainee,reaction [s]\r\n";
  for (const MalfunctionRun& run : runs_.runs()) {
    for (std::uint32_t i = 0; i < trainees_.all().size(); ++i) {
      const auto found = std::find_if(run.reactions.begin(), run.reactions.end(),
                                      [i](const MalfunctionRun::Reaction& each) { return each.trainee == i; });
      panel::put(csv, "{},{},{},{},{},{}\r\n", trace::csv_cell(names_.malfunction(run.malfunction)),
                 trace::csv_seconds(run.start), trace::csv_seconds(run.effect), trace::csv_seconds(run.end),
                 trace::csv_cell(trainees_.all()[i].name),
                 trace::csv_seconds(found == run.reactions.end() ? kNotYet : found->at - run.effect));
    }
  }
  return csv;
}

}  // namespace symplant::panel
