// What an operation drives, in words.
#include "symplant/why/driven_things.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

namespace symplant::why {

std::string reader_words(const SymbolReader& reader, const trace::PlantNames& names) {
  const auto named = [](std::string_view kind, std::string_view name) { return std::string(kind).append(name); };
  switch (reader.kind) {
    case SymbolReader::Kind::requirement:
      return named("requirement ", names.requirement(reader.index));
    case SymbolReader::Kind::event:
      return std::string(names.symbol(reader.index));
    case SymbolReader::Kind::track:
      return named("track ", names.location(reader.index));
    case SymbolReader::Kind::transfer:
      return named("transfer ", names.transfer(reader.index));
    case SymbolReader::Kind::work:
      return named("work ", names.work(reader.index));
    case SymbolReader::Kind::source:
      return named("source ", names.source(reader.index));
    case SymbolReader::Kind::malfunction:
      return named("malfunction ", names.malfunction(reader.index));
    case SymbolReader::Kind::value:
      return named("value ", names.value(reader.index));
    case SymbolReader::Kind::unit:
    case SymbolReader::Kind::behavior:
      break;
  }
  return std::string(names.unit(reader.index));
}

std::vector<std::string> driven_things(std::uint32_t operation, const SymbolUse& use, const trace::PlantNames& names,
                                       bool with_malfunctions) {
  std::vector<std::string> things;
  const auto add = [&](std::string thing) {
    if (std::find(things.begin(), things.end(), thing) == things.end()) things.push_back(std::move(thing));
  };
  const SymbolDriver driver = use.driver(operation);
  if (driver.kind == SymbolDriver::Kind::unit || driver.kind == SymbolDriver::Kind::behavior) {
    add(std::string(names.unit(driver.unit)));
  }
  for (const SymbolReader& reader : use.readers(operation)) {
    if (reader.kind == SymbolReader::Kind::malfunction && !with_malfunctions) continue;
    if (reader.kind != SymbolReader::Kind::requirement) add(reader_words(reader, names));
  }
  return things;
}

}  // namespace symplant::why
