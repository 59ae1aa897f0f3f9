// An FMU: its container.
#include "fmu/package.hpp"

#include <fmt/format.h>

#include <utility>

#include "convert/zip_package.hpp"
#include "fmu/model_description.hpp"
#include "symplant/fmi/tables_file.hpp"
#include "symplant/fmi/variables.hpp"

namespace symplant::fmu {
namespace {

convert::PackagePart part(std::string name, std::string bytes) {
  return {std::move(name),
          [bytes = std::move(bytes)](std::size_t number) { return number == 0 ? bytes : std::string(); }};
}

}  // namespace

base::Result<std::string, PackageError> package(const model::PlantModel& plant, const tables::PlantTables& tables,
                                                const std::string& identifier, std::span<const Library> libraries) {
  const fmi::Variables variables(tables);
  if (!variables.repeated_name().empty()) {
    return PackageError{
        fmt::format("two variables of the FMU would have the name `{}`: rename one of the symbols, devices, "
                    "values or malfunctions",
                    variables.repeated_name())};
  }
  std::vector<convert::PackagePart> parts;
  parts.push_back(part("modelDescription.xml", model_description(plant, tables, variables, identifier)));
  for (const Library& library : libraries) {
    parts.push_back(part(fmt::format("binaries/{}/{}{}", library.platform, identifier, library.extension),
                         std::string(library.bytes)));
  }
  parts.push_back(part(fmt::format("resources/{}", fmi::kTablesName), fmi::write_tables(tables)));
  auto packed = convert::zip_package(parts);
  if (!packed) return PackageError{packed.error().message};
  return std::move(*packed);
}

}  // namespace symplant::fmu
