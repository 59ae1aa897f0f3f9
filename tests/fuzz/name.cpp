// Any text as a symbol's name: the parsed parts must give the name again.
#include <algorithm>

#include "fuzz/target.hpp"
#include "naming/load.hpp"
#include "text/utf8.hpp"

namespace symplant::fuzz {
namespace {

using name::Level;
using name::LevelReading;
using name::NameFault;

/// The range of a view within the name.
std::size_t offset_of(std::string_view level, std::string_view name) {
  require(level.data() >= name.data() && level.data() + level.size() <= name.data() + name.size(),
          "a level lies outside the name");
  return static_cast<std::size_t>(level.data() - name.data());
}

void look_at_levels(std::string_view name, const LevelReading& reading) {
  require(reading.levels == 5, "a name without a fault has not five levels");
  for (const std::string_view level : reading.text) {
    require(!level.empty() && level.find('_') == level.npos, "a level is empty, or two");
    offset_of(level, name);
  }
  const std::string path = std::string(reading.of(Level::line)) + "_" + std::string(reading.of(Level::process)) + "_" +
                           std::string(reading.of(Level::device));
  require(name.starts_with(path), "the levels are not those of the name");
  const std::string_view task = reading.of(Level::task);
  const std::size_t begin = offset_of(task, name);
  require(begin == path.size() + 3 && begin + task.size() == name.size(), "the levels joined are not the name");
  const char letter = name[path.size() + 1];
  require((letter | 0x20) == (reading.direction->says == name::Direction::event ? 'i' : 'o'),
          "the direction is another");
}

void look_at_fault(std::string_view name, const LevelReading& reading) {
  const std::size_t begin = offset_of(reading.where, name);
  const std::size_t size = reading.where.size();
  require(is_utf8(name.substr(0, begin)) && is_utf8(reading.where), "a fault cuts a character");
  const auto separators = static_cast<std::size_t>(std::count(name.begin(), name.end(), '_'));
  if (reading.fault == NameFault::illegal_character) {
    require(reading.levels == 0 && size != 0, "an illegal character that is none");
    require(text::code_point_at(name, begin).length == size, "an illegal character is one character");
  } else {
    require(reading.levels == separators + 1, "levels are miscounted");
  }
  if (reading.fault == NameFault::empty_level) require(size == 0, "an empty level is not empty");
  if (reading.fault == NameFault::wrong_number_of_levels) require(reading.levels != 5, "five levels are right");
  if (reading.fault == NameFault::direction_unknown) {
    const std::string_view word = reading.where;
    require(!word.empty() && word != "I" && word != "O" && word != "i" && word != "o", "a direction is refused");
  }
}

}  // namespace
}  // namespace symplant::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symplant;
  const std::string text(reinterpret_cast<const char*>(data), size);
  if (!fuzz::is_utf8(text)) return -1;  // the reader rejects such text
  const name::LevelReading reading = name::read_levels(*naming::strict_naming()->levels(), text);
  if (reading.fault == name::NameFault::none) {
    fuzz::look_at_levels(text, reading);
  } else {
    fuzz::look_at_fault(text, reading);
  }
  return 0;
}
