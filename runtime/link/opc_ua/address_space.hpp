// Makes the nodes of the server: folders, devices, symbols, values, malfunctions and methods of a plant.
#pragma once

#include <open62541/server.h>

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "symplant/link/image/map.hpp"
#include "symplant/link/opc_ua/variables.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::link::opc_ua {

/// What the nodes call. The context of a variable's node is its Variable.
struct NodeCallbacks {
  UA_DataSource variable;
  UA_MethodCallback start_malfunction;
  UA_MethodCallback end_malfunction;
  UA_MethodCallback freeze;
  UA_MethodCallback run;
  UA_MethodCallback step;
};

/// What the nodes show. All of it must outlive the server.
struct PlantNodes {
  const tables::PlantTables& tables;
  const image::Map& map;
  std::span<Variable> variables;  ///< as Variables::all()
  std::uint64_t model_hash;
};

/// Adds the namespace and all nodes of the plant. Bad if the server has no memory left. O(plant).
UA_StatusCode add_plant_nodes(UA_Server* server, const PlantNodes& plant, const NodeCallbacks& callbacks);

/// Calls `visit(variable, node id)` for each variable with the text of its node id in kPlantNamespace. O(plant).
void for_variable_nodes(const PlantNodes& plant, const std::function<void(Variable&, const std::string&)>& visit);

}  // namespace symplant::link::opc_ua
