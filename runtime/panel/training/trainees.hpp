// The trainees of a run: what each did, and how often it was refused.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "symplant/tables/time.hpp"

namespace symplant::panel {

/// Plant times of something that happens again and again. Keeps the last kMost; those before are only counted.
class Times {
 public:
  static constexpr std::size_t kMost = 1000;

  void add(tables::Time time);
  /// Forgets those after a time, unless they are only counted.
  void forget_after(tables::Time time);
  std::uint64_t count() const { return before_ + times_.size(); }
  /// The last one; nothing if it is not kept.
  std::optional<tables::Time> last() const;

 private:
  std::deque<tables::Time> times_;
  std::uint64_t before_ = 0;
};

struct Trainee {
  std::string name;
  tables::Time since;  ///< when it was first seen
  Times acts;          ///< on the plant
  Times refusals;      ///< of requests
};

/// Used by one thread at a time. A name is a trainee: two browsers with one name are one.
class Trainees {
 public:
  static constexpr std::size_t kMost = 100;

  /// The index of a trainee; nothing if there is no such name. O(trainees).
  std::optional<std::uint32_t> find(std::string_view name) const;
  /// The index of a trainee, which is new if the name is; nothing if there are kMost others. O(trainees).
  std::optional<std::uint32_t> find_or_add(std::string_view name, tables::Time now);
  void acted(std::uint32_t trainee, tables::Time time);
  void refused(std::uint32_t trainee, tables::Time time);
  /// The plant was set back: forgets what was done after a time, but no trainee.
  void set_back(tables::Time after);

  const std::vector<Trainee>& all() const { return all_; }
  /// Grows with each change.
  std::uint64_t version() const { return version_; }

 private:
  std::vector<Trainee> all_;
  std::uint64_t version_ = 0;
};

}  // namespace symplant::panel
