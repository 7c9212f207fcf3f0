# SPDX-License-Identifier: MIT
# One function for each kind of target, so that a folder's CMakeLists.txt says only what is its own.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)

# Checkouts in other folders share their compiled objects. Precompiled headers ccache takes only when it is told so.
find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_C_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=1
      CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_C_COMPILER_LAUNCHER})
endif()

find_program(GOLD ld.gold)

# A program is linked under another name and then takes its place: one that runs, or is just started, stays whole.
set(CMAKE_CXX_LINK_EXECUTABLE
    "<CMAKE_CXX_COMPILER> <FLAGS> <CMAKE_CXX_LINK_FLAGS> <LINK_FLAGS> <OBJECTS> -o <TARGET>.new <LINK_LIBRARIES>"
    "mv -f <TARGET>.new <TARGET>")

# The flags of our own targets; the libraries that we use are compiled as they are.
add_library(texel_flags INTERFACE)
target_compile_options(texel_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow
  # A function that forgets its result returns whatever lies there: the right value on one machine, another on the next.
  -Werror=return-type
  # GCC 12 warns of copies inside std::string's operator+: that they overlap, or are too long. Neither can happen (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-stringop-overflow>
  # libstdc++ 12's own stable_sort uses what C++17 deprecates, and Clang 19 says so.
  $<$<CXX_COMPILER_ID:Clang>:-Wno-deprecated-declarations>
  # The sanitizers' own code makes GCC warn of std::regex; without them the same files are warned of as ever.
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<BOOL:${TEXEL_SANITIZE}>>:-Wno-maybe-uninitialized>
  # GCC 12's vectoriser of straight-line code turns double -> float -> double into nothing: then a result depends on what was
  # inlined and on -O.
  $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>
  # A fused multiply-add would give other bytes on another machine.
  -ffp-contract=off
  $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess> # what ccache needs of precompiled headers
  # GCC looks for memory to use again after 128 MB. Most of our files end within 512 MB (the largest needs 700, not 590), and
  # without the search they are compiled in 0.9 of the time.
  $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=524288>
  $<$<BOOL:${TEXEL_WARNINGS_AS_ERRORS}>:-Werror>)
if(TEXEL_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif()

# What nearly every file includes takes longer to read than the rest of most, and is read once for all. GCC takes a
# precompiled header only for the options that it was made with, so each kind of target has its own:
#   (plain)  what is measured
#   LIGHT    code that waits for files, people or other programs: nobody sees that it runs slower, and it compiles sooner.
#            Of -O0, -Og, -O1 and -O2, GCC 12 needs least time for -Og: 0.68 of -O2's
#   LAB      light, with what a lab is
#   TEST     light, with GoogleTest
# For the sanitizers it is not optimised: that hides no fault from them, and compiles in half the time.
set(TEXEL_LIGHT $<$<CONFIG:Release>:-Og> $<$<BOOL:${TEXEL_SANITIZE}>:-O0>)
# What a student's steps are made with: the lines of the calls tell where one crashed. GCC takes a precompiled header that was
# made with this for files without it, but not the other way round.
set(TEXEL_LINES $<$<CONFIG:Release>:-g1>)
function(texel_precompile name)
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/empty.cpp CONTENT "")
  cmake_parse_arguments(ARG "" "" "OPTIONS;DEPENDS;HEADERS" ${ARGN})
  add_library(${name} STATIC ${CMAKE_BINARY_DIR}/empty.cpp)
  target_link_libraries(${name} PRIVATE texel_flags fmt::fmt glm::glm ${ARG_DEPENDS})
  target_compile_options(${name} PRIVATE ${ARG_OPTIONS})
  target_precompile_headers(${name} PRIVATE ${CMAKE_SOURCE_DIR}/cmake/texel_precompiled.hpp ${ARG_HEADERS})
endfunction()

# texel_own(target [LIGHT | LAB | TEST]): the flags and precompiled headers of our own targets.
function(texel_own target)
  cmake_parse_arguments(ARG "LIGHT;LAB;TEST" "" "" ${ARGN})
  set(precompiled texel_precompiled)
  if(ARG_LIGHT OR ARG_LAB OR ARG_TEST)
    target_compile_options(${target} PRIVATE ${TEXEL_LIGHT})
    set(precompiled texel_precompiled_light)
  endif()
  if(ARG_LAB)
    set(precompiled texel_precompiled_lab)
  elseif(ARG_TEST)
    set(precompiled texel_precompiled_test)
  endif()
  target_link_libraries(${target} PRIVATE texel_flags fmt::fmt glm::glm)
  target_precompile_headers(${target} REUSE_FROM ${precompiled})
endfunction()

# texel_together(target): seven of its files are compiled as one, which reads and instantiates what they all include once
# and takes little more than half of the time. Not for files that students edit: after a save they are compiled alone, as
# all files are by the presets without precompiled headers (dev, clang, tidy).
function(texel_together target)
  if(NOT CMAKE_DISABLE_PRECOMPILE_HEADERS)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 7)
  endif()
endfunction()

# texel_library(name [LIGHT] SOURCES … MEASURED … DEPENDS … PRIVATE_DEPENDS …)
# The folder's headers lie in include/<name>/; nothing else sees them but who links texel_<name>. MEASURED are the files of a
# LIGHT library that go through every pixel or vertex.
function(texel_library name)
  cmake_parse_arguments(ARG "LIGHT" "" "SOURCES;MEASURED;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  if(ARG_LIGHT)
    set(kind LIGHT)
  endif()
  if(ARG_MEASURED)
    add_library(texel_${name}_measured OBJECT ${ARG_MEASURED})
    target_include_directories(texel_${name}_measured PRIVATE include)
    target_link_libraries(texel_${name}_measured PRIVATE ${ARG_DEPENDS} ${ARG_PRIVATE_DEPENDS})
    texel_own(texel_${name}_measured)
    texel_together(texel_${name}_measured)
    list(APPEND ARG_SOURCES $<TARGET_OBJECTS:texel_${name}_measured>)
  endif()
  if(ARG_SOURCES)
    add_library(texel_${name} STATIC ${ARG_SOURCES})
    target_include_directories(texel_${name} PUBLIC include)
    target_link_libraries(texel_${name} PUBLIC ${ARG_DEPENDS} PRIVATE ${ARG_PRIVATE_DEPENDS})
    texel_own(texel_${name} ${kind})
  else()
    add_library(texel_${name} INTERFACE)
    target_include_directories(texel_${name} INTERFACE include)
    target_link_libraries(texel_${name} INTERFACE ${ARG_DEPENDS})
  endif()
endfunction()

# texel_program(name [LIGHT | LAB] SOURCES … DEPENDS …): a program that is installed.
function(texel_program name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE ${ARG_DEPENDS})
  texel_own(${name} ${ARG_UNPARSED_ARGUMENTS})
  install(TARGETS ${name} DESTINATION bin)
endfunction()

# texel_lab(05_normal_map): labs/05_normal_map/lab.cpp becomes the program lab05_normal_map. The other .cpp files there, which
# students write, become the objects steps05_normal_map; in a student's tree only those that were there at first, so that a
# copy of one does no harm. lab.cpp has no loop over pixels, and is compiled after each save.
function(texel_lab folder)
  # What a student's steps are to use is not used yet. No other target has flags of its own in a student's tree: the grader
  # builds one beside the course, and the compiler's cache then has most of its objects.
  if(NOT TEXEL_TEACH)
    add_compile_options(-Wno-unused-parameter -Wno-unused-variable -Wno-unused-function)
  endif()
  texel_program(lab${folder} LAB SOURCES ${folder}/lab.cpp DEPENDS texel_start)
  target_include_directories(lab${folder} PRIVATE ${folder})
  if(GOLD) # links after a save in 0.06 s, where the usual linker takes 0.13
    target_link_options(lab${folder} PRIVATE -fuse-ld=gold)
  endif()
  set(given ${CMAKE_SOURCE_DIR}/.starter/labs/${folder})
  if(NOT IS_DIRECTORY ${given})
    set(given ${CMAKE_CURRENT_SOURCE_DIR}/${folder})
  endif()
  file(GLOB steps RELATIVE ${given} ${given}/*.cpp)
  list(REMOVE_ITEM steps lab.cpp)
  if(steps)
    list(TRANSFORM steps PREPEND ${folder}/)
    add_library(steps${folder} OBJECT ${steps})
    target_include_directories(steps${folder} PUBLIC ${folder})
    target_link_libraries(steps${folder} PRIVATE texel_gl)
    texel_own(steps${folder})
    target_compile_options(steps${folder} PRIVATE ${TEXEL_LINES})
    target_link_libraries(lab${folder} PRIVATE steps${folder})
  endif()
endfunction()

# texel_test_program(name SOURCES … DEPENDS …): a GoogleTest program; who calls says what of it is a test.
function(texel_test_program name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE GTest::gtest_main ${ARG_DEPENDS})
  texel_own(${name} TEST)
endfunction()

# texel_test(name SOURCES … DEPENDS …): the same with one ctest entry for each test case
# (WHOLE: one entry for the program, for tests that share a costly context). Those of a source that holds what a renderer
# draws to a limit have the label "limits", by which `./run renderers` finds them. Those of the sources, the build and the
# documents say nothing of behaviour (TREE): they have the label "tree", and `./run mutants` does not ask them. Tests that take
# minutes begin first (SLOW).
function(texel_test name)
  cmake_parse_arguments(ARG "WHOLE;TREE;SLOW" "" "" ${ARGN})
  cmake_parse_arguments(OF "" "" "SOURCES;DEPENDS" ${ARG_UNPARSED_ARGUMENTS})
  texel_test_program(${name} ${ARG_UNPARSED_ARGUMENTS})
  set(labels)
  foreach(source IN LISTS OF_SOURCES)
    file(STRINGS ${source} limits REGEX "support/tolerance.hpp")
    if(limits)
      set(labels limits)
    endif()
  endforeach()
  if(ARG_TREE)
    set(labels tree)
  endif()
  set(cost 0)
  if(ARG_SLOW)
    set(cost 100)
  endif()
  if(ARG_WHOLE)
    add_test(NAME ${name} COMMAND ${name} WORKING_DIRECTORY ${CMAKE_SOURCE_DIR})
    set_tests_properties(${name} PROPERTIES LABELS "${labels}" COST ${cost})
  else()
    gtest_discover_tests(${name} WORKING_DIRECTORY ${CMAKE_SOURCE_DIR} DISCOVERY_TIMEOUT 60 PROPERTIES COST ${cost} LABELS "${labels}")
  endif()
endfunction()
