# Writes the templates into a C++ file, so that the tool needs no files beside it.
# -DNAMES=a|b -DFOLDER=... -DOUTPUT=...
string(REPLACE "|" ";" NAMES "${NAMES}")
set(rows "")
set(count 0)
foreach(name IN LISTS NAMES)
  file(READ ${FOLDER}/${name}.mustache text)
  # Several literals: compilers bound the length of one.
  string(LENGTH "${text}" length)
  set(literals "")
  set(at 0)
  while(at LESS length)
    string(SUBSTRING "${text}" ${at} 4000 part)
    string(APPEND literals "R\"symplant(${part})symplant\"\n")
    math(EXPR at "${at} + 4000")
  endwhile()
  string(APPEND rows "    {\"${name}\", ${literals}},\n")
  math(EXPR count "${count} + 1")
endforeach()
file(
  WRITE ${OUTPUT}
  "// The templates as the tool carries them; made from templates/.\n#include \"emit/render.hpp\"\n\n"
  "namespace symplant::emit {\nnamespace {\n\nconstexpr Template kTemplates[] = {\n${rows}};\n\n}  // namespace\n\n"
  "std::span<const Template> embedded_templates() { return kTemplates; }\n\n}  // namespace symplant::emit\n")
