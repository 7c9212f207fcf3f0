// SPDX-License-Identifier: MIT
// Small parts of the pages that need no browser.
import assert from "node:assert/strict";
import { test } from "node:test";
import { lineNumbersOf, surroundingsOf } from "../../web/site/src/places.js";
import { readState, writeState } from "../../web/site/src/state.js";
import { Work } from "../../web/site/src/storage.js";

const file = `// far away

// Two places.
vec3 tangent() {
  //@step 9.3 begin
  one();
  two();
  //@end
}

vec3 other() {
  //@step 9.3 begin
  three();
  //@end
}
`;

test("a step's lines have the file's numbers, in both of its places, also when it has grown", () => {
  const numbers = lineNumbersOf(file, "9.3");
  assert.deepEqual(numbers("  one();\n  two();\n//@next\n  three();"), [6, 7, null, 13]);
  assert.deepEqual(numbers("a\nb\nc\n//@next\nd\ne"), [6, 7, 8, null, 14, 15]);
});

test("what stands around a step reaches to the blank lines", () => {
  assert.deepEqual(surroundingsOf(file, "9.3"), { before: "// Two places.\nvec3 tangent() {\n  //@step 9.3 begin", after: "" });
  const single = file.slice(0, file.indexOf("vec3 other"));
  assert.equal(surroundingsOf(single, "9.3").after, "  //@end\n}");
});

test("a state is the same after its way through the address", () => {
  const state = { set: { method: "a b&c", yaw: "-12.5" }, view: "normal", split: { parameter: "method", value: "x:y", position: 0.25 } };
  assert.deepEqual(readState(writeState(state)), { ...state, look: null });
  assert.equal(writeState({ set: {}, view: "color", split: null }), "?look=default");
  assert.equal(readState("?compare=method:raw:7").split, null);
});

test("what was written survives, also what cannot be read", () => {
  const kept = new Map();
  const store = { getItem: (key) => kept.get(key) ?? null, setItem: (key, text) => kept.set(key, text) };
  const work = new Work("/course/", store);
  work.write("5.1", "first");
  work.drewWell("5.1");
  work.write("5.1", "second");
  const again = new Work("/course/", store);
  assert.deepEqual([again.text("5.1"), again.lastGood("5.1")], ["second", "first"]);
  assert.equal(new Work("/other/", store).text("5.1"), undefined);
  kept.set([...kept.keys()][0], "{broken");
  assert.deepEqual(new Work("/course/", store).steps(), []);
});
