# Open62541_FOUND, Open62541_VERSION and the target open62541::open62541: a library with encryption and diagnostics.
# CMake files of open62541 are not used: those of Debian's package libopen62541-1.4-dev stop every project that has not
# installed its tools, too.
find_path(Open62541_INCLUDE_DIR open62541/config.h)
find_library(Open62541_LIBRARY open62541)
mark_as_advanced(Open62541_INCLUDE_DIR Open62541_LIBRARY)

if(Open62541_INCLUDE_DIR)
  file(STRINGS ${Open62541_INCLUDE_DIR}/open62541/config.h version_lines
       REGEX "define UA_OPEN62541_VER_(MAJOR|MINOR|PATCH) [0-9]+")
  string(REGEX MATCHALL " [0-9]+" Open62541_VERSION "${version_lines}")
  string(REGEX REPLACE "; |^ " "." Open62541_VERSION "${Open62541_VERSION}")
  string(SUBSTRING "${Open62541_VERSION}" 1 -1 Open62541_VERSION)
  file(STRINGS ${Open62541_INCLUDE_DIR}/open62541/config.h Open62541_ENCRYPTION
       REGEX "^#define UA_ENABLE_ENCRYPTION_(MBEDTLS|OPENSSL|LIBRESSL)")
  file(STRINGS ${Open62541_INCLUDE_DIR}/open62541/config.h Open62541_DIAGNOSTICS REGEX "^#define UA_ENABLE_DIAGNOSTICS")
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(
  Open62541
  REQUIRED_VARS Open62541_LIBRARY Open62541_INCLUDE_DIR Open62541_ENCRYPTION Open62541_DIAGNOSTICS
  VERSION_VAR Open62541_VERSION
  HANDLE_VERSION_RANGE)

if(Open62541_FOUND AND NOT TARGET open62541::open62541)
  add_library(open62541::open62541 UNKNOWN IMPORTED)
  set_target_properties(open62541::open62541 PROPERTIES IMPORTED_LOCATION ${Open62541_LIBRARY}
                                                        INTERFACE_INCLUDE_DIRECTORIES ${Open62541_INCLUDE_DIR})
endif()
