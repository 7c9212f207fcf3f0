// SPDX-License-Identifier: MIT
// Which methods store a tangent in each vertex. The others need none.
#define STORED_TANGENT                                                                    \
  (NORMAL_MAPPING && (METHOD == METHOD_GRAM_SCHMIDT || METHOD == METHOD_ANGLE_WEIGHTED || \
                      METHOD == METHOD_MIKKTSPACE || METHOD == METHOD_ANALYTIC))
#define STORED_BITANGENT (NORMAL_MAPPING && METHOD == METHOD_AVERAGED)
