// Changes one part of a request at a time, so that short parts are changed as often as long ones: its address, the
// lines of its head, its body; or all of it.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

/// Of libFuzzer: changes `size` bytes in a buffer for `most`, and returns how many they are then.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace symplant::fuzz {
namespace {

using Range = std::pair<std::size_t, std::size_t>;  ///< from the first to before the second

Range part_of(std::string_view request, unsigned part) {
  const std::size_t line = std::min(request.find('\n'), request.size());
  const std::size_t head = std::min(request.find("\n\n"), request.size());
  const std::size_t method = std::min(request.find(' '), line);
  const std::size_t address = std::min(method + 1, line);
  switch (part) {
    case 0:
      return {address, std::min(request.find(' ', address), line)};
    case 1:
      return {line, std::max(line, head)};
    case 2:
      return {std::min(head + 2, request.size()), request.size()};
    default:
      return {0, request.size()};
  }
}

}  // namespace
}  // namespace symplant::fuzz

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  const std::string_view request(reinterpret_cast<const char*>(data), size);
  const auto [begin, end] = symplant::fuzz::part_of(request, seed % 4);
  const std::size_t around = size - (end - begin);
  if (around >= most) return LLVMFuzzerMutate(data, size, most);
  std::vector<std::uint8_t> part(data + begin, data + end);
  const std::vector<std::uint8_t> rest(data + end, data + size);
  if (seed / 4 % 8 == 0 && !part.empty()) {  // a part without its start, which single bytes seldom lead to
    part.erase(part.begin(), part.begin() + 1 + static_cast<std::ptrdiff_t>(seed / 32 % part.size()));
  } else {
    part.resize(most - around);
    part.resize(LLVMFuzzerMutate(part.data(), end - begin, part.size()));
  }
  std::copy(part.begin(), part.end(), data + begin);
  std::copy(rest.begin(), rest.end(), data + begin + part.size());
  return around + part.size();
}
