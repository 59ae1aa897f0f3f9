# SYMPLANT_THREE: the folder with the sources of three.js, as Debian's and Ubuntu's package libjs-three has them (version 111).
find_path(SYMPLANT_THREE examples/jsm/loaders/GLTFLoader.js PATHS /usr/share/javascript/three NO_CMAKE_FIND_ROOT_PATH
          DOC "The folder of three.js: three.module.js, examples/jsm")
set(three_advice "install the package libjs-three, or set SYMPLANT_THREE to a folder with version 111 of three.js")
foreach(file three.module.js examples/jsm/loaders/GLTFLoader.js examples/jsm/controls/OrbitControls.js)
  if(NOT EXISTS ${SYMPLANT_THREE}/${file})
    message(FATAL_ERROR "${SYMPLANT_THREE}/${file} is not found: ${three_advice}")
  endif()
endforeach()
# Other versions have other interfaces: the page would be built, and its 3D view would not work.
file(STRINGS ${SYMPLANT_THREE}/three.module.js three_revision REGEX "REVISION = '[^']*'" LIMIT_COUNT 1)
if(NOT three_revision MATCHES "REVISION = '111'")
  message(FATAL_ERROR "${SYMPLANT_THREE}/three.module.js is not version 111 of three.js (${three_revision}): ${three_advice}")
endif()
