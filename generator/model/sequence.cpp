// Finds and compares sequence numbers.
#include "model/sequence.hpp"

#include <cstddef>

namespace symplant::model {

std::string_view sequence_number(std::string_view task) {
  std::size_t begin = task.size();
  while (begin > 0 && task[begin - 1] >= '0' && task[begin - 1] <= '9') --begin;
  std::string_view digits = task.substr(begin);
  while (digits.size() > 1 && digits.front() == '0') digits.remove_prefix(1);
  return digits;
}

int compare_sequence(std::string_view a, std::string_view b) {
  if (a.empty() || b.empty()) return static_cast<int>(a.empty()) - static_cast<int>(b.empty());
  if (a.size() != b.size()) return a.size() < b.size() ? -1 : 1;
  return a.compare(b);
}

}  // namespace symplant::model
