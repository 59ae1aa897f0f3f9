# Writes a text into a C++ file, so that the program needs no other file at run time.
# -DNAMESPACE=a::b -DNAME=x -DINPUT=... -DOUTPUT=...
include(${CMAKE_CURRENT_LIST_DIR}/CppLiterals.cmake)
symplant_cpp_literals(literals ${INPUT})
get_filename_component(file ${INPUT} NAME)
file(SIZE ${INPUT} size)
set(includes "#include <string_view>\n")
set(body "  return ${literals};\n")
if(size GREATER 60000) # literals side by side are one, and compilers need not support more than 65,536 characters
  string(REPLACE ")symplant\"\nR\"symplant(" ")symplant\")\n          .append(R\"symplant(" parts "${literals}")
  set(includes "#include <string>\n#include <string_view>\n")
  set(body "  static const std::string text = std::string()\n          .append(${parts});\n  return text;\n")
endif()
file(WRITE ${OUTPUT} "// ${file} as the program carries it.\n${includes}\nnamespace ${NAMESPACE} {\n\n"
                     "std::string_view ${NAME}();\nstd::string_view ${NAME}() {\n${body}}\n\n}  // namespace ${NAMESPACE}\n")
