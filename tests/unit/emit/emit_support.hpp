// Shared parts of the tests of code generation.
#pragma once

#include <string>
#include <vector>

#include "emit/emit.hpp"
#include "support/catch.hpp"
#include "support/compile.hpp"
#include "support/golden.hpp"
#include "support/strings.hpp"

namespace symplant::test {

inline const std::string kSource = SYMPLANT_SOURCE_DIR;

/// The result of code generation, its files as texts.
struct Emitted {
  struct File {
    std::string name;
    std::string content;
  };
  std::vector<File> files;
  std::vector<emit::OwnFile> own_files;
  std::vector<std::string> inputs;
  std::vector<std::string> errors;
};

inline Emitted emitted(const model::PlantModel& plant, const lower::EngineTables& tables,
                       const emit::EmitOptions& options = {}) {
  const base::DiskFileSystem files;
  const emit::EmitResult result = emit::emit(plant, tables, options, files);
  Emitted made{{}, result.own_files, result.inputs, result.errors};
  for (const emit::EmittedFile& file : result.files) made.files.push_back({file.name, base::text_of(file.content)});
  return made;
}

inline Emitted emit_list(const std::string& list, const std::string& name) {
  const CompiledText text = compile_text(list, name);
  REQUIRE(text.compiled);
  return emitted(text.plant(), text.tables());
}

inline std::string file_of(const Emitted& result, const std::string& name) {
  for (const Emitted::File& file : result.files) {
    if (file.name == name) return file.content;
  }
  FAIL("no file " << name);
  return {};
}

}  // namespace symplant::test
