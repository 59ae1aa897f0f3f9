// One link of a plant with everything that the formats of `symplant map` show.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "model/plant_model.hpp"
#include "symplant/link/image/numbers.hpp"
#include "symplant/link/link.hpp"
#include "symplant/link/link_map.hpp"
#include "symplant/link/modbus/io_map.hpp"
#include "symplant/tables/tables.hpp"
#include "symplant/trace/plant_names.hpp"
#include "symplant/why/symbol_use.hpp"

namespace symplant::map {

/// A plant as its links see it. Refers to the model and the tables.
struct LinkedPlant {
  const model::PlantModel& plant;
  const tables::PlantTables& tables;
  const why::SymbolUse use;
  const trace::PlantNames names;

  LinkedPlant(const model::PlantModel& model, const tables::PlantTables& rows)
      : plant(model), tables(rows), use(rows), names(rows) {}
};

/// The map of one controller's link.
struct LinkView {
  std::shared_ptr<const LinkedPlant> of;
  link::LinkChoice choice;  ///< the URL is empty if neither plant.json nor the command line gives one
  link::LinkMap map;
  std::vector<const link::MappedSymbol*> mapped;     ///< by symbol, into `map`; null: on no link
  std::vector<const link::modbus::IoPoint*> points;  ///< by symbol, into `served()`; null: not served; empty: no server

  const std::string& controller() const { return of->plant.controllers[choice.controller]; }
  /// Whether it is a server, whose clients poll served().
  bool is_server() const { return map.served != nullptr; }
  const link::modbus::IoMap& served() const { return *map.served; }
  /// The location of a symbol on the link, as the protocol has it, or the address in the PLC that the link goes to.
  const std::string& location(std::uint32_t symbol) const { return mapped[symbol]->location; }
  bool is_operation(std::uint32_t symbol) const {
    return of->tables.symbols[symbol].direction() == tables::Direction::operation;
  }
  /// Words of 16 bits that a symbol takes.
  std::uint32_t words(std::uint32_t symbol) const { return link::image::words_of(of->tables.symbols[symbol].type()); }
  /// Calls `use` with each symbol that the link's controller has, on the link or not. O(symbols).
  template <typename Use>
  void for_each_symbol(Use use) const {
    for (std::uint32_t symbol = 0; symbol < mapped.size(); ++symbol) {
      if (of->plant.controller_of(of->plant.symbols[symbol]) == choice.controller) use(symbol);
    }
  }
};

/// The links whose maps to show: those of `links`, which are [CONTROLLER=]URL, or, if there are none, one for each
/// controller, as in plant.json. An error if a URL is invalid, has no map or does not fit the plant. O(symbols log
/// symbols).
std::variant<std::vector<LinkView>, link::LinkError> views_of(const std::shared_ptr<const LinkedPlant>& of,
                                                              const std::vector<std::string>& links);

/// What the bit or number of an operation does while the link is lost: "holds", "off", or "on" for the bit of an
/// inverted operation that is no longer commanded.
std::string on_loss_text(const tables::PlantTables& tables, const link::MappedSymbol& mapped);

}  // namespace symplant::map
