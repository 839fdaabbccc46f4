# Build helpers: find_package() that names Debian packages, libraries, clang-tidy, and the header check.

set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

# g++ collects no garbage: a sixth less time for half a gigabyte of memory.
if(TERRATACT_QUICK AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options(--param=ggc-min-heapsize=2097152)
endif()

# terratact_find(<name> [version] [COMPONENTS c...] DEBIAN <package>...)
# Calls find_package(); on failure it names the missing Debian package.
macro(terratact_find name)
  cmake_parse_arguments(_find "" "" "DEBIAN" ${ARGN})
  find_package(${name} ${_find_UNPARSED_ARGUMENTS} QUIET)
  if(NOT ${name}_FOUND)
    terratact_missing(${name} ${_find_DEBIAN})
  endif()
endmacro()

# terratact_find_pkg(<module> DEBIAN <package>)
# Does the same with pkg-config; the target is PkgConfig::<module>.
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

# terratact_library(<target> [PARTS "room room..."...] [APART source...])
# Call after the target's sources are named. Its headers are also compiled alone (below). With CMAKE_UNITY_BUILD the
# sources of a directory are compiled as one, which saves parsing headers and instantiating templates.
#   PARTS: with TERRATACT_QUICK, sources of these rooms, and of the rooms in them, are joined. A part should compile in
#   10 to 40 s, so that two processors are busy.
#   APART: sources that are joined separately, because they define a name that another source of their part defines,
#   too. If the compiler reports a name defined twice, rename it or add the source to APART.
# Sources with their own compile options are compiled alone anyway. TERRATACT_LEAVE_OUT is a pattern of sources that
# nothing which the preset builds needs; else it does not link.
function(terratact_library target)
  cmake_parse_arguments(library "" "" "PARTS;APART" ${ARGN})
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  set_property(GLOBAL APPEND PROPERTY terratact_libraries ${target})
  if(NOT TERRATACT_QUICK)
    set(library_PARTS)
  endif()
  foreach(part IN LISTS library_PARTS)
    string(REPLACE " " ";" rooms ${part})
    foreach(room IN LISTS rooms)
      set(part_of_${room} ${part})
    endforeach()
  endforeach()
  get_target_property(sources ${target} SOURCES)
  if(TERRATACT_LEAVE_OUT)
    list(FILTER sources EXCLUDE REGEX ${TERRATACT_LEAVE_OUT})
    set_property(TARGET ${target} PROPERTY SOURCES ${sources})
  endif()
  foreach(source IN LISTS sources)
    cmake_path(ABSOLUTE_PATH source NORMALIZE OUTPUT_VARIABLE path)
    cmake_path(RELATIVE_PATH path BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
    cmake_path(GET path PARENT_PATH room)
    string(REGEX REPLACE "/.*" "" outer "${room}")
    foreach(name ${room} ${outer})
      if(part_of_${name})
        set(room ${part_of_${name}})
        break()
      endif()
    endforeach()
    string(MAKE_C_IDENTIFIER "${target}_${room}" group)
    set_property(SOURCE "${source}" PROPERTY UNITY_GROUP ${group})
  endforeach()
  # These warnings are wrong in joined sources. Types without linkage belong to the one compiled file. g++ 12 loses track
  # of allocations, and of the lengths of joined strings.
  if(CMAKE_UNITY_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage -Wno-free-nonheap-object -Wno-restrict)
  endif()
  if(library_APART)
    list(TRANSFORM library_APART PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
    set_property(SOURCE ${library_APART} PROPERTY UNITY_GROUP "${target}_apart")
  endif()
endfunction()

# terratact_quick(<target> [LIGHT|HEAVY])
# With TERRATACT_QUICK, compiles a target in less time, with -Og instead of -O3. Estimates then take 1.5 times as long.
#   LIGHT: the target parses, calls and shows, and computes little. A release compiles it with -O1, a quarter faster.
#   HEAVY: the target computes. Sanitizers compile it with -O1, the others with -O0 in half of the time.
function(terratact_quick target)
  cmake_parse_arguments(quick "LIGHT;HEAVY" "" "" ${ARGN})
  if(TERRATACT_QUICK)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-Og>)
    if(NOT quick_HEAVY)
      target_compile_options(${target} PRIVATE $<$<CONFIG:Debug>:-O0>)
    endif()
  elseif(quick_LIGHT)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
endfunction()

# Target tidy: runs clang-tidy with clang's warnings on every joined source and every source compiled alone, with their
# headers. clang-tidy takes its configuration from the folder of a source. For joined sources that is the build tree,
# where the check against including sources is switched off.
function(terratact_tidy)
  find_program(TERRATACT_CLANG_TIDY NAMES clang-tidy-21 clang-tidy-22 clang-tidy-23 clang-tidy REQUIRED)
  set(project ${PROJECT_SOURCE_DIR}/.clang-tidy)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${project})
  file(READ ${project} config)
  string(REPLACE "bugprone-*," "bugprone-*,\n  -bugprone-suspicious-include," config "${config}")
  file(WRITE ${PROJECT_BINARY_DIR}/.clang-tidy "${config}")
  add_custom_target(tidy VERBATIM
    COMMAND ${PROJECT_SOURCE_DIR}/cmake/tidy.sh ${PROJECT_BINARY_DIR} ${TERRATACT_CLANG_TIDY})
  terratact_check_headers()
endfunction()

# terratact_included(<header> <variable>)
# Returns the includes of one of our headers, and recursively those of our headers among them. They are as written:
# <QWidget>, "core/base/poll.h", …
function(terratact_included header variable)
  get_property(known GLOBAL PROPERTY terratact_included_by_${header} SET)
  if(NOT known)
    set_property(GLOBAL PROPERTY terratact_included_by_${header})  # guards against a cycle
    file(STRINGS ${PROJECT_SOURCE_DIR}/${header} lines REGEX "^#include ")
    set(all)
    foreach(line IN LISTS lines)
      string(REGEX REPLACE "^#include (\"[^\"]+\"|<[^>]+>).*" "\\1" included "${line}")
      list(APPEND all ${included})
      if(included MATCHES "^\"(.+)\"$")
        terratact_included(${CMAKE_MATCH_1} more)
        list(APPEND all ${more})
      endif()
    endforeach()
    list(REMOVE_DUPLICATES all)
    set_property(GLOBAL PROPERTY terratact_included_by_${header} "${all}")
  endif()
  get_property(all GLOBAL PROPERTY terratact_included_by_${header})
  set(${variable} "${all}" PARENT_SCOPE)
endfunction()

# Target headers: compiles every header of every FILE_SET alone. A header that relies on its includer, or on a library
# its target does not link, fails. Most of the time goes into a few large foreign headers, so a header that includes one
# uses it precompiled. The includes are read at configure time. A header that drops such an include keeps it in this
# check until the next configuration.
function(terratact_check_headers)
  add_custom_target(headers)
  set(large QWidget QObject QPen QString Eigen/Core thread memory string functional vector none)
  set(sign_QWidget "<(QWidget|QFrame|QLabel|QDialog|QMainWindow|QMenu|QScrollArea|Q(List|Table)Widget|Q[A-Za-z]*(Button|Edit)|qwt_plot.h)>")
  set(sign_QObject "<(QObject|QCoreApplication|QProxyStyle|QThread|QTimer)>")
  set(sign_QPen "<QPen>")
  set(sign_QString "<QString(List)?>")
  set(sign_Eigen/Core "<Eigen/(Core|Dense)>")
  foreach(name thread memory string functional vector)
    set(sign_${name} "<${name}>")
  endforeach()
  set(sign_none ".")
  get_property(libraries GLOBAL PROPERTY terratact_libraries)
  foreach(library IN LISTS libraries)
    get_target_property(headers ${library} HEADER_SET)
    foreach(header IN LISTS headers)
      file(RELATIVE_PATH header ${PROJECT_SOURCE_DIR} ${header})
      set(source ${PROJECT_BINARY_DIR}/header_check/${header}.cpp)
      file(CONFIGURE OUTPUT ${source} CONTENT "#include \"${header}\"\n")
      terratact_included(${header} included)
      foreach(name IN LISTS large)
        if(" ${included}" MATCHES "${sign_${name}}")
          list(APPEND sources_${library}_${name} ${source})
          break()
        endif()
      endforeach()
    endforeach()
    foreach(name IN LISTS large)
      if(sources_${library}_${name})
        string(MAKE_C_IDENTIFIER ${library}_headers_${name} target)
        add_library(${target} OBJECT ${sources_${library}_${name}})
        set_target_properties(${target} PROPERTIES UNITY_BUILD OFF AUTOMOC OFF)
        # These properties give the effect of linking the library without waiting for its build.
        target_compile_features(${target} PRIVATE cxx_std_20)
        target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
        set(directories $<TARGET_PROPERTY:${library},INTERFACE_INCLUDE_DIRECTORIES>)
        target_include_directories(${target} SYSTEM PRIVATE $<FILTER:${directories},EXCLUDE,^${PROJECT_SOURCE_DIR}$>)
        target_compile_definitions(${target} PRIVATE $<TARGET_PROPERTY:${library},INTERFACE_COMPILE_DEFINITIONS>)
        target_compile_options(${target} PRIVATE $<TARGET_PROPERTY:${library},INTERFACE_COMPILE_OPTIONS>)
        add_dependencies(headers ${target})
        if(NOT name STREQUAL "none")
          target_precompile_headers(${target} PRIVATE <${name}>)
        endif()
      endif()
    endforeach()
  endforeach()
endfunction()
