// The states of the plant that an operator keeps, and those that are kept automatically.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "symplant/panel/operate/exercises.hpp"
#include "symplant/scenario/player.hpp"
#include "symplant/trace/snapshot_file.hpp"

namespace symplant::panel {

/// A state of the plant, and of the scenario that was played. A file has only that of the plant.
struct KeptState {
  trace::Snapshot snapshot;
  std::uint64_t play = 0;  ///< which scenario it was, by Desk's number; 0: none
  std::optional<scenario::Player::State> played = std::nullopt;
  std::optional<Exercise::Progress> exercise = std::nullopt;
};

/// The snapshots in memory and in a folder. Used by one thread at a time.
class Snapshots {
 public:
  static constexpr std::size_t kMost = 100;  ///< in memory, with a name
  static constexpr std::size_t kMostBacktracks = 30;
  static constexpr std::size_t kMostBytes = std::size_t{1} << 29;  ///< of backtracks, but always two of them

  /// `folder`: of the files; empty: there are none. `block`: the size of a state.
  Snapshots(std::string folder, std::size_t block);

  bool has_folder() const { return !folder_.empty(); }
  /// Keeps a state under a name, which replaces another one of this name. Returns why not, or an empty text.
  std::string keep(const std::string& name, std::shared_ptr<KeptState> state);
  /// Keeps a state under its time; if there are too many, the oldest one is removed.
  void keep_backtrack(std::shared_ptr<KeptState> state);
  /// Removes a state from memory. False if there is no state with this name in memory.
  bool forget(const std::string& name);
  /// The state of a name: in memory, else in the folder, for a plant of this model. `error` says why there is none.
  std::shared_ptr<KeptState> find(const std::string& name, std::uint64_t model_hash, std::size_t block,
                                  std::string& error) const;
  /// The path of a file in the folder.
  std::string path(std::string_view name, std::string_view ending) const;
  /// Notes that the folder has a file of a snapshot.
  void has_file(const std::string& name);

  /// Appends the array of all of them.
  void put_all(std::string& json) const;
  /// Grows with each change.
  std::uint64_t version() const { return version_; }

 private:
  struct Entry {
    std::string name;
    bool is_backtrack;
    bool is_file;  ///< only in the folder
    tables::Time time;
    std::shared_ptr<KeptState> state;
  };
  Entry* entry(const std::string& name);

  std::string folder_;
  std::size_t most_backtracks_;
  std::vector<Entry> entries_;
  std::uint64_t version_ = 1;
};

}  // namespace symplant::panel
