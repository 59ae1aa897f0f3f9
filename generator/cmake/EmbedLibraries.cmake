# Writes shared libraries into a C++ file, as `std::span<const Library> libraries()` of symplant::fmu.
# -DLIBRARIES=linux64=/path/to/a.so,win64=/path/to/b.dll -DOUTPUT=...
string(REPLACE "," ";" libraries "${LIBRARIES}")
set(rows "")
foreach(library ${libraries})
  string(REGEX MATCH "^([^=]+)=(.+)$" parts "${library}")
  set(platform ${CMAKE_MATCH_1})
  set(path ${CMAKE_MATCH_2})
  get_filename_component(extension ${path} LAST_EXT)
  file(SIZE ${path} size)
  file(READ ${path} bytes HEX)
  string(REPEAT "." 128 line)
  string(REGEX REPLACE "(${line})" "\\1\"\n     \"" bytes "${bytes}")
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "\\\\x\\1" bytes "${bytes}")
  string(APPEND rows "    {\"${platform}\", \"${extension}\",\n     {\"${bytes}\", ${size}}},\n")
endforeach()
file(
  WRITE ${OUTPUT}
  "// The libraries of FMUs as the tool carries them.\n#include \"fmu/library.hpp\"\n\n"
  "// g++ and clang take literals of any length.\n#pragma GCC diagnostic ignored \"-Woverlength-strings\"\n\nnamespace symplant::fmu {\n"
  "namespace {\n\nconstexpr Library kLibraries[] = {\n${rows}};\n\n}  // namespace\n\n"
  "std::span<const Library> libraries() { return kLibraries; }\n\n}  // namespace symplant::fmu\n")
