# Install rules for `cmake --install`, and the Debian package made by `cpack -G DEB`.

include(GNUInstallDirs)

# Programs find their files at ../share/terratact (app/runtime/resources.h), also in the build tree.
file(RELATIVE_PATH _data ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_DATADIR})
if(NOT _data STREQUAL "../share")
  message(FATAL_ERROR "the programs look for ../share, but from CMAKE_INSTALL_BINDIR to CMAKE_INSTALL_DATADIR it is ${_data}")
endif()
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/share)
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/resources ${PROJECT_BINARY_DIR}/share/terratact SYMBOLIC)

set(TERRATACT_HOMEPAGE "${PROJECT_HOMEPAGE_URL}" CACHE STRING "Where the package's sources and answers are found")
set(_resources ${PROJECT_SOURCE_DIR}/resources)
set(_docs ${PROJECT_SOURCE_DIR}/docs)
set(_programs terratact)
if(TERRATACT_GUI)
  list(APPEND _programs terratact-console)
endif()

install(TARGETS ${_programs})
install(FILES ${_resources}/models/default.ttm ${_resources}/models/default.card.toml ${_resources}/models/default.presets.csv ${_resources}/models/default.ttn ${_resources}/models/one_plane.ttm
  DESTINATION ${CMAKE_INSTALL_DATADIR}/terratact/models)
install(FILES ${_resources}/robots/absolem.toml DESTINATION ${CMAKE_INSTALL_DATADIR}/terratact/robots)
install(FILES ${_resources}/sessions/demo.tts ${_resources}/sessions/feel_forward.tts ${_resources}/sessions/two_tracks.tts
  DESTINATION ${CMAKE_INSTALL_DATADIR}/terratact/sessions)
install(FILES ${_resources}/dbc/terratact.dbc DESTINATION ${CMAKE_INSTALL_DATADIR}/terratact/dbc)
install(FILES ${_resources}/mappings/ctu_absolem.toml ${_resources}/mappings/simulated_robot.toml ${_resources}/mappings/terratact.toml ${_resources}/mappings/terratact_signals.toml
  DESTINATION ${CMAKE_INSTALL_DATADIR}/terratact/mappings)
install(FILES ${_resources}/panels/example.toml DESTINATION ${CMAKE_INSTALL_DATADIR}/terratact/panels)

list(TRANSFORM _programs REPLACE "(.+)" "${_docs}/man/\\1.1" OUTPUT_VARIABLE _pages)
install(FILES ${_pages} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES
  ${_docs}/can.md ${_docs}/can_absolem.log ${_docs}/can_demo.log ${_docs}/can_payload.dbc ${_docs}/can_payload.log ${_docs}/clusters.md ${_docs}/evaluation.md ${_docs}/robot.md ${_docs}/two_tracks.md
  ${_docs}/extremes.md ${_docs}/faults.md ${_docs}/feel_forward.md ${_docs}/fig8.svg ${_docs}/fig9.svg ${_docs}/hazards.md ${_docs}/link.md ${_docs}/manual.md ${_docs}/panel.md
  ${_docs}/cli.md ${_docs}/files.md ${_docs}/import.md ${_docs}/truth.md ${_docs}/memory.md ${_docs}/sessions.md ${_docs}/strip.md ${_docs}/your_robot.md
  ${_docs}/console.png ${_docs}/pit.svg ${_docs}/tradeoff.md ${_docs}/tradeoff.svg
  ${_resources}/desktop/changelog ${_resources}/desktop/copyright
  DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/doc/terratact)
install(DIRECTORY ${_docs}/screens DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/doc/terratact)

# bash-completion loads the file that has the program's name.
foreach(_program IN LISTS _programs)
  install(FILES ${_resources}/desktop/completion.bash RENAME ${_program}
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
endforeach()

if(TERRATACT_GUI)
  set(_id org.terratact.console)
  install(FILES ${_resources}/desktop/${_id}.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
  file(READ ${_resources}/desktop/${_id}.metainfo.xml _metainfo)
  string(REPLACE "${PROJECT_HOMEPAGE_URL}" "${TERRATACT_HOMEPAGE}" _metainfo "${_metainfo}")
  file(WRITE ${PROJECT_BINARY_DIR}/${_id}.metainfo.xml "${_metainfo}")
  install(FILES ${PROJECT_BINARY_DIR}/${_id}.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
  install(FILES ${_resources}/desktop/${_id}.mime.xml RENAME ${_id}.xml
    DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages)
  install(FILES ${_resources}/desktop/${_id}.svg
    DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
endif()

# Packaging uses the existing build and builds nothing, so it needs no tests.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME terratact)
set(CPACK_PACKAGE_VENDOR "Terratact contributors")
set(CPACK_PACKAGE_CONTACT "Terratact contributors <terratact@localhost.invalid>" CACHE STRING
  "Who maintains the package, as Name <address>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "terrain profile by touch for tracked robots in smoke")
set(CPACK_PACKAGE_DESCRIPTION
"Terratact is for the operator of a tracked rescue robot where cameras and
lasers see nothing: the robot feels the ground with its flippers and a probing
arm, and the console shows the terrain profile under and ahead of it, with
bands that say how sure it is.
.
The package has the console (terratact-console), the command line (terratact)
with a simulated robot, a trained model, and tools for the robot's CAN bus.")
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/debian_files.cmake)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_HOMEPAGE ${TERRATACT_HOMEPAGE})

# The version of a package ends with the release it was built on: 0.2.0~deb12. It sorts before the version of Debian 13.
# After an upgrade of the system, apt therefore takes the new release's package.
set(TERRATACT_PACKAGE_VERSION "" CACHE STRING "Version without the release; empty: what cmake/version.sh prints")
set(_version ${TERRATACT_PACKAGE_VERSION})
if(NOT _version)
  execute_process(COMMAND ${PROJECT_SOURCE_DIR}/cmake/version.sh
    OUTPUT_VARIABLE _version OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE _failed)
  if(_failed)  # a wrong tag must not stop a user's build; cmake/packages.sh stops there
    message(WARNING "cmake/version.sh found no version, so a package would get ${PROJECT_VERSION}")
    set(_version ${PROJECT_VERSION})
  endif()
endif()
cmake_host_system_information(RESULT _system QUERY DISTRIB_INFO)
string(REPLACE "debian" "deb" _distribution "${_system_ID}")
set(CPACK_PACKAGE_VERSION ${_version}~${_distribution}${_system_VERSION_ID})
set(CPACK_DEBIAN_PACKAGE_SECTION science)
# Qt loads the icons' plugin at run time. Debian 13 has it in a package of its own, Debian 12 in libqt6svg6.
set(_icons)
file(GLOB _found /var/lib/dpkg/info/qt6-svg-plugins*.list)
if(TERRATACT_GUI AND _found)
  set(_icons ", qt6-svg-plugins")
endif()
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)   # versions of this release's libraries; Qwt is linked statically
set(CPACK_DEBIAN_PACKAGE_DEPENDS "fonts-dejavu-core${_icons}")   # figures and console show text, and no library depends on a font
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "can-utils, gpiod")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS iproute2)   # `terratact can check` names its commands
if(TERRATACT_GUI)
  # Qt loads plugins at run time; X11 and offscreen come with libqt6gui6. Qt's own Czech and German texts are in a
  # separate package. ALSA needs a plugin to play through a desktop's sound server.
  string(APPEND CPACK_DEBIAN_PACKAGE_RECOMMENDS ", qt6-wayland, qt6-translations-l10n, pipewire-alsa | libasound2-plugins")
endif()
include(CPack)
