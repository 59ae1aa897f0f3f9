// A PLC that executes requests as SlmpPlc does, but distorts its replies by a seeded schedule.
//
//   LyingPlc plc({}, {.seed = 7, .lies_per_thousand = 300});
//   plc.lie_always(Distortion::late);        // or one kind alone
//   plc.lie_once(Distortion::wrong_route);   // or for the next reply
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "support/slmp/slmp_plc.hpp"

namespace symplant::test::slmp {

enum class Distortion : std::uint8_t {
  honest,
  late,              ///< whole and right, but after `late_by`; over TCP later replies wait for it
  held,              ///< comes directly before the reply to the peer's next request; over TCP in one segment with it
  doubled,           ///< twice, in one segment or as two datagrams
  bytewise,          ///< whole and right, each byte in a segment (TCP) or datagram (UDP)
  halved,            ///< whole and right, in two segments or datagrams with a short pause
  truncated,         ///< its first part, then nothing
  reset_within,      ///< its first part, then a reset of the connection (over UDP nothing)
  foreign_serial,    ///< the serial number of the request before; a 3E reply becomes `wrong_subheader`
  wrong_subheader,   ///< that of the other frame type
  wrong_route,       ///< another network and station
  length_too_long,   ///< the length field promises some bytes more than follow
  length_too_short,  ///< the length field covers some bytes less than follow
  length_huge,       ///< FFFF
  garbage,           ///< random bytes
  bare_error,        ///< end code CEE0 without an error information block
  short_error,       ///< end code CEE0 with a part of the block
  extra_data,        ///< 2 bytes more than asked for, with a length field that fits
  missing_data,      ///< 2 bytes fewer, with a length field that fits; without data `length_too_short`
  trailing_bytes,    ///< bytes after the frame
  other_code,        ///< the reply in the other code: ASCII for binary
  silent,            ///< none
  reset,             ///< a reset of the connection instead of a reply (over UDP none)
  end_code,          ///< a random end code instead of what was asked for
  closed,            ///< whole and right, then the end of the connection
  refused,           ///< as `reset`, and connection attempts are refused for `refuses_for`
};
inline constexpr std::size_t kDistortions = 26;

std::string_view name_of(Distortion distortion);
/// Whether a client can take the reply for what it asked: the bytes come in time, whole and in order.
bool is_harmless(Distortion distortion);

struct LieOptions {
  std::uint64_t seed = 1;
  unsigned lies_per_thousand = 500;
  /// The kinds that the schedule draws from; empty: all.
  std::vector<Distortion> kinds = {};
  /// More than the client's timeout.
  std::chrono::milliseconds late_by{80};
  std::chrono::milliseconds pause{2};  ///< of `halved`
  std::chrono::milliseconds refuses_for{20};
};

class LyingPlc {
 public:
  explicit LyingPlc(PlcOptions options = {}, LieOptions lies = {});
  ~LyingPlc();
  LyingPlc(const LyingPlc&) = delete;
  LyingPlc& operator=(const LyingPlc&) = delete;

  /// Memory, log, connections; the log has the end codes before the distortion.
  SlmpPlc& plc();
  std::uint16_t port();

  /// The next reply; then goes on as before.
  void lie_once(Distortion distortion);
  void lie_always(Distortion distortion);
  void follow_schedule();
  /// Replies that left in this form.
  std::size_t count(Distortion distortion) const;
  std::size_t lies() const;

 private:
  class Liar;
  std::unique_ptr<Liar> liar_;
  SlmpPlc plc_;
};

}  // namespace symplant::test::slmp
