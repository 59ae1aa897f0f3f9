// Keeps the levels of each device once.
#include "name/device_store.hpp"

#include <algorithm>

#include "text/ascii.hpp"
#include "text/folding.hpp"

namespace symplant::name {
namespace {

bool is_ascii(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

std::uint64_t mixed(std::uint64_t hash, std::uint64_t with) { return (hash ^ with) * 0x9E37'79B9'7F4A'7C15U; }

bool is_exact(const DeviceLevels& known, const DeviceStore::Texts& texts) {
  return known.device == texts[2] && known.process == texts[1] && known.line == texts[0];
}

}  // namespace

std::uint64_t DeviceStore::hash_of(std::string_view level) const {
  if (ignored_ == Case::ascii || is_ascii(level)) return text::hash_ignoring_case(level);
  return text::hash_ignoring_case(text::folded(level));
}

bool DeviceStore::is_same(std::string_view a, std::string_view b) const {
  if (text::equal_ignoring_case(a, b)) return true;
  return ignored_ == Case::unicode && !is_ascii(a) && text::folded(a) == text::folded(b);
}

const DeviceLevels* DeviceStore::find_or_add(const Texts& texts, std::string_view path) {
  if (last_ != nullptr && is_exact(*last_, texts)) return last_;
  std::uint64_t hash = 0;
  for (const std::string_view text : texts) hash = mixed(hash, text::hash_ignoring_case(text));
  const auto next = static_cast<std::uint32_t>(levels_.size());
  const std::uint32_t index =
      by_text_.find_or_add(hash, next, [&](std::uint32_t other) { return is_exact(levels_[other], texts); });
  last_ = index == next ? add(texts, path) : &levels_[index];
  return last_;
}

const DeviceLevels* DeviceStore::add(const Texts& texts, std::string_view path) {
  const auto next = static_cast<std::uint32_t>(levels_.size());
  DeviceLevels& added = levels_.emplace_back();
  if (!path.empty()) {
    added = {path, texts[0], texts[1], texts[2]};
  } else {
    std::string joined;
    for (const std::string_view text : texts) joined.append(joined.empty() || text.empty() ? "" : "_").append(text);
    added = {texts_.keep(joined), texts_.keep(texts[0]), texts_.keep(texts[1]), texts_.keep(texts[2])};
  }
  const std::uint64_t process = mixed(hash_of(texts[0]), hash_of(texts[1]));
  const auto same_process = [&](std::uint32_t other) {
    return is_same(levels_[other].line, texts[0]) && is_same(levels_[other].process, texts[1]);
  };
  added.process_id = by_process_.find_or_add(process, next, same_process);
  const std::uint32_t first = by_folded_.find_or_add(mixed(process, hash_of(texts[2])), next, [&](std::uint32_t other) {
    return same_process(other) && is_same(levels_[other].device, texts[2]);
  });
  added.device_id = first == next ? devices_++ : levels_[first].device_id;
  return &added;
}

}  // namespace symplant::name
