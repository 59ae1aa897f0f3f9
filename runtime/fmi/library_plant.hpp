// The plant of an FMU's library: linked in, or read from the file that the FMU carries.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "symplant/engine/behaviour.hpp"
#include "symplant/fmi/tables_file.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::fmi {

/// A plant that is compiled into the library, with the user's C++.
struct CompiledPlant {
  const tables::PlantTables& tables;
  std::span<const engine::Behaviour> behaviours;
};

/// Defined by the library: null if it is for any plant.
const CompiledPlant* compiled_plant();

/// The plant of one instance.
class LibraryPlant {
 public:
  /// `resources` as the importer gives it: the URI of a folder. The error says what is wrong.
  static std::variant<LibraryPlant, std::string> load(std::string_view resources);

  const tables::PlantTables& tables() const noexcept { return loaded_ ? loaded_->tables() : compiled_->tables; }
  std::span<const engine::Behaviour> behaviours() const noexcept {
    return loaded_ ? std::span<const engine::Behaviour>() : compiled_->behaviours;
  }

 private:
  std::unique_ptr<const LoadedTables> loaded_;
  const CompiledPlant* compiled_ = nullptr;
};

/// The path of a `file:` URI, in UTF-8; a text that is not such a URI is a path. `windows`: with drives.
std::string path_of_uri(std::string_view uri, bool windows);

}  // namespace symplant::fmi
