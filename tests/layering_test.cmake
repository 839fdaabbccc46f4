# Checks which file may include which, and that every file is built. Run with cmake -P; it fails with a list of all
# violations. -D ROOT=<tree> checks another tree. The rules of includes:
#   core     a room includes itself and rooms before it in core_rooms; no Qt; no Linux headers except in
#   learn/kernels/huge_pages.cpp
#   drivers  core/base/{message,result,system_message}.h and core/{wire,robot,sim,log}, text, the bins, the panel; no Qt
#   app/display  core values that an operator reads, Qt Core; the only room of app that widgets include
#   widgets  a room includes itself and rooms before it in widgets_rooms; app/display; core values that they draw, Qt, Qwt
#   app      all five; a room includes itself and rooms before it in app_rooms; no Qt up to cli;
#            mission includes no widgets and only Qt Core; nobody includes cli; review and console do not include each
#            other
#   tests    anything, through headers
# Nothing may be modal, because a modal window would block STOP:
#   widgets, app  no Qt message boxes, no exec() except the application's, no event loops, no modality
# Text from a file is always shown literally:
#   widgets, app  every label is a PlainLabel, every tip is set by widgets/base/tips.h, no other rich text widget or
#   document
# Text from a file cannot move a terminal's cursor:
#   all but tests  print with printText() (app/runtime/print_text.h) only
# The same seed gives the same draws with every compiler and standard library (docs/extremes.md):
#   core/{infer,learn}  no distribution or shuffle of the standard library, whose algorithms differ
#   build files         no option that lets a compiler reorder sums or ignore NaN
cmake_minimum_required(VERSION 3.25)
if(NOT ROOT)
  cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH ROOT)
endif()

set(core_rooms base series store robot robot/watch bags wire wire/logs wire/dbc mapping terrain learn/data clouds learn/kernels learn/gp learn/net learn/model learn/model/file infer/estimate strip trail infer/sampling infer infer/verdict eval atem atem/probe sim/ground sim/rest sim log/rows log)
set(widgets_rooms base terrain terrain/readings control signals)
set(app_rooms runtime link link/gamepad recording recording/export plotting modelling
  modelling/simulation modelling/robots modelling/truth modelling/trials modelling/evaluation modelling/training figures
  figures/report cli/session cli shell/preferences shell start mission/text mission pages sessions imports review/export
  review console/pages console/connection console/past console main)
set(no_qt "^app/(runtime|link|recording|plotting|modelling|figures|cli)/")
set(qt "^<(Q[A-Za-z]|q[a-z0-9_]+\\.h>)")
set(qt_core_only "^app/(display|mission)/")
set(qt_core "^<Q(CoreApplication|DateTime|ElapsedTimer|FileInfo|List|Object|RegularExpression|String|StringList|Thread|tGlobal)>")
set(linux "^<(linux/|sys/(socket|ioctl|epoll|eventfd|timerfd|un|mman)\\.h|net/|netinet/|arpa/|poll\\.h|gpiod)")
set(drivers_core "^core/(base/(message|result|system_message|text|poll)\\.h|(wire|robot|sim|log)/.+|terrain/bins\\.h|atem/panel(_file)?\\.h)$")
set(widgets_core "^core/(limits|base/(degree|message|text)|robot/(attitude|command|force_drift|force_sensor|measurement|probe_side)|terrain/(bins|outline)|infer/estimate/(estimate|provenance|touch|settings|two_track_estimate|variant)|infer/verdict/(bimodality|obstacle|two_track_verdict|verdict)|strip/(felt_by|height_band|strip|strip_section)|wire/frame_trouble|series/[a-z_]+|atem/(probe/)?[a-z_]+)\\.h$")

set(blocking "(QMessageBox|QInputDialog|QErrorMessage|QProgressDialog|QWizard|QFileDialog::get|QColorDialog::get|QFontDialog::get|QMenu::exec[(]|[Dd]ialog[A-Za-z0-9_]*([.]|->)open[(]|setModal|setWindowModality|(Application|Window)Modal|QEventLoop|([.]|->)exec[(])")
set(rich "(new[ \t]+QLabel|QLabel[ \t]+[A-Za-z_]+[ \t]*[;({]|public[ \t]+QLabel|setToolTip[(]|QToolTip::showText|setTextFormat|setWhatsThis|setStatusTip|QTextEdit|QTextBrowser|QTextDocument|setHtml|insertHtml|RichText|QGraphicsTextItem|[Aa]ddRow[(][^(]*(tr[(]|QString|label,|name,))")
# Exceptions: the label and the tips themselves, the key sheet with the program's own HTML, and reading labels aloud.
set(may_be_rich "^(widgets/base/(plain_label|tips|spoken)\\.(h|cpp)|app/shell/text_sheet\\.cpp)$")
set(printing "(fmt::v?print|std::v?f?printf|std::f?puts|(^|[^A-Za-z_:])(f?printf|fputs|puts)|std::(cout|cerr|clog)) *[(<]")
set(unlike "std::([a-z_]+_distribution|shuffle|sample|generate_canonical|random_device)")
# Exceptions: rows of a campaign for a search, and a simulated scanner's noise; the model stores what training drew.
set(may_be_unlike "^core/learn/model/training\\.cpp$")
set(loose "[-\"](Ofast|f?fast-math|f?unsafe-math-optimizations|f?associative-math|f?reciprocal-math|f?finite-math-only)")

set(offences "")
macro(offence text)
  list(APPEND offences "${file}: ${text}")
endmacro()

# Returns the rank of a file's room in its layer; a room includes rooms before it.
function(room_rank layer path result)
  cmake_path(GET path PARENT_PATH room)
  string(REGEX REPLACE "^${layer}/?" "" room "${room}")
  list(FIND ${layer}_rooms "${room}" rank)
  if(path STREQUAL "core/limits.h")
    set(${result} -1 PARENT_SCOPE)
    return()
  endif()
  if(rank EQUAL -1)
    message(FATAL_ERROR "layering: ${path}: room \"${room}\" has no place in ${layer}_rooms")
  endif()
  set(${result} ${rank} PARENT_SCOPE)
endfunction()

file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/core/*.h ${ROOT}/core/*.cpp ${ROOT}/drivers/*.h
  ${ROOT}/drivers/*.cpp ${ROOT}/widgets/*.h ${ROOT}/widgets/*.cpp ${ROOT}/app/*.h ${ROOT}/app/*.cpp
  ${ROOT}/tests/*.h ${ROOT}/tests/*.cpp)
foreach(file IN LISTS files)
  string(REGEX REPLACE "^app/display/.*" "display" layer ${file})
  string(REGEX REPLACE "/.*" "" layer ${layer})

  # Every file must be in its room's CMakeLists.txt; otherwise a header is not checked or a test not run.
  if(layer STREQUAL "tests")
    set(lists tests/CMakeLists.txt)
    string(REGEX REPLACE "^tests/|\\.cpp$" "" name ${file})   # tests are listed without suffix
  else()
    cmake_path(GET file PARENT_PATH room)
    cmake_path(GET file FILENAME name)
    set(lists ${room}/CMakeLists.txt)
  endif()
  set(listed "")
  if(EXISTS ${ROOT}/${lists})
    file(READ ${ROOT}/${lists} listed)
  endif()
  if(NOT listed MATCHES "(^|[ \n(])${name}([ \n).]|$)" AND NOT (layer STREQUAL "tests" AND file MATCHES "\\.h$"))
    offence("is not listed in ${lists}")
  endif()

  file(STRINGS ${ROOT}/${file} lines REGEX "^[ \t]*#[ \t]*include")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE "^[ \t]*#[ \t]*include[ \t]*" "" what "${line}")
    if(what MATCHES "^\"([^\"]+)\"")
      set(target ${CMAKE_MATCH_1})
      string(REGEX REPLACE "^app/display/.*" "display" to ${target})
      string(REGEX REPLACE "/.*" "" to ${to})
      if(target MATCHES "\\.moc$")
        continue()
      elseif(target MATCHES "\\.cpp$")
        offence("includes the source file ${target}")
      elseif(NOT to MATCHES "^(core|drivers|display|widgets|app|tests)$")
        offence("includes \"${target}\", which is not written from the root")
      elseif(to STREQUAL "tests" AND NOT layer STREQUAL "tests")
        offence("includes ${target} of the tests")
      elseif(layer STREQUAL to AND DEFINED ${layer}_rooms)
        room_rank(${layer} ${file} from_rank)
        room_rank(${layer} ${target} to_rank)
        if(to_rank GREATER from_rank)
          offence("includes ${target}, whose room comes later in ${layer}_rooms")
        elseif(target MATCHES "^app/cli/" AND NOT file MATCHES "^app/cli/")
          offence("includes ${target}: nobody includes cli")
        elseif(file MATCHES "^app/console/" AND target MATCHES "^app/review/")
          offence("includes ${target}: console and review do not know each other")
        endif()
      elseif(layer STREQUAL "core")
        offence("core includes ${target}")
      elseif(layer STREQUAL "drivers")
        if(NOT to STREQUAL "drivers" AND NOT target MATCHES "${drivers_core}")
          offence("drivers include ${target}")
        endif()
      elseif(layer STREQUAL "widgets")
        if(NOT to MATCHES "^(display|widgets)$" AND NOT target MATCHES "${widgets_core}")
          offence("widgets include ${target}")
        endif()
      elseif(layer STREQUAL "display")
        if(NOT to STREQUAL "display" AND NOT target MATCHES "${widgets_core}")
          offence("display includes ${target}")
        endif()
      elseif(file MATCHES "^app/mission/" AND to STREQUAL "widgets")
        offence("mission includes ${target}: it shows nothing itself; shared values are in app/display")
      endif()
    elseif(what MATCHES "${qt}" AND (layer MATCHES "^(core|drivers)$" OR file MATCHES "${no_qt}"))
      offence("includes ${what}: no Qt here")
    elseif(what MATCHES "${qt}" AND file MATCHES "${qt_core_only}" AND NOT what MATCHES "${qt_core}")
      offence("includes ${what}: only Qt Core here")
    elseif(what MATCHES "${linux}" AND layer STREQUAL "core" AND NOT file STREQUAL "core/learn/kernels/huge_pages.cpp")
      offence("includes ${what}: Linux belongs to drivers")
    endif()
  endforeach()
endforeach()

# Reports a violation for every line of `file` that matches `pattern`.
macro(refuse pattern before after)
  file(STRINGS ${ROOT}/${file} lines REGEX "${pattern}")
  foreach(line IN LISTS lines)
    string(REGEX MATCH "${pattern}" what "${line}")
    offence("${before} ${what}${after}")
  endforeach()
endmacro()

file(GLOB_RECURSE building RELATIVE ${ROOT} ${ROOT}/cmake/*.cmake ${ROOT}/cmake/*.sh)
file(GLOB own RELATIVE ${ROOT} ${ROOT}/CMakeLists.txt ${ROOT}/CMakePresets.json ${ROOT}/*/CMakeLists.txt)
foreach(file IN LISTS building own files)
  refuse("${loose}" "asks for" ": a NaN would go unseen and sums come out differently")
  if(file MATCHES "^core/(infer|learn)/" AND NOT file MATCHES "${may_be_unlike}")
    refuse("${unlike}" "draws with" ", which differs between standard libraries")
  endif()
endforeach()

foreach(file IN LISTS files)
  if(file MATCHES "^(widgets|app)/" AND NOT file MATCHES "${may_be_rich}")
    refuse("${rich}" "has" ": it may show a file's text as HTML; use widgets/base/plain_label.h and widgets/base/tips.h")
  endif()
  if(file MATCHES "^(core|drivers|widgets|app)/" AND NOT file STREQUAL "app/runtime/print_text.h")
    refuse("${printing}" "prints with" ": a text of a file may hold escapes, and printText() (app/runtime/print_text.h) prints none")
  endif()
  if(file MATCHES "^(widgets|app)/")
    refuse("${blocking}" "shows" ": a modal window stands between the operator and STOP")
  endif()
endforeach()

list(LENGTH files count)
if(count EQUAL 0)
  message(FATAL_ERROR "layering: no source files under ${ROOT}")
endif()
if(offences)
  list(JOIN offences "\n" text)
  message(FATAL_ERROR "layering:\n${text}")
endif()
message(STATUS "layering: ${count} files, none out of place")
