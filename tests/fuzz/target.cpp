// Shared parts of the fuzz targets.
#include "fuzz/target.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>
#include <vector>

#include "app/pipeline.hpp"
#include "diag/json.hpp"
#include "diag/text.hpp"
#include "emit/emit.hpp"
#include "support/memory_file_system.hpp"
#include "symplant/tables/digest.hpp"
#include "text/utf8.hpp"

namespace symplant::fuzz {
namespace {

/// One of this many different plants is emitted: code generation takes ten times as long as all other stages.
constexpr std::uint64_t kOneEmittedIn = 16;
/// Plants with more symbols are not emitted: it takes long and covers the same code.
constexpr std::size_t kMostEmitted = 300;

void look_at_index(const diag::Location& index) {
  require(index.pointer.empty() || index.source != nullptr, "a place in the description was not located");
  if (index.source == nullptr) return;
  const std::string_view text = index.source->text();
  require(index.span.begin <= index.span.end && index.span.end <= text.size(), "a place lies outside its file");
  require(is_utf8(text), "a file's text is no UTF-8");
}

void look_at_findings(const diag::Diagnostics& diagnostics) {
  for (const diag::Diagnostic& finding : diagnostics.all()) {
    require(is_utf8(finding.message), "a message is no UTF-8");
    look_at_index(finding.location);
    for (const diag::Related& related : finding.related) look_at_index(related.location);
  }
  const std::string json = diag::render_json(diagnostics.all());
  require(nlohmann::json::accept(json), "the findings as JSON are no JSON");
  const std::string text = diag::render_text(diagnostics.all());
  const auto unsafe = [](char c) { return static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t'; };
  require(std::none_of(text.begin(), text.end(), unsafe), "a control character reaches the terminal");
}

std::vector<std::string> emit_ascii(const app::Compiled& compiled) {
  const test::MemoryFileSystem no_templates;
  const emit::EmitResult result = emit::emit(compiled.plant, compiled.tables, {}, no_templates);
  require(result.errors.empty(), "a template of the tool's own has a fault");
  std::vector<std::string> texts;
  for (const emit::EmittedFile& file : result.files) {
    const auto strange = [](char c) { return (c < 0x20 || c > 0x7E) && c != '\n'; };
    const std::string& text = texts.emplace_back(base::text_of(file.content));
    require(std::none_of(text.begin(), text.end(), strange), "generated code is not printable ASCII");
  }
  return texts;
}

}  // namespace

void require(bool holds, std::string_view what) {
  if (holds) return;
  std::fprintf(stderr, "oracle: %.*s\n", static_cast<int>(what.size()), what.data());
  std::abort();
}

bool is_utf8(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const text::CodePoint point = text::code_point_at(text, at);
    if (!point.valid) return false;
    at += point.length;
  }
  return true;
}

std::string_view fixed_list() {
  return "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial\n"
         "VAR_GLOBAL,EXLINE_MB_AGV_O_P1,Y0001,%QX0001,BOOL,FALSE\n"
         "VAR_GLOBAL,EXLINE_MB_AGV_I_P1,X0002,%IX0002,BOOL,TRUE\n"
         "VAR_GLOBAL,EXLINE_MB_AGV_O_P2,Y0003,%QX0003,BOOL,FALSE\n"
         "VAR_GLOBAL,EXLINE_MB_AGV_I_P2,X0004,%IX0004,BOOL,FALSE\n"
         "VAR_GLOBAL,EXLINE_MB_MC_O_IDLE1,Y0005,%QX0005,BOOL,FALSE\n"
         "VAR_GLOBAL,EXLINE_MB_MC_I_IDLE1,X0006,%IX0006,BOOL,FALSE\n"
         "VAR_GLOBAL,EXLINE_MB_MC_O_RUN2,Y0007,%QX0007,BOOL,FALSE\n"
         "VAR_GLOBAL,EXLINE_MB_MC_I_RUN2,X0008,%IX0008,BOOL,FALSE\n"
         "VAR_GLOBAL,L_P_CYL_O_ADV,Y0010,%QX0016,BOOL,FALSE\n"
         "VAR_GLOBAL,L_P_CYL_I_ADV,X0011,%IX0017,BOOL,FALSE\n"
         "VAR_GLOBAL,L_P_CYL_I_RET,X0012,%IX0018,BOOL,TRUE\n"
         "VAR_GLOBAL,L_P_LAMP_O_ON,Y0013,%QX0019,BOOL,FALSE\n"
         "VAR_GLOBAL,L_P_BUTTON_I_PRESSED,X0014,%IX0020,BOOL,FALSE\n"
         "VAR_GLOBAL,L_P_AND_I_OR,X0015,%IX0021,BOOL,FALSE\n"
         "VAR_GLOBAL,L_P_\xEA\xB3\xB5_I_\xC3\x84,X0016,%IX0022,BOOL,FALSE\n"
         "VAR_GLOBAL,not,X0017,%IX0023,BOOL,FALSE\n"
         "VAR_GLOBAL,don't',X0018,%IX0024,BOOL,FALSE\n"
         "VAR_GLOBAL,LEVEL,,%IW10,INT,0\n"
         "VAR_GLOBAL,L_P_DRIVE_O_SPEED,,%QD12,REAL,0\n"
         "VAR_GLOBAL,BIG,,%IL20,ULINT,0\n"
         "VAR_GLOBAL,LONG,,%IL24,LINT,0\n";
}

void compile_all(const std::string& plant, const base::FileSystem& files) {
  std::ostringstream err;
  app::Progress progress(err, false);
  diag::Diagnostics diagnostics;
  const auto compiled = app::compile({plant, {}, {}, "2026-01-01"}, files, progress, diagnostics);
  require(compiled.has_value() || diagnostics.has_errors(), "nothing was compiled, and no error says why");
  look_at_findings(diagnostics);
  if (!compiled || diagnostics.has_errors() || compiled->plant.symbols.size() > kMostEmitted) return;
  const std::uint64_t hash = tables::model_hash(compiled->tables.tables());
  if (hash % kOneEmittedIn == 0) require(emit_ascii(*compiled) == emit_ascii(*compiled), "generating twice differs");
}

const model::PlantModel& fixed_plant() {
  static const model::PlantModel plant = [] {
    test::MemoryFileSystem files;
    files.files["symbols.csv"] = fixed_list();
    std::ostringstream err;
    app::Progress progress(err, false);
    diag::Diagnostics diagnostics;
    auto made = app::compile({"symbols.csv", {}, {}}, files, progress, diagnostics);
    require(made.has_value(), "the fixed list is not understood");
    return std::move(made->plant);
  }();
  return plant;
}

}  // namespace symplant::fuzz
