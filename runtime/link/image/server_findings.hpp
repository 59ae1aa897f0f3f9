// Findings that the thread of a server passes to that of the cycle.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "symplant/link/link.hpp"
#include "symplant/share/ring.hpp"

namespace symplant::link::image {

/// The server numbers the images that it publishes, from 1. If it finds something about a value that only the images
/// from `since` to `until` - 1 had, it is a finding if the cycle took none of these. Wait-free; findings are lost while
/// the queue is full.
class ServerFindings {
 public:
  explicit ServerFindings(std::size_t capacity) : found_(capacity) {}

  // --- the server's thread

  void add(const LinkFinding& finding) noexcept { found_.put({finding, 0, 0}); }
  /// To be called before image `until` is published.
  void add(const LinkFinding& finding, std::uint64_t since, std::uint64_t until) noexcept {
    found_.put({finding, since, until});
  }
  /// The number of an image that the cycle has taken. Only a first check: the cycle may take a later one at any time.
  std::uint64_t taken() const noexcept { return taken_.load(std::memory_order_relaxed); }

  // --- the cycle's thread

  /// The cycle has taken this image, which is later than the one before.
  void took(std::uint64_t image) noexcept {
    before_ = taken();
    taken_.store(image, std::memory_order_relaxed);
  }
  /// The next finding. O(what the server added since the last call).
  std::optional<LinkFinding> take() noexcept {
    while (const Found* const found = found_.front()) {
      if (found->until > taken()) break;
      const LinkFinding finding = found->finding;
      const bool sampled = found->since != 0 && before_ >= found->since;
      found_.pop();
      if (!sampled) return finding;
    }
    return std::nullopt;
  }

 private:
  struct Found {
    LinkFinding finding{};
    std::uint64_t since = 0;  ///< 0: of no image
    std::uint64_t until = 0;
  };

  share::Ring<Found> found_;
  std::atomic<std::uint64_t> taken_{0};
  std::uint64_t before_ = 0;  ///< the image taken before
};

}  // namespace symplant::link::image
