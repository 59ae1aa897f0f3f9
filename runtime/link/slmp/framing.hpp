// SLMP frames, 3E and 4E, binary and ASCII: bytes in, bytes out, no socket (SH-080008, chapter 4).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "symplant/link/slmp/device.hpp"

namespace symplant::link::slmp {

enum class FrameType : std::uint8_t { e3, e4 };
enum class Code : std::uint8_t { binary, ascii };
/// The subcommands: those of Q and L have shorter device specifications, and every family takes them.
enum class Commands : std::uint8_t { ql, iqr };

/// The station that a request goes to. The defaults are the station that the connection ends at, and its CPU.
struct Route {
  std::uint8_t network = 0;
  std::uint8_t station = 0xFF;
  std::uint16_t module = 0x03FF;
  std::uint8_t multidrop = 0;
  friend bool operator==(const Route&, const Route&) = default;
};

/// Everything in a frame that is the same for all requests of a link.
struct Framing {
  FrameType frame = FrameType::e3;
  Code code = Code::binary;
  Commands commands = Commands::ql;
  Family family = Family::q;  ///< for the text of X and Y numbers
  Route route = {};
  std::uint16_t timer = 2;  ///< how long the PLC waits for its own answer, in units of 250 ms; 0: no limit
};

enum class Command : std::uint16_t {
  read = 0x0401,
  write = 0x1401,
  read_random = 0x0403,
  write_random = 0x1402,
  read_blocks = 0x0406,
  write_blocks = 0x1406,
  read_model = 0x0101,
};

/// Builds one request at a time, in its memory. A request of n bytes costs O(n).
class RequestWriter {
 public:
  explicit RequestWriter(const Framing& framing) : framing_(framing) {}

  /// Starts a request; `bits`: in units of bits instead of words.
  void begin(Command command, bool bits, std::uint16_t serial);
  void put_8(std::uint8_t value) { put(value, 1); }
  void put_16(std::uint16_t value) { put(value, 2); }
  void put_32(std::uint32_t value) { put(value, 4); }
  /// A device specification.
  void put_device(Kind kind, std::uint32_t number);
  /// Values of consecutive bits, 0 or 1, in units of bits.
  void put_bits(std::span<const std::uint8_t> bits);
  /// The value of one bit in a list of devices.
  void put_listed_bit(bool on);
  /// The whole frame. Valid until begin().
  std::span<const std::uint8_t> finish();

 private:
  void put(std::uint32_t value, int bytes);
  void put_at(std::size_t at, std::uint32_t value, int bytes);
  bool ascii() const noexcept { return framing_.code == Code::ascii; }

  Framing framing_;
  std::vector<std::uint8_t> bytes_;
  std::size_t length_at_ = 0;  ///< index of the length field
};

/// The first reply in the bytes received so far.
struct Reply {
  enum class Kind : std::uint8_t {
    incomplete,  ///< more bytes are needed
    complete,
    late,    ///< a complete reply to an earlier request: drop `consumed` bytes
    broken,  ///< not a reply to this request: close the connection
  } kind = Kind::incomplete;
  std::size_t consumed = 0;
  std::uint16_t end_code = 0;
  std::span<const std::uint8_t> data = {};  ///< as on the wire; of an error: its information block
  const char* reason = "";                  ///< of a broken one
};

/// Parses the reply to the request with this serial number (used by 4E). `datagram`: the bytes are one whole reply.
/// O(1).
Reply parse_reply(std::span<const std::uint8_t> bytes, const Framing& framing, std::uint16_t serial,
                  bool datagram) noexcept;

/// The longest reply, in bytes.
inline constexpr std::size_t kLongestReply = 4 * 2048;

/// Reads the data of a reply. A data block of n words costs O(n).
class DataReader {
 public:
  DataReader(std::span<const std::uint8_t> data, Code code) noexcept : data_(data), ascii_(code == Code::ascii) {}

  /// Whether exactly `words` words, 32-bit numbers counted as two, are left.
  bool holds(std::size_t words) const noexcept { return data_.size() == words * (ascii_ ? 4 : 2); }
  /// The next words; false if the text is not hexadecimal.
  bool words(std::span<std::uint16_t> out) noexcept;
  /// The next 32-bit number as two words, the low one first.
  bool low_high(std::span<std::uint16_t, 2> out) noexcept;

 private:
  std::span<const std::uint8_t> data_;
  bool ascii_;
};

}  // namespace symplant::link::slmp
