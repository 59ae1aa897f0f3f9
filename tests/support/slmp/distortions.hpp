// Replies with changed bytes, for lying_plc.cpp.
#pragma once

#include <cstddef>
#include <cstdint>

#include "support/slmp/lying_plc.hpp"

namespace symplant::test::slmp {

/// Random numbers that are the same with every library (splitmix64).
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : state_(seed) {}
  /// 0 to `bound` - 1; 0 if `bound` is 0.
  std::size_t below(std::size_t bound);

 private:
  std::uint64_t state_;
};

Bytes joined(const Bytes& first, const Bytes& second);
Bytes front(const Bytes& bytes, std::size_t count);
Bytes back(const Bytes& bytes, std::size_t from);

/// The reply in the form of those kinds that only change its bytes.
Bytes distorted(Distortion kind, const Exchange& exchange, Draws& draws);

}  // namespace symplant::test::slmp
