// Tracks that are rings, with parts and sensors: the loads of material flow, and a loop written by hand for them.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "bench/two_state_plant.hpp"

namespace symplant::bench {

inline constexpr std::uint32_t kPartsOnTrack = 20;
inline constexpr std::uint32_t kSensorsOnTrack = 5;
inline constexpr std::int64_t kTrackLength = 24'000'000;  // um
inline constexpr std::int64_t kPartLength = 300'000;
inline constexpr std::int64_t kPartSpeed = 200'000;  // um/s: a part takes 120 s around its track

/// Rings of 24 m with 20 parts and 5 sensors each: 2 * 5 marks for each part in 120 s. A run command moves all of them.
struct TrackPlant : BenchPlant {
  explicit TrackPlant(std::uint32_t tracks) {
    conditions.reserve(tracks);
    for (std::uint32_t t = 0; t < tracks; ++t) {
      rows.push_back({kTrackLength, 0, {t, 1}, {}, {t * kSensorsOnTrack, kSensorsOnTrack}, {t, 1}});
      drives.push_back({kTrackLength, t, tables::kNone, tables::kNone, kPartSpeed});
      conditions.push_back({0b10, t, 0, tables::ReaderKind::drive});
      watches.push_back({0, t, 0});
      ends.push_back({t, tables::kNone});
      for (std::uint32_t s = 0; s < kSensorsOnTrack; ++s) add_sensor(t, s);
    }
    symbols.push_back({0, tables::kNone, 0, 1, kind(tables::Direction::operation)});
    tables.symbols = symbols;
    tables.conditions = conditions;
    tables.operation_watches = watches;
    tables.operation_bits = 64;
    tables.event_bits = (tracks * kSensorsOnTrack + 63) / 64 * 64;
    tables.material.kinds = kinds;
    tables.material.tracks = rows;
    tables.material.drives = drives;
    tables.material.ends = ends;
    tables.material.sensors = sensors;
    make_as_is();
    for (std::uint32_t t = 0; t < tracks; ++t) {
      for (std::uint32_t p = 0; p < kPartsOnTrack; ++p) {
        plant->put({t, kTrackLength / kPartsOnTrack * p + 1000 * (t % 997) + 400'000}, 0);
      }
    }
    plant->advance_to(0);
    plant->set_operation(0, true);
    plant->advance_to(1);
    plant->forget_changed_events();
  }

 private:
  static tables::SymbolKind kind(tables::Direction direction) {
    return tables::symbol_kind(tables::DataType::boolean, direction, tables::AddressForm::none, true);
  }
  void add_sensor(std::uint32_t track, std::uint32_t number) {
    const auto index = static_cast<std::uint32_t>(symbols.size());
    symbols.push_back({track * kSensorsOnTrack + number, tables::kNone, 0, 1, kind(tables::Direction::event)});
    const std::int64_t at = kTrackLength / kSensorsOnTrack * number + 1'000'000 + 1000 * (track % 1009);
    sensors.push_back({index, track, at, {}, tables::SensorReads::part});
  }

  std::vector<tables::KindRow> kinds{{kPartLength, 0}};
  std::vector<tables::TrackRow> rows;
  std::vector<tables::DriveRow> drives;
  std::vector<tables::EndRow> ends;
  std::vector<tables::SensorRow> sensors;
  std::vector<tables::ConditionRow> conditions;
  std::vector<tables::BitWatch> watches;
  std::vector<tables::SymbolRow> symbols;
};

/// A step is 100 ms of plant time. Counts the sensors that switched.
class EngineParts {
 public:
  explicit EngineParts(std::uint32_t tracks) : made_(tracks) {}
  std::int64_t step() {
    made_.plant->advance_to(now_ += kStep);
    std::int64_t switched = 0;
    seen_.resize(made_.tables.event_bits / 64);
    for (const std::uint32_t word : made_.plant->changed_events()) {
      const std::uint64_t bits = made_.plant->events()[word];
      switched += std::popcount(bits ^ seen_[word]);
      seen_[word] = bits;
    }
    made_.plant->forget_changed_events();
    return switched;
  }

 private:
  static constexpr tables::Time kStep = 100 * tables::kMillisecond;
  TrackPlant made_;
  tables::Time now_ = 0;
  std::vector<std::uint64_t> seen_;
};

/// A queue of touching parts on one track, which starts and stops as a whole.
struct QueuePlant : BenchPlant {
  explicit QueuePlant(std::uint32_t parts) {
    const std::int64_t length = parts * kPartLength + 10'000'000;
    rows.push_back({length, 0, {0, 1}, {}, {}, {}});
    drives.push_back({length, 0, tables::kNone, tables::kNone, kPartSpeed});
    conditions.push_back({0b10, 0, 0, tables::ReaderKind::drive});
    watches.push_back({0, 0, 0});
    tables.conditions = conditions;
    tables.operation_watches = watches;
    tables.operation_bits = 64;
    tables.material.kinds = kinds;
    tables.material.tracks = rows;
    tables.material.drives = drives;
    make_as_is();
    for (std::uint32_t p = 0; p < parts; ++p) plant->put({0, kPartLength / 2 + p * kPartLength}, 0);
    plant->advance_to(0);
  }

 private:
  std::vector<tables::KindRow> kinds{{kPartLength, 0}};
  std::vector<tables::TrackRow> rows;
  std::vector<tables::DriveRow> drives;
  std::vector<tables::ConditionRow> conditions;
  std::vector<tables::BitWatch> watches;
};

/// A step is a start or a stop, 1 ms after the last one.
class EngineQueue {
 public:
  explicit EngineQueue(std::uint32_t parts) : made_(parts) {}
  std::int64_t step() {
    runs_ = !runs_;
    made_.plant->set_operation(0, runs_);
    made_.plant->advance_to(now_ += tables::kMillisecond);
    return 1;
  }

 private:
  QueuePlant made_;
  tables::Time now_ = 0;
  bool runs_ = false;
};

/// The same load as it is usually written by hand: every cycle of 1 ms moves every part and evaluates every sensor.
class HandParts {
 public:
  explicit HandParts(std::uint32_t tracks)
      : positions_(std::size_t{tracks} * kPartsOnTrack), sensors_(std::size_t{tracks} * kSensorsOnTrack) {
    for (std::uint32_t t = 0; t < tracks; ++t) {
      for (std::uint32_t p = 0; p < kPartsOnTrack; ++p) {
        const std::int64_t x = kTrackLength / kPartsOnTrack * p + 1000 * (t % 997) + 400'000;
        positions_[t * kPartsOnTrack + p] = static_cast<std::int32_t>(x);
      }
    }
  }
  std::int64_t step() {
    std::int64_t switched = 0;
    for (int cycle = 0; cycle < 100; ++cycle) switched += move();
    return switched;
  }

 private:
  std::int64_t move() {
    constexpr auto kInCycle = static_cast<std::int32_t>(kPartSpeed / 1000);
    std::int64_t switched = 0;
    const auto tracks = static_cast<std::uint32_t>(positions_.size() / kPartsOnTrack);
    for (std::uint32_t t = 0; t < tracks; ++t) {
      std::int32_t* const parts = &positions_[t * kPartsOnTrack];
      for (std::uint32_t p = 0; p < kPartsOnTrack; ++p) {
        parts[p] += kInCycle;
        if (parts[p] >= kTrackLength) parts[p] -= kTrackLength;
      }
      for (std::uint32_t s = 0; s < kSensorsOnTrack; ++s) {
        const auto at = static_cast<std::int32_t>(kTrackLength / kSensorsOnTrack * s + 1'000'000 + 1000 * (t % 1009));
        bool covered = false;
        for (std::uint32_t p = 0; p < kPartsOnTrack; ++p) {
          covered = covered || (parts[p] >= at && parts[p] - static_cast<std::int32_t>(kPartLength) <= at);
        }
        std::uint8_t& sensor = sensors_[t * kSensorsOnTrack + s];
        switched += (sensor != 0) != covered ? 1 : 0;
        sensor = covered ? 1 : 0;
      }
    }
    return switched;
  }

  std::vector<std::int32_t> positions_;
  std::vector<std::uint8_t> sensors_;
};

}  // namespace symplant::bench
