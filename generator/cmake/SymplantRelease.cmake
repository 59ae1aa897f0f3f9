# A build to ship, by scripts/release: everything except the C library is linked statically, fmt is compiled in, and no byte depends on
# the folder of the build. scripts/third-party makes the static libraries that Debian does not have.
set(third_party ${PROJECT_SOURCE_DIR}/build/third-party)
if(NOT EXISTS ${third_party}/lib/libzip.a)
  message(FATAL_ERROR "SYMPLANT_RELEASE needs static libraries in ${third_party}: run scripts/third-party first")
endif()
set(CMAKE_FIND_LIBRARY_SUFFIXES .a)
list(PREPEND CMAKE_PREFIX_PATH ${third_party})
add_compile_options(-ffile-prefix-map=${PROJECT_BINARY_DIR}/= -ffile-prefix-map=${PROJECT_SOURCE_DIR}/=)

# symplant_static_libraries(VARIABLE): replaces shared libraries in a list of targets.
function(symplant_static_libraries VARIABLE)
  list(TRANSFORM ${VARIABLE} REPLACE "^fmt::fmt$" "$<BUILD_INTERFACE:fmt::fmt-header-only>")
  list(TRANSFORM ${VARIABLE} REPLACE "^pugixml::pugixml$" "pugixml::static")
  if("PkgConfig::LIBZIP" IN_LIST ${VARIABLE})
    find_package(ZLIB REQUIRED)
    list(APPEND ${VARIABLE} ZLIB::ZLIB)  # behind libzip, which needs it
  endif()
  set(${VARIABLE} "${${VARIABLE}}" PARENT_SCOPE)
endfunction()
