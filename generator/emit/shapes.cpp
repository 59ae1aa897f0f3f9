// Finds devices of equal structure, and patterns that match exactly these devices.
#include "emit/shapes.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <unordered_map>

#include "text/ascii.hpp"
#include "text/pattern.hpp"

namespace symplant::emit {
namespace {

std::string key_of(const model::Unit& unit) {
  std::string key;
  for (const model::State& state : unit.states) {
    key += text::to_upper(state.name) + (state.operation != model::kNone ? "\nO" : "\n-") +
           (state.event != model::kNone ? "I\n" : "-\n");
  }
  if (unit.is_archetype()) {
    key += std::to_string(unit.facet->archetype) + "\n";
  }
  key += std::string(description::actuation_name(unit.actuation)) + "\n" + std::to_string(unit.rest) + "\n" +
         std::to_string(unit.initial) + "\n" + std::to_string(static_cast<int>(unit.initial_from));
  return key;
}

/// The device level without the number at its end: the kind of the device, as the list names it.
std::string_view kind_of(const model::Unit& unit) {
  const std::size_t last = unit.device.find_last_not_of("0123456789");
  return unit.device.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

/// The end of the path with the facet's name; empty if it has none.
std::string_view facet_of(const model::Unit& unit) { return unit.path.substr(unit.device_path().size()); }

/// If a shape has more kinds than this, the names do not express kinds: each device has an individual name.
constexpr std::size_t kMostKinds = 8;

/// Splits a shape by kind of device (clamps and grippers may have equal structure, but are described separately), in
/// the order of their first devices. Returns the shape itself if it has too many kinds.
std::vector<Shape> by_kind(const Shape& shape, const model::PlantModel& plant) {
  std::vector<Shape> kinds;
  text::ByName<std::size_t> by_name;
  for (const std::uint32_t unit : shape.units) {
    const auto [found, added] = by_name.try_emplace(kind_of(plant.units[unit]), kinds.size());
    if (added) kinds.emplace_back();
    if (kinds.size() > kMostKinds) return {shape};
    kinds[found->second].units.push_back(unit);
  }
  return kinds;
}

class Namer {
 public:
  explicit Namer(const model::PlantModel& plant) : plant_(plant) {}

  void name(Shape& shape) const {
    const std::string first(path(shape.units.front()));
    if (shape.units.size() == 1) return take(shape, first);
    for (const std::string& pattern :
         {by_levels(shape.units), around(shape.units, true), around(shape.units, false), without_digits(first)}) {
      if (fits_just(pattern, shape)) return take(shape, pattern);
    }
    // Shorten the fixed part from the whole path down: the fewer characters it has, the more devices it may match.
    std::string best = first;
    for (std::size_t length = first.size(); length-- > 1;) {
      if ((static_cast<unsigned char>(first[length]) & 0xC0U) == 0x80U) continue;  // within a character
      const std::string pattern = first.substr(0, length) + "*";
      if (!fits_none_but(pattern, shape)) break;
      best = pattern;
    }
    take(shape, best);
  }

 private:
  std::string_view path(std::uint32_t unit) const { return plant_.units[unit].path; }

  /// `BODY_*_CLAMP?`: the common part of line and process, then the kind. Empty if the devices are of several kinds.
  std::string by_levels(const std::vector<std::uint32_t>& units) const {
    const model::Unit& first = plant_.units[units.front()];
    std::string_view index = first.device_path();  // line and process, with their `_`
    index.remove_suffix(first.device.size());
    const std::string_view facet = facet_of(first);
    bool one_index = true;
    bool one_name = true;
    bool one_digit = true;
    for (const std::uint32_t u : units) {
      const model::Unit& unit = plant_.units[u];
      if (!text::equal_ignoring_case(kind_of(unit), kind_of(first))) return {};
      if (!text::equal_ignoring_case(facet_of(unit), facet)) return {};
      const std::size_t shorter = std::min(index.size(), unit.device_path().size() - unit.device.size());
      std::size_t same = 0;
      while (same < shorter && text::upper(index[same]) == text::upper(unit.path[same])) ++same;
      one_index = one_index && same == index.size();
      index = index.substr(0, same);
      one_name = one_name && text::equal_ignoring_case(unit.device, first.device);
      one_digit = one_digit && unit.device.size() == kind_of(unit).size() + 1;
    }
    while (!one_index && !index.empty() && (static_cast<unsigned char>(index.back()) & 0x80U) != 0) {
      index.remove_suffix(1);  // within a character, perhaps
    }
    return std::string(index) + (one_index ? "" : "*_") +
           (one_name ? std::string(first.device) : std::string(kind_of(first)) + (one_digit ? "?" : "*")) +
           std::string(facet);
  }

  /// The common prefix of all paths, a `*` and, if `with_end` is set, the common suffix.
  std::string around(const std::vector<std::uint32_t>& units, bool with_end) const {
    const std::string_view first = path(units.front());
    std::size_t begin = first.size();
    std::size_t end = first.size();
    for (const std::uint32_t unit : units) {
      const std::string_view other = path(unit);
      const std::size_t shorter = std::min(first.size(), other.size());
      std::size_t same = 0;
      while (same < std::min(begin, shorter) && text::upper(first[same]) == text::upper(other[same])) ++same;
      begin = same;
      same = 0;
      while (same < std::min(end, shorter) &&
             text::upper(first[first.size() - 1 - same]) == text::upper(other[other.size() - 1 - same])) {
        ++same;
      }
      end = same;
    }
    while (begin > 0 && begin < first.size() && (static_cast<unsigned char>(first[begin]) & 0xC0U) == 0x80U) --begin;
    end = std::min(end, first.size() - begin);
    while (end > 0 && (static_cast<unsigned char>(first[first.size() - end]) & 0xC0U) == 0x80U) --end;
    return std::string(first.substr(0, begin)) + "*" + (with_end ? std::string(first.substr(first.size() - end)) : "");
  }

  /// The text with a `*` for each number.
  static std::string without_digits(const std::string& text) {
    std::string pattern;
    for (const char c : text) {
      if (c < '0' || c > '9') {
        pattern += c;
      } else if (pattern.empty() || pattern.back() != '*') {
        pattern += '*';
      }
    }
    return pattern;
  }

  bool fits_just(const std::string& pattern, const Shape& shape) const {
    return fits_none_but(pattern, shape) &&
           std::all_of(shape.units.begin(), shape.units.end(),
                       [&](std::uint32_t unit) { return text::matches_pattern(path(unit), pattern); });
  }

  bool fits_none_but(const std::string& pattern, const Shape& shape) const {
    for (std::uint32_t unit = 0; unit < plant_.units.size(); ++unit) {
      if (!text::matches_pattern(path(unit), pattern)) continue;
      if (!std::binary_search(shape.units.begin(), shape.units.end(), unit)) return false;
    }
    return true;
  }

  void take(Shape& shape, const std::string& pattern) const {
    shape.pattern = pattern;
    std::copy_if(shape.units.begin(), shape.units.end(), std::back_inserter(shape.named),
                 [&](std::uint32_t unit) { return text::matches_pattern(path(unit), pattern); });
  }

  const model::PlantModel& plant_;
};

}  // namespace

std::vector<Shape> shapes_of(const model::PlantModel& plant) {
  std::vector<Shape> shapes;
  std::unordered_map<std::string, std::size_t> by_key;
  for (std::uint32_t u = 0; u < plant.units.size(); ++u) {
    const auto [found, added] = by_key.try_emplace(key_of(plant.units[u]), shapes.size());
    if (added) shapes.emplace_back();
    shapes[found->second].units.push_back(u);
  }
  std::vector<Shape> kinds;
  for (const Shape& shape : shapes) {
    std::vector<Shape> parts = by_kind(shape, plant);
    std::move(parts.begin(), parts.end(), std::back_inserter(kinds));
  }
  std::stable_sort(kinds.begin(), kinds.end(),
                   [](const Shape& a, const Shape& b) { return a.units.front() < b.units.front(); });
  const Namer namer(plant);
  for (Shape& kind : kinds) namer.name(kind);
  return kinds;
}

}  // namespace symplant::emit
