// Any bytes as a symbol list, through all stages to generated code.
#include "fuzz/target.hpp"
#include "support/memory_file_system.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  symplant::test::MemoryFileSystem files;
  files.files["symbols.csv"].assign(reinterpret_cast<const char*>(data), size);
  symplant::fuzz::compile_all("symbols.csv", files);
  return 0;
}
