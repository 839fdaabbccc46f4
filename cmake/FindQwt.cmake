# Finds Qwt for Qt 6: the system's, else the one that cmake/setup.sh built in .deps/. Distributions use different names,
# and some have Qwt for Qt 5, too. Each candidate must therefore link a test program against Qt 6. Qt6 (Widgets, Svg,
# PrintSupport) must be found before. Sets Qwt_FOUND, Qwt_VERSION and the target Qwt::Qwt.

include(FindPackageHandleStandardArgs)

# QVector<QPointF> is QList<QPointF> in Qt 6, so a Qt 5 library has another symbol here.
set(_qwt_probe [[
#include <qwt_plot_curve.h>
int main()
{
    QwtPlotCurve curve;
    curve.setSamples(QVector<QPointF>{QPointF(0.0, 1.0)});
    return curve.dataSize() == 1 ? 0 : 1;
}
]])

# Tests the header and library found with these find_path/find_library arguments.
function(_qwt_try where)
  find_path(Qwt_INCLUDE_DIR qwt_global.h NO_CACHE
    PATH_SUFFIXES qwt-qt6 qt6/qwt qwt6-qt6 qwt6 qwt ${CMAKE_LIBRARY_ARCHITECTURE}/qt6/qwt ${ARGN})
  find_library(Qwt_LIBRARY NAMES qwt-qt6 qwt6-qt6 qwt NO_CACHE ${ARGN})
  if(NOT Qwt_INCLUDE_DIR OR NOT Qwt_LIBRARY)
    return()
  endif()
  set(libraries Qt6::Widgets Qt6::Svg Qt6::PrintSupport)
  set(dir ${CMAKE_BINARY_DIR}/CMakeFiles/qwt-probe)
  file(WRITE ${dir}/probe.cpp "${_qwt_probe}")
  unset(Qwt_LINKS_QT6 CACHE)
  try_compile(Qwt_LINKS_QT6 ${dir} SOURCES ${dir}/probe.cpp
    CMAKE_FLAGS -DINCLUDE_DIRECTORIES=${Qwt_INCLUDE_DIR}
    LINK_LIBRARIES ${Qwt_LIBRARY} ${libraries}
    CXX_STANDARD 20 CXX_STANDARD_REQUIRED ON)
  if(Qwt_LINKS_QT6)
    set(Qwt_INCLUDE_DIR ${Qwt_INCLUDE_DIR} CACHE PATH "Headers of Qwt for Qt 6")
    set(Qwt_LIBRARY ${Qwt_LIBRARY} CACHE FILEPATH "Library of Qwt for Qt 6")
  endif()
  unset(Qwt_LINKS_QT6 CACHE)
endfunction()

if(NOT EXISTS "${Qwt_LIBRARY}")
  unset(Qwt_INCLUDE_DIR CACHE)
  unset(Qwt_LIBRARY CACHE)
  _qwt_try(system)
endif()
foreach(_name IN ITEMS qwt qwt-${CMAKE_LIBRARY_ARCHITECTURE})  # the second in a cross build
  if(NOT Qwt_LIBRARY)
    set(_prefix ${PROJECT_SOURCE_DIR}/.deps/${_name})
    _qwt_try(${_name} PATHS ${_prefix}/include ${_prefix}/lib NO_DEFAULT_PATH)
  endif()
endforeach()

if(Qwt_INCLUDE_DIR)
  file(STRINGS ${Qwt_INCLUDE_DIR}/qwt_global.h _qwt_version REGEX "QWT_VERSION_STR")
  string(REGEX MATCH "[0-9]+\\.[0-9]+\\.[0-9]+" Qwt_VERSION "${_qwt_version}")
endif()
find_package_handle_standard_args(Qwt
  REQUIRED_VARS Qwt_LIBRARY Qwt_INCLUDE_DIR VERSION_VAR Qwt_VERSION)
if(Qwt_FOUND AND NOT TARGET Qwt::Qwt)
  add_library(Qwt::Qwt UNKNOWN IMPORTED)
  set_target_properties(Qwt::Qwt PROPERTIES
    IMPORTED_LOCATION ${Qwt_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${Qwt_INCLUDE_DIR}
    INTERFACE_LINK_LIBRARIES "Qt6::Widgets;Qt6::Svg;Qt6::PrintSupport")
endif()
