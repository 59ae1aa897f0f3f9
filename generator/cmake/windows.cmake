# Toolchain: builds programs for Windows on Linux by mingw-w64. `scripts/windows` makes the libraries that it finds.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix) # with std::thread
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)

get_filename_component(project "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)
set(libraries ${project}/build/windows-libraries/prefix)

# No DLL next to the program, and no byte that depends on the folder or the time of the build.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static -Wl,--no-insert-timestamp")
set(CMAKE_MODULE_LINKER_FLAGS_INIT "-static -s -Wl,--no-insert-timestamp")
set(CMAKE_SHARED_LINKER_FLAGS_INIT "-static")
set(CMAKE_CXX_FLAGS_INIT "\"-ffile-prefix-map=${project}/=\" -D_WIN32_WINNT=0x0A00 -DNOMINMAX -DWIN32_LEAN_AND_MEAN -DZIP_STATIC -DUTF8PROC_STATIC -Wa,-mbig-obj")
set(CMAKE_C_FLAGS_INIT "\"-ffile-prefix-map=${project}/=\" -D_WIN32_WINNT=0x0A00")

set(CMAKE_FIND_ROOT_PATH ${libraries} /usr/x86_64-w64-mingw32)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(PKG_CONFIG_ARGN --static)
set(ENV{PKG_CONFIG_LIBDIR} ${libraries}/lib/pkgconfig)
set(ENV{PKG_CONFIG_SYSROOT_DIR} "")

find_program(SYMPLANT_WINE NAMES wine64 wine PATHS /usr/lib/wine)
if(SYMPLANT_WINE)
  set(CMAKE_CROSSCOMPILING_EMULATOR ${SYMPLANT_WINE}) # for the tests
endif()
