// What a PLC was asked.
#include "support/slmp/plc_log.hpp"

#include <algorithm>

namespace symplant::test::slmp {
namespace {

constexpr std::uint32_t kMostNumbers = 1U << 20U;  // above those of every device

}  // namespace

std::size_t PlcLog::count() const {
  const std::lock_guard lock(mutex_);
  return requests_.size();
}

std::size_t PlcLog::count(std::uint16_t command) const {
  const std::lock_guard lock(mutex_);
  return static_cast<std::size_t>(std::count_if(
      requests_.begin(), requests_.end(), [&](const LoggedRequest& request) { return request.command == command; }));
}

std::vector<LoggedRequest> PlcLog::requests() const {
  const std::lock_guard lock(mutex_);
  return requests_;
}

std::vector<Address> PlcLog::writes() const {
  const std::lock_guard lock(mutex_);
  std::vector<Address> all;
  for (std::size_t device = 0; device < written_.size(); ++device) {
    for (std::size_t number = 0; number < written_[device].size(); ++number) {
      if (written_[device][number]) all.push_back({device_types()[device].name, static_cast<std::uint32_t>(number)});
    }
  }
  return all;
}

std::vector<Address> PlcLog::writes_outside(const std::vector<DeviceRange>& windows) const {
  std::vector<Address> all = writes();
  std::erase_if(all, [&](const Address& address) {
    return std::any_of(windows.begin(), windows.end(), [&](const DeviceRange& window) {
      return window.device == address.device && address.number >= window.first &&
             address.number - window.first < window.count;
    });
  });
  return all;
}

std::vector<std::string> PlcLog::violations() const {
  const std::lock_guard lock(mutex_);
  return violations_;
}

std::size_t PlcLog::most_outstanding() const {
  const std::lock_guard lock(mutex_);
  return most_outstanding_;
}

void PlcLog::clear() {
  const std::lock_guard lock(mutex_);
  requests_.clear();
  violations_.clear();
  written_.clear();
  most_outstanding_ = 0;
}

void PlcLog::add(LoggedRequest request) {
  const std::lock_guard lock(mutex_);
  if (request.is_write) {
    written_.resize(device_types().size());
    for (const DeviceRange& range : request.ranges) {
      if (range.first >= kMostNumbers || range.count > kMostNumbers) continue;
      std::vector<bool>& numbers = written_[index_of(*device_of_name(range.device))];
      if (numbers.size() < range.first + range.count) numbers.resize(range.first + range.count);
      std::fill_n(numbers.begin() + range.first, range.count, true);
    }
  }
  requests_.push_back(std::move(request));
}

void PlcLog::add_violation(std::string text) {
  const std::lock_guard lock(mutex_);
  violations_.push_back(std::move(text));
}

void PlcLog::note_outstanding(std::size_t requests) {
  const std::lock_guard lock(mutex_);
  most_outstanding_ = std::max(most_outstanding_, requests);
}

}  // namespace symplant::test::slmp
