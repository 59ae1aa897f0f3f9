# SYMPLANT_THREE: the folder with the sources of three.js, as Debian's and Ubuntu's package libjs-three has them (version 111).
find_path(SYMPLANT_THREE examples/jsm/loaders/GLTFLoader.js PATHS /usr/share/javascript/three NO_CMAKE_FIND_ROOT_PATH
          DOC "The folder of three.js: three.module.js, examples/jsm")
if(NOT EXISTS ${SYMPLANT_THREE}/three.module.js)
  message(FATAL_ERROR "three.js is not found: install the package libjs-three, or set SYMPLANT_THREE to a folder with its version 111 "
                      "(three.module.js, examples/jsm/loaders/GLTFLoader.js, examples/jsm/controls/OrbitControls.js)")
endif()
