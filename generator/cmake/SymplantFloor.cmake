# A floor of the architecture: a static library of one folder that links only the floors below it.

# The folder of a floor with its sources for the system that is built for.
if(WIN32)
  set(SYMPLANT_SYSTEM windows)
else()
  set(SYMPLANT_SYSTEM posix)
endif()

# Warnings, language level and sanitizers, the same for every target of the project.
add_library(symplant_options INTERFACE)
target_compile_features(symplant_options INTERFACE cxx_std_20)
if(NOT MSVC)
  target_compile_options(
    symplant_options
    INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion
              $<$<COMPILE_LANGUAGE:CXX>:-Wnon-virtual-dtor -Wold-style-cast>
              # g++ 12 falsely reports overlaps in std::string's operator+ (GCC bug 105651).
              $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-restrict>
              $<$<BOOL:${SYMPLANT_WERROR}>:-Werror>)
endif()
if(SYMPLANT_SANITIZE)
  target_compile_options(symplant_options INTERFACE -fsanitize=${SYMPLANT_SANITIZE} -fno-sanitize-recover=all
                                                    -fno-omit-frame-pointer)
  target_link_options(symplant_options INTERFACE -fsanitize=${SYMPLANT_SANITIZE})
endif()

set(SYMPLANT_COLD_FLOORS view learn diff watch study map)

# symplant_floor(NAME SOURCES a.cpp ... [FLOORS below ...] [LIBRARIES private ...])
# Makes the target symplant_NAME with the alias symplant::NAME.
function(symplant_floor NAME)
  cmake_parse_arguments(ARG "" "" "SOURCES;FLOORS;LIBRARIES" ${ARGN})
  add_library(symplant_${NAME} STATIC ${ARG_SOURCES})
  add_library(symplant::${NAME} ALIAS symplant_${NAME})
  set_target_properties(symplant_${NAME} PROPERTIES EXPORT_NAME ${NAME} CXX_EXTENSIONS OFF
                                                    POSITION_INDEPENDENT_CODE ON)
  target_compile_features(symplant_${NAME} PUBLIC cxx_std_20)
  list(TRANSFORM ARG_FLOORS PREPEND symplant_)
  if(SYMPLANT_RELEASE)
    symplant_static_libraries(ARG_LIBRARIES)
  endif()
  target_link_libraries(symplant_${NAME} PUBLIC ${ARG_FLOORS} PRIVATE $<BUILD_INTERFACE:symplant_options>
                                                                      ${ARG_LIBRARIES})
  # Under the sanitizers, optimizing takes more than half of the compile time; these layers see no long inputs and run for a short time.
  if(SYMPLANT_SANITIZE AND NAME IN_LIST SYMPLANT_COLD_FLOORS)
    target_compile_options(symplant_${NAME} PRIVATE -O0)
  endif()
  if(SYMPLANT_FUZZ)  # coverage for libFuzzer; main() stays that of the program
    target_compile_options(symplant_${NAME} PRIVATE -fsanitize=fuzzer-no-link)
    target_link_options(symplant_${NAME} INTERFACE $<BUILD_INTERFACE:-fsanitize=fuzzer-no-link>)
  endif()
endfunction()

# symplant_embed_text(TARGET NAMESPACE NAME FILE)
# Gives a floor the function `std::string_view NAMESPACE::NAME()` with the text of a file; callers declare it.
set(SYMPLANT_EMBED_TEXT ${CMAKE_CURRENT_LIST_DIR}/EmbedText.cmake)
function(symplant_embed_text TARGET NAMESPACE NAME FILE)
  get_filename_component(input ${FILE} ABSOLUTE)
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${NAME}.cpp)
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DNAMESPACE=${NAMESPACE} -DNAME=${NAME} -DINPUT=${input} -DOUTPUT=${output} -P
            ${SYMPLANT_EMBED_TEXT}
    DEPENDS ${input} ${SYMPLANT_EMBED_TEXT}
    VERBATIM)
  target_sources(symplant_${TARGET} PRIVATE ${output})
endfunction()
