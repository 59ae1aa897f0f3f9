// Decodes the payload of a device request.
#include "support/slmp/plc_request.hpp"

#include <algorithm>

#include "support/slmp/plc_fields.hpp"

namespace symplant::test::slmp {
namespace {

constexpr std::uint32_t kMostLoopback = 960;

class Decoder {
 public:
  Decoder(const RequestFrame& frame, const PlcProfile& profile, Code code, bool octal)
      : frame_(frame),
        profile_(profile),
        fields_(frame.payload, code),
        is_iqr_((frame.subcommand & 2U) != 0),
        is_bitwise_((frame.subcommand & 1U) != 0),
        octal_(octal),
        limits_(profile.limits(is_iqr_, code)) {
    request_.command = frame.command;
  }

  DecodedRequest result() {
    end_code_ = unsupported();
    if (end_code_ == kOk) decode_command();
    if (end_code_ == kOk) check_fields();
    return {end_code_, std::move(request_)};
  }

 private:
  std::uint16_t unsupported() const;
  void decode_command();
  void decode_batch();
  void decode_random();
  void decode_random_bits();
  void decode_blocks();
  void decode_loopback();
  void check_fields();
  void refuse(std::uint16_t end_code) {
    if (end_code_ == kOk) end_code_ = end_code;
  }
  Item device(std::uint32_t width);
  Item single(std::uint32_t width);

  const RequestFrame& frame_;
  const PlcProfile& profile_;
  FieldReader fields_;
  bool is_iqr_;
  bool is_bitwise_;
  bool octal_;
  Limits limits_;
  bool has_wrong_block_ = false;  ///< a bit device in a word block or a word device in a bit block
  std::uint16_t end_code_ = kOk;
  DeviceRequest request_;
};

std::uint16_t Decoder::unsupported() const {
  const std::uint16_t most_subcommand = [&]() -> std::uint16_t {
    switch (frame_.command) {
      case kRead:
      case kWrite:
      case kWriteRandom:
        return 3;
      case kReadRandom:
      case kReadBlocks:
      case kWriteBlocks:
        return 2;
      default:
        return 0;
    }
  }();
  const bool is_known = frame_.command == kRead || frame_.command == kWrite || frame_.command == kReadRandom ||
                        frame_.command == kWriteRandom || (profile_.has_model && frame_.command == kReadModel) ||
                        (profile_.has_loopback && frame_.command == kLoopback) ||
                        (profile_.has_blocks && (frame_.command == kReadBlocks || frame_.command == kWriteBlocks));
  if (frame_.command == kWrite && is_bitwise_ && !profile_.has_bit_batches) return kCommand;
  if (!is_known || frame_.subcommand > most_subcommand || (most_subcommand == 2 && is_bitwise_)) return kCommand;
  return is_iqr_ && !profile_.has_iqr_subcommands ? profile_.foreign_subcommand : std::uint16_t{kOk};
}

void Decoder::decode_command() {
  request_.is_write = frame_.command == kWrite || frame_.command == kWriteRandom || frame_.command == kWriteBlocks;
  switch (frame_.command) {
    case kRead:
    case kWrite:
      return decode_batch();
    case kReadRandom:
      return decode_random();
    case kWriteRandom:
      return is_bitwise_ ? decode_random_bits() : decode_random();
    case kReadBlocks:
    case kWriteBlocks:
      return decode_blocks();
    case kLoopback:
      return decode_loopback();
    default:
      return;
  }
}

Item Decoder::device(std::uint32_t width) {
  Item item;
  item.width = width;
  if (fields_.code() == Code::binary) {
    item.number = fields_.number(is_iqr_ ? 4 : 2);
    if (!is_iqr_) item.number |= fields_.number(1) << 16U;
    item.device = device_of_code(static_cast<std::uint16_t>(fields_.number(is_iqr_ ? 2 : 1)));
    return item;
  }
  item.device = device_of_padded_name(fields_.text(is_iqr_ ? 4 : 2));
  const unsigned base = item.device == nullptr ? 16 : base_of(*item.device, octal_ ? Family::fx5 : Family::q);
  item.number = fields_.digits(is_iqr_ ? 8 : 6, base);
  return item;
}

void Decoder::decode_batch() {
  Item item = device(is_bitwise_ ? 1 : 16);
  item.points = fields_.number(2);
  request_.points = item.points;
  const bool is_short = fields_.is_short();
  if (!is_short && (item.points == 0 || item.points > (is_bitwise_ ? limits_.bits : limits_.words))) {
    return refuse(is_bitwise_ ? profile_.too_many_bits : profile_.too_many_words);
  }
  if (request_.is_write && !is_short) {
    if (is_bitwise_) item.values = fields_.bits(item.points);
    for (std::uint32_t i = 0; i < item.points && !is_bitwise_; ++i) item.values.push_back(fields_.number(2));
  }
  request_.items.push_back(std::move(item));
}

/// A point of its device and, in a write, its value.
Item Decoder::single(std::uint32_t width) {
  Item item = device(width);
  if (request_.is_write) item.values.push_back(fields_.number(width / 8));
  return item;
}

void Decoder::decode_random() {
  const std::uint32_t words = fields_.number(1);
  const std::uint32_t dwords = fields_.number(1);
  request_.points = words + dwords;
  const bool is_too_much =
      request_.is_write ? 12 * words + 14 * dwords > limits_.random_write_cost : request_.points > limits_.random_read;
  if (!fields_.is_short() && (request_.points == 0 || is_too_much)) return refuse(profile_.too_many_random_words);
  for (std::uint32_t i = 0; i < words; ++i) request_.items.push_back(single(16));
  for (std::uint32_t i = 0; i < dwords; ++i) request_.items.push_back(single(32));
}

void Decoder::decode_random_bits() {
  request_.points = fields_.number(1);
  if (!fields_.is_short() && (request_.points == 0 || request_.points > limits_.random_bits)) {
    return refuse(kRandomBits);
  }
  for (std::uint32_t i = 0; i < request_.points; ++i) {
    Item item = device(1);
    item.values.push_back(fields_.number(is_iqr_ ? 2 : 1));
    if (item.values.front() > 1) fields_.mark_bad_bit();
    request_.items.push_back(std::move(item));
  }
}

void Decoder::decode_blocks() {
  const std::uint32_t word_blocks = fields_.number(1);
  const std::uint32_t blocks = word_blocks + fields_.number(1);
  if (!fields_.is_short() && (blocks == 0 || blocks > limits_.blocks)) return refuse(profile_.too_many_words);
  std::uint32_t cost = 0;
  for (std::uint32_t i = 0; i < blocks && !fields_.is_short(); ++i) {
    Item item = device(16);
    item.points = fields_.number(2);
    request_.points += item.points;
    cost += item.points + (request_.is_write ? limits_.block_write_overhead : 0);
    if (fields_.is_short()) break;
    if (item.points == 0 || cost > limits_.block_points) return refuse(profile_.too_many_words);
    for (std::uint32_t k = 0; k < item.points && request_.is_write; ++k) item.values.push_back(fields_.number(2));
    has_wrong_block_ |= item.device != nullptr && item.device->is_bit != (i >= word_blocks);
    request_.items.push_back(std::move(item));
  }
}

void Decoder::decode_loopback() {
  const std::uint32_t size = fields_.number(2);
  request_.points = size;
  if (!fields_.is_short() && (size == 0 || size > kMostLoopback)) return refuse(kContent);
  request_.text = fields_.text(size);
  if (request_.text.find_first_not_of("0123456789ABCDEF") != std::string::npos) refuse(kContent);
}

void Decoder::check_fields() {
  if (fields_.is_short() || fields_.left() != 0) return refuse(kLength);
  if (fields_.is_malformed()) return refuse(kNotHex);
  for (const Item& item : request_.items) {
    if (item.device == nullptr) return refuse(kDevice);
    if (item.width == 1 && !item.device->is_bit) return refuse(kContent);
  }
  if (has_wrong_block_) return refuse(kDevice);
  if (fields_.has_bad_bit()) refuse(kBitValue);
}

}  // namespace

DecodedRequest decode(const RequestFrame& frame, const PlcProfile& profile, Code code, bool has_octal_input_output) {
  return Decoder(frame, profile, code, has_octal_input_output).result();
}

}  // namespace symplant::test::slmp
