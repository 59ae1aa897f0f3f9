// Images of random maps: what is read is what the PLC has, and what is written is what it has then.
#include <map>
#include <random>
#include <set>

#include "support/catch.hpp"
#include "support/slmp/slmp_plc.hpp"
#include "symplant/link/client_parts.hpp"
#include "symplant/link/image/numbers.hpp"
#include "symplant/link/slmp/device.hpp"
#include "unit/link/symbol_list.hpp"

using namespace symplant;
using link::Plane;
using test::SymbolList;

namespace {

struct ImageCase {
  std::string parameters;
  link::slmp::Family family;
  test::slmp::PlcOptions plc;
};

/// The dialog of a random map, its images, and the PLC.
class Images {
 public:
  Images(const ImageCase& one, std::uint32_t seed) : random_(seed), family_(one.family), plc_(one.plc) {
    using tables::DataType;
    add("M", 7'000, SymbolList::kOut, DataType::boolean);
    add("L", 200, SymbolList::kIn, DataType::boolean);
    add("D", 4'000, SymbolList::kOut, DataType::lreal);
    add("W", 500, SymbolList::kOut, DataType::udint);
    add("TN", 500, SymbolList::kOut, DataType::word);
    add("R", 9'000, SymbolList::kIn, DataType::udint);
    add("SW", 500, SymbolList::kIn, DataType::word);
    const std::string url = "slmp://127.0.0.1:" + std::to_string(plc_.port()) + "?" + one.parameters;
    auto made = link::client_parts({url, 0}, list_.tables());
    if (auto* error = std::get_if<link::LinkError>(&made)) FAIL(error->message);
    parts_ = std::get<link::client::ClientParts>(std::move(made));
    for (std::size_t i = 0; i < link::kPlanes; ++i) {
      const std::uint32_t size = parts_.map.sizes[i];
      words_[i].resize(link::has_bits(static_cast<Plane>(i)) ? link::image::bit_words(size) + 1 : size + 1);
    }
    REQUIRE_FALSE(parts_.dialog->open());
  }

  /// Fills the operations in the PLC, reads them, and counts those that are different.
  int wrong_after_read() {
    each_word(true,
              [&](const char* device, std::uint32_t number, Plane, std::uint32_t) { put(device, number, draw()); });
    REQUIRE_FALSE(parts_.dialog->read({image(Plane::operation_bits), image(Plane::operation_numbers)}, 0));
    return wrong(true);
  }

  /// Writes random events, and counts those that the PLC has otherwise.
  int wrong_after_write() {
    std::map<std::pair<Plane, std::uint32_t>, link::client::LaneChange> changes;
    each_word(false, [&](const char*, std::uint32_t, Plane plane, std::uint32_t at) {
      const bool bit = plane == Plane::event_bits;
      const std::uint32_t lane = bit ? at / 16 : at;
      auto& change = changes[{plane, lane}];
      change.lane = {plane, lane};
      change.mask = static_cast<std::uint16_t>(change.mask | (bit ? 1U << at % 16 : 0xFFFFU));
      link::image::set_lane(image(plane), lane, draw());
      change.value = link::image::get_lane(image(plane), lane);
    });
    std::vector<link::client::LaneChange> list;
    for (const auto& entry : changes) list.push_back(entry.second);
    std::vector<link::client::Unwritten> unwritten;
    REQUIRE_FALSE(parts_.dialog->write(list, unwritten));
    CHECK(unwritten.empty());
    return wrong(false);
  }

  /// Number of bits and words of events.
  std::size_t events() {
    std::size_t count = 0;
    each_word(false, [&](const char*, std::uint32_t, Plane, std::uint32_t) { ++count; });
    return count;
  }

  test::slmp::SlmpPlc& plc() { return plc_; }

 private:
  static constexpr std::size_t kSymbols = 60;  ///< of each kind

  std::uint16_t draw() { return static_cast<std::uint16_t>(random_() >> 8); }

  void add(const char* name, std::uint32_t end, tables::Direction direction, tables::DataType type) {
    const std::uint32_t step = type == tables::DataType::boolean ? 1 : 4;
    std::set<std::uint32_t> drawn;
    while (drawn.size() < kSymbols) drawn.insert(static_cast<std::uint32_t>(random_() % (end / step)) * step);
    for (const std::uint32_t number : drawn) {
      const std::string text = device_text({*link::slmp::kind_of(name), number}, family_);
      list_.add_device("AT_" + text, direction, text, type);
      types_.push_back(type);
    }
  }

  std::span<std::uint64_t> image(Plane plane) { return words_[static_cast<std::size_t>(plane)]; }

  bool is_bit(const std::string& device) const { return device == "M" || device == "L"; }
  void put(const std::string& device, std::uint32_t number, std::uint16_t value) {
    if (is_bit(device)) return plc_.memory().set_bit(device, number, (value & 1) != 0);
    plc_.memory().set_word(device, number, value);
  }
  std::uint16_t get(const std::string& device, std::uint32_t number) {
    return is_bit(device) ? std::uint16_t{plc_.memory().bit(device, number)} : plc_.memory().word(device, number);
  }

  /// Calls `visit(device, number, plane, position of the bit, or lane of the word)` for each bit and word of
  /// operations, or of events.
  template <class Visit>
  void each_word(bool operations, Visit visit) {
    for (std::size_t i = 0; i < parts_.map.points.size(); ++i) {
      const link::image::Point& point = parts_.map.points[i];
      const bool operation = !link::is_event(point.plane);
      const bool bit = link::has_bits(point.plane);
      const auto device = link::slmp::parse_device(parts_.addresses[i], family_);
      if (operation != operations || !device) continue;
      const std::string name(link::slmp::info_of(device->kind).name);
      const auto words = static_cast<std::uint32_t>(link::image::words_of(types_.at(point.symbol)));
      for (std::uint32_t k = 0; k < (bit ? 1 : words); ++k) {
        visit(name.c_str(), device->number + k, point.plane, bit ? point.position : 4 * point.position + k);
      }
    }
  }

  int wrong(bool operations) {
    int count = 0;
    each_word(operations, [&](const char* device, std::uint32_t number, Plane plane, std::uint32_t at) {
      const std::uint16_t value = link::has_bits(plane) ? std::uint16_t{link::image::get_bit(image(plane), at)}
                                                        : link::image::get_lane(image(plane), at);
      if (value != get(device, number)) ++count;
    });
    return count;
  }

  std::mt19937 random_;
  link::slmp::Family family_;
  test::slmp::SlmpPlc plc_;
  SymbolList list_;
  std::vector<tables::DataType> types_;  ///< by symbol
  link::client::ClientParts parts_;
  std::array<std::vector<std::uint64_t>, link::kPlanes> words_;
};

ImageCase case_of(const std::string& parameters, link::slmp::Family family, test::slmp::Family server) {
  ImageCase one{parameters, family, {}};
  one.plc.profile = test::slmp::profile_of(server);
  if (parameters.find("ascii") != std::string::npos) one.plc.code = test::slmp::Code::ascii;
  return one;
}

}  // namespace

TEST_CASE("What a random map reads and writes is what the PLC has") {
  for (const ImageCase& one :
       {case_of("family=q", link::slmp::Family::q, test::slmp::Family::q),
        case_of("family=iqr", link::slmp::Family::iqr, test::slmp::Family::iqr),
        case_of("family=iqr&commands=iqr&frame=4e&transport=udp", link::slmp::Family::iqr, test::slmp::Family::iqr),
        case_of("family=iqr&code=ascii", link::slmp::Family::iqr, test::slmp::Family::iqr),
        case_of("family=fx5", link::slmp::Family::fx5, test::slmp::Family::fx5)}) {
    for (std::uint32_t seed = 1; seed <= 3; ++seed) {
      CAPTURE(one.parameters, seed);
      Images images(one, seed);
      CHECK(images.wrong_after_read() == 0);
      CHECK(images.wrong_after_write() == 0);
      CHECK(images.plc().log().writes().size() == images.events());
      CHECK(images.plc().log().violations().empty());
    }
  }
}
