// Writes and reads material flow. Locations have no blanks.
#include "property/text_material.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>

namespace symplant::property {
namespace {

constexpr std::array<std::string_view, 3> kReadsWords = {"part", "code", "number"};

std::string cell_of(const std::string& content) { return content.empty() ? "-" : content; }

std::string number_cell(const auto& number) { return number ? std::to_string(*number) : "-"; }

std::string list_cell(const std::vector<std::string>& list) {
  std::string text;
  for (const std::string& each : list) text += (text.empty() ? "" : ",") + each;
  return cell_of(text);
}

std::vector<std::string> list_in(Line& line) {
  std::vector<std::string> list;
  std::string text = line.cell();
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    list.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return list;
}

struct MaterialLines {
  std::vector<std::string> lines;

  void add(std::string text, const std::string& condition = "") {
    lines.push_back("material " + std::move(text) + (condition.empty() ? "" : " " + condition));
  }
  void sensors(const std::vector<description::GivenSensor>& sensors) {
    for (const description::GivenSensor& given : sensors) {
      add("sensor " + given.symbol + " " + number_cell(given.at) + " " +
          std::string(kReadsWords[static_cast<std::size_t>(given.reads)]) + (given.inverted ? " inverted " : " - ") +
          list_cell(given.kinds));
    }
  }
  void track(const description::GivenTrack& track) {
    add("track " + track.name + " " + std::to_string(track.length) + " " + std::to_string(track.gap));
    for (const description::GivenDrive& given : track.drives) {
      add("drive " + number_cell(given.until) + " " + std::to_string(given.speed.speed) + " " +
          cell_of(given.speed.of));
      if (!given.forward.empty()) add("forward", given.forward);
      if (!given.backward.empty()) add("backward", given.backward);
    }
    for (const description::GivenStop& given : track.stops) add("stop " + std::to_string(given.at), given.when);
    sensors(track.sensors);
    for (const description::GivenEnd& given : track.ends) add("end " + given.to, given.when);
  }
  void source(const description::GivenSource& given) {
    const std::string every = given.every ? property::text_of(*given.every) : "-";
    add("source " + given.name + " " + cell_of(given.at) + " " + list_cell(given.kinds) + " " + every + " " +
            std::to_string(given.first) + " " + number_cell(given.count),
        given.when);
  }
};

std::vector<description::GivenSensor>& sensors_of_last(description::GivenMaterial& material) {
  if (!material.places.empty()) return material.places.back().sensors;
  if (!material.tracks.empty()) return material.tracks.back().sensors;
  throw std::runtime_error("a sensor without a track or place");
}

template <class Number>
std::optional<Number> optional_in(Line& line) {
  const std::string text = line.cell();
  return text.empty() ? std::nullopt : std::optional<Number>(Line::number_of<Number>(text));
}

void read_sensor(Line& line, std::vector<description::GivenSensor>& sensors) {
  description::GivenSensor& given = sensors.emplace_back();
  given.symbol = line.word();
  given.at = optional_in<std::int64_t>(line);
  const std::string reads = line.word();
  const auto at = std::find(kReadsWords.begin(), kReadsWords.end(), reads);
  if (at == kReadsWords.end()) throw std::runtime_error("`" + reads + "` is nothing that a sensor reads");
  given.reads = static_cast<tables::SensorReads>(at - kReadsWords.begin());
  given.inverted = line.word() == "inverted";
  given.kinds = list_in(line);
}

void read_of_track(const std::string& word, Line& line, description::GivenTrack& track) {
  if (word == "drive") {
    description::GivenDrive& given = track.drives.emplace_back();
    given.until = optional_in<std::int64_t>(line);
    given.speed.speed = line.number<std::int64_t>();
    given.speed.of = line.cell();
  } else if (word == "stop") {
    description::GivenStop& given = track.stops.emplace_back();
    given.at = line.number<std::int64_t>();
    given.when = line.all();
  } else if (word == "end") {
    description::GivenEnd& given = track.ends.emplace_back();
    given.to = line.word();
    given.when = line.all();
  } else if ((word == "forward" || word == "backward") && !track.drives.empty()) {
    (word == "forward" ? track.drives.back().forward : track.drives.back().backward) = line.all();
  } else {
    throw std::runtime_error("`" + word + "` of material");
  }
}

void read_source(Line& line, description::GivenSource& given) {
  given.name = line.word();
  given.at = line.word();
  given.kinds = list_in(line);
  if (line.next() == "-") {
    line.word();
  } else {
    given.every = line.duration();
  }
  given.first = line.number<tables::Time>();
  given.count = optional_in<std::uint64_t>(line);
  given.when = line.all();
}

void read_transfer(Line& line, description::GivenTransfer& given) {
  given.name = line.word();
  given.from = line.word();
  given.to = line.word();
  given.once = line.word() == "once";
  given.when = line.all();
}

void read_work(Line& line, description::GivenWork& given) {
  given.name = line.word();
  given.at = line.word();
  given.from = line.word();
  given.to = line.word();
  given.when = line.all();
}

}  // namespace

std::vector<std::string> material_lines(const description::GivenMaterial& material) {
  MaterialLines writer;
  for (const description::GivenKind& kind : material.kinds) {
    writer.add("kind " + kind.name + " " + std::to_string(kind.length) + " " + std::to_string(kind.code));
  }
  for (const description::GivenTrack& track : material.tracks) writer.track(track);
  for (const description::GivenPlace& place : material.places) {
    writer.add("place " + place.name + " " + std::to_string(place.holds));
    writer.sensors(place.sensors);
  }
  for (const description::GivenTransfer& given : material.transfers) {
    writer.add(
        "transfer " + given.name + " " + cell_of(given.from) + " " + cell_of(given.to) + (given.once ? " once" : " -"),
        given.when);
  }
  for (const description::GivenWork& given : material.work) {
    writer.add("work " + given.name + " " + cell_of(given.at) + " " + given.from + " " + given.to, given.when);
  }
  for (const description::GivenSource& given : material.sources) writer.source(given);
  return std::move(writer.lines);
}

void read_material(Line& line, description::GivenMaterial& material) {
  const std::string word = line.word();
  if (word == "kind") {
    description::GivenKind& kind = material.kinds.emplace_back();
    kind.name = line.word();
    kind.length = line.number<std::int64_t>();
    kind.code = line.number<std::uint32_t>();
  } else if (word == "track") {
    description::GivenTrack& track = material.tracks.emplace_back();
    track.name = line.word();
    track.length = line.number<std::int64_t>();
    track.gap = line.number<std::int64_t>();
  } else if (word == "place") {
    material.places.emplace_back().name = line.word();
    material.places.back().holds = line.number<std::uint32_t>();
  } else if (word == "sensor") {
    read_sensor(line, sensors_of_last(material));
  } else if (word == "transfer") {
    read_transfer(line, material.transfers.emplace_back());
  } else if (word == "work") {
    read_work(line, material.work.emplace_back());
  } else if (word == "source") {
    read_source(line, material.sources.emplace_back());
  } else if (!material.tracks.empty()) {
    read_of_track(word, line, material.tracks.back());
  } else {
    throw std::runtime_error("`" + word + "` of material without a track");
  }
}

}  // namespace symplant::property
