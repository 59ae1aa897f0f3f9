# Replaces the first occurrence of a text in a file; fails if the text is not found.
# -DINPUT=... -DOUTPUT=... -DFROM=... -DTO=...
file(READ ${INPUT} text)
string(FIND "${text}" "${FROM}" at)
if(at EQUAL -1)
  message(FATAL_ERROR "`${FROM}` is not in ${INPUT}")
endif()
string(LENGTH "${FROM}" length)
math(EXPR behind "${at} + ${length}")
string(SUBSTRING "${text}" 0 ${at} before)
string(SUBSTRING "${text}" ${behind} -1 after)
file(WRITE ${OUTPUT} "${before}${TO}${after}")
