// Lays out tracks and places.
//
// The marks of a track are flags: a line at the position, and a text in one of several rows, so that no line crosses a
// text.
#include "elements/material/drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "elements/material/words.hpp"
#include "view/layout.hpp"

namespace symplant::view {
namespace {

constexpr int kSide = 20;
constexpr int kTrackPixels = 720;
constexpr int kBeltHeight = 20;
constexpr int kRulerHeight = 26;
constexpr int kSlot = 16;
constexpr std::uint32_t kMostSlots = 20;
constexpr std::size_t kMostKinds = 6;

struct Flag {
  int x = 0;
  std::string_view style;
  std::string text;
  int row = 0;   ///< from the belt
  int base = 0;  ///< y of its text
};

/// Sorts flags by position and gives them rows: a text is further from the belt than those to its right that it
/// passes, and of one position the last flag is the nearest. Returns the number of rows. O(n^2) comparisons in short
/// ranges.
int arrange(std::vector<Flag>& flags) {
  std::stable_sort(flags.begin(), flags.end(), [](const Flag& a, const Flag& b) { return a.x < b.x; });
  int rows = 0;
  for (std::size_t i = flags.size(); i-- > 0;) {
    const int end = flags[i].x + static_cast<int>(columns(flags[i].text) + 2) * kLetterWidth;
    for (std::size_t j = i + 1; j < flags.size() && flags[j].x <= end; ++j) {
      flags[i].row = std::max(flags[i].row, flags[j].row + 1);
    }
    rows = std::max(rows, flags[i].row + 1);
  }
  return rows;
}

/// The distance of the ruler's ticks in um: 1, 2 or 5 times a power of ten, at most 12 ticks.
std::int64_t tick_of(std::int64_t length) {
  std::int64_t tick = 1;
  for (int step = 0; length / tick > 12; ++step) tick = step % 3 == 1 ? tick / 2 * 5 : tick * 2;
  return tick;
}

class LocationDrawer {
 public:
  LocationDrawer(const model::PlantModel& plant, std::uint32_t location)
      : material_(plant.material), words_(plant), location_(location) {}

  Drawing draw() && {
    material_.is_track(location_) ? draw_track() : draw_place();
    return std::move(drawing_);
  }

 private:
  const model::Track& track() const { return material_.tracks[location_]; }
  int pixel(std::int64_t at) const {
    return kSide + static_cast<int>(static_cast<double>(at) * kTrackPixels / static_cast<double>(track().length));
  }

  void draw_track() {
    drawing_.title = words_.track(track());
    for (const model::PartSensor& sensor : track().sensors) {
      above_.push_back({pixel(sensor.at), "sensor", words_.sensor(sensor)});
    }
    collect_below();
    const int parts_height = draw_kinds();
    const int belt = parts_height + arrange(above_) * kLineHeight + 10;
    const int ruler_end = belt + kBeltHeight + kRulerHeight;
    std::reverse(below_.begin(), below_.end());  // of one position, the first is nearest to the belt
    const int rows = arrange(below_);
    for (Flag& flag : above_) flag.base = belt - 6 - flag.row * kLineHeight;
    for (Flag& flag : below_) flag.base = ruler_end + 12 + flag.row * kLineHeight;
    for (const Flag& flag : above_) draw_leader(flag.x, flag.base - 8, belt);
    for (const Flag& flag : below_) draw_leader(flag.x, belt, flag.base);
    drawing_.width = std::max(drawing_.width, kSide + kTrackPixels + kSide);
    draw_belt(belt);
    draw_ruler(belt + kBeltHeight);
    for (const Flag& flag : above_) draw_flag(flag, belt, belt);
    for (const Flag& flag : below_) draw_flag(flag, belt, belt + kBeltHeight);
    drawing_.height = ruler_end + rows * kLineHeight + 8;
  }

  /// The kinds of parts to scale, in one row. Returns its height.
  int draw_kinds() {
    int x = kSide;
    const std::size_t shown = std::min(material_.kinds.size(), kMostKinds);
    for (std::size_t k = 0; k < shown; ++k) {
      const model::PartKind& kind = material_.kinds[k];
      const int width = std::max(2, pixel(kind.length) - kSide);
      drawing_.shapes.push_back({Shape::Kind::rect, "part", x, 2, width, 10});
      x = add_text("fact start", x + width + 4, 11, words_.kind(kind)) + 18;
    }
    const std::size_t hidden = material_.kinds.size() - shown;
    if (hidden != 0) add_text("fact start", x, 11, fmt::format("{} other {}", hidden, hidden == 1 ? "kind" : "kinds"));
    return kLineHeight + 8;
  }

  void draw_belt(int y) {
    std::int64_t begin = 0;
    for (std::size_t d = 0; d < track().drives.size(); ++d) {
      const model::Drive& drive = track().drives[d];
      const int x = pixel(begin);
      const int width = pixel(drive.until) - x;
      drawing_.shapes.push_back({Shape::Kind::rect, d % 2 == 0 ? "belt" : "belt other", x, y, width, kBeltHeight});
      const int middle = x + width / 2;
      if (drive.forward || model::runs_always(drive)) draw_chevron(middle + 5, y, 5);
      if (drive.backward) draw_chevron(middle - 5, y, -5);
      begin = drive.until;
    }
  }

  /// Its tip is at x + size.
  void draw_chevron(int x, int y, int size) {
    const int middle = y + kBeltHeight / 2;
    drawing_.shapes.push_back({Shape::Kind::line, "chevron", x, middle - 5, x + size, middle});
    drawing_.shapes.push_back({Shape::Kind::line, "chevron", x, middle + 5, x + size, middle});
  }

  void draw_ruler(int y) {
    const std::int64_t tick = tick_of(track().length);
    for (std::int64_t at = 0; at <= track().length; at += tick) {
      drawing_.shapes.push_back({Shape::Kind::line, "tick", pixel(at), y, pixel(at), y + 5});
      add_text("tick start", pixel(at) + 2, y + 15, length_text(at));
    }
  }

  void draw_leader(int x, int from, int to) {
    drawing_.shapes.push_back({Shape::Kind::line, "leader", x, from, x, to});
  }

  /// `edge`: of the belt, where its dot is.
  void draw_flag(const Flag& flag, int belt, int edge) {
    if (flag.style == "stop") {
      drawing_.shapes.push_back({Shape::Kind::rect, "stop", flag.x - 2, belt - 3, 4, kBeltHeight + 6});
    } else if (!flag.style.empty()) {
      drawing_.shapes.push_back({Shape::Kind::dot, flag.style, flag.x, edge, 4});
    }
    add_text("fact start", flag.x + 4, flag.base, flag.text);
  }

  /// Drives, stops, ends, and what other elements do here.
  void collect_below() {
    std::int64_t begin = 0;
    for (const model::Drive& drive : track().drives) {
      below_.push_back({pixel(begin), "", "drive " + words_.drive(drive)});
      begin = drive.until;
    }
    for (const model::Stop& stop : track().stops) {
      below_.push_back({pixel(stop.at), "stop", "stop when " + words_.condition(stop.condition)});
    }
    const auto add = [&](const tables::PartLocation& at, std::int64_t whole, std::string_view style, std::string text) {
      if (at.location == location_) {
        below_.push_back({pixel(at.at == tables::kWhole ? whole : at.at), style, std::move(text)});
      }
    };
    for (const model::Track& other : material_.tracks) {
      for (const model::TrackEnd& end : other.ends) {
        add({end.to, tables::kWhole}, 0, "", "from " + other.name + words_.when(end.condition));
      }
    }
    for (const model::Source& source : material_.sources)
      add(source.to, 0, "source", "source " + words_.source(source));
    for (const model::Work& work : material_.work) add(work.at, 0, "work", "work " + words_.work(work));
    for (const model::Transfer& transfer : material_.transfers) {
      add(transfer.from, track().length, "transfer", "transfer " + words_.transfer(transfer));
      add(transfer.to, 0, "transfer", "transfer " + words_.transfer(transfer));
    }
    for (const model::TrackEnd& end : track().ends)
      below_.push_back({pixel(track().length), "", "to " + words_.end(end)});
    if (track().ends.empty()) below_.push_back({pixel(track().length), "stop", "hard end"});
  }

  void draw_place() {
    const model::Place& place = material_.places[location_ - material_.tracks.size()];
    drawing_.title = words_.place(place);
    const std::uint32_t slots = std::min(place.holds, kMostSlots);
    for (std::uint32_t s = 0; s < slots; ++s) {
      drawing_.shapes.push_back({Shape::Kind::rect, "belt", kSide + static_cast<int>(s) * kSlot, 2, kSlot, kSlot});
    }
    drawing_.width = kSide + static_cast<int>(slots) * kSlot + kSide;
    drawing_.height = kSlot + 4;
    if (slots < place.holds) add_text("fact start", drawing_.width - kSide + 4, kSlot - 1, "...");
    for (const model::PartSensor& sensor : place.sensors) add_line("sensor", words_.sensor(sensor));
    const auto add = [&](std::uint32_t location, std::string_view style, const std::string& text) {
      if (location == location_) add_line(style, text);
    };
    for (const model::Track& other : material_.tracks) {
      for (const model::TrackEnd& end : other.ends) add(end.to, "", "from " + other.name + words_.when(end.condition));
    }
    for (const model::Source& source : material_.sources) {
      add(source.to.location, "source", "source " + words_.source(source));
    }
    for (const model::Work& work : material_.work) add(work.at.location, "work", "work " + words_.work(work));
    for (const model::Transfer& transfer : material_.transfers) {
      const bool here = transfer.from.location == location_ || transfer.to.location == location_;
      if (here) add_line("transfer", "transfer " + words_.transfer(transfer));
    }
  }

  void add_line(std::string_view style, const std::string& text) {
    drawing_.height += kLineHeight;
    if (!style.empty()) drawing_.shapes.push_back({Shape::Kind::dot, style, kSide + 4, drawing_.height - 4, 4});
    add_text("fact start", kSide + 14, drawing_.height, text);
  }

  /// Returns where it ends.
  int add_text(std::string_view style, int x, int y, std::string text) {
    const int end = x + static_cast<int>(columns(text)) * kLetterWidth;
    drawing_.width = std::max(drawing_.width, end + kSide);
    drawing_.shapes.push_back({Shape::Kind::text, style, x, y, 0, 0, std::move(text)});
    return end;
  }

  const model::Material& material_;
  const MaterialWords words_;
  const std::uint32_t location_;
  std::vector<Flag> above_;
  std::vector<Flag> below_;
  Drawing drawing_;
};

}  // namespace

Drawing draw_location(const model::PlantModel& plant, std::uint32_t location) {
  return LocationDrawer(plant, location).draw();
}

}  // namespace symplant::view
