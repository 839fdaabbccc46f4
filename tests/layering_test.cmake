# Who may include whom, and is every file built?  Run with cmake -P; fails with a list of all
# offences.  -D ROOT=<tree> checks another tree.  The rules:
#   core     a folder includes itself and the folders before it in core_order; no Qt, no Linux (learn/huge_pages.cpp asks it, where it is there)
#   drivers  core/result.h and core/{wire,robot,sim,log}, text, the bins, the panel; no Qt
#   widgets  the values of core that they draw, text, Qt, Qwt
#   app      all four (its command line: no Qt)
#   tests    anything, through headers
# And nothing that has to be answered before all else: a modal window would stand between the operator and STOP:
#   widgets, app  no box of Qt's that asks, no exec() but the application's, no loop of events, no modality
# And a text of somebody's file is shown as it is, whatever it looks like:
#   widgets, app  no label but a PlainLabel, no tip but by widgets/tips.h, no other widget or document for rich text
# And a text of a file must not move a terminal's cursor:
#   all but tests  print with say() (app/say.h), nothing else
# And the same seed gives the same draws with every compiler and standard library (docs/extremes.md):
#   core/{infer,learn}  no distribution nor shuffle of the standard library, whose algorithms differ from one to the next
#   build files         no option that lets a compiler reorder sums or forget NaN
cmake_minimum_required(VERSION 3.25)
if(NOT ROOT)
  cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH ROOT)
endif()

set(core_order robot wire terrain learn infer eval atem sim log)   # files of core/ itself come first
set(qt "^<(Q[A-Za-z]|q[a-z0-9_]+\\.h>)")
set(linux "^<(linux/|sys/(socket|ioctl|epoll|eventfd|timerfd|un|mman)\\.h|net/|netinet/|arpa/|poll\\.h|gpiod)")
set(drivers_core "^core/(result\\.h|text\\.h|(wire|robot|sim|log)/.+|terrain/bins\\.h|atem/panel(_file)?\\.h)$")
set(widgets_core "^core/(text|robot/(attitude|command|force_drift|measurement)|terrain/(bins|outline)|infer/(bimodality|estimate|ghost|obstacle|provenance|touch|settings|variant|verdict)|wire/frame_trouble|atem/[a-z_]+)\\.h$")

set(blocking "(QMessageBox|QInputDialog|QErrorMessage|QProgressDialog|QWizard|QFileDialog::get|QColorDialog::get|QFontDialog::get|QMenu::exec[(]|[Dd]ialog[A-Za-z0-9_]*([.]|->)open[(]|setModal|setWindowModality|(Application|Window)Modal|QEventLoop|([.]|->)exec[(])")
set(rich "(new[ \t]+QLabel|QLabel[ \t]+[A-Za-z_]+[ \t]*[;({]|public[ \t]+QLabel|setToolTip[(]|QToolTip::showText|setTextFormat|setWhatsThis|setStatusTip|QTextEdit|QTextBrowser|QTextDocument|setHtml|insertHtml|RichText|QGraphicsTextItem|[Aa]ddRow[(][^(]*(tr[(]|QString|label,|name,))")
# The label and the tips themselves; the sheet of the keys, whose HTML is the program's own; how a label is read aloud.
set(may_be_rich "^(widgets/(plain_label|tips|spoken)\\.(h|cpp)|app/text_sheet\\.cpp)$")
set(printing "(fmt::v?print|std::v?f?printf|std::f?puts|(^|[^A-Za-z_:])(f?printf|fputs|puts)|std::(cout|cerr|clog)) *[(<]")
set(unlike "std::([a-z_]+_distribution|shuffle|sample|generate_canonical|random_device)")
# A campaign's rows for a search and a simulated scanner's noise: what training draws is kept in the model.
set(may_be_unlike "^core/learn/training\\.cpp$")
set(loose "[-\"](Ofast|f?fast-math|f?unsafe-math-optimizations|f?associative-math|f?reciprocal-math|f?finite-math-only)")

set(offences "")
macro(offence text)
  list(APPEND offences "${file}: ${text}")
endmacro()

# rank of a path inside core; its last folder in the order includes everything before it
function(core_rank path result)
  if(path MATCHES "^core/([^/]+)/")
    list(FIND core_order ${CMAKE_MATCH_1} rank)
    if(rank EQUAL -1)
      message(FATAL_ERROR "layering: core/${CMAKE_MATCH_1} has no place in core_order")
    endif()
  else()
    set(rank -1)
  endif()
  set(${result} ${rank} PARENT_SCOPE)
endfunction()

file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/core/*.h ${ROOT}/core/*.cpp ${ROOT}/drivers/*.h
  ${ROOT}/drivers/*.cpp ${ROOT}/widgets/*.h ${ROOT}/widgets/*.cpp ${ROOT}/app/*.h ${ROOT}/app/*.cpp
  ${ROOT}/tests/*.h ${ROOT}/tests/*.cpp)
foreach(file IN LISTS files)
  string(REGEX REPLACE "/.*" "" layer ${file})

  # Built? Named by its folder's CMakeLists.txt, or a header nobody checks, a test nobody runs.
  file(READ ${ROOT}/${layer}/CMakeLists.txt listed)
  string(REGEX REPLACE "^${layer}/" "" name ${file})
  if(layer STREQUAL "tests")
    string(REGEX REPLACE "\\.cpp$" "" name ${name})   # a test is listed without its suffix
  endif()
  string(FIND "${listed}" "${name}" position)
  if(position EQUAL -1 AND NOT (layer STREQUAL "tests" AND file MATCHES "\\.h$"))
    offence("is not listed in ${layer}/CMakeLists.txt")
  endif()

  file(STRINGS ${ROOT}/${file} lines REGEX "^[ \t]*#[ \t]*include")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE "^[ \t]*#[ \t]*include[ \t]*" "" what "${line}")
    if(what MATCHES "^\"([^\"]+)\"")
      set(target ${CMAKE_MATCH_1})
      string(REGEX REPLACE "/.*" "" to ${target})
      if(target MATCHES "\\.moc$")
        continue()
      elseif(target MATCHES "\\.cpp$")
        offence("includes the source file ${target}")
      elseif(NOT to MATCHES "^(core|drivers|widgets|app|tests)$")
        offence("includes \"${target}\", which is not written from the root")
      elseif(to STREQUAL "tests" AND NOT layer STREQUAL "tests")
        offence("includes ${target} of the tests")
      elseif(layer STREQUAL "core")
        if(NOT to STREQUAL "core")
          offence("core includes ${target}")
        else()
          core_rank(${file} from_rank)
          core_rank(${target} to_rank)
          if(to_rank GREATER from_rank)
            offence("includes ${target}, which comes later in core")
          endif()
        endif()
      elseif(layer STREQUAL "drivers")
        if(NOT to STREQUAL "drivers" AND NOT target MATCHES "${drivers_core}")
          offence("drivers include ${target}")
        endif()
      elseif(layer STREQUAL "widgets")
        if(NOT to STREQUAL "widgets" AND NOT target MATCHES "${widgets_core}")
          offence("widgets include ${target}")
        endif()
      endif()
    elseif(what MATCHES "${qt}" AND (layer MATCHES "^(core|drivers)$" OR file MATCHES "^app/(cli|command)"))
      offence("includes ${what}: no Qt here")
    elseif(what MATCHES "${linux}" AND layer STREQUAL "core" AND NOT file STREQUAL "core/learn/huge_pages.cpp")
      offence("includes ${what}: Linux belongs to drivers")
    endif()
  endforeach()
endforeach()

# An offence for every line of `file` with `pattern` in it: before, what was found, after.
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
    refuse("${rich}" "has" ": it may show a file's text as HTML; use widgets/plain_label.h and widgets/tips.h")
  endif()
  if(file MATCHES "^(core|drivers|widgets|app)/" AND NOT file STREQUAL "app/say.h")
    refuse("${printing}" "prints with" ": a text of a file may hold escapes, and say() (app/say.h) prints none")
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
