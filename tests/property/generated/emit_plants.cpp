// Draws random plants and writes their generated code, a folder each, and a table of them: emit_plants FOLDER
// COUNT.
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "base/file_system.hpp"
#include "draw_generated.hpp"
#include "emit/emit.hpp"
#include "lower/lower.hpp"

namespace symplant::property {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& content) { std::ofstream(path, std::ios::binary) << content; }

bool emit_plant(const fs::path& folder, std::uint64_t seed) {
  const DrawnPlant drawn = draw_generated(seed);
  const lower::EngineTables tables = lower::lower(drawn.model);
  const base::DiskFileSystem files;
  const emit::EmitResult result = emit::emit(drawn.model, tables, {}, files);
  for (const std::string& error : result.errors) std::cerr << drawn.text.name << ": " << error << "\n";
  if (!result.errors.empty()) return false;
  const fs::path own = folder / drawn.text.name;
  fs::create_directories(own);
  for (const emit::EmittedFile& file : result.files) write(own / file.name, base::text_of(file.content));
  write(own / (drawn.text.name + ".csv"), list_text(drawn.text));
  return true;
}

std::string table_of_all(std::uint64_t count) {
  std::string text = "// Every generated plant.\n#include \"generated_plants.hpp\"\n\n";
  std::string rows;
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    const std::string name = "drawn_" + std::to_string(seed);
    text += "namespace " + name + " {\nconst symplant::tables::PlantTables& tables() noexcept;\n}\n";
    rows += "      {" + std::to_string(seed) + ", ::" + name + "::tables()},\n";
  }
  return text + "\nnamespace symplant::property {\n\nstd::vector<GeneratedPlant> generated_plants() {\n  return {\n" +
         rows + "  };\n}\n\n}  // namespace symplant::property\n";
}

}  // namespace
}  // namespace symplant::property

int main(int argc, char** argv) {
  using namespace symplant::property;
  if (argc != 3) return 2;
  const fs::path folder = argv[1];
  const std::uint64_t count = std::strtoull(argv[2], nullptr, 10);
  fs::create_directories(folder);
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    if (!emit_plant(folder, seed)) return 1;
  }
  write(folder / "generated_plants.cpp", table_of_all(count));
  return 0;
}
