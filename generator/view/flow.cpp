// The signal flow of a plant in words.
#include "view/flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "elements/follow/words.hpp"
#include "elements/value/readers.hpp"
#include "elements/value/words.hpp"
#include "model/classify.hpp"
#include "model/condition_text.hpp"
#include "text/utf8.hpp"
#include "view/layout.hpp"

namespace symplant::view {
namespace {

using model::kNone;
using model::Read;

constexpr std::uint32_t kMostOfName = 60;  // columns
constexpr std::uint32_t kMostOfLine = 40;
constexpr std::size_t kMostJumps = 2;  // lines for them
constexpr std::string_view kCut = " ...";

/// The beginning of a text, with ` ...` at its end if it has more columns than `most`.
std::string cut(const std::string& text, std::uint32_t most, bool& is_cut) {
  if (columns(text) <= most) return text;
  is_cut = true;
  std::string kept;
  std::uint32_t width = 0;
  for (std::size_t at = 0; at < text.size();) {
    const text::CodePoint point = text::code_point_at(text, at);
    width += columns(text.substr(at, point.length));
    if (width + kCut.size() > most) break;
    kept += text.substr(at, point.length);
    at += point.length;
  }
  while (!kept.empty() && kept.back() == ' ') kept.pop_back();
  return kept + std::string(kCut);
}

/// A box of a title and lines, and the whole text for what is cut.
FlowBox box_of(FlowBox::Kind kind, const std::string& title, const std::vector<std::string>& lines,
               std::vector<std::string> whole) {
  FlowBox box;
  box.kind = kind;
  bool is_cut = false;
  box.lines.push_back(cut(title, kMostOfName, is_cut));
  for (const std::string& line : lines) box.lines.push_back(cut(line, kMostOfLine, is_cut));
  if (is_cut) box.whole = std::move(whole);
  return box;
}

class FlowMaker {
 public:
  explicit FlowMaker(const Scene& scene)
      : scene_(scene),
        plant_(scene.plant),
        reads_(model::reads_of(plant_)),
        all_(scene.units.size() == plant_.units.size() && scene.locations.size() == plant_.material.locations()) {}

  Flow make() {
    choose_values();
    choose_sinks();
    for (const Read& read : reads_) {
      if (is_arrow(read) && read.what != Read::What::value) add_part(sources_[{read.what, read.of}].parts, read.part);
    }
    for (auto& [key, source] : sources_) source.box = add(source_box(key.first, key.second, source.parts));
    for (std::uint32_t v = 0; v < plant_.values.size(); ++v) {
      if (values_[v] != kNone) values_[v] = add(box_of_value(v));
    }
    for (auto& [key, box] : sinks_) box = add(sink_box(key.first, key.second));
    add_arrows();
    return std::move(flow_);
  }

 private:
  using SourceKey = std::pair<Read::What, std::uint32_t>;
  using SinkKey = std::pair<Read::Reader, std::uint32_t>;
  struct Source {
    std::vector<std::string_view> parts;
    std::uint32_t box = kNone;
  };

  bool shows_unit(std::uint32_t unit) const {
    return std::binary_search(scene_.units.begin(), scene_.units.end(), unit);
  }
  bool shows_location(std::uint32_t location) const {
    return std::binary_search(scene_.locations.begin(), scene_.locations.end(), location);
  }
  /// Whether one of the devices and locations shown reads, or is read.
  bool concerns_shown(const Read& read) const {
    if (read.reader == Read::Reader::unit && shows_unit(read.by)) return true;
    if (read.reader == Read::Reader::track && shows_location(read.by)) return true;
    if (read.what == Read::What::unit) return shows_unit(read.of);
    if (read.what == Read::What::location) return shows_location(read.of);
    return read.what == Read::What::symbol && shows_unit(plant_.symbols[read.of].unit_of_device());
  }

  void choose_values() {
    values_.assign(plant_.values.size(), all_ ? 0 : kNone);
    if (all_) return;
    for (std::uint32_t v = 0; v < plant_.values.size(); ++v) {
      if (plant_.values[v].matched != kNone && shows_unit(plant_.values[v].matched)) values_[v] = 0;
    }
    for (const Read& read : reads_) {
      if (!concerns_shown(read)) continue;
      if (read.reader == Read::Reader::value) values_[read.by] = 0;
      if (read.what == Read::What::value) values_[read.of] = 0;
    }
  }

  void choose_sinks() {
    for (std::uint32_t s = 0; s < plant_.signals.size() && all_; ++s) sinks_[{Read::Reader::signal, s}] = 0;
    for (const Read& read : reads_) {
      if (read.reader == Read::Reader::value || read.reader == Read::Reader::requirement ||
          read.reader == Read::Reader::malfunction) {
        continue;
      }
      const bool of_value = read.what == Read::What::value && values_[read.of] != kNone;
      const bool of_shown = read.reader == Read::Reader::signal && concerns_shown(read);
      if (of_value || of_shown) sinks_[{read.reader, read.by}] = 0;
    }
  }

  /// Whether reader and read are in the picture. Of what a device and an element of the material flow read, only values
  /// are: the rest is no part of the signal flow.
  bool is_arrow(const Read& read) const {
    if (read.what == Read::What::value && values_[read.of] == kNone) return false;
    if (read.reader == Read::Reader::value) return values_[read.by] != kNone;
    const bool shows_rest = read.reader == Read::Reader::signal || read.reader == Read::Reader::follow;
    return (shows_rest || read.what == Read::What::value) && sinks_.contains({read.reader, read.by});
  }

  static void add_part(std::vector<std::string_view>& parts, std::string_view part) {
    if (!part.empty() && std::find(parts.begin(), parts.end(), part) == parts.end()) parts.push_back(part);
  }

  std::uint32_t add(FlowBox box) {
    flow_.boxes.push_back(std::move(box));
    return static_cast<std::uint32_t>(flow_.boxes.size() - 1);
  }

  std::string symbol_line(std::uint32_t index) const {
    const model::Symbol& symbol = plant_.symbols[index];
    return fmt::format("{}, {}", symbol.direction == tables::Direction::operation ? "operation" : "event",
                       model::data_type_name(symbol.type));
  }

  FlowBox source_box(Read::What what, std::uint32_t of, const std::vector<std::string_view>& parts) const {
    using Kind = FlowBox::Kind;
    std::string title = "time";
    std::string line = "plant time in seconds";
    if (what == Read::What::symbol) {
      title = plant_.symbols[of].name();
      line = symbol_line(of);
    } else if (what == Read::What::unit) {
      title = plant_.units[of].path;
      line = "device";
    } else if (what == Read::What::location) {
      title = plant_.material.location_name(of);
      line = plant_.material.is_track(of) ? "track" : "place";
    }
    for (const std::string_view part : parts) line.append(part == parts.front() ? ": " : ", ").append(part);
    FlowBox box = box_of(Kind::source, title, {line}, {title, line});
    if (what == Read::What::unit) box.unit = of;
    return box;
  }

  FlowBox box_of_value(std::uint32_t index) const {
    const model::Value& value = plant_.values[index];
    std::vector<std::string> lines = value_box(value, plant_);
    const std::size_t jumps = value.changes.size();
    if (jumps > kMostJumps) {
      lines.resize(lines.size() - (jumps - kMostJumps) - 1);
      lines.push_back(fmt::format("and {} more jumps", jumps - kMostJumps + 1));
    }
    const std::string title = value_title(value);
    FlowBox box = box_of(FlowBox::Kind::value, title, lines, {title, value_line(value, plant_)});
    if (jumps > kMostJumps) box.whole = {title, value_line(value, plant_)};
    box.value = index;
    return box;
  }

  FlowBox sink_box(Read::Reader reader, std::uint32_t by) const {
    const auto box = [](const std::string& title, const std::vector<std::string>& lines) {
      std::vector<std::string> whole{title};
      whole.insert(whole.end(), lines.begin(), lines.end());
      return box_of(FlowBox::Kind::sink, title, lines, std::move(whole));
    };
    const model::Material& material = plant_.material;
    switch (reader) {
      case Read::Reader::signal: {
        const model::Signal& signal = plant_.signals[by];
        return box(std::string(plant_.symbols[signal.row.symbol].name()),
                   {"signal: " + symbol_line(signal.row.symbol), signal_line(signal, plant_)});
      }
      case Read::Reader::follow: {
        const model::Follow& follow = plant_.follows[by];
        return box(std::string(plant_.symbols[follow.symbol].name()), {"follows", follow_text(follow, plant_)});
      }
      case Read::Reader::unit: {
        FlowBox device = box(std::string(plant_.units[by].path), {"device"});
        device.unit = by;
        return device;
      }
      case Read::Reader::track:
        return box(material.tracks[by].name, {"track"});
      case Read::Reader::transfer:
        return box(material.transfers[by].name, {"transfer"});
      case Read::Reader::work:
        return box(material.work[by].name, {"work"});
      default:
        return box(material.sources[by].name, {"source of parts"});
    }
  }

  void add_arrows() {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> known;
    for (const Read& read : reads_) {
      if (!is_arrow(read)) continue;
      const std::uint32_t from =
          read.what == Read::What::value ? values_[read.of] : sources_.at({read.what, read.of}).box;
      const std::uint32_t to =
          read.reader == Read::Reader::value ? values_[read.by] : sinks_.at({read.reader, read.by});
      const auto [found, added] = known.try_emplace({from, to}, flow_.arrows.size());
      if (added) {
        flow_.arrows.push_back({from, to, read.in_condition});
      } else if (!read.in_condition) {
        flow_.arrows[found->second].in_condition = false;
      }
    }
    std::stable_sort(flow_.arrows.begin(), flow_.arrows.end(),
                     [](const FlowArrow& a, const FlowArrow& b) { return a.to < b.to; });
  }

  const Scene& scene_;
  const model::PlantModel& plant_;
  const std::vector<Read> reads_;
  const bool all_;
  std::vector<std::uint32_t> values_;  ///< the box of each value; kNone: not shown
  std::map<SourceKey, Source> sources_;
  std::map<SinkKey, std::uint32_t> sinks_;  ///< and their boxes
  Flow flow_;
};

}  // namespace

std::string_view flow_class(FlowBox::Kind kind) {
  switch (kind) {
    case FlowBox::Kind::source:
      return "flow-source";
    case FlowBox::Kind::value:
      return "flow-value";
    case FlowBox::Kind::sink:
      return "flow-sink";
  }
  return "";
}

Flow flow_of(const Scene& scene) {
  if (scene.plant.values.empty() && scene.plant.signals.empty()) return {};
  return FlowMaker(scene).make();
}

}  // namespace symplant::view
