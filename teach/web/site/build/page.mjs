// SPDX-License-Identifier: MIT
// The pages' HTML. All links are relative and name their file: the folder works below any address.
import { query } from "./course.mjs";
import { escaped } from "./handout.mjs";

/** The styles stand in the page: a lab's first paint waits for no other file. */
function document({ title, description, style, body, script = "", classes }) {
  return `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1, interactive-widget=resizes-content">
<meta name="color-scheme" content="light dark">
<meta name="description" content="${escaped(description)}">
<link rel="icon" href="data:,">
<title>${escaped(title)}</title>
<style>${style}</style>
${script}</head>
<body class="${classes}">
${body}</body>
</html>
`;
}

function bar(labs, root, here) {
  const items = labs.map((lab) =>
    `<li><a href="${root}${lab.folder}/index.html"${lab.number === here ? ' aria-current="page"' : ""} ` +
    `aria-label="Lab ${lab.number}: ${escaped(lab.title)}" title="${escaped(lab.title)}">${lab.number}</a></li>`);
  return `<header class="bar">
<a class="home" href="${root}index.html">Texel Labs</a>
<nav aria-label="Labs"><ol>${items.join("")}</ol></nav>
<a class="guide" href="${root}guide/index.html">Guide</a>
</header>
`;
}

/** Buttons over the picture; their work is in src/tools.js. */
const tools = [
  ["panel", "Parameters", "Looks, view and parameters"],
  ["turn", "Turntable", "Turn the model slowly (space)"],
  ["view", "Reset view", "The camera as it was at first (R)"],
  ["look", "First look", "As the lab opens (J)"],
  ["link", "Copy link", "The address of just this picture"],
  ["snapshot", "Snapshot", "Save the picture as a PNG (S)"],
];

/** The small pictures are one file: eleven kept the first picture back by 37 ms. */
function looksList(looks, pictured) {
  const items = looks.map((look) => {
    const at = (100 * pictured.indexOf(look)) / Math.max(1, pictured.length - 1);
    const image = at < 0 ? ""
      : `<img src="looks.webp" style="object-position: 0 ${at}%" alt="" width="128" height="128" loading="lazy" decoding="async">`;
    return `<li><a class="look" href="${escaped(query(look) || "?")}" data-look="${look.name}">${image}<span>${escaped(look.caption)}</span></a></li>`;
  });
  return `<ul class="looks">\n${items.join("\n")}\n</ul>`;
}

/**
 * Starts the engine with the lab before the page's own script is there, which takes it over (engine/client.mjs). Names the files of
 * the first picture: of the address, or of the best look (src/lab.js). Behind the still: in the page's head this kept the first paint
 * back by a tenth.
 */
const early = ({ number, files, opening, looks }) => `if (location.protocol !== "file:" && "OffscreenCanvas" in window) {
  const worker = new Worker("../engine/worker.mjs", { type: "module" }), canvas = document.createElement("canvas");
  const started = new Promise((done) => {
    worker.addEventListener("message", ({ data }) => done(data), { once: true });
    worker.addEventListener("error", ({ message }) => done({ error: { message: message || "the engine cannot be loaded" } }));
  });
  const asked = new URLSearchParams(location.search || "${query(opening ?? looks.find((look) => look.hero) ?? {})}");
  const files = Object.fromEntries(Object.entries(${JSON.stringify(files)}).map(([name, value]) => [name, asked.get(name) ?? value]));
  const surface = canvas.transferControlToOffscreen();
  worker.postMessage({ id: 0, call: "start", args: { canvas: surface, timeOrigin: performance.timeOrigin, lab: ${number}, files } }, [surface]);
  globalThis.texelEarly = { worker, canvas, started };
}`.replace(/\n\s*/g, " ");

/** The handout is laid out when the page's scripts have run: before, it kept them back by 100 ms. It waits for 300 ms at most. */
const late = `new Promise((done) => {
  addEventListener("load", () => setTimeout(done));
  setTimeout(done, 300);
}).then(() => {
  document.querySelector("#handout").style.contentVisibility = "";
  document.getElementById(location.hash.slice(1))?.scrollIntoView();
});`.replace(/\n\s*/g, " ");

/** Has the room of what src/progress.js puts there: nothing moves when that comes. */
const progress = (count) => count === 0 ? `<div class="progress" hidden></div>`
  : `<div class="progress"><p><b>${count} shader ${count === 1 ? "step" : "steps"}, not checked yet.</b> Your code stays in this browser.</p>` +
    `<div class="buttons">${["Check all", "Save as .zip", "Load a .zip"].map((text) => `<button type="button" disabled>${text}</button>`).join(" ")}</div></div>`;

/** The editor for experiments, below the steps; src/experiment.js fills it. */
const experiment = ({ shader }) => `<section class="experiment" id="experiment" data-path="${shader}">
<h2>Experiment</h2>
<p>Here you can change the lab&#8217;s whole shader and see what it does to the picture. Nothing is judged, and your steps stay as they
are. What you write is kept in this browser. You can share it by a link.</p>
<div class="workbench bench"></div>
</section>
`;

/** The picture with which the page opens, in its first paint. Not where the address or what was written asks for another one. */
const opens = (webp, number) => `<img class="still" alt="" width="784" height="448" decoding="sync" elementtiming="still" src="data:image/webp;base64,${webp.toString("base64")}">
<script>
  let isKept = false;
  try { isKept = Object.keys(localStorage).some((key) => key.startsWith(\`texel-labs \${new URL("..", location.href).pathname} ${number}.\`)); } catch {}
  if (location.protocol === "file:" || location.search || isKept) document.querySelector(".still").remove();
</script>`;

/**
 * The page of a lab. `pictured`: the looks that have a small picture; another one is only its caption. `scripts`: those that it needs at
 * once. `still`: what the page opens with, as WebP, or null.
 */
export function labPage({ lab, labs, handout, pictured, scripts, still, style }) {
  const at = labs.indexOf(lab);
  const beside = (other, text) => (other ? `<a href="../${other.folder}/index.html">${text} ${other.number}: ${escaped(other.title)}</a>` : "<span></span>");
  const body = `<a class="skip" href="#handout">To the handout</a>
${bar(labs, "../", lab.number)}<main class="lab" data-lab="${lab.number}">
<section class="stage" aria-label="Picture">
<div class="frame">
<div class="picture" id="picture" tabindex="0" role="application" aria-roledescription="picture" aria-label="Picture of the lab ${escaped(lab.title)}" aria-describedby="picture-keys">${still ? opens(still, lab.number) : ""}</div>
<script>${early(lab)}</script>
<p class="spoken" id="picture-keys">Arrow keys turn the camera, plus and minus zoom, Enter reads the pixel in the middle.</p>
<div class="divider" role="slider" tabindex="0" aria-label="Where the compared picture begins" aria-valuemin="0" aria-valuemax="100" hidden><span class="left"></span><span class="right"></span></div>
<div class="message" role="alert" hidden></div>
<div class="legend-place" aria-live="polite"></div>
<div class="compared" hidden></div>
<aside class="pixel" aria-label="Pixel" aria-live="polite" hidden></aside>
<p class="waiting">The picture is on its way.</p>
<noscript><p class="waiting">The picture needs JavaScript. The handout does not.</p></noscript>
</div>
<div class="tools" role="toolbar" aria-label="Picture">
${tools.map(([id, text, help]) => `<button type="button" data-tool="${id}" title="${help}"${id === "turn" || id === "panel" ? ' aria-pressed="false"' : ""}>${text}</button>`).join("\n")}
<span class="followed" hidden><span></span> <button type="button" data-tool="mine">Back to mine</button></span>
<span class="followed experimenting" hidden><span>Experiment</span> <button type="button" data-tool="end">End</button></span>
<output class="said" aria-live="polite"></output>
</div>
</section>
<section class="panel" id="panel" aria-label="Panel">
<details class="part looks-part" data-part="looks" open><summary>Looks</summary>
${looksList(lab.looks, pictured)}
</details>
<div class="controls-of-lab"></div>
<p class="help" aria-hidden="true"></p>
</section>
<link rel="stylesheet" href="../site/katex/katex.css">
<article class="handout" id="handout" style="content-visibility: hidden">
<script>${late}</script>
<noscript><style>#handout { content-visibility: visible !important }</style></noscript>
<header><p class="number" aria-hidden="true">${lab.number}</p><div><h1>${escaped(lab.title)}</h1><p>${escaped(lab.lesson)}</p></div></header>
${progress(lab.steps.filter((step) => step.kind === "shader").length)}
${handout}${experiment(lab)}<footer>${beside(labs[at - 1], "Lab")}${beside(labs[at + 1], "Lab")}</footer>
</article>
</main>
`;
  return document({
    title: `Lab ${lab.number}: ${lab.title} – Texel Labs`,
    description: lab.lesson,
    style,
    body,
    classes: "of-lab",
    script:
      scripts.map((file) => `<link rel="modulepreload" href="${file}">\n`).join("") + `<script type="module" src="../site/lab.js"></script>\n` +
      `<script>if (location.protocol === "file:") addEventListener("DOMContentLoaded", () => { document.querySelector(".waiting").textContent = ` +
      `"A browser does not run this page from a file. In the folder of the pages type: python3 -m http.server"; });</script>\n`,
  });
}

/** The course as one line, a mark for each step; src/index.js says which are right. Solved pages have none. */
function way(labs) {
  const marks = labs.flatMap((lab) => lab.steps.map(({ id, title, points, kind }) =>
    `<li class="${kind}" data-step="${id}" data-points="${points}" data-page="${lab.folder}/index.html#step-${id}" ` +
    `title="${id} ${escaped(title)}${kind === "shader" ? "" : ", in C++: not on a page"}"></li>`));
  return `<section class="way" hidden>\n<p></p>\n<ol>${marks.join("")}</ol>\n</section>\n`;
}

/** The first page: a picture of each lab, as in the gallery. */
export function indexPage({ labs, heroes, kind, style }) {
  const cards = labs.map((lab) => {
    const hero = heroes.get(lab.folder);
    const shader = lab.steps.filter((step) => step.kind === "shader").length;
    const steps = lab.steps.length === 0 ? "" : shader === 0 ? `${lab.steps.length} steps, all in C++`
      : shader === lab.steps.length ? `${shader} steps, all here` : `${lab.steps.length} steps, ${shader} of them here`;
    return `<li><a href="${lab.folder}/index.html" data-lab="${lab.number}">` +
      `<img src="${hero.src}" alt="" width="${hero.width}" height="${hero.height}"${lab.number > 6 ? ' loading="lazy"' : ""}>` +
      `<h2><b>${lab.number}</b> ${escaped(lab.title)}</h2><p>${escaped(lab.lesson)}</p><p class="quiet">${steps}</p></a></li>`;
  });
  const about = kind === "starter"
    ? "Turn the pictures, change their parameters, and write the missing lines of the shaders: each step is checked while you type."
    : "Turn the pictures, change their parameters, and edit the shaders: each step is checked while you type. All steps are solved here.";
  const body = `<header class="masthead">
<h1>Texel Labs</h1>
<p>Texture mapping, normal mapping and environment mapping in nine small OpenGL programs, here in your browser. ${about}</p>
<p class="quiet"><a href="guide/index.html">The student&#8217;s guide</a></p>
</header>
<main>
${kind === "starter" ? way(labs) : ""}<ul class="cards">
${cards.join("\n")}
</ul>
</main>
`;
  return document({
    title: "Texel Labs",
    description: "Nine labs on texture mapping, normal mapping and environment mapping, in the browser",
    style,
    body,
    classes: "of-index",
    script: `<script type="module" src="site/index.js"></script>\n`,
  });
}

/** A document of the course as a page of its own. */
export function textPage({ labs, title, html, style }) {
  return document({
    title: `${title} – Texel Labs`,
    description: title,
    style,
    body: `${bar(labs, "../", 0)}<main class="text"><article class="handout">
<h1>${escaped(title)}</h1>
${html}</article></main>
`,
    classes: "of-text",
    script: `<link rel="stylesheet" href="../site/katex/katex.css">\n`,
  });
}
