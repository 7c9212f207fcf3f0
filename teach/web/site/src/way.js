// SPDX-License-Identifier: MIT
const kHoursAPoint = 0.25, kHoursALab = 0.5;  // as docs/course.md estimates

/**
 * How far a student is: {right, next, hours}, of steps {id, points} in the course's order. `next` is the step that was written last
 * while it is not right, else the first that is not; undefined after the last. `hours` is what the others take.
 */
export function wayThrough(steps, work) {
  const right = steps.filter(({ id }) => work.isRight(id)), left = steps.filter((step) => !right.includes(step));
  const labs = new Set(left.map(({ id }) => parseInt(id)));
  const hours = left.reduce((sum, { points }) => sum + points * kHoursAPoint, labs.size * kHoursALab);
  return { right, next: left.find(({ id }) => id === work.lastStep()) ?? left[0], hours };
}
