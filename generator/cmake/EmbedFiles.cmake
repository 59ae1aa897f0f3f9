# Writes the texts of a folder's files into a C++ file, as `std::span<const PageFile> page_files()` of symplant::panel.
# -DFOLDER=... -DFILES=a.js,b.css,name=/path/of/c.js -DOUTPUT=...
include(${CMAKE_CURRENT_LIST_DIR}/CppLiterals.cmake)
string(REPLACE "," ";" files "${FILES}")
set(rows "")
foreach(file ${files})
  set(name ${file})
  set(path ${FOLDER}/${file})
  if(file MATCHES "^([^=]+)=(.+)$")
    set(name ${CMAKE_MATCH_1})
    set(path ${CMAKE_MATCH_2})
  endif()
  symplant_cpp_literals(literals ${path})
  file(SIZE ${path} size)  # counting in a constant expression is limited
  string(APPEND rows "    {\"${name}\", {${literals}, ${size}}},\n")
endforeach()
file(
  WRITE ${OUTPUT}
  "// The files of the page as the program carries them.\n#include \"symplant/panel/web/page_files.hpp\"\n\n"
  "// g++ and clang take literals of any length.\n#pragma GCC diagnostic ignored \"-Woverlength-strings\"\n\nnamespace symplant::panel {\n"
  "namespace {\n\nconstexpr PageFile kFiles[] = {\n${rows}};\n\n}  // namespace\n\n"
  "std::span<const PageFile> page_files() { return kFiles; }\n\n}  // namespace symplant::panel\n")
