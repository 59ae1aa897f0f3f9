// Finds a text in a blob of names by its index.
#include "symplant/trace/name_index.hpp"

#include <algorithm>

namespace symplant::trace {

std::size_t NameIndex::after(std::size_t at) const {
  return at < blob_.size() ? std::min(blob_.find('\0', at), blob_.size() - 1) + 1 : blob_.size();
}

std::string_view NameIndex::operator[](std::size_t index) const {
  std::call_once(made_, [this] {
    std::size_t count = 0;
    for (std::size_t at = 0; at < blob_.size(); at = after(at)) {
      if (count++ % kStep == 0) starts_.push_back(at);
    }
  });
  if (index / kStep >= starts_.size()) return {};
  std::size_t at = starts_[index / kStep];
  for (std::size_t skipped = index % kStep; skipped != 0; --skipped) at = after(at);
  const std::string_view rest = blob_.substr(at);
  return rest.substr(0, rest.find('\0'));
}

}  // namespace symplant::trace
