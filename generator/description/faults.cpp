// Messages and locations of a description's faults.
#include "description/faults.hpp"

#include <algorithm>

#include "symplant/json/location.hpp"

namespace symplant::description {

std::string ticked(std::string_view text) { return "`" + std::string(text) + "`"; }

std::string missing(const std::string& what, std::string_view nearest) {
  return what + " not found" + (nearest.empty() ? "" : "; did you mean " + ticked(nearest) + "?");
}

std::string_view named_text(Named what) {
  switch (what) {
    case Named::state:
      return "state";
    case Named::operation:
      return "operation";
    case Named::event:
      return "event";
  }
  return {};
}

Pointer Pointer::grown(const Step& step) const {
  if (fixed_) return *this;
  Pointer grown = *this;
  if (count_ == steps_.size()) {
    grown.begin_ = text();
    grown.count_ = 0;
  }
  grown.steps_[grown.count_++] = step;
  return grown;
}

Pointer Pointer::matched_by(std::string_view pattern) const {
  Pointer pointer = *this;
  pointer.matched_by_ = pattern;
  return pointer;
}

std::string Pointer::text() const {
  std::string text = begin_;
  for (std::size_t i = 0; i < count_; ++i) {
    const Step& step = steps_[i];
    text = step.key.data() == nullptr ? json::child(text, step.index) : json::child(text, step.key);
  }
  return text;
}

Pointer device_pointer(const DeviceDescription& device) { return Pointer("/devices") / device.path; }

Pointer key_pointer(const DeviceDescription& device, DeviceKey key) {
  const DeviceDescription& entry = device.entry_of(key);
  if (entry.by_naming) {  // the user's entry contradicts it
    Pointer pointer = device_pointer(device);
    pointer.fixed_ = true;
    return pointer;
  }
  Pointer pointer = device_pointer(entry) / device_key_name(key);
  if (entry.is_pattern()) pointer.pattern_ = &entry;
  pointer.key_ = key;
  return pointer;
}

void Faults::add(const Pointer& at, std::string message, FaultKind kind, std::size_t column) {
  if (!at.pattern_text().empty()) {
    const auto [reported, added] = reported_.try_emplace(at.text() + "#" + std::to_string(column), faults_.size());
    if (!added) {
      std::string& first = faults_[reported->second].message;
      const std::string others =
          std::string(at.pattern() != nullptr ? " (also for other devices that " : " (also for others that ") +
          ticked(at.pattern_text()) + " matches)";
      if (!first.ends_with(others)) first += others;
      return;
    }
  }
  faults_.push_back({at.text(), std::move(message), column, kind});
}

void Faults::describes(const DeviceDescription& described) {
  for (std::size_t k = 0; k < kDeviceKeys; ++k) {
    const auto key = static_cast<DeviceKey>(k);
    if (!described.gives(key)) continue;
    const DeviceDescription& entry = described.entry_of(key);
    if (entry.is_pattern() && !entry.by_naming) ++takers_[&entry][k];
  }
}

void Faults::report_lacks(const SomeHave& some_have) {
  for (auto& [at, lack] : lacks_) {
    const std::string pattern = ticked(lack.pattern->path);
    const std::size_t takers = takers_[lack.pattern][static_cast<std::size_t>(lack.key)];
    if (lack.count == takers && !some_have(lack.pattern->path, at.second, lack.name)) {
      const std::size_t others = lack.count - 1;
      if (others == 1) lack.message += " (the other device that takes this entry from " + pattern + " lacks it too)";
      if (others > 1) {
        lack.message +=
            " (the other " + std::to_string(others) + " devices that take this entry from " + pattern + " lack it too)";
      }
      add(DescriptionFault{at.first, std::move(lack.message), 0, FaultKind::unknown_name});
      continue;
    }
    std::string paths;
    for (const std::string_view path : lack.paths) paths.append(paths.empty() ? "" : ", ").append(ticked(path));
    if (lack.count > lack.paths.size()) {
      paths.append(" and ").append(std::to_string(lack.count - lack.paths.size())).append(" more");
    }
    std::string words = std::to_string(lack.count);
    words.append(" of the ").append(std::to_string(takers)).append(" devices that take this entry from ");
    words.append(pattern);
    words.append(lack.count == 1 ? " has no " : " have no ").append(named_text(at.second)).append(" ");
    words.append(ticked(lack.name)).append("; the entry is left out for ").append(paths);
    warnings_.push_back({at.first, std::move(words), 0, FaultKind::left_out});
  }
  lacks_.clear();
}

}  // namespace symplant::description
