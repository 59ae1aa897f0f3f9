// The names of ordinary malfunctions.
#include "elements/malfunction/names.hpp"

#include "text/ascii.hpp"

namespace symplant::model {
namespace {

/// The text before the ending; empty if it does not end so.
std::string_view before(std::string_view name, std::string_view ending) {
  if (name.size() <= ending.size()) return {};
  const std::size_t length = name.size() - ending.size();
  return text::equal_ignoring_case(name.substr(length), ending) ? name.substr(0, length) : std::string_view();
}

}  // namespace

bool is_ordinary_malfunction(std::string_view name, const PlantNames& names, const PlantModel& plant) {
  for (const std::string_view ending : {" stuck", " slow"}) {
    const std::string_view path = before(name, ending);
    if (!path.empty() && names.unit(path, {})) return true;
  }
  for (const std::string_view ending : {" stuck on", " stuck off"}) {
    const std::string_view of = before(name, ending);
    const auto symbol = of.empty() ? std::nullopt : names.symbol(of);
    if (symbol && symbol->type == tables::DataType::boolean &&
        plant.symbols[symbol->index].direction == tables::Direction::event) {
      return true;
    }
  }
  return false;
}

}  // namespace symplant::model
