# Helpers for the build: packages that name what to install, and the header check.

set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

# terratact_find(<name> [version] [COMPONENTS c...] DEBIAN <package>...)
# find_package() whose failure says which Debian package is missing.
macro(terratact_find name)
  cmake_parse_arguments(_find "" "" "DEBIAN" ${ARGN})
  find_package(${name} ${_find_UNPARSED_ARGUMENTS} QUIET)
  if(NOT ${name}_FOUND)
    terratact_missing(${name} ${_find_DEBIAN})
  endif()
endmacro()

# terratact_find_pkg(<module> DEBIAN <package>): the same through pkg-config, as PkgConfig::<module>.
macro(terratact_find_pkg module)
  cmake_parse_arguments(_find "" "" "DEBIAN" ${ARGN})
  find_package(PkgConfig QUIET)
  if(NOT PkgConfig_FOUND)
    terratact_missing(pkg-config pkg-config)
  endif()
  pkg_check_modules(${module} QUIET IMPORTED_TARGET ${module})
  if(NOT ${module}_FOUND)
    terratact_missing(${module} ${_find_DEBIAN})
  endif()
endmacro()

function(terratact_missing name)
  list(JOIN ARGN " " packages)
  message(FATAL_ERROR
    "${name} was not found: install ${packages}, or run cmake/setup.sh core gui test, "
    "which installs all that is missing.")
endfunction()

# Compiles every header of every FILE_SET alone, as part of the default build: a header that
# leans on its includer, or on a library that its target does not link, does not get in.
function(terratact_check_headers)
  if(CMAKE_CXX_CLANG_TIDY)
    # Generated sources (moc, resources) lie in the build tree and are not ours to tidy.
    file(WRITE ${PROJECT_BINARY_DIR}/.clang-tidy "Checks: '-*,misc-definitions-in-headers'\n")
  else()
    add_custom_target(header_check ALL)
    add_dependencies(header_check all_verify_interface_header_sets)
  endif()
endfunction()
