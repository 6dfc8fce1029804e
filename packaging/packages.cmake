# SPDX-License-Identifier: GPL-3.0-or-later
# What is installed beside the programs, and the Debian packages made of it: `cpack` in the build folder, or
# `packaging/bootstrap release`, which also checks them. One package for each install component.
if(WIN32)
  include(${CMAKE_CURRENT_LIST_DIR}/windows/packages.cmake)
  return()
endif()

# The date of the version: of the last commit, of the source archive's files without git, or SOURCE_DATE_EPOCH.
if(DEFINED ENV{SOURCE_DATE_EPOCH})
  set(release_epoch $ENV{SOURCE_DATE_EPOCH})
else()
  execute_process(COMMAND git -C ${PROJECT_SOURCE_DIR} log -1 --format=%ct OUTPUT_VARIABLE release_epoch
                  OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(NOT release_epoch)
    file(TIMESTAMP ${PROJECT_SOURCE_DIR}/CHANGELOG.md release_epoch "%s" UTC)
  endif()
endif()
set(ENV{SOURCE_DATE_EPOCH} ${release_epoch})  # string(TIMESTAMP) follows it
string(TIMESTAMP LOOPMEND_RELEASE_DATE "%Y-%m-%d" UTC)
string(TIMESTAMP LOOPMEND_RELEASE_TIME "%a, %d %b %Y %H:%M:%S +0000" UTC)

set(LOOPMEND_HOME_PAGE "" CACHE STRING "Address at which the pages of docs/ are published; without it the metainfo has no screenshots")
set(LOOPMEND_CONTACT "The Loopmend contributors <loopmend@users.noreply.github.com>" CACHE STRING "Who made the packages, and an address")
set(LOOPMEND_METAINFO_WEB "")
if(LOOPMEND_HOME_PAGE)
  file(READ ${CMAKE_CURRENT_LIST_DIR}/linux/metainfo_web.xml web_lines)
  string(CONFIGURE "${web_lines}" LOOPMEND_METAINFO_WEB @ONLY)
endif()

# Debian 12 and 13 each have their packages, those of 13 are the newer ones: 0.1.0+debian13.
cmake_host_system_information(RESULT system QUERY DISTRIB_ID DISTRIB_VERSION_ID)
list(JOIN system "" system)
set(LOOPMEND_DEB_VERSION ${PROJECT_VERSION}+${system})

set(made ${PROJECT_BINARY_DIR}/packaging)
find_program(LOOPMEND_GZIP gzip REQUIRED)
set(compressed_files "")
# compressed(NAME FROM): FROM with the version filled in, as packaging/NAME.gz of the build folder; the same bytes every time.
function(compressed name from)
  configure_file(${from} ${made}/${name} @ONLY)
  add_custom_command(OUTPUT ${made}/${name}.gz COMMAND ${LOOPMEND_GZIP} -9 -n -k -f ${made}/${name} DEPENDS ${made}/${name})
  set(compressed_files ${compressed_files} ${made}/${name}.gz PARENT_SCOPE)
endfunction()
set(linux ${CMAKE_CURRENT_LIST_DIR}/linux)
set(debian ${CMAKE_CURRENT_LIST_DIR}/debian)
compressed(loopmend.1 ${linux}/loopmend.1)
compressed(loopmend-gui.1 ${linux}/loopmend-gui.1)
compressed(changelog ${debian}/changelog.in)
add_custom_target(loopmend_packaging ALL DEPENDS ${compressed_files})
configure_file(${linux}/org.loopmend.Loopmend.metainfo.xml ${made}/org.loopmend.Loopmend.metainfo.xml @ONLY)

set(share ${CMAKE_INSTALL_DATADIR})
# The command line.
install(FILES ${made}/loopmend.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT command_line)
install(FILES ${linux}/loopmend.bash-completion RENAME loopmend DESTINATION ${share}/bash-completion/completions COMPONENT command_line)
install(FILES ${linux}/loopmend.thumbnailer DESTINATION ${share}/thumbnailers COMPONENT pictures)
install(FILES ${linux}/loopmend.mime.xml RENAME loopmend.xml DESTINATION ${share}/mime/packages COMPONENT command_line)
# The window.
install(FILES ${made}/loopmend-gui.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT application)
install(FILES ${linux}/org.loopmend.Loopmend.desktop DESTINATION ${share}/applications COMPONENT application)
install(FILES ${made}/org.loopmend.Loopmend.metainfo.xml DESTINATION ${share}/metainfo COMPONENT application)
install(FILES ${PROJECT_SOURCE_DIR}/resources/icons/loopmend.svg DESTINATION ${share}/icons/hicolor/scalable/apps COMPONENT application)
foreach(size 16 24 32 48 128)
  install(FILES ${PROJECT_SOURCE_DIR}/resources/icons/${size}/loopmend.png DESTINATION ${share}/icons/hicolor/${size}x${size}/apps COMPONENT application)
endforeach()

# The documentation.
if(LOOPMEND_BUILD_DOCS)
  file(GLOB_RECURSE pages CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/docs/* ${PROJECT_SOURCE_DIR}/engine/*.h)
  add_custom_command(OUTPUT ${made}/site/index.html
    COMMAND ${PROJECT_SOURCE_DIR}/docs/build_site.sh ${made}/site
    DEPENDS ${pages} ${PROJECT_SOURCE_DIR}/mkdocs.yml ${PROJECT_SOURCE_DIR}/CHANGELOG.md)
  add_custom_target(loopmend_docs ALL DEPENDS ${made}/site/index.html)
  install(DIRECTORY ${made}/site/ DESTINATION ${share}/doc/loopmend-doc/html COMPONENT documentation)
endif()

set(CPACK_COMPONENTS_ALL "")
# package(COMPONENT NAME DEPENDS DESCRIPTION): DEPENDS beside the libraries that its programs need.
macro(package component name depends description)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name})
  set(CPACK_DEBIAN_${upper}_FILE_NAME DEB-DEFAULT)
  set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS "${depends}")
  set(CPACK_COMPONENT_${upper}_DESCRIPTION "${description}")
  install(FILES ${debian}/copyright ${made}/changelog.gz DESTINATION ${share}/doc/${name} COMPONENT ${component})
endmacro()
package(application loopmend "loopmend-cli (= ${LOOPMEND_DEB_VERSION}), loopmend-pictures (= ${LOOPMEND_DEB_VERSION}), qttranslations5-l10n"
"The window shows scans, their boundary loops, and patches that a geometric
flow shapes while you watch. It gives figures for the seam, compares flows,
and exports STL, PLY, OBJ, OFF, glTF, 3MF and VTK polydata.")
package(command_line loopmend-cli ""
"The command line fills holes, joins boundary loops of several meshes, smooths
regions and, with loopmend-pictures, draws. It reads and writes PLY, STL, OBJ, OFF, glTF and 3MF.")
if(TARGET loopmend_pictures)
  package(pictures loopmend-pictures "loopmend-cli (= ${LOOPMEND_DEB_VERSION})"
"What the command line draws pictures with: thumbnails of the file manager, the
command render, and the pages of batch. It reads and writes VTK polydata, and
brings VTK and OpenGL.")
  set(CPACK_DEBIAN_PICTURES_PACKAGE_RECOMMENDS libgl1-mesa-dri)  # on machines without a graphics driver
  set(CPACK_DEBIAN_COMMAND_LINE_PACKAGE_RECOMMENDS "loopmend-pictures (= ${LOOPMEND_DEB_VERSION})")
endif()
package(development libloopmend-dev
"libeigen3-dev, libopenmesh-dev, libcgal-dev, libsuitesparse-dev, libopenblas-pthread-dev, libtbb-dev, zlib1g-dev, libpng-dev, libjpeg62-turbo-dev, libexpat1-dev, libzip-dev, nlohmann-json3-dev"
"The numerical engine as a static library, with its headers and its CMake
package: find_package(loopmend) gives the target loopmend::engine.")
if(LOOPMEND_BUILD_DOCS)
  package(documentation loopmend-doc ""
"The user guide, the mathematics, the pages for developers and the benchmarks,
as web pages to be read offline. They begin at
/usr/share/doc/loopmend-doc/html/index.html.")
endif()
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_SECTION doc)
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_ARCHITECTURE all)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME loopmend)
set(CPACK_PACKAGE_VENDOR "The Loopmend contributors")
set(CPACK_PACKAGE_CONTACT "${LOOPMEND_CONTACT}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "close holes in scanned meshes so that curvature runs on")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_COMPONENTS_IGNORE_GROUPS ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_VERSION ${LOOPMEND_DEB_VERSION})
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_OUTPUT_FILE_PREFIX ${PROJECT_BINARY_DIR}/packages)
set(CPACK_VERBATIM_VARIABLES ON)
include(CPack)
