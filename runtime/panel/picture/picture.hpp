// What the plant looks like now, as JSON: whole, or what changed since the last time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "symplant/panel/picture/track_state.hpp"
#include "symplant/panel/picture/value_states.hpp"
#include "symplant/panel/role.hpp"
#include "symplant/plant/plant.hpp"
#include "symplant/trace/history.hpp"
#include "symplant/trace/malfunction_marks.hpp"
#include "symplant/trace/plant_names.hpp"
#include "symplant/trace/record.hpp"

namespace symplant::panel {

/// Follows the records of a run together with a History, and keeps what the History does not have: the times of moves,
/// and the speeds of parts. Used by one thread at a time. apply() is O(1), O(parts) for the parts of a track.
class Picture {
 public:
  /// Both must outlive it.
  Picture(const trace::PlantNames& names, const trace::History& history);

  /// To be called after History::apply().
  void apply(const trace::Record& record);
  /// To be called after History::load(): everything counts as changed. O(plant).
  void load(const plant::Plant& plant);
  /// The symbol is forced, or no longer.
  void touch_symbol(std::uint32_t symbol) { symbols_.mark(symbol); }

  /// The outputs of all values: records have only those that a trace shows, at its times. O(outputs).
  void take_outputs(std::span<const double> outputs) { values_.take(outputs); }

  bool has_changes() const {
    return malfunctions_changed_ || values_.has_changes() ||
           !(devices_.list.empty() && symbols_.list.empty() && locations_.list.empty());
  }
  /// Appends the keys `devices`, `symbols`, `tracks`, `places` and `values` of all of them, as at plant time `now`, and
  /// `malfunctions`; a role that does not see all gets nothing of malfunctions. O(plant).
  void put_all(std::string& json, tables::Time now, Role role);
  /// Appends these keys of what changed since forget_changes(). O(changes).
  void put_changes(std::string& json, tables::Time now, Role role);
  void forget_changes();

 private:
  /// What changed, each once. A change that only a malfunction's mark shows is a trainer's.
  struct Marks {
    explicit Marks(std::size_t count) : marked(count), shown(count) {}
    void mark(std::uint32_t index, bool for_all = true) {
      if (!marked[index]) list.push_back(index);
      marked[index] = true;
      if (for_all) shown[index] = true;
    }
    /// What a role sees of it.
    std::vector<std::uint32_t> of(Role role) const;
    void clear() {
      for (const std::uint32_t index : list) marked[index] = shown[index] = false;
      list.clear();
    }
    std::vector<bool> marked;
    std::vector<bool> shown;
    std::vector<std::uint32_t> list;
  };
  struct Motion {
    tables::Time at = 0;  ///< when `remaining` was read
    tables::Time remaining = 0;
    tables::Time whole = 0;  ///< 0: it does not move
    std::uint8_t from = 0;
    std::uint8_t to = 0;
    bool runs = false;  ///< not stopped midway, disabled or frozen
  };
  struct PartSpot {
    std::uint64_t number;
    std::uint32_t kind;
    std::int32_t v;
    std::int64_t x;
  };
  struct Track {
    tables::Time at = 0;
    std::vector<PartSpot> parts;
  };

  void set_motion(const trace::Record& record);
  void set_malfunction(const trace::Record& record);
  void put_malfunctions(std::string& json) const;
  void put_device(std::string& json, std::uint32_t unit, tables::Time now, Role role) const;
  void put_symbol(std::string& json, std::uint32_t symbol, Role role) const;
  void put_track(std::string& json, std::uint32_t track) const;
  void put_place(std::string& json, std::uint32_t place) const;
  void look_at_tracks(tables::Time now);

  const trace::PlantNames& names_;
  const trace::History& history_;
  std::vector<Motion> motions_;
  std::vector<Track> tracks_;
  Track* track_ = nullptr;  ///< the track whose parts are being recorded
  TrackStates track_states_;
  ValueStates values_;
  trace::MalfunctionMarks malfunctions_;
  bool malfunctions_changed_ = false;
  Marks devices_;
  Marks symbols_;
  Marks locations_;
};

}  // namespace symplant::panel
