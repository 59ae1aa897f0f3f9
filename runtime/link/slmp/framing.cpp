// SLMP frames, 3E and 4E, binary and ASCII.
#include "symplant/link/slmp/framing.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace symplant::link::slmp {

namespace {

constexpr std::size_t kSerialBytes = 4;  ///< serial number and a reserved word, of a 4E frame
constexpr std::size_t kRouteBytes = 5;
constexpr int kShortestText = 2;
constexpr std::array kHexDigits = {'0', '1', '2', '3', '4', '5', '6', '7', '8', '9', 'A', 'B', 'C', 'D', 'E', 'F'};

/// 16 if the character is not a hexadecimal digit.
std::uint32_t digit_of(std::uint8_t c) noexcept {
  if (c >= '0' && c <= '9') return c - std::uint32_t{'0'};
  if (c >= 'A' && c <= 'F') return c - std::uint32_t{'A'} + 10;
  if (c >= 'a' && c <= 'f') return c - std::uint32_t{'a'} + 10;
  return 16;
}

/// Reads the fields of a header in turn.
class Header {
 public:
  Header(std::span<const std::uint8_t> bytes, bool ascii) noexcept : bytes_(bytes), ascii_(ascii) {}

  /// Low byte first in binary; most significant digit first in ASCII.
  std::uint32_t next(int bytes) noexcept { return ascii_ ? text(2 * bytes) : binary(bytes, false); }
  /// The subheader is not swapped.
  std::uint32_t subheader() noexcept { return ascii_ ? text(4) : binary(2, true); }
  bool valid() const noexcept { return valid_; }

 private:
  std::uint32_t text(int digits) noexcept {
    std::uint32_t value = 0;
    for (int i = 0; i < digits; ++i) {
      const std::uint32_t digit = digit_of(bytes_[at_++]);
      valid_ = valid_ && digit < 16;
      value = value << 4 | (digit & 0xF);
    }
    return value;
  }
  std::uint32_t binary(int bytes, bool high_first) noexcept {
    std::uint32_t value = 0;
    for (int i = 0; i < bytes; ++i) {
      const std::uint32_t byte = bytes_[at_++];
      value = high_first ? value << 8 | byte : value | byte << (8 * i);
    }
    return value;
  }

  std::span<const std::uint8_t> bytes_;
  bool ascii_;
  bool valid_ = true;
  std::size_t at_ = 0;
};

Reply broken(const char* reason) noexcept { return {.kind = Reply::Kind::broken, .reason = reason}; }

}  // namespace

void RequestWriter::put_at(std::size_t at, std::uint32_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) {
    const auto byte = static_cast<std::uint8_t>(value >> (8 * i));
    if (!ascii()) {
      bytes_[at + static_cast<std::size_t>(i)] = byte;
      continue;
    }
    const auto text = at + 2 * static_cast<std::size_t>(bytes - 1 - i);
    bytes_[text] = static_cast<std::uint8_t>(kHexDigits[byte >> 4]);
    bytes_[text + 1] = static_cast<std::uint8_t>(kHexDigits[byte & 0xF]);
  }
}

void RequestWriter::put(std::uint32_t value, int bytes) {
  const std::size_t at = bytes_.size();
  bytes_.resize(at + static_cast<std::size_t>(ascii() ? kShortestText * bytes : bytes));
  put_at(at, value, bytes);
}

void RequestWriter::begin(Command command, bool bits, std::uint16_t serial) {
  bytes_.clear();
  const bool e4 = framing_.frame == FrameType::e4;
  if (ascii()) {
    put_16(e4 ? 0x5400 : 0x5000);
  } else {
    bytes_ = {static_cast<std::uint8_t>(e4 ? 0x54 : 0x50), 0x00};
  }
  if (e4) {
    put_16(serial);
    put_16(0);
  }
  put_8(framing_.route.network);
  put_8(framing_.route.station);
  put_16(framing_.route.module);
  put_8(framing_.route.multidrop);
  length_at_ = bytes_.size();
  put_16(0);
  put_16(framing_.timer);
  put_16(static_cast<std::uint16_t>(command));
  const bool iqr = framing_.commands == Commands::iqr && command != Command::read_model;
  put_16(static_cast<std::uint16_t>((iqr ? 2 : 0) + (bits ? 1 : 0)));
}

void RequestWriter::put_device(Kind kind, std::uint32_t number) {
  const KindInfo& info = info_of(kind);
  const bool iqr = framing_.commands == Commands::iqr;
  if (!ascii()) {
    put(number, iqr ? 4 : 3);
    put(info.code, iqr ? 2 : 1);
    return;
  }
  const std::size_t name = iqr ? 4 : 2;
  for (std::size_t i = 0; i < name; ++i) {
    bytes_.push_back(static_cast<std::uint8_t>(i < info.name.size() ? info.name[i] : '*'));
  }
  const std::size_t digits = iqr ? 8 : 6;
  const std::size_t at = bytes_.size();
  bytes_.resize(at + digits, '0');
  const std::uint32_t base = base_of(kind, framing_.family);
  for (std::size_t i = digits; i > 0; --i, number /= base) {
    bytes_[at + i - 1] = static_cast<std::uint8_t>(kHexDigits[number % base]);
  }
}

void RequestWriter::put_bits(std::span<const std::uint8_t> bits) {
  if (ascii()) {
    for (const std::uint8_t bit : bits) bytes_.push_back(static_cast<std::uint8_t>('0' + bit));
    return;
  }
  for (std::size_t i = 0; i < bits.size(); i += 2) {
    const int second = i + 1 < bits.size() ? bits[i + 1] : 0;
    bytes_.push_back(static_cast<std::uint8_t>(bits[i] << 4 | second));
  }
}

void RequestWriter::put_listed_bit(bool on) {
  if (framing_.commands == Commands::iqr) {
    put_16(on ? 1 : 0);
  } else {
    put_8(on ? 1 : 0);
  }
}

std::span<const std::uint8_t> RequestWriter::finish() {
  const std::size_t counted_from = length_at_ + (ascii() ? 4 : 2);
  put_at(length_at_, static_cast<std::uint32_t>(bytes_.size() - counted_from), 2);
  return bytes_;
}

Reply parse_reply(std::span<const std::uint8_t> bytes, const Framing& framing, std::uint16_t serial,
                  bool datagram) noexcept {
  const bool e4 = framing.frame == FrameType::e4;
  const std::size_t scale = framing.code == Code::ascii ? 2 : 1;
  const std::size_t header_size = scale * (2 + (e4 ? kSerialBytes : 0) + kRouteBytes + 2);
  if (bytes.size() < header_size + 2 * scale) {
    return datagram ? broken("a datagram is too short") : Reply{};
  }
  Header header(bytes, framing.code == Code::ascii);
  const std::uint32_t subheader = header.subheader();
  if (subheader != (e4 ? 0xD400 : 0xD000)) return broken("it does not begin as a reply of this frame type");
  const std::uint32_t echoed = e4 ? header.next(2) : serial;
  if (e4) header.next(2);
  Route route;
  route.network = static_cast<std::uint8_t>(header.next(1));
  route.station = static_cast<std::uint8_t>(header.next(1));
  route.module = static_cast<std::uint16_t>(header.next(2));
  route.multidrop = static_cast<std::uint8_t>(header.next(1));
  const std::size_t length = header.next(2);
  const auto end_code = static_cast<std::uint16_t>(header.next(2));
  if (!header.valid()) return broken("its header is not hexadecimal text");
  if (length < 2 * scale || header_size + length > kLongestReply) return broken("its length field is out of range");
  if (route != framing.route) return broken("it comes from another station");
  if (datagram && bytes.size() != header_size + length) return broken("a datagram differs from its length field");
  if (bytes.size() < header_size + length) return {};
  Reply reply{.kind = echoed == serial ? Reply::Kind::complete : Reply::Kind::late,
              .consumed = header_size + length,
              .end_code = end_code};
  reply.data = bytes.subspan(header_size + 2 * scale, length - 2 * scale);
  return reply;
}

bool DataReader::words(std::span<std::uint16_t> out) noexcept {
  if (data_.size() < out.size() * (ascii_ ? 4 : 2)) return false;
  bool valid = true;
  if (ascii_) {
    for (std::size_t i = 0; i < out.size(); ++i) {
      std::uint32_t value = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        const std::uint32_t digit = digit_of(data_[4 * i + k]);
        valid = valid && digit < 16;
        value = value << 4 | (digit & 0xF);
      }
      out[i] = static_cast<std::uint16_t>(value);
    }
  } else {
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i] = static_cast<std::uint16_t>(data_[2 * i] | data_[2 * i + 1] << 8);
    }
  }
  data_ = data_.subspan(out.size() * (ascii_ ? 4 : 2));
  return valid;
}

bool DataReader::low_high(std::span<std::uint16_t, 2> out) noexcept {
  if (!words(out)) return false;
  if (ascii_) std::swap(out[0], out[1]);
  return true;
}

}  // namespace symplant::link::slmp
