// SPDX-License-Identifier: MIT
// A vector that normalize() can take: `v`, or `otherwise` where v has no length but rounding. 1 is a usual length. NaN
// stays NaN: it is a mistake in the formula, not in the model or the map, and must be seen.
vec3 with_length(vec3 v, vec3 otherwise) { return dot(v, v) < 1e-10 ? otherwise : v; }
