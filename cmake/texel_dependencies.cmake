# SPDX-License-Identifier: MIT
# Every library that we use, from the system's packages (Debian 12's names are in ./run and vcpkg.json has the same).

include(GoogleTest)
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(glfw3 3.3 REQUIRED)
find_package(glm REQUIRED)
find_package(fmt REQUIRED)
find_package(CLI11 REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(LibArchive REQUIRED)
find_package(SQLite3 3.37 REQUIRED)
pkg_check_modules(sodium REQUIRED IMPORTED_TARGET libsodium)
pkg_check_modules(spng REQUIRED IMPORTED_TARGET spng)
pkg_check_modules(imgui REQUIRED IMPORTED_TARGET imgui)
find_path(STB_INCLUDE_DIR stb/stb_image.h REQUIRED)
if(TEXEL_TESTS)
  find_package(GTest REQUIRED)
  find_package(tinyobjloader REQUIRED) # the independent reader that ours is compared with
endif()

# glad's loader for OpenGL 3.3 core and the two extensions that we use, generated here.
set(GLAD_DIR ${CMAKE_BINARY_DIR}/glad)
if(NOT EXISTS ${GLAD_DIR}/src/gl.c)
  find_program(GLAD glad REQUIRED)
  execute_process(
    COMMAND ${GLAD} --reproducible --quiet --api gl:core=3.3
            --extensions GL_KHR_debug,GL_EXT_texture_filter_anisotropic --out-path ${GLAD_DIR} c
    COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET ERROR_QUIET)
endif()
add_library(glad STATIC ${GLAD_DIR}/src/gl.c)
target_include_directories(glad SYSTEM PUBLIC ${GLAD_DIR}/include)

# The headers that nearly all our files include, read once; for tests with GoogleTest's.
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/empty.cpp CONTENT "")
add_library(texel_precompiled STATIC ${CMAKE_BINARY_DIR}/empty.cpp)
target_link_libraries(texel_precompiled PRIVATE texel_flags fmt::fmt glm::glm)
target_precompile_headers(texel_precompiled PRIVATE ${CMAKE_CURRENT_LIST_DIR}/texel_precompiled.hpp)
if(TEXEL_TESTS)
  add_library(texel_test_precompiled STATIC ${CMAKE_BINARY_DIR}/empty.cpp)
  target_link_libraries(texel_test_precompiled PRIVATE texel_flags fmt::fmt glm::glm GTest::gtest)
  target_precompile_headers(texel_test_precompiled PRIVATE
    ${CMAKE_CURRENT_LIST_DIR}/texel_precompiled.hpp <gtest/gtest.h>)
endif()
