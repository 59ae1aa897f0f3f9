// A symbol list with its names parsed, as the derivation takes it.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "address/address.hpp"
#include "name/named_table.hpp"
#include "read/symbol_table.hpp"

namespace symplant::model {

struct ListInput {
  std::shared_ptr<const read::SymbolTable> table;
  name::NamedTable named;              ///< of `*table`
  std::string controller{};            ///< the controller that it belongs to; empty: the default one
  std::optional<address::Radix> xy{};  ///< without a value: what the rows prove, else hexadecimal
  std::string prefix{};                ///< put before the names of its symbols and the lines of its devices
};

}  // namespace symplant::model
