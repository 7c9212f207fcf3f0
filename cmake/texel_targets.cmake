# SPDX-License-Identifier: MIT
# One function for each kind of target, so that a folder's CMakeLists.txt says only what is its own.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)

find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_C_COMPILER_LAUNCHER ${CCACHE})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()

# The flags of our own targets; the libraries that we use are compiled as they are.
add_library(texel_flags INTERFACE)
target_compile_options(texel_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow
  # GCC 12 warns of overlapping copies inside std::string's operator+ that cannot happen (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  # A fused multiply-add would give other bytes on another machine.
  -ffp-contract=off
  $<$<BOOL:${TEXEL_WARNINGS_AS_ERRORS}>:-Werror>)
if(TEXEL_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif()

# texel_round_as_written(FILES…): GCC 12's vectoriser of straight-line code turns double -> float -> double into
# nothing, so that a result depends on what was inlined and on -O; these files' results do not.
function(texel_round_as_written)
  set_source_files_properties(${ARGN} PROPERTIES
    COMPILE_OPTIONS $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)
endfunction()

# texel_library(name SOURCES … DEPENDS … PRIVATE_DEPENDS …)
# The folder's headers lie in include/<name>/; nothing else sees them but who links texel_<name>.
function(texel_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  if(ARG_SOURCES)
    add_library(texel_${name} STATIC ${ARG_SOURCES})
    target_include_directories(texel_${name} PUBLIC include)
    target_link_libraries(texel_${name} PUBLIC ${ARG_DEPENDS} PRIVATE texel_flags ${ARG_PRIVATE_DEPENDS})
  else()
    add_library(texel_${name} INTERFACE)
    target_include_directories(texel_${name} INTERFACE include)
    target_link_libraries(texel_${name} INTERFACE ${ARG_DEPENDS})
  endif()
endfunction()

# texel_program(name SOURCES … DEPENDS …): a program that is installed.
function(texel_program name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE texel_flags ${ARG_DEPENDS})
  install(TARGETS ${name} DESTINATION bin)
endfunction()

# texel_lab(05_normal_map): labs/05_normal_map/lab.cpp becomes the program lab05_normal_map.
function(texel_lab folder)
  texel_program(lab${folder} SOURCES ${folder}/lab.cpp DEPENDS texel_app)
  target_include_directories(lab${folder} PRIVATE ${folder})
endfunction()

# texel_test(name SOURCES … DEPENDS …): a GoogleTest program, one ctest entry for each test case
# (WHOLE: one entry for the program, for tests that share a costly context).
function(texel_test name)
  cmake_parse_arguments(ARG "WHOLE" "" "SOURCES;DEPENDS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE texel_flags GTest::gtest_main ${ARG_DEPENDS})
  if(ARG_WHOLE)
    add_test(NAME ${name} COMMAND ${name} WORKING_DIRECTORY ${CMAKE_SOURCE_DIR})
  else()
    gtest_discover_tests(${name} WORKING_DIRECTORY ${CMAKE_SOURCE_DIR} DISCOVERY_TIMEOUT 60)
  endif()
endfunction()
