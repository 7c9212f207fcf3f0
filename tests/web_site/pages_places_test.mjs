// SPDX-License-Identifier: MIT
// Small parts of the pages that need no browser.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { lineNumbersOf, pathOf, surroundingsOf } from "../../teach/web/site/src/places.js";
import { readState, writeState } from "../../teach/web/site/src/state.js";
import { Work } from "../../teach/web/site/src/storage.js";
import { wayThrough } from "../../teach/web/site/src/way.js";

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

test("a file of an archive is known in whatever folder the tree lies", () => {
  const paths = ["shaders/09_bump/frame.glsl", "shaders/lib/fresnel.glsl"];
  for (const folder of ["", "my-labs/", "a/b/"]) assert.equal(pathOf(`${folder}${paths[0]}`, paths), paths[0]);
  for (const other of ["my-shaders/lib/fresnel.glsl", "lib/fresnel.glsl", "shaders/lib/fresnel.glsl.txt"])
    assert.equal(pathOf(other, paths), undefined);
});

test("what stands around a step reaches to the blank lines, without marks and license", () => {
  assert.deepEqual(surroundingsOf(file, "9.3"), { before: "// Two places.\nvec3 tangent() {", after: "" });
  const single = file.slice(0, file.indexOf("vec3 other"));
  assert.equal(surroundingsOf(single, "9.3").after, "}");
  assert.equal(surroundingsOf(`// SPDX-License-Identifier: MIT\n${single}`, "9.3").before.includes("SPDX"), false);
});

test("a state is the same after its way through the address", () => {
  const state = { set: { method: "a b&c", yaw: "-12.5" }, view: "normal", split: { parameter: "method", value: "x:y", position: 0.25 } };
  assert.deepEqual(readState(writeState(state)), { ...state, look: null });
  assert.equal(writeState({ set: {}, view: "color", split: null }), "?look=default");
  assert.equal(readState("?compare=method:raw:7").split, null);
});

/** A browser's storage: what it keeps are its own properties. `room`: characters of the texts that it takes. */
class Store {
  static room = Infinity;
  getItem(key) {
    return this[key] ?? null;
  }
  setItem(key, text) {
    if (text.length > Store.room) throw new Error("full");
    this[key] = text;
  }
  removeItem(key) {
    delete this[key];
  }
}

test("what was written survives, beside what another page writes", () => {
  const store = new Store(), page = (place = "/course/") => new Work(place, () => store);
  const one = page(), other = page();
  one.write("5.1", "first");
  one.drewWell("5.1", "first");
  one.write("5.1", "second");
  other.write("9.4", "of the other page");
  const again = page();
  assert.deepEqual(again.steps().sort(), ["5.1", "9.4"]);
  assert.deepEqual([again.text("5.1"), again.lastGood("5.1"), again.text("9.4")], ["second", "first", "of the other page"]);
  assert.equal(other.text("5.1"), "second");
  assert.deepEqual(page("/other/").steps(), []);
  other.forget("5.1");
  one.drewWell("5.1", "second");
  assert.deepEqual([one.text("5.1"), one.lastGood("5.1"), page().steps()], [undefined, undefined, ["9.4"]]);
});

test("the way through the course knows what is right, and goes on where one wrote last", () => {
  const store = new Store(), page = () => new Work("/course/", () => store), work = page();
  const steps = [["1.3", 1], ["1.6", 2], ["5.1", 3]].map(([id, points]) => ({ id, points }));
  assert.deepEqual(wayThrough(steps, work), { right: [], next: steps[0], hours: 2.5 });
  work.write("5.1", "wrong");
  work.judged("5.1", false);
  assert.equal(wayThrough(steps, page()).next, steps[2]);
  work.judged("5.1", true);
  work.judged("1.3", true);
  assert.deepEqual(wayThrough(steps, page()), { right: [steps[0], steps[2]], next: steps[1], hours: 1 });
  work.judged("1.6", true);
  assert.deepEqual(wayThrough(steps, page()).next, undefined);
  work.judged("1.6", false);
  assert.equal(wayThrough(steps, page()).next, steps[1]);
  assert.deepEqual(page().steps(), ["5.1"]);
});

test("what the browser refuses is tried again at each change", () => {
  const store = new Store(), work = new Work("/course/", () => store), said = [];
  work.watch = () => said.push(work.lasts);
  try {
    Store.room = 10;
    work.write("5.1", "a text that is too long");
    assert.deepEqual([work.text("5.1"), work.hasUnsaved, new Work("/course/", () => store).steps()], ["a text that is too long", true, []]);
    work.write("5.2", "short");
    Store.room = Infinity;
    work.write("5.2", "shorter");
  } finally {
    Store.room = Infinity;
  }
  assert.deepEqual([said, work.hasUnsaved, new Work("/course/", () => store).text("5.1")], [[false, true], false, "a text that is too long"]);
  // The last good text is dispensable.
  Store.room = 10;
  work.drewWell("5.2", "a good text that is too long");
  assert.deepEqual([work.lasts, work.hasUnsaved, work.lastGood("5.2")], [true, false, "a good text that is too long"]);
  // The last who wrote counts.
  work.write("5.1", "another text that is too long");
  store.setItem("texel-labs /course/ 5.1", "newer");
  work.heard("texel-labs /course/ 5.1");
  Store.room = Infinity;
  assert.deepEqual([work.text("5.1"), work.lasts], ["newer", true]);
});

test("a blocked storage is said from the beginning, and loses nothing while the page is open", () => {
  const work = new Work("/course/", () => { throw new Error("blocked"); });
  assert.equal(work.lasts, false);
  work.write("5.1", "text");
  assert.deepEqual([work.steps(), work.text("5.1"), work.hasUnsaved], [["5.1"], "text", true]);
  work.forget("5.1");
  assert.deepEqual([work.steps(), work.hasUnsaved], [[], false]);
});

test("./run web ends with the command that serves what it made", () => {
  const script = fileURLToPath(new URL("../../teach/web/run.sh", import.meta.url));
  // All that works is left out: what is printed stays.
  const web = (...options) => execFileSync("bash", ["-c", `root=/nowhere
    say() { :; }; need() { :; }; build_programs() { :; }; draw_gallery() { :; }; build_release() { :; }; texel() { :; }
    node() { :; }; rm() { :; }; mkdir() { :; }; find() { :; }; cd() { :; }
    . "$0"; compile_engine() { :; }; cpp_steps() { :; }; web "$@"`, script, ...options], { encoding: "utf8" }).trim().split("\n").at(-1);
  assert.match(web(), / \.\/run web --serve$/);
  assert.match(web("--starter"), / \.\/run web --starter --serve$/);
});
