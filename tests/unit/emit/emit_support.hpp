// What the tests of emission share.
#pragma once

#include <string>

#include "emit/emit.hpp"
#include "support/catch.hpp"
#include "support/compile.hpp"
#include "support/golden.hpp"
#include "support/strings.hpp"

namespace symplant::test {

inline const std::string kSource = SYMPLANT_SOURCE_DIR;

inline emit::EmitResult emit_list(const std::string& list, const std::string& name) {
  const CompiledText text = compile_text(list, name);
  REQUIRE(text.compiled);
  const MemoryFileSystem files;
  return emit::emit(text.plant(), text.tables(), {}, files);
}

inline std::string file_of(const emit::EmitResult& result, const std::string& name) {
  for (const emit::EmittedFile& file : result.files) {
    if (file.name == name) return file.content;
  }
  FAIL("no file " << name);
  return {};
}

}  // namespace symplant::test
