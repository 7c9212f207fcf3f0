# SPDX-License-Identifier: MIT
# Every library that we use, from the system's packages (Debian 12's names are in ./run and vcpkg.json has the same).

find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(glfw3 3.3 REQUIRED)
find_package(glm REQUIRED)
find_package(fmt REQUIRED)
find_package(CLI11 REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(nlohmann_json REQUIRED)
pkg_check_modules(spng REQUIRED IMPORTED_TARGET spng)
pkg_check_modules(imgui REQUIRED IMPORTED_TARGET imgui)
find_path(STB_INCLUDE_DIR stb/stb_image.h REQUIRED)

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

texel_precompile(texel_precompiled OPTIONS ${TEXEL_LINES})
texel_precompile(texel_precompiled_light OPTIONS ${TEXEL_LIGHT})
