# SPDX-License-Identifier: MIT
# Compiles SOURCE, which must fail, and for the reason in its second line: // error: TEXT
file(STRINGS ${SOURCE} reason REGEX "^// error: " LIMIT_COUNT 1)
string(REPLACE "// error: " "" reason "${reason}")
if(reason STREQUAL "")
  message(FATAL_ERROR "${SOURCE} does not say '// error: TEXT'")
endif()
list(TRANSFORM INCLUDE PREPEND -I)
set(compile ${COMPILER} -std=c++20 -fsyntax-only ${INCLUDE})

# The same file without its fault compiles, so that nothing else is what fails.
execute_process(COMMAND ${compile} -DWITHOUT_FAULT ${SOURCE} RESULT_VARIABLE result ERROR_VARIABLE output)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${SOURCE} does not compile without its fault either:\n${output}")
endif()
execute_process(COMMAND ${compile} ${SOURCE} RESULT_VARIABLE result ERROR_VARIABLE output)
if(result EQUAL 0)
  message(FATAL_ERROR "${SOURCE} compiles, but must not: ${reason}")
endif()
string(FIND "${output}" "${reason}" place)
if(place EQUAL -1)
  message(FATAL_ERROR "${SOURCE} fails for another reason than '${reason}':\n${output}")
endif()
