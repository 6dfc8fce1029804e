# SPDX-License-Identifier: GPL-3.0-or-later
# For CMake: GCC of Debian's g++-mingw-w64-x86-64-posix, with the libraries that ./libraries has made.
set(LOOPMEND_WINDOWS_LIBRARIES ${CMAKE_CURRENT_LIST_DIR}/../../build/windows-libraries/installed)
if(DEFINED ENV{LOOPMEND_WINDOWS_LIBRARIES})
  set(LOOPMEND_WINDOWS_LIBRARIES $ENV{LOOPMEND_WINDOWS_LIBRARIES})
endif()
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_Fortran_COMPILER x86_64-w64-mingw32-gfortran-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)
set(CMAKE_FIND_ROOT_PATH ${LOOPMEND_WINDOWS_LIBRARIES} /usr/x86_64-w64-mingw32)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(CMAKE_CROSSCOMPILING_EMULATOR wine)
# MinGW sets the x87 unit, with which its exp and pow compute, to 64 bits in the first thread alone; Windows gives further threads 53. CRT_fp8.o keeps
# 53 in all of them: results do not depend on the thread.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static -L${LOOPMEND_WINDOWS_LIBRARIES}/lib /usr/x86_64-w64-mingw32/lib/CRT_fp8.o")
