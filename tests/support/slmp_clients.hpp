// Exchanges images of bit points with an SLMP server: by the link's dialog, or by simpler clients to compare with.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "support/slmp/slmp_plc.hpp"
#include "symplant/link/client/parts.hpp"
#include "symplant/link/client_parts.hpp"
#include "symplant/link/slmp/exchange.hpp"
#include "symplant/link/slmp/plan.hpp"
#include "unit/link/symbol_list.hpp"

namespace symplant::test {

/// One family in the names of the link, of the client's framing and of the server.
struct SlmpFamily {
  std::string_view name;
  link::slmp::Family client;
  slmp::Family server;
};
inline constexpr std::array kSlmpFamilies = {SlmpFamily{"q", link::slmp::Family::q, slmp::Family::q},
                                             SlmpFamily{"iqr", link::slmp::Family::iqr, slmp::Family::iqr},
                                             SlmpFamily{"fx5", link::slmp::Family::fx5, slmp::Family::fx5}};

enum class Spread : std::uint8_t { dense, scattered };
inline constexpr std::uint32_t kBitDevices = 32'768;  ///< of M and of B, as many as an FX5 can have

/// Numbers of bit devices, ascending.
inline std::vector<std::uint32_t> bit_numbers(std::uint32_t count, Spread spread, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::set<std::uint32_t> numbers;
  while (numbers.size() < count) {
    const auto next = static_cast<std::uint32_t>(numbers.size());
    numbers.insert(spread == Spread::dense ? next : static_cast<std::uint32_t>(random() % kBitDevices));
  }
  return {numbers.begin(), numbers.end()};
}

/// Bit points of a plant: half of them operations at M, half of them events at B. Dense ones begin at 0 without gaps,
/// scattered ones are random in all devices.
struct BitMap {
  BitMap(std::uint32_t points, Spread spread)
      : operations(bit_numbers(points / 2, spread, 1)), events(bit_numbers(points / 2, spread, 2)) {}

  std::vector<std::uint32_t> operations;
  std::vector<std::uint32_t> events;
};

/// A server of a family that has all devices of the maps.
class BitPlc {
 public:
  explicit BitPlc(const SlmpFamily& family) : plc_(options_of(family)) {
    plc_.memory().configure("M", kBitDevices);
    plc_.memory().configure("B", kBitDevices);
  }
  slmp::SlmpPlc& plc() { return plc_; }

 private:
  static slmp::PlcOptions options_of(const SlmpFamily& family) {
    slmp::PlcOptions options;
    options.profile = slmp::profile_of(family.server);
    return options;
  }
  slmp::SlmpPlc plc_;
};

/// The dialog of the link.
class PlannedClient {
 public:
  PlannedClient(const BitMap& map, const SlmpFamily& family, std::uint16_t port) : list_(list_of(map, family.client)) {
    auto made = link::client_parts({url_of(family, port), 0}, list_.tables());
    if (auto* error = std::get_if<link::LinkError>(&made)) throw std::runtime_error(error->message);
    parts_ = std::get<link::client::ClientParts>(std::move(made));
    bits_.resize(link::image::bit_words(parts_.map.size(link::Plane::operation_bits)));
    numbers_.resize(parts_.map.size(link::Plane::operation_numbers));
    changes_.resize(parts_.map.size(link::Plane::event_bits) / link::image::kLaneBits);
    for (const link::image::Point& point : parts_.map.points) {
      if (point.plane != link::Plane::event_bits) continue;
      const std::uint32_t lane = point.position / link::image::kLaneBits;
      changes_[lane].lane = {link::Plane::event_bits, lane};
      changes_[lane].mask =
          static_cast<std::uint16_t>(changes_[lane].mask | 1U << (point.position % link::image::kLaneBits));
      changes_[lane].value = changes_[lane].mask;
    }
    if (auto fault = parts_.dialog->open()) throw std::runtime_error(fault.message);
  }

  /// Reads all operations and writes all events. False if a request failed.
  bool exchange() {
    return !parts_.dialog->read({bits_, numbers_}, 0) && !parts_.dialog->write(changes_, unwritten_) &&
           unwritten_.empty();
  }

 private:
  static std::string url_of(const SlmpFamily& family, std::uint16_t port) {
    return "slmp://127.0.0.1:" + std::to_string(port) + "?family=" + std::string(family.name);
  }
  static SymbolList list_of(const BitMap& map, link::slmp::Family family) {
    SymbolList list;
    const auto add = [&](const std::vector<std::uint32_t>& numbers, const char* kind, tables::Direction direction) {
      for (const std::uint32_t number : numbers) {
        const std::string text = device_text({*link::slmp::kind_of(kind), number}, family);
        list.add_device("AT_" + text, direction, text);
      }
    };
    add(map.operations, "M", SymbolList::kOut);
    add(map.events, "B", SymbolList::kIn);
    return list;
  }

  SymbolList list_;
  link::client::ClientParts parts_;
  std::vector<std::uint64_t> bits_;
  std::vector<std::uint64_t> numbers_;
  std::vector<link::client::LaneChange> changes_;
  std::vector<link::client::Unwritten> unwritten_;
};

/// What a client transfers that has one batch request in units of bits for each span.
struct BitSpans {
  std::vector<link::slmp::Span> reads;
  std::vector<link::slmp::Span> writes;
  std::size_t requests() const { return reads.size() + writes.size(); }
};

/// Consecutive numbers in spans of at most `most`: 1 for a client that transfers each point by a separate request.
inline std::vector<link::slmp::Span> spans_of(const char* kind, const std::vector<std::uint32_t>& numbers,
                                              std::uint32_t most) {
  std::vector<link::slmp::Span> spans;
  for (const std::uint32_t number : numbers) {
    const bool fits = !spans.empty() && spans.back().first + spans.back().count == number && spans.back().count < most;
    if (!fits) spans.push_back({*link::slmp::kind_of(kind), number, 0, 0});
    ++spans.back().count;
  }
  return spans;
}

inline BitSpans point_spans(const BitMap& map) {
  return {spans_of("M", map.operations, 1), spans_of("B", map.events, 1)};
}

/// As a program has them that calls the batch functions of an SLMP library for each run of devices.
inline BitSpans run_spans(const BitMap& map, const SlmpFamily& family) {
  const std::uint32_t most = link::slmp::limits_of({.family = family.client}).bits;
  return {spans_of("M", map.operations, most), spans_of("B", map.events, most)};
}

/// A client without a plan.
class SpanClient {
 public:
  SpanClient(BitSpans spans, const SlmpFamily& family, std::uint16_t port)
      : spans_(std::move(spans)), ones_(kBitDevices, 1), exchange_(settings_of(family, port)) {
    if (auto fault = exchange_.open()) throw std::runtime_error(fault.message);
  }

  /// Reads all operations and writes all events. False if a request failed.
  bool exchange() {
    for (const link::slmp::Span& span : spans_.reads) {
      begin(link::slmp::Command::read, span);
      if (exchange_.transact(reply_) || reply_.end_code != 0 || reply_.data.size() != (span.count + 1) / 2)
        return false;
      bits_.clear();
      for (const std::uint8_t two : reply_.data) {
        bits_.push_back(two >> 4);
        bits_.push_back(two & 1);
      }
    }
    for (const link::slmp::Span& span : spans_.writes) {
      begin(link::slmp::Command::write, span).put_bits(std::span(ones_).first(span.count));
      if (exchange_.transact(reply_) || reply_.end_code != 0) return false;
    }
    return true;
  }

 private:
  static link::slmp::Settings settings_of(const SlmpFamily& family, std::uint16_t port) {
    link::slmp::Settings settings;
    settings.address = {"127.0.0.1", port};
    settings.framing.family = family.client;
    return settings;
  }
  link::slmp::RequestWriter& begin(link::slmp::Command command, const link::slmp::Span& span) {
    link::slmp::RequestWriter& request = exchange_.begin(command, true);
    request.put_device(span.kind, span.first);
    request.put_16(static_cast<std::uint16_t>(span.count));
    return request;
  }

  BitSpans spans_;
  std::vector<std::uint8_t> ones_;
  link::slmp::Exchange exchange_;
  link::slmp::Reply reply_;
  std::vector<std::uint8_t> bits_;
};

}  // namespace symplant::test
