// Examines a link that goes to the PLC.
#include "symplant/link/doctor/client_doctor.hpp"

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>
#include <utility>

#include "symplant/link/client/event_lanes.hpp"
#include "symplant/link/client/steady_now.hpp"
#include "symplant/link/image/numbers.hpp"
#include "symplant/link/image/words.hpp"

namespace symplant::link::doctor {

namespace {

using client::Fault;
using client::Identity;
using client::LaneChange;
using client::steady_now;
using std::chrono::steady_clock;

constexpr auto kBetweenLooks = std::chrono::milliseconds(100);

/// The words of the planes of one direction.
struct Image {
  std::vector<std::uint64_t> bits;
  std::vector<std::uint64_t> numbers;

  Image(const image::Map& map, Plane bit_plane, Plane number_plane, std::uint64_t fill)
      : bits(image::bit_words(map.size(bit_plane)), fill), numbers(map.size(number_plane), fill) {}

  client::Words words() { return {bits, numbers}; }
  const std::vector<std::uint64_t>& of(Plane plane) const { return has_bits(plane) ? bits : numbers; }
};

Image operations_of(const image::Map& map, std::uint64_t fill) {
  return {map, Plane::operation_bits, Plane::operation_numbers, fill};
}
Image events_of(const image::Map& map, std::uint64_t fill) {
  return {map, Plane::event_bits, Plane::event_numbers, fill};
}

bool is_event(const image::Point& point) { return link::is_event(point.plane); }

std::string count_text(std::size_t count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string milliseconds(steady_clock::duration time) {
  const auto tenths = std::chrono::duration_cast<std::chrono::microseconds>(time).count() / 100;
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " ms";
}

class ClientDoctor {
 public:
  ClientDoctor(client::ClientParts parts, const tables::PlantTables& tables, const Options& options)
      : parts_(std::move(parts)), tables_(tables), options_(options), unread_(parts_.map.points.size(), true) {}

  Report examine() {
    report_.url = parts_.dialog->url();
    list_points();
    report_map();
    if (connect() && identify() && read_twice()) {
      watch();
      test_writing();
      report_functions();
    }
    parts_.dialog->close();
    for (const char* name : {"connection", "identity", "reading", "watching", "write test"}) skip(name);
    std::sort(report_.points.begin(), report_.points.end(),
              [](const Point& a, const Point& b) { return a.symbol < b.symbol; });
    return std::move(report_);
  }

 private:
  void step(std::string name, Result result, std::string text) {
    report_.steps.push_back({std::move(name), result, std::move(text)});
  }
  /// Adds a step that was not reached.
  void skip(const char* name) {
    const bool there =
        std::any_of(report_.steps.begin(), report_.steps.end(), [&](const Step& step) { return step.name == name; });
    if (!there) step(name, Result::skipped, "not reached");
  }
  void say(Point& point, Result result, const std::string& text) {
    point.result = std::max(point.result == Result::skipped ? Result::good : point.result, result);
    point.text += (point.text.empty() ? "" : "; ") + text;
  }

  void list_points() {
    for (std::size_t i = 0; i < parts_.map.points.size(); ++i) {
      report_.points.push_back({parts_.map.points[i].symbol, parts_.addresses[i], Result::skipped, {}, ""});
    }
    for (const Unreachable& one : parts_.unreachable) {
      report_.points.push_back({one.symbol, "", Result::warning, {}, "not linked: " + one.reason});
    }
  }

  void report_map() {
    const auto events = static_cast<std::size_t>(std::count_if(parts_.map.points.begin(), parts_.map.points.end(),
                                                               [](const image::Point& p) { return is_event(p); }));
    std::string text = count_text(parts_.map.points.size() - events, "operation") + ", " + count_text(events, "event");
    const std::size_t lost = parts_.unreachable.size();
    if (lost != 0) text += ", " + count_text(lost, "symbol") + " without a usable address";
    const bool none = parts_.map.points.empty();
    if (none) text += ": nothing to exchange; check the addresses of the list";
    step("map", none ? Result::bad : lost != 0 ? Result::warning : Result::good, text);
  }

  bool connect() {
    const auto begin = steady_clock::now();
    const Fault fault = parts_.dialog->open();
    if (fault) {
      step("connection", Result::bad, fault.message);
      return false;
    }
    step("connection", Result::good, "established in " + milliseconds(steady_clock::now() - begin));
    return true;
  }

  bool identify() {
    Fault fault;
    const Identity identity = parts_.dialog->identify(fault);
    if (fault) {
      step("identity", Result::bad, fault.message);
      return false;
    }
    report_.reached = true;
    switch (identity.kind) {
      case Identity::Kind::verified:
        step("identity", Result::good, identity.message);
        break;
      case Identity::Kind::unverifiable:
        step("identity", Result::warning, identity.message + "; a run writes only with `--arm`");
        break;
      case Identity::Kind::wrong:
        step("identity", Result::bad, identity.message);
        wrong_plc_ = true;
        break;
    }
    return true;
  }

  /// Until it is known which symbols the PLC refuses.
  Fault read(Image& operations, Image& events) {
    constexpr int kMostReadings = 1000;
    for (int reading = 0; reading < kMostReadings; ++reading) {
      const tables::Time now = steady_now();
      Fault fault = parts_.dialog->read(operations.words(), now);
      if (fault && fault.kind != Fault::Kind::rejected) return fault;
      fault = parts_.dialog->read_back(events.words(), now);
      if (fault && fault.kind != Fault::Kind::rejected) return fault;
      if (!parts_.dialog->is_dividing()) break;
    }
    return {};
  }

  std::uint64_t value_of(std::size_t i, const Image& operations, const Image& events) const {
    const image::Point& point = parts_.map.points[i];
    const std::vector<std::uint64_t>& words = (is_event(point) ? events : operations).of(point.plane);
    if (has_bits(point.plane)) return image::get_bit(words, point.position) ? 1 : 0;
    return image::value_of(words[point.position], tables_.symbols[point.symbol].type());
  }

  /// The bits of a point as read, to compare with what was there before reading.
  bool keeps(std::size_t i, const Image& operations, const Image& events, bool fill) const {
    const image::Point& point = parts_.map.points[i];
    const std::vector<std::uint64_t>& words = (is_event(point) ? events : operations).of(point.plane);
    for (const LaneChange& own : client::lanes_of(tables_, point)) {
      if ((image::get_lane(words, own.lane.number) & own.mask) != (fill ? own.mask : 0)) return false;
    }
    return true;
  }

  /// Reads into images of ones and of zeros in turn: a point that keeps them is not read, since the PLC rejected it.
  bool read_twice() {
    constexpr int kTimes = 4;
    const auto begin = steady_clock::now();
    const std::uint64_t before = parts_.dialog->requests();
    std::vector<std::string> rejections;
    for (int time = 0; time < kTimes; ++time) {
      const bool ones = time % 2 == 0;
      Image operations = operations_of(parts_.map, ones ? ~std::uint64_t{0} : 0);
      Image events = events_of(parts_.map, ones ? ~std::uint64_t{0} : 0);
      const Fault fault = read(operations, events);
      if (fault) {
        step("reading", Result::bad, fault.message);
        return false;
      }
      for (std::size_t i = 0; i < unread_.size(); ++i) {
        unread_[i] = unread_[i] && keeps(i, operations, events, ones);
        report_.points[i].value = value_of(i, operations, events);
      }
      for (client::Rejection& rejection : parts_.dialog->take_rejections()) {
        if (std::find(rejections.begin(), rejections.end(), rejection.message) == rejections.end()) {
          rejections.push_back(std::move(rejection.message));
        }
      }
    }
    report_reading(rejections, (parts_.dialog->requests() - before) / kTimes, (steady_clock::now() - begin) / kTimes);
    return true;
  }

  void report_reading(const std::vector<std::string>& rejections, std::uint64_t requests, steady_clock::duration time) {
    std::size_t unread = 0;
    for (std::size_t i = 0; i < unread_.size(); ++i) {
      if (unread_[i]) {
        ++unread;
        report_.points[i].value.reset();
        say(report_.points[i], Result::bad, "not readable");
      } else {
        report_.points[i].result = Result::good;
      }
    }
    std::string text = count_text(unread_.size() - unread, "point") + " in " + count_text(requests, "request") + ", " +
                       milliseconds(time);
    for (const std::string& message : rejections) text += "; " + message;
    step("reading", rejections.empty() && unread == 0 ? Result::good : Result::bad, text);
  }

  bool ends(steady_clock::time_point end) const {
    return steady_clock::now() >= end || (options_.stop != nullptr && options_.stop->load());
  }

  /// Looks which points change although the plant writes nothing.
  void watch() {
    const auto end = steady_clock::now() + std::chrono::nanoseconds(options_.duration);
    std::vector<bool> changed(unread_.size());
    do {
      std::this_thread::sleep_for(kBetweenLooks);
      Image operations = operations_of(parts_.map, 0);
      Image events = events_of(parts_.map, 0);
      if (const Fault fault = read(operations, events)) return step("watching", Result::bad, fault.message);
      parts_.dialog->take_rejections();
      for (std::size_t i = 0; i < unread_.size(); ++i) {
        if (unread_[i]) continue;
        const std::uint64_t value = value_of(i, operations, events);
        changed[i] = changed[i] || value != report_.points[i].value;
        report_.points[i].value = value;
      }
    } while (!ends(end));
    report_changes(changed);
  }

  void report_changes(const std::vector<bool>& changed) {
    std::size_t operations = 0;
    std::size_t events = 0;
    for (std::size_t i = 0; i < changed.size(); ++i) {
      if (!changed[i]) continue;
      if (!is_event(parts_.map.points[i])) {
        ++operations;
        continue;
      }
      ++events;
      say(report_.points[i], Result::warning,
          "the PLC changes it by itself: an input module, the program or another client writes it, or it is an output");
    }
    step("watching", events == 0 ? Result::good : Result::warning,
         count_text(operations, "operation") + " changed" +
             (events == 0 ? "" : ", and " + count_text(events, "event") + " that only the plant should write"));
  }

  /// All mapped bits of the events, as changes from `from`; `flip` inverts them.
  std::vector<LaneChange> changes_from(const Image& from, bool flip) const {
    std::vector<image::Point> points;
    for (std::size_t i = 0; i < unread_.size(); ++i) {
      if (is_event(parts_.map.points[i]) && !unread_[i]) points.push_back(parts_.map.points[i]);
    }
    std::sort(points.begin(), points.end(), [](const image::Point& a, const image::Point& b) {
      return std::pair(a.plane, a.position) < std::pair(b.plane, b.position);
    });
    std::vector<LaneChange> changes;
    for (const image::Point& point : points) {
      for (const LaneChange& own : client::lanes_of(tables_, point)) {
        if (changes.empty() || changes.back().lane != own.lane) {
          changes.push_back({own.lane, 0, image::get_lane(from.of(own.lane.plane), own.lane.number)});
        }
        LaneChange& change = changes.back();
        if (flip && (change.mask & own.mask) == 0) change.value = static_cast<std::uint16_t>(change.value ^ own.mask);
        change.mask = static_cast<std::uint16_t>(change.mask | own.mask);
      }
    }
    return changes;
  }

  /// Inverts every event, looks whether it stays, and restores it.
  void test_writing() {
    if (!options_.write_test) return step("write test", Result::skipped, "not asked for; `--write-test` runs it");
    if (wrong_plc_) return step("write test", Result::skipped, "not run: this is another PLC");
    Image before = events_of(parts_.map, 0);
    Image after = events_of(parts_.map, 0);
    Fault fault = parts_.dialog->read_back(before.words(), steady_now());
    if (fault || !parts_.dialog->take_rejections().empty()) {
      return step("write test", Result::bad, "not run: the events were not readable any more");
    }
    fault = write(changes_from(before, true));
    std::this_thread::sleep_for(kBetweenLooks);  // the PLC refreshes its inputs meanwhile
    if (!fault) fault = parts_.dialog->read_back(after.words(), steady_now());
    const Fault restored = restore(before);
    if (fault || restored) {
      return step("write test", Result::bad,
                  restored ? restored.message + "; some events do not have their former values"
                           : fault.message + "; all events have their former values");
    }
    report_writing(before, after);
  }

  /// What the PLC refuses is found by reading back; what it was too busy for is written again.
  Fault write(std::vector<LaneChange> changes) {
    constexpr int kMostTimes = 5;
    for (int time = 0; time < kMostTimes && !changes.empty(); ++time) {
      std::vector<client::Unwritten> unwritten;
      if (Fault fault = parts_.dialog->write(changes, unwritten)) return fault;
      changes.clear();
      for (const client::Unwritten& one : unwritten) {
        if (one.answer == client::Answer::busy) changes.push_back(one.change);
      }
    }
    return {};
  }

  /// Writes what was there, by a new connection if the old one is lost.
  Fault restore(const Image& before) {
    Fault fault = write(changes_from(before, false));
    if (!fault) return fault;
    parts_.dialog->close();
    fault = parts_.dialog->open();
    return fault ? fault : write(changes_from(before, false));
  }

  void report_writing(const Image& before, const Image& after) {
    std::size_t lost = 0;
    std::size_t all = 0;
    for (std::size_t i = 0; i < unread_.size(); ++i) {
      if (!is_event(parts_.map.points[i]) || unread_[i]) continue;
      ++all;
      if (value_of(i, before, before) != value_of(i, after, after)) continue;
      ++lost;
      say(report_.points[i], Result::bad,
          "written, but the PLC keeps its own value: choose another strategy for events");
    }
    std::string text = count_text(all - lost, "event") + " of " + std::to_string(all) + " written and restored";
    for (const client::Rejection& rejection : parts_.dialog->take_rejections()) text += "; " + rejection.message;
    step("write test", lost == 0 ? Result::good : Result::bad, text);
  }

  /// Last, since what was asked for is known then.
  void report_functions() {
    std::string text = parts_.dialog->functions();
    if (!text.empty()) step("functions", Result::good, std::move(text));
  }

  client::ClientParts parts_;
  const tables::PlantTables& tables_;
  const Options& options_;
  std::vector<bool> unread_;  ///< by point
  bool wrong_plc_ = false;
  Report report_;
};

}  // namespace

Report examine_client(client::ClientParts parts, const tables::PlantTables& tables, const Options& options) {
  return ClientDoctor(std::move(parts), tables, options).examine();
}

}  // namespace symplant::link::doctor
