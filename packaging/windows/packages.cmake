# SPDX-License-Identifier: GPL-3.0-or-later
# For Windows: a zip that runs from any folder and an installer by NSIS, made by `cpack` in build/windows. Both have both programs, each of one file.
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION . RENAME LICENSE.txt COMPONENT application)
install(FILES ${PROJECT_SOURCE_DIR}/CHANGELOG.md DESTINATION . COMPONENT application)
# What the authors of the libraries ask to be passed on; packaging/windows/libraries has collected it.
install(DIRECTORY ${LOOPMEND_WINDOWS_LIBRARIES}/share/licenses DESTINATION . COMPONENT application OPTIONAL)

if(NOT TARGET loopmend-gui)
  return()  # the command line alone is one file
endif()
set(CPACK_GENERATOR ZIP NSIS)
set(CPACK_PACKAGE_NAME Loopmend)
set(CPACK_PACKAGE_VENDOR "The Loopmend contributors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_FILE_NAME loopmend-${PROJECT_VERSION}-windows)
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_CURRENT_LIST_DIR}/package_kinds.cmake)
set(CPACK_PACKAGE_INSTALL_DIRECTORY Loopmend)
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_OUTPUT_FILE_PREFIX ${PROJECT_BINARY_DIR}/packages)
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_COMPONENTS_ALL application command_line)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_ARCHIVE_COMPONENT_INSTALL ON)
set(CPACK_COMPONENT_APPLICATION_DISPLAY_NAME "Window")
set(CPACK_COMPONENT_COMMAND_LINE_DISPLAY_NAME "Command line")

set(CPACK_NSIS_EXECUTABLE_PRE_ARGUMENTS "V2 \"-XTarget amd64-unicode\"")  # as the programs are; a 32-bit one needs more of Wine
set(CPACK_NSIS_DISPLAY_NAME Loopmend)
set(CPACK_NSIS_PACKAGE_NAME Loopmend)
set(CPACK_NSIS_MUI_ICON ${PROJECT_BINARY_DIR}/app/loopmend.ico)
set(CPACK_NSIS_MUI_UNIICON ${PROJECT_BINARY_DIR}/app/loopmend.ico)
set(CPACK_NSIS_INSTALLED_ICON_NAME "bin\\loopmend-gui.exe")
set(CPACK_NSIS_ENABLE_UNINSTALL_BEFORE_INSTALL ON)
set(CPACK_PACKAGE_EXECUTABLES loopmend-gui Loopmend)  # the entry of the Start menu

# File types: a session opens with the window; for meshes it is one of the programs to choose from.
set(classes "Software\\Classes")
set(program "$INSTDIR\\bin\\loopmend-gui.exe")
set(added "")
set(removed "")
foreach(type Session Mesh)
  set(key "${classes}\\Loopmend.${type}")
  string(TOLOWER ${type} what)
  string(APPEND added "
  WriteRegStr SHCTX '${key}' '' 'Loopmend ${what}'
  WriteRegStr SHCTX '${key}\\DefaultIcon' '' '${program},0'
  WriteRegStr SHCTX '${key}\\shell\\open\\command' '' '\"${program}\" \"%1\"'")
  string(APPEND removed "
  DeleteRegKey SHCTX '${key}'")
endforeach()
foreach(ending ply stl obj off gltf glb 3mf)
  string(APPEND added "
  WriteRegStr SHCTX '${classes}\\.${ending}\\OpenWithProgids' 'Loopmend.Mesh' ''")
  string(APPEND removed "
  DeleteRegValue SHCTX '${classes}\\.${ending}\\OpenWithProgids' 'Loopmend.Mesh'
  DeleteRegKey /ifempty SHCTX '${classes}\\.${ending}\\OpenWithProgids'
  DeleteRegKey /ifempty SHCTX '${classes}\\.${ending}'")
endforeach()
set(tell "
  System::Call 'shell32::SHChangeNotify(i 0x08000000, i 0, p 0, p 0)'")  # the file types have changed
set(CPACK_NSIS_EXTRA_INSTALL_COMMANDS "${added}
  WriteRegStr SHCTX '${classes}\\.loopmend' '' 'Loopmend.Session'${tell}")
set(CPACK_NSIS_EXTRA_UNINSTALL_COMMANDS "${removed}
  DeleteRegKey SHCTX '${classes}\\.loopmend'${tell}")
set(CPACK_NSIS_DELETE_ICONS_EXTRA "DeleteRegKey /ifempty SHCTX 'Software\\${CPACK_PACKAGE_VENDOR}'")  # the last commands of the uninstaller
include(CPack)
