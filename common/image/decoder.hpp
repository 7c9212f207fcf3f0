// SPDX-License-Identifier: MIT
// stb_image with the formats that we read; stb_image.cpp compiles it.
#pragma once
#define STBI_ONLY_PNG
#define STBI_ONLY_GIF
#ifdef __EMSCRIPTEN__  // a page has only the tree's pictures
#define STBI_ONLY_PNM
#else
#define STBI_ONLY_TGA
#define STBI_ONLY_JPEG
#define STBI_ONLY_BMP
#endif
#define STBI_NO_STDIO
#define STBI_FAILURE_USERMSG
#include <stb/stb_image.h>
