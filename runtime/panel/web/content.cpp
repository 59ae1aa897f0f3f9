// The bytes of answers.
#include "symplant/panel/web/content.hpp"

#include <utility>

namespace symplant::panel {

const Bytes& Content::packed() {
  if (packed_ == nullptr) packed_ = std::make_shared<const std::string>(gzip(*plain_, packing_));
  return packed_;
}

Bytes Outgoing::share(std::string text) {
  auto kept = std::make_unique<const std::string>(std::move(text));
  *size_ += kept->size();
  return {kept.release(), [size = size_](const std::string* shared) {
            *size -= shared->size();
            delete shared;
          }};
}

}  // namespace symplant::panel
