// Whether the times of moves slowly leave what was learned.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "observe/observer.hpp"
#include "watch/statistics.hpp"

namespace symplant::watch {

/// Compares the mean of the last 30 times of each move with the mean that was learned (of at least 30).
class Drift {
 public:
  static constexpr std::size_t kLast = 30;
  static constexpr std::uint64_t kLeastLearned = 30;
  static constexpr double kErrors = 6;    ///< standard errors of the difference
  static constexpr double kShare = 0.05;  ///< of the mean that was learned

  struct Found {
    double mean;  ///< of the last 30, ns
    const Statistic* learned;
  };

  /// `learned` must outlive this.
  Drift(const model::PlantModel& plant, const std::vector<Statistic>& learned, tables::Time resolution);

  /// A move took `took`. The first time that its mean has left what was learned it returns how. O(1).
  std::optional<Found> add(const observe::Move& move, Span span, tables::Time took);

 private:
  struct Series {
    const Statistic* learned = nullptr;
    std::array<double, kLast> last{};
    std::size_t count = 0;
    double sum = 0;
    bool found = false;
  };
  Series* series_of(const observe::Move& move, Span span);

  const model::PlantModel& plant_;
  double rounding_;  ///< standard deviation that the interval of reading adds to a time
  std::vector<Series> series_;
  std::unordered_map<std::uint32_t, std::vector<std::size_t>> of_unit_;
};

}  // namespace symplant::watch
