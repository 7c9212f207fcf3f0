// SPDX-License-Identifier: MIT
// The picture that a lab draws. VIEW selects it: the colours, or one of the quantities behind them. These go
// unchanged into a float target (alpha 1 marks the object).
out vec4 picture;

// The colour, or one of the two views that are the same in all labs.
void show(vec4 color) {
#if VIEW == VIEW_DEPTH
  picture = vec4(vec3(1.0 / gl_FragCoord.w), 1.0);  // w in clip space is the distance along the view axis
#elif VIEW == VIEW_MASK
  picture = vec4(1.0);
#else
  picture = color;
#endif
}
