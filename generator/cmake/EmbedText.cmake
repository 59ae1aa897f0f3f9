# Writes a text into a C++ file, so that the program needs no other file at run time.
# -DNAMESPACE=a::b -DNAME=x -DINPUT=... -DOUTPUT=...
include(${CMAKE_CURRENT_LIST_DIR}/CppLiterals.cmake)
symplant_cpp_literals(literals ${INPUT})
get_filename_component(file ${INPUT} NAME)
file(
  WRITE ${OUTPUT}
  "// ${file} as the program carries it.\n#include <string_view>\n\nnamespace ${NAMESPACE} {\n\n"
  "std::string_view ${NAME}();\nstd::string_view ${NAME}() {\n  return ${literals};\n}\n\n}  // namespace ${NAMESPACE}\n")
