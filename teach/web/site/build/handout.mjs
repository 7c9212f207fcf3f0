// SPDX-License-Identifier: MIT
// A handout's Markdown becomes HTML: formulas typeset, pictures beside it, and its commands live.
import katex from "katex";
import { Marked, Parser } from "marked";
import { query } from "./course.mjs";

export const escaped = (text) =>
  text.replace(/[&<>"']/g, (c) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "'": "&#39;" })[c]);

/** A heading's address, as code hosts make it. */
const slug = (text) => text.toLowerCase().replace(/[^\p{L}\p{N} -]/gu, "").trim().replace(/ /g, "-");

/** A formula as HTML with MathML inside it for screen readers. Throws where KaTeX does not understand it. */
const typeset = (tex, displayMode) =>
  katex.renderToString(tex, { displayMode, throwOnError: true, strict: (code) => (code === "unicodeTextInMathMode" ? "ignore" : "error") });

const formulas = {
  extensions: [
    {
      name: "display",
      level: "inline",
      start: (src) => src.indexOf("$$"),
      tokenizer: (src) => {
        const match = /^\$\$([^$]+)\$\$/.exec(src);
        return match && { type: "display", raw: match[0], tex: match[1] };
      },
      renderer: ({ tex }) => typeset(tex, true),
    },
    {
      name: "formula",
      level: "inline",
      start: (src) => src.indexOf("$"),
      tokenizer: (src) => {
        const match = /^\$([^$\n]+(?:\n[^$\n]+)?)\$/.exec(src);
        return match && { type: "formula", raw: match[0], tex: match[1] };
      },
      renderer: ({ tex }) => typeset(tex, false),
    },
  ],
};

/**
 * The look of a command such as `./run lab 5 --method raw --view normal`: {set, view}, or null where it does something
 * else, or has an option that is no parameter.
 */
export function lookOf(command, lab) {
  const words = command.trim().split(/\s+/);
  if (words.splice(0, 3).join(" ") !== `./run lab ${lab.number}`) return null;
  const look = { set: {}, view: "color" };
  while (words.length > 0) {
    const name = /^--([a-z][a-z-]*)$/.exec(words.shift())?.[1];
    const value = words.shift();
    if (name === undefined || value === undefined || value.startsWith("--") || value.includes("…")) return null;
    if (["snapshot", "measure", "stats", "mesh", "batch", "bench", "frames", "config", "size"].includes(name)) return null;
    if (name === "view") look.view = value;
    else look.set[name.replaceAll("-", "_")] = value;
  }
  return look;
}

/** The documents that are pages too: their files from the tree's root, and their folders on the site. */
export const documents = { "docs/student.md": "guide", "labs/from_file_to_pixel.md": "from_file_to_pixel", "labs/05_normal_map/frames.md": "frames" };

/** Where a link of the tree leads on the site: pictures are copied, some documents are pages, the rest stays text. */
function site(href, copies) {
  if (/^(https?:|#)/.test(href)) return href;
  const [path, anchor] = href.split("#");
  const named = Object.keys(documents).find((file) => file.endsWith(`/${path.split("/").pop()}`) && !path.endsWith("README.md"));
  if (named) return `../${documents[named]}/index.html${anchor ? `#${anchor}` : ""}`;
  const handout = /(\d\d_\w+)\/README\.md$/.exec(path);
  if (handout) return `../${handout[1]}/index.html${anchor ? `#${anchor}` : ""}`;
  const picture = /docs\/pictures\/(.+\.(?:png|svg))$/.exec(path);
  if (picture) {
    copies.add(picture[1]);
    return `../pictures/${picture[1].replace(/png$/, "webp")}`;
  }
  return null;
}

/**
 * The handout as HTML. `lab` may be absent (the student's guide). Each step is a section with an empty place for its
 * editor. Pictures that it shows are added to `copies`, by their path below docs/pictures.
 */
export function handout(markdown, lab, copies, sizeOf = () => ({})) {
  const steps = new Map((lab?.steps ?? []).map((step) => [step.id, step]));
  const live = (command) => {
    const look = lab && lookOf(command, lab);
    return look && `<a class="see" href="${escaped(query(look) || "?")}" title="Show this look in the picture">`;
  };
  const renderer = {
    html: ({ text }) => (/^<\/?details>(<summary>[\w ]+<\/summary>)?\s*$/.test(text)
      ? text.replace("<details><summary>After", '<details class="after"><summary>After') : escaped(text)),
    heading({ tokens, depth, text }) {
      return `<h${depth} id="${slug(text)}">${this.parser.parseInline(tokens)}</h${depth}>\n`;
    },
    codespan({ text }) {
      const link = live(text);
      const code = `<code>${escaped(text)}</code>`;
      return link ? `${link}${code}</a>` : code;
    },
    code({ text }) {
      const lines = text.split("\n").map((line) => {
        const link = live(line.replace(/\s+#.*$/, ""));
        return link ? `${link}${escaped(line)}</a>` : escaped(line);
      });
      return `<pre tabindex="0"><code>${lines.join("\n")}</code></pre>\n`;
    },
    link({ href, tokens }) {
      const text = this.parser.parseInline(tokens);
      const to = site(href, copies);
      return to === null ? text : `<a href="${escaped(to)}">${text}</a>`;
    },
    image({ href, text }) {
      const to = site(href, copies);
      if (to === null) throw new Error(`the handout shows ${href}, which is no file below docs/pictures`);
      const { width, height } = sizeOf(to);
      const size = width ? ` width="${width}" height="${height}"` : "";
      const drawn = to.endsWith(".svg") ? ' class="drawing"' : "";
      const image = `<img${drawn} src="${escaped(to)}" alt="${escaped(text)}"${size} loading="lazy" decoding="async">`;
      return to.includes("/steps/") ? `${image}<span class="caption" aria-hidden="true">${escaped(text)}</span>` : image;
    },
    table(token) {
      const inline = (cell) => this.parser.parseInline(cell.tokens);
      const head = token.header.map((cell) => (cell.text === "" ? "<td></td>" : `<th scope="col">${inline(cell)}</th>`)).join("");
      const rows = token.rows.map((row) => `<tr>${row.map((cell) => `<td>${inline(cell)}</td>`).join("")}</tr>`).join("\n");
      return `<div class="scroll" tabindex="0"><table>\n<thead><tr>${head}</tr></thead>\n<tbody>${rows}</tbody>\n</table></div>\n`;
    },
  };
  const marked = new Marked(formulas, { renderer });
  const tokens = marked.lexer(markdown);
  let html = "", step = null, chapters = 0;
  const close = () => {
    if (step) html += `${step.pictures}${step.text}${stepPlace(step)}${step.after}${folded(step.details)}</section>\n`;
    step = null;
  };
  /** A step's picture comes first, then the text, the question and what is to be written; the editor; what one learned; the rest is folded. */
  const sort = (token) => {
    const isPicture = token.type === "paragraph" && token.tokens.length === 1 && token.tokens[0].type === "image" && step.text === "";
    if (token.type === "html" && token.text.includes("After it passes")) step.part = "after";
    if (token.type === "list" && token.items.some(({ text }) => text.startsWith("**Where:**"))) {
      const list = (items) => (items.length > 0 ? marked.parser([{ ...token, items }]) : "");
      const isTask = ({ text }) => text.startsWith("**Write:**");
      step.text += list(token.items.filter(isTask));
      step.details += list(token.items.filter((item) => !isTask(item)));
    } else step[step.part ?? (isPicture ? "pictures" : "text")] += marked.parser([token]);
    if (token.type === "html" && token.text.includes("</details>")) step.part = null;
  };
  while (tokens.length > 0) {
    const token = tokens.shift();
    if (token.type === "paragraph" && token.text.startsWith("**Predict:**")) {
      step.text += marked.parser([token]) + predict(step.id, tokens.splice(0, 6).filter(({ type }) => type === "list"), marked);
      continue;
    }
    if (token.type === "heading" && token.depth <= 3) {
      close();
      if (token.depth === 1) continue;  // the page's own
      // What follows the steps is laid out when it comes near, as they are.
      if (lab && token.depth === 2 && chapters++ > 0) html += `${chapters > 2 ? "</section>\n" : ""}<section class="chapter">\n`;
      const begun = token.depth === 3 && steps.get(token.text.split(" ")[0]);
      if (begun) {
        html += stepHead(begun);
        step = { ...begun, pictures: "", text: "", details: "", after: "", part: null };
        continue;
      }
    }
    if (step) {
      sort(token);
      continue;
    }
    // What one types in a shell, and the marks in the sources, mean nothing on a page.
    if (lab && token.type === "code" && token.text.includes("./run watch")) continue;
    if (lab && token.type === "paragraph" && token.text.startsWith("Write between the lines `//@step`")) {
      const sources = Object.entries(tokens.links).map(([name, { href }]) => `\n\n[${name}]: ${href}`);
      html += marked.parse(token.text.replace(/^[^;]*; /, "").replace(/^\[the/, "[The") + sources.join(""));
      continue;
    }
    html += marked.parser([token]);
  }
  close();
  return chapters > 1 ? `${html}</section>\n` : html;
}

/** The choices of a step's question: each opens the answer to it, and closes the others. */
function predict(id, [choices, answers], marked) {
  const inline = (item) => Parser.parseInline(item.tokens[0].tokens, marked.defaults);
  const all = choices.items.map((choice, i) =>
    `<details name="predict-${id}"><summary>${inline(choice)}</summary><p>${inline(answers.items[i])}</p></details>\n`);
  return `<div class="predict">\n${all.join("")}</div>\n`;
}

const folded = (details) => (details === "" ? "" : `<details class="more"><summary>Details</summary>\n${details}</details>\n`);

const points = (n) => `${n} point${n === 1 ? "" : "s"}`;

function stepHead(step) {
  return `<section class="step" id="step-${step.id}" data-step="${step.id}" data-look="${escaped(query(step))}">\n` +
    `<h3><span class="id">${step.id}</span> <span class="title">${escaped(step.title)}</span> ` +
    `<span class="points">${points(step.points)}</span></h3>\n`;
}

function stepPlace(step) {
  if (step.kind === "shader")
    return `<div class="workbench" role="group" aria-label="Step ${step.id}: your code"><p class="quiet">The editor needs ` +
      `JavaScript and WebGL 2.</p></div>\n`;
  return `<p class="by-program"><b>Done by the program.</b> This step is C++, and a browser cannot compile it. Here the finished ` +
    `code runs. You write it in the desktop course: <a href="../guide/index.html">how to begin</a>.</p>\n`;
}
