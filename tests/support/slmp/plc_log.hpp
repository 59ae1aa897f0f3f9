// What a PLC was asked: requests, addresses written, rules that clients broke.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

#include "support/slmp/plc_memory.hpp"

namespace symplant::test::slmp {

/// A point of a device. X1F is {"X", 31}.
struct Address {
  std::string_view device;  ///< a name in device_types()
  std::uint32_t number = 0;
  bool operator==(const Address&) const = default;
};

struct LoggedRequest {
  bool is_udp = false;
  bool is_4e = false;
  bool is_write = false;
  bool has_reply = true;  ///< false: the PLC was silent
  std::uint16_t command = 0;
  std::uint16_t subcommand = 0;
  std::uint16_t end_code = 0;
  std::uint32_t points = 0;         ///< as the limits count them: words, bits, or devices of a random request
  std::vector<DeviceRange> ranges;  ///< of the devices' points: 16 for a word of a bit device
};

/// Every call is atomic. Values are copies.
class PlcLog {
 public:
  std::size_t count() const;
  std::size_t count(std::uint16_t command) const;
  std::vector<LoggedRequest> requests() const;
  /// Every address that a write request named, refused requests too, each once, by device and number. Not
  /// the numbers that no device has.
  std::vector<Address> writes() const;
  /// Addresses in writes() that are in none of the windows.
  std::vector<Address> writes_outside(const std::vector<DeviceRange>& windows) const;
  /// Every rule of the protocol that a client broke: limits, lengths, devices, foreign frames, a second request before
  /// the reply to the first one in 3E, a duplicate destination, a second connection. Not: writes that are disabled.
  std::vector<std::string> violations() const;
  /// The most requests of a connection that had no reply at one moment; requests to a silent PLC count.
  std::size_t most_outstanding() const;
  void clear();

  // The server's part.
  void add(LoggedRequest request);
  void add_violation(std::string text);
  void note_outstanding(std::size_t requests);

 private:
  mutable std::mutex mutex_;
  std::vector<LoggedRequest> requests_;
  std::vector<std::string> violations_;
  std::vector<std::vector<bool>> written_;  ///< by index_of(), then number
  std::size_t most_outstanding_ = 0;
};

}  // namespace symplant::test::slmp
