// Tables of a plant that a test describes as in plant.json, and the indexes of their names.
#pragma once

#include <cstdint>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "support/catch.hpp"
#include "support/compile.hpp"
#include "symplant/tables/names.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::test {

/// `members` are those of plant.json after `symbols`: `"devices": {...}`.
class DescribedPlant {
 public:
  DescribedPlant(const std::vector<Row>& list, const std::string& members) {
    MemoryFileSystem files;
    files.files["symbols.csv"] = list_text(list);
    files.files["plant.json"] = R"({"symplant": 1, "symbols": ["symbols.csv"], )" + members + "}";
    std::ostringstream err;
    app::Progress progress(err, false);
    diag::Diagnostics diagnostics;
    compiled_ = app::compile({"plant.json", {}, {}}, files, progress, diagnostics);
    REQUIRE(compiled_);
    for (const diag::Diagnostic& found : diagnostics.all()) UNSCOPED_INFO(found.message);
    REQUIRE(!check::has_stopping_errors(diagnostics));
    rows = compiled_->tables.tables();
  }
  DescribedPlant(const DescribedPlant&) = delete;
  DescribedPlant& operator=(const DescribedPlant&) = delete;

  std::uint32_t unit(std::string_view name) const { return index_in(rows.unit_names, name, 1); }
  std::uint32_t symbol(std::string_view name) const { return index_in(rows.symbol_names, name, 2); }
  std::uint32_t location(std::string_view name) const { return index_in(rows.material.location_names, name, 1); }
  std::uint8_t state(std::string_view unit_name, std::string_view state) const {
    std::uint32_t first = 0;
    for (std::uint32_t type = 0; type < rows.units[unit(unit_name)].type; ++type) first += rows.types[type].states;
    const auto names = tables::split_names(rows.state_names);
    for (std::uint32_t s = first; s < names.size(); ++s) {
      if (names[s] == state) return static_cast<std::uint8_t>(s - first);
    }
    FAIL("no state " << state);
    return 0;
  }

  const app::Compiled& compiled() const { return *compiled_; }

  tables::PlantTables rows{};

 private:
  static std::uint32_t index_in(std::string_view blob, std::string_view name, std::uint32_t each) {
    const auto names = tables::split_names(blob);
    for (std::uint32_t i = 0; i < names.size(); i += each) {
      if (names[i] == name) return i / each;
    }
    FAIL("no name " << name);
    return 0;
  }

  std::optional<app::Compiled> compiled_;
};

}  // namespace symplant::test
