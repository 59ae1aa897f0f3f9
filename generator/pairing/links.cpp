// Joins symbols by the rows of Naming::links.
#include <unordered_map>
#include <utility>

#include "pairing/facet_builder.hpp"
#include "pairing/work.hpp"
#include "text/ascii.hpp"

namespace symplant::pairing {
namespace {

class LinkPairing {
 public:
  explicit LinkPairing(Work& work) : work_(work) {}

  void run() {
    find_symbols();
    for (std::uint32_t row = 0; row < work_.naming.links.size(); ++row) take(row);
    for (Device& device : devices_) {
      if (!device.builder.has_symbols()) continue;
      Facet facet = device.builder.take(device.first, false);
      facet.by = FacetBy::links;
      if (work_.is_read(device.first)) {
        work_.add(std::move(facet), work_.device[device.first]);
      } else {
        work_.add(std::move(facet), work_.inputs[device.first].name);
      }
    }
  }

 private:
  struct Device {
    std::uint32_t first;  ///< the symbol that names it
    FacetBuilder builder;
  };
  /// What a row has said of a symbol.
  struct Said {
    std::uint32_t device;
    std::uint32_t row;
  };

  void find_symbols() {
    for (const name::NamedLink& link : work_.naming.links) {
      if (!link.operation.empty()) symbols_.try_emplace(link.operation, kNone);
      symbols_.try_emplace(link.event, kNone);
    }
    for (std::uint32_t i = 0; i < work_.inputs.size(); ++i) {
      const auto found = symbols_.find(work_.inputs[i].name);
      if (found != symbols_.end() && found->second == kNone) found->second = i;
    }
  }

  /// The symbol of that name; kNone, and a remark, if a row cannot link it on this side.
  std::uint32_t find(const std::string& name, name::Direction side, std::uint32_t row) {
    const std::uint32_t input = symbols_.find(name)->second;
    if (input == kNone || !work_.inputs[input].boolean) {
      work_.result.remarks.push_back(
          {Remark::Kind::link_unknown, input == kNone ? 0 : input, side == name::Direction::operation ? 1U : 0U, row});
      return kNone;
    }
    if (work_.inputs[input].side == side) return input;
    work_.result.remarks.push_back({Remark::Kind::link_side, input, 0, row});
    return kNone;
  }

  void take(std::uint32_t row) {
    const name::NamedLink& link = work_.naming.links[row];
    const std::uint32_t event = find(link.event, name::Direction::event, row);
    if (!link.operation.empty()) {
      current_ = kNone;
      const std::uint32_t operation = find(link.operation, name::Direction::operation, row);
      if (operation == kNone) return;
      current_ = device_of(operation, event);
      add(operation, link.state, row);
    }
    if (event != kNone && current_ != kNone) add(event, link.state, row);
  }

  /// The device of the operation; without one that of the event; else the operation is the device.
  std::uint32_t device_of(std::uint32_t operation, std::uint32_t event) {
    if (const auto said = said_.find(operation); said != said_.end()) return said->second.device;
    const bool by_event = !work_.is_read(operation) && event != kNone && work_.is_read(event);
    const std::uint32_t first = by_event ? event : operation;
    const std::uint64_t key = work_.is_read(first) ? work_.device[first] : work_.devices.size() + std::uint64_t{first};
    const auto [found, added] = by_key_.try_emplace(key, static_cast<std::uint32_t>(devices_.size()));
    if (added) devices_.push_back({first, FacetBuilder(work_)});
    return found->second;
  }

  void add(std::uint32_t input, const std::string& state, std::uint32_t row) {
    const auto [said, added] = said_.try_emplace(input, Said{current_, row});
    const name::NamedLink& before = work_.naming.links[said->second.row];
    if (added) {
      devices_[current_].builder.add(input, state, false);
    } else if (said->second.device != current_) {
      work_.result.remarks.push_back({Remark::Kind::link_repeated, input, said->second.row, row});
    } else if (!text::equal_ignoring_case(before.state, state)) {
      if (work_.is_operation(input)) {
        work_.result.remarks.push_back({Remark::Kind::link_repeated, input, said->second.row, row});
      } else {
        devices_[current_].builder.add_again(input, state);
      }
    }
  }

  Work& work_;
  text::ByName<std::uint32_t> symbols_;  ///< the inputs of the names in links
  std::unordered_map<std::uint64_t, std::uint32_t> by_key_;
  std::unordered_map<std::uint32_t, Said> said_;  ///< by input: its first row
  std::vector<Device> devices_;
  std::uint32_t current_ = kNone;  ///< the device of the row above
};

}  // namespace

void pair_by_links(Work& work) {
  if (!work.naming.links.empty()) LinkPairing(work).run();
}

}  // namespace symplant::pairing
