// The load *rich*, built by the tool from a list and a plant.json instead of by hand.
#pragma once

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/pipeline.hpp"
#include "bench/two_state_plant.hpp"
#include "support/memory_file_system.hpp"
#include "symplant/plant/owned_plant.hpp"

namespace symplant::bench {

/// The devices, conditions, times and disables of RichPlant. Throws if the files are rejected.
struct RichFiles {
  static constexpr std::uint64_t kInverted = 0;  ///< no symbol is inverted
  static constexpr std::uint32_t kStride = TwoStatePlant::kStride;
  static constexpr std::uint64_t kStateEvents = TwoStatePlant::kStateEvents;

  RichFiles(std::uint32_t devices, const std::vector<tables::Time>& travel_times) {
    test::MemoryFileSystem files;
    std::string& list = files.files["list.csv"];
    std::string& plant_json = files.files["plant.json"];
    list = "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial\n";
    plant_json = R"({"symplant": 1, "symbols": ["list.csv"], "devices": {)";
    for (std::uint32_t d = 0; d < devices; ++d) {
      const std::uint32_t bit = 2 * d;
      list += fmt::format(
          "VAR_GLOBAL,L_P_D{0}_O_A1,,%QX{1},BOOL,FALSE\nVAR_GLOBAL,L_P_D{0}_O_B2,,%QX{2},BOOL,FALSE\n"
          "VAR_GLOBAL,L_P_D{0}_I_A1,,%IX{1},BOOL,FALSE\nVAR_GLOBAL,L_P_D{0}_I_B2,,%IX{2},BOOL,FALSE\n",
          d, bit, bit + 1);
      const std::string when =
          fmt::format("not L_P_D{}.A1 or L_P_D{}.A1", (d + devices - RichPlant::kFar % devices) % devices,
                      (d + devices - RichPlant::kFarther % devices) % devices);
      const std::string rest = fmt::format(R"("when": "{}", "after": "{}ns", "takes": "{}ns")", when, RichPlant::kAfter,
                                           travel_times.front());
      plant_json += fmt::format(
          R"({}"L_P_D{}": {{"transitions": [{{"from": "A1", "to": "B2", {}}}, {{"from": "B2", "to": "A1", {}}}]{}}})",
          d == 0 ? "" : ", ", d, rest, rest,
          d % 8 == 0 && d + 1 < devices ? fmt::format(R"(, "disables": {{"B2": ["L_P_D{}"]}})", d + 1) : "");
    }
    plant_json += "}}";
    diag::Diagnostics diagnostics;
    std::ostringstream err;
    app::Progress progress(err, false);
    compiled = app::compile({"plant.json", {}, {}}, files, progress, diagnostics);
    if (!compiled) throw std::runtime_error(diagnostics.all()[0].message);
    tables = compiled->tables.tables();
    plant = std::make_unique<plant::OwnedPlant>(tables);
  }

  std::optional<app::Compiled> compiled;
  tables::PlantTables tables{};
  std::unique_ptr<plant::OwnedPlant> plant;
};

}  // namespace symplant::bench
