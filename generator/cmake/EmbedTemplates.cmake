# Writes the templates into a C++ file, so that the tool needs no other files at run time.
# -DNAMES=a|b -DFOLDER=... -DOUTPUT=...
include(${CMAKE_CURRENT_LIST_DIR}/CppLiterals.cmake)
string(REPLACE "|" ";" NAMES "${NAMES}")
set(rows "")
set(count 0)
foreach(name IN LISTS NAMES)
  symplant_cpp_literals(literals ${FOLDER}/${name}.mustache)
  string(APPEND rows "    {\"${name}\", ${literals}},\n")
  math(EXPR count "${count} + 1")
endforeach()
file(
  WRITE ${OUTPUT}
  "// The templates as the tool carries them; made from templates/.\n#include \"emit/render.hpp\"\n\n"
  "namespace symplant::emit {\nnamespace {\n\nconstexpr Template kTemplates[] = {\n${rows}};\n\n}  // namespace\n\n"
  "std::span<const Template> embedded_templates() { return kTemplates; }\n\n}  // namespace symplant::emit\n")
