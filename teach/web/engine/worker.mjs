// SPDX-License-Identifier: MIT
// The engine's thread: it owns the canvas and the C++, and answers calls one after the other. So a slow or endless shader
// stops this thread, and never the page.
import { asPpm, unpacks } from "./pictures.mjs";

const here = new URL(".", import.meta.url);
// All that the engine is made of is asked for at once; `start` waits for it.
const glue = import("./engine.mjs");
const engine = new URL("engine.wasm", here);
const program = WebAssembly.compileStreaming(fetch(engine))
  .catch(() => fetch(engine).then((answer) => answer.arrayBuffer()).then(WebAssembly.compile));  // of a server that calls it otherwise
const tree = fetch(new URL("files.json", here)).then((answer) => answer.json());
for (const promise of [glue, program, tree]) promise.catch(() => {});  // `start` says what failed

const kHidden = 500;  // milliseconds without a frame after which nobody looks

let module, canvas, gl, firstPicture = null, frameMs = 0, timeOrigin = performance.timeOrigin;
let unread;  // paths of the files that nobody has read
let packed = new Set();  // paths of the PNGs that come as WebP
const ahead = new Map();  // files that came before the C++ asked for them
let coming = Promise.resolve();  // those that were asked for

/// The tree as the C++ sees it, in /tree: texts are there at once, other files are loaded when they are first read.
function mount(FS, { texts, files }) {
  const folders = new Map();
  const add = (path) => {
    const slash = path.lastIndexOf("/"), folder = path.slice(0, slash);
    if (!folders.has(folder)) {
      FS.mkdirTree(`/tree/${folder}`);
      folders.set(folder, FS.lookupPath(`/tree/${folder}`).node);
    }
    // As FS.writeFile, which looks each path up several times.
    const parent = folders.get(folder);
    return parent.node_ops.mknod(parent, path.slice(slash + 1), 0o100666, 0);
  };
  const encoder = new TextEncoder();
  for (const [path, text] of Object.entries(texts)) {
    const node = add(path);
    node.contents = encoder.encode(text);
    node.usedBytes = node.contents.length;
  }
  for (const [path, size] of Object.entries(files)) {
    const node = add(path);
    let contents = null;
    Object.defineProperty(node, "contents", {
      get: () => (contents ??= load(path)),
      set: (value) => (contents = value),
    });
    // A picture is another file when it comes as WebP: its size is known when it is there.
    Object.defineProperty(node, "usedBytes", {
      get: () => (contents === null && !packed.has(path) ? size : node.contents.length),
      set() {},
    });
  }
}

async function fetched(path) {
  const answer = await fetch(new URL(`tree/${path}`, here));
  if (!answer.ok) throw new Error(`cannot load ${path} (${answer.status})`);
  return answer.arrayBuffer();
}

/// Loads the files of these parameters' values side by side: the C++ would ask for one after the other. A `cube_map`
/// "scene" is all of assets/cube_maps/scene; what is no map and no model lies in assets/textures.
function loadAhead(values) {
  const wanted = Object.entries(values).flatMap(([name, value]) => {
    const folder = [...unread].some((path) => path.startsWith(`assets/${name}s/`)) ? `${name}s` : "textures";
    return [...unread].filter((path) => [".", "/"].some((end) => path.startsWith(`assets/${folder}/${value}${end}`)));
  });
  return (coming = Promise.all([coming, ...wanted.map(async (path) => {
    unread.delete(path);
    try {
      ahead.set(path, packed.has(path) ? await asPpm(await fetched(path.replace(/png$/, "webp"))) : new Uint8Array(await fetched(path)));
    } catch (error) {
      console.warn(error);  // the C++ asks for it again, and says what fails
    }
  })]).then(() => {}));
}

/// The C++ waits for the file, so this is the one place for a request that blocks; a worker may do that.
function load(path) {
  unread.delete(path);
  const early = ahead.get(path);
  if (early) {
    ahead.delete(path);
    return early;
  }
  const request = new XMLHttpRequest();
  request.open("GET", new URL(`tree/${path}`, here), false);
  request.responseType = "arraybuffer";
  request.send();
  if (request.status !== 200) throw new Error(`cannot load ${path} (${request.status})`);
  return new Uint8Array(request.response);
}

/// With `lab`, that lab is opened at once: `opened` is what `open` gives. `files`: the values of its first picture, whose files
/// are loaded meanwhile.
async function start(options) {
  timeOrigin = options.timeOrigin;
  const listing = await tree;
  unread = new Set(Object.keys(listing.files));
  if (unpacks) packed = new Set(listing.packed);
  loadAhead(options.files ?? {});
  const { default: createEngine } = await glue, compiled = await program;
  module = await createEngine({
    preRun: [(m) => { mount(m.FS, listing); m.FS.chdir("/tree"); m.ENV.TEXEL_ROOT = "/tree"; m.ENV.TEXEL_THREADS = "1"; }],
    instantiateWasm: (imports, done) => {
      WebAssembly.instantiate(compiled, imports).then((instance) => done(instance, compiled));
      return {};
    },
    print: () => {},
    printErr: (text) => console.warn(text),
  });
  // The context waits for the page's thread, and each extension for the GPU's process: pictures come meanwhile.
  canvas = options.canvas ?? new OffscreenCanvas(16, 16);
  gl = canvas.getContext("webgl2", { alpha: false, antialias: false, depth: false, stencil: false });
  if (!gl) throw { message: "This browser has no WebGL 2. Use a current Firefox, Chrome, Edge or Safari.", kind: "failed" };
  for (const name of ["EXT_color_buffer_float", "EXT_texture_filter_anisotropic", "OES_texture_float_linear", "WEBGL_debug_renderer_info"])
    gl.getExtension(name);
  canvas.addEventListener("webglcontextlost", (event) => {
    event.preventDefault();
    postMessage({ lost: "The browser took the graphics away." });
  });
  module.GL.makeContextCurrent(module.GL.registerContext(gl, { majorVersion: 2, minorVersion: 0, enableExtensionsByDefault: 0 }));
  return { kind: listing.kind, labs: listing.labs, opened: options.lab === undefined ? null : special.open({ lab: options.lab }) };
}

/// A call to the C++: JSON in and out; pictures come as copies of its memory.
function ask(call, args = {}) {
  const text = JSON.stringify({ call, with: args });
  const length = module.lengthBytesUTF8(text) + 1;
  const at = module._malloc(length);
  module.stringToUTF8(text, at, length);
  const answer = JSON.parse(module.UTF8ToString(module._texel_call(at)));
  module._free(at);
  if (answer.error) throw answer.error;
  const memory = module.HEAPU8.buffer;
  const pictures = answer.buffers.map(({ at, bytes, type }) => {
    const copy = memory.slice(at, at + bytes);
    return type === "f32" ? new Float32Array(copy) : new Uint8Array(copy);
  });
  return { result: answer.result, pictures };
}

const special = {
  start,
  open: (args) => ({ ...ask("open", args).result, parameters: ask("parameters").result, looks: ask("looks").result }),
  async set(values) {
    await loadAhead(values);
    return ask("set", values).result;
  },
  async resize({ width, height }) {
    canvas.width = width;
    canvas.height = height;
    if (firstPicture === null) await loadAhead(ask("values").result.values);
    return ask("resize", { width, height }).result;
  },
  async draw(args) {
    await loadAhead(wanted(args));
    return picture(ask("draw", args));
  },
  async check(args) {
    const steps = ask("steps").result;
    const all = steps.filter(({ id }) => args.step === undefined || id === args.step).flatMap(({ cases }) => cases);
    for (const one of all) await loadAhead(wanted(one));
    return ask("check", args).result;
  },
  compare(args) {
    const { result, pictures: [own, expected, heat_map] } = ask("compare", args);
    return result && { ...result, own, expected, heat_map };
  },
  figures: () => ({
    first_picture_ms: firstPicture,
    frame_ms: frameMs,
    bytes: performance.getEntriesByType("resource").reduce((sum, entry) => sum + entry.encodedBodySize, 0),
    renderer: gl.getParameter(0x9246) ?? gl.getParameter(gl.RENDERER),
  }),
  /// Answers when the browser shows what was drawn last: it takes a picture over at the end of a frame. A hidden page has no frames.
  presented: () => new Promise((done) => {
    requestAnimationFrame(() => requestAnimationFrame(done));
    setTimeout(done, kHidden);
  }),
  lose: () => gl.getExtension("WEBGL_lose_context")?.loseContext(),
};

/// All values of a picture of which `set` says those that are not the defaults.
const wanted = ({ set = {} }) => ({ ...Object.fromEntries(ask("parameters").result.map((p) => [p.name, p.default])), ...set });

const picture = ({ result, pictures: [data] }) => ({ ...result, data });

onmessage = async ({ data: { id, call, args } }) => {
  try {
    const result = await (special[call] ? special[call](args) : ask(call, args).result);
    const report = result?.report ?? result;
    if (report?.drawn) {
      frameMs = report.frame_ms;
      firstPicture ??= performance.timeOrigin + performance.now() - timeOrigin;
    }
    postMessage({ id, result });
  } catch (error) {
    postMessage({ id, error: { message: String(error.message ?? error), kind: "internal", problems: [], ...error } });
  }
};
