// SPDX-License-Identifier: MIT
// The first page: how far the student is on the way through the course.
import { element } from "./dom.js";
import { keepOffline } from "./offline.js";
import { Work } from "./storage.js";
import { wayThrough } from "./way.js";

function showWay(host) {
  const marks = new Map([...host.querySelectorAll(".shader")].map((mark) => [mark.dataset.step, mark]));
  const steps = [...marks].map(([id, mark]) => ({ id, points: Number(mark.dataset.points) }));
  const { right, next, hours } = wayThrough(steps, new Work(new URL(".", location.href).pathname));
  for (const [id, mark] of marks) {
    mark.classList.toggle("right", right.some((step) => step.id === id));
    mark.classList.toggle("next", id === next?.id);
  }
  const said = host.querySelector("p");
  said.replaceChildren(element("b", {}, `${right.length} of ${steps.length} shader steps are right.`));
  if (next) {
    const { page } = marks.get(next.id).dataset, whole = Math.max(1, Math.round(hours));
    said.append(` ${right.length > 0 ? "Go on" : "Begin"}: `, element("a", { href: page }, marks.get(next.id).title),
      `. What is left takes about ${whole} ${whole === 1 ? "hour" : "hours"}. `,
      element("span", { className: "quiet" }, "Dashed: in C++, on the desktop."));
  }
  host.hidden = false;
}

const host = document.querySelector(".way");
if (host) addEventListener("pageshow", () => showWay(host));  // also when one comes back to the page
keepOffline("sw.js");
