// The actions of acts and steps that the plant refused; the other actions were done.
#include "symplant/panel/operate/refusals.hpp"

#include "symplant/scenario/player.hpp"

namespace symplant::panel {
namespace {

constexpr std::uint64_t kWhich = (std::uint64_t{1} << scenario::kRefusedBits) - 1;

template <class T>
void erase_at(std::vector<T>& list, std::uint64_t index) {
  list.erase(list.begin() + static_cast<std::ptrdiff_t>(index));
}

}  // namespace

scenario::Step Refusals::done_of(scenario::Step step, std::size_t index) const {
  // From the last one: those before it keep their indexes.
  for (auto value = values_.rbegin(); value != values_.rend(); ++value) {
    if (*value >> scenario::kRefusedBits != index) continue;
    const std::uint64_t which = *value & kWhich;
    if (which >= scenario::kStartNote) {
      erase_at(step.start, which - scenario::kStartNote);
    } else if (which >= scenario::kTakeNote) {
      erase_at(step.take, which - scenario::kTakeNote);
    } else {
      erase_at(step.put, which);
    }
  }
  return step;
}

std::string_view Refusals::words() const {
  const std::uint64_t which = values_.front() & kWhich;
  if (which >= scenario::kStartNote) return "too many malfunctions are active";
  return which >= scenario::kTakeNote ? "there is no part there" : "a part has no room there";
}

}  // namespace symplant::panel
