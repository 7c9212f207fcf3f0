// SPDX-License-Identifier: MIT
// Writes the pages: node build.mjs --out DIR [--tree DIR] [--gallery DIR] [--programs DIR]. `--out` is the site's folder (out/web),
// which has the engine in `engine/`; `--gallery` is a gallery's folder, for the looks' small pictures; `--programs` has the
// desktop's programs, which say what each lab shows first.
import { copyFileSync, existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { basename, dirname, join, relative, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { brotliCompressSync, constants } from "node:zlib";
import esbuild from "esbuild";
import { readLabs } from "./build/course.mjs";
import { documents, handout } from "./build/handout.mjs";
import { indexPage, labPage, textPage } from "./build/page.mjs";
import { asWebp, galleryPicture, pictureSize, pngSize, smallPicture, still, strip } from "./build/pictures.mjs";

const here = dirname(fileURLToPath(import.meta.url));

function options() {
  const usage = (text) => {
    console.error(`teach/web/site: ${text}. Usage: npm run build -- --out DIR [--tree DIR] [--gallery DIR] [--programs DIR]`);
    process.exit(2);
  };
  try {
    const { values } = parseArgs({ options: { out: { type: "string" }, tree: { type: "string" }, gallery: { type: "string" }, programs: { type: "string" } } });
    if (!values.out) usage("where to?");
    const tree = resolve(values.tree ?? join(here, "../../.."));
    if (!existsSync(join(tree, "labs"))) usage(`${tree} is not the course's folder`);
    return { out: resolve(values.out), tree, gallery: values.gallery && resolve(values.gallery), programs: values.programs && resolve(values.programs) };
  } catch (error) {
    return usage(error.message);
  }
}

const { out, tree, gallery, programs } = options();
const write = (path, content) => {
  mkdirSync(dirname(join(out, path)), { recursive: true });
  writeFileSync(join(out, path), content);
};
const docs = (path) => join(tree, "docs", path);

/** Scripts, into site/. Gives those that a lab's page needs at once, as its HTML names them. */
async function bundle() {
  rmSync(join(out, "site"), { recursive: true, force: true });
  const { metafile: { outputs } } = await esbuild.build({
    absWorkingDir: here,
    entryPoints: ["src/lab.js", "src/index.js"],
    outdir: join(out, "site"),
    bundle: true, splitting: true, format: "esm", minify: true, target: ["es2022"], legalComments: "none", logLevel: "error", loader: { ".frag": "text" },
    chunkNames: "[name]-[hash]",
    external: ["../engine/client.mjs"], metafile: true,
  });
  const page = Object.values(outputs).find(({ entryPoint }) => entryPoint === "src/lab.js");
  const needed = page.imports.filter(({ kind }) => kind === "import-statement").map(({ path }) => basename(path));
  return needed.map((name) => (name === "client.mjs" ? `../engine/${name}` : `../site/${name}`));
}

/** What each page has in its head. */
async function styles() {
  const css = [join(tree, "common/core/page.css"), join(here, "src/style.css")].map((file) => readFileSync(file, "utf8")).join("\n");
  return (await esbuild.transform(css, { loader: "css", minify: true })).code;
}

/** The engine's scripts, which lie in out/ already: each with what it includes, without comments and long names. */
async function shrinkEngine() {
  const engine = join(out, "engine");
  await esbuild.build({
    absWorkingDir: engine, entryPoints: readdirSync(engine).filter((name) => name.endsWith(".mjs")), outdir: engine, outExtension: { ".js": ".mjs" },
    allowOverwrite: true, bundle: true, format: "esm", minify: true, target: ["es2022"], external: ["./engine.mjs"], logLevel: "error",
  });
}

/** KaTeX' style and fonts; formulas are typeset already. */
function mathFonts() {
  const from = join(here, "node_modules/katex/dist");
  write("site/katex/katex.css", readFileSync(join(from, "katex.min.css"), "utf8").replace(/,url\([^)]*\.(?:woff|ttf)\) format\("[^"]*"\)/g, ""));
  mkdirSync(join(out, "site/katex/fonts"), { recursive: true });
  for (const font of readdirSync(join(from, "fonts")).filter((name) => name.endsWith(".woff2")))
    copyFileSync(join(from, "fonts", font), join(out, "site/katex/fonts", font));
}

function pages(style, scripts) {
  const labs = readLabs(tree, programs);
  const copies = new Set();
  const sizeOf = (path) => pictureSize(docs(`pictures/${path.replace("../pictures/", "").replace(/webp$/, "png")}`));
  for (const lab of labs) {
    rmSync(join(out, lab.folder), { recursive: true, force: true });
    const pictureOf = (look) => galleryPicture(gallery, lab, look), pictured = lab.looks.filter(pictureOf);
    if (pictured.length > 0) write(`${lab.folder}/looks.webp`, strip(pictured.map(pictureOf), 144, 68));
    const markdown = readFileSync(join(tree, "labs", lab.folder, "README.md"), "utf8");
    write(`${lab.folder}/index.html`, labPage({ lab, labs, handout: handout(markdown, lab, copies, sizeOf), pictured, scripts,
      still: still(programs && join(programs, `lab${lab.folder}`), tree, lab.opening), style }));
  }
  for (const [file, folder] of Object.entries(documents)) {
    const markdown = readFileSync(join(tree, file), "utf8");
    const title = /^# (.*)/.exec(markdown)[1].replace("'", "’");
    write(`${folder}/index.html`, textPage({ labs, title, html: handout(markdown, null, copies, sizeOf), style }));
  }

  const heroes = new Map(labs.map((lab) => {
    const file = galleryPicture(gallery, lab, lab.looks.find((look) => look.hero)) ?? docs(`pictures/${lab.folder}.png`);
    const { width, height } = pngSize(file), wide = Math.min(600, width, Math.floor(1.5 * height));
    const size = { width: wide, height: Math.round(wide / 1.5) };
    write(`pictures/${lab.folder}.webp`, smallPicture(file, size.width, size.height, 82));
    return [lab.folder, { src: `pictures/${lab.folder}.webp`, ...size }];
  }));
  const kind = existsSync(join(tree, "teach/commands")) ? "course" : "starter";
  write("index.html", indexPage({ labs, heroes, kind, style }));
  for (const picture of copies) {
    const bytes = readFileSync(docs(`pictures/${picture}`));
    if (picture.endsWith(".png")) write(`pictures/${picture.replace(/png$/, "webp")}`, asWebp(bytes, 88));
    else write(`pictures/${picture}`, bytes);
  }
}

const filesBelow = (folder) => (existsSync(folder) ? readdirSync(folder, { withFileTypes: true }) : []).flatMap((entry) =>
  entry.isDirectory() ? filesBelow(join(folder, entry.name)) : [join(folder, entry.name)]);

/** The service worker keeps pages, scripts and the engine at once; the pictures and what the labs read later. */
function serviceWorker() {
  const files = filesBelow(out).map((file) => relative(out, file).split("\\").join("/")).filter((file) => file !== "sw.js" && !file.endsWith(".br"));
  // What comes as WebP is kept so.
  const packed = new Set(files.filter((file) => file.endsWith(".webp")).map((file) => file.replace(/webp$/, "png")));
  const isLater = (file) => /^engine\/tree\/|^pictures\/|\/looks\.webp$/.test(file);
  const list = (kept) => () => JSON.stringify(kept);
  write("sw.js", readFileSync(join(here, "src/sw.js"), "utf8")
    .replace("/* shell */ []", list(files.filter((file) => !isLater(file))))
    .replace("/* rest */ []", list(files.filter(isLater))));
}

/** Beside each text the same compressed, as file.br: servers can send that (engine/serve.mjs, Caddy and nginx do). */
function compress() {
  for (const file of filesBelow(out).filter((name) => /\.(html|m?js|css|json|wasm|svg)$/.test(name)))
    writeFileSync(`${file}.br`, brotliCompressSync(readFileSync(file), { params: { [constants.BROTLI_PARAM_QUALITY]: 11 } }));
}

const scripts = await bundle();
await shrinkEngine();
mathFonts();
pages(await styles(), scripts);
serviceWorker();
compress();
console.log(`the pages: ${join(out, "index.html")}`);
