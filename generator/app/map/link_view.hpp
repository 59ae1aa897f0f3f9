// One link of a plant with everything that the formats of `symplant map` show.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "model/plant_model.hpp"
#include "symplant/link/client/parts.hpp"
#include "symplant/link/io_map.hpp"
#include "symplant/link/link.hpp"
#include "symplant/tables/tables.hpp"
#include "symplant/trace/plant_names.hpp"
#include "symplant/why/symbol_use.hpp"

namespace symplant::app {

/// A plant as its links see it. Refers to the model and the tables.
struct LinkedPlant {
  const model::PlantModel& plant;
  const tables::PlantTables& tables;
  const why::SymbolUse use;
  const trace::PlantNames names;

  LinkedPlant(const model::PlantModel& model, const tables::PlantTables& rows)
      : plant(model), tables(rows), use(rows), names(rows) {}
};

/// The map of one controller's link. For a link that goes to the PLC, `client` has the addresses there, in the order of
/// the map's points.
struct LinkView {
  std::shared_ptr<const LinkedPlant> of;
  link::LinkChoice choice;  ///< the URL is empty if neither plant.json nor the command line gives one
  link::IoMap map;
  std::optional<link::client::ClientParts> client;
  std::vector<const link::IoPoint*> points;  ///< by symbol, into `map`; null: on no link

  const std::string& controller() const { return of->plant.controllers[choice.controller]; }
  /// "coil 5", "holding registers 10-11", or the address in the PLC that the link goes to. `point` is one of `map`.
  std::string location(const link::IoPoint& point) const;
  /// Calls `use` with each symbol that the link's controller has, on the link or not. O(symbols).
  template <typename Use>
  void for_each_symbol(Use use) const {
    for (std::uint32_t symbol = 0; symbol < points.size(); ++symbol) {
      if (of->plant.controller_of(of->plant.symbols[symbol]) == choice.controller) use(symbol);
    }
  }
};

/// An error if the URL does not fit the plant. O(symbols + addresses).
std::variant<LinkView, link::LinkError> view_of(std::shared_ptr<const LinkedPlant> of, link::LinkChoice choice);

/// Whether the PLC writes the table.
bool is_written(link::Table table);

/// What the bit or number of an operation does while the link is lost: "holds", "off", or "on" for the bit of an
/// inverted operation that is no longer commanded.
std::string on_loss_text(const tables::PlantTables& tables, const link::IoPoint& point);

}  // namespace symplant::app
