// SPDX-License-Identifier: MIT
// The engine's thread: it owns the canvas and the C++, and answers calls one after the other. So a slow or endless shader
// stops this thread, and never the page.
const here = new URL(".", import.meta.url);
// All that the engine is made of is asked for at once; `start` waits for it.
const glue = import("./engine.mjs");
const program = fetch(new URL("engine.wasm", here)).then((answer) => answer.arrayBuffer()).then(WebAssembly.compile);
const tree = fetch(new URL("files.json", here)).then((answer) => answer.json());
for (const promise of [glue, program, tree]) promise.catch(() => {});  // `start` says what failed

let module, canvas, gl, bytes = 0, firstPicture = null, frameMs = 0, timeOrigin = performance.timeOrigin;
let unread;  // paths of the files that nobody has read
const ahead = new Map();  // files that came before the C++ asked for them

/// The tree as the C++ sees it, in /tree: texts are there at once, other files are loaded when they are first read.
function mount(FS, listing) {
  const folderOf = (path) => path.slice(0, path.lastIndexOf("/"));
  for (const [path, text] of Object.entries(listing.texts)) {
    FS.mkdirTree(folderOf(`/tree/${path}`));
    FS.writeFile(`/tree/${path}`, text);
  }
  for (const [path, size] of Object.entries(listing.files)) {
    const file = `/tree/${path}`;
    FS.mkdirTree(folderOf(file));
    FS.writeFile(file, "");
    const node = FS.lookupPath(file).node;
    let contents = null;
    Object.defineProperty(node, "contents", {
      get: () => (contents ??= load(path, size)),
      set: (value) => (contents = value),
    });
    node.usedBytes = size;
  }
}

/// Loads the files of these parameters' values side by side: the C++ would ask for one after the other. A `cube_map`
/// "scene" is all of assets/cube_maps/scene; what is no map and no model lies in assets/textures.
async function loadAhead(values) {
  const wanted = Object.entries(values).flatMap(([name, value]) => {
    const folder = [...unread].some((path) => path.startsWith(`assets/${name}s/`)) ? `${name}s` : "textures";
    return [...unread].filter((path) => [".", "/"].some((end) => path.startsWith(`assets/${folder}/${value}${end}`)));
  });
  await Promise.all(wanted.map(async (path) => {
    unread.delete(path);
    const answer = await fetch(new URL(`tree/${path}`, here)).catch(() => null);
    if (answer?.ok) ahead.set(path, new Uint8Array(await answer.arrayBuffer()));
  }));
}

/// The C++ waits for the file, so this is the one place for a request that blocks; a worker may do that.
function load(path, size) {
  unread.delete(path);
  bytes += size;
  const early = ahead.get(path);
  if (early?.length === size) {
    ahead.delete(path);
    return early;
  }
  const request = new XMLHttpRequest();
  request.open("GET", new URL(`tree/${path}`, here), false);
  request.responseType = "arraybuffer";
  request.send();
  const data = new Uint8Array(request.response ?? 0);
  if (data.length !== size) throw new Error(`cannot load ${path} (${request.status})`);
  return data;
}

async function start(options) {
  timeOrigin = options.timeOrigin;
  const listing = await tree, { default: createEngine } = await glue, compiled = await program;
  unread = new Set(Object.keys(listing.files));
  canvas = options.canvas ?? new OffscreenCanvas(16, 16);
  gl = canvas.getContext("webgl2", { alpha: false, antialias: false, depth: false, stencil: false });
  if (!gl) throw { message: "This browser has no WebGL 2. Use a current Firefox, Chrome, Edge or Safari.", kind: "failed" };
  for (const name of ["EXT_color_buffer_float", "EXT_texture_filter_anisotropic", "WEBGL_debug_renderer_info"])
    gl.getExtension(name);
  canvas.addEventListener("webglcontextlost", (event) => {
    event.preventDefault();
    postMessage({ lost: "The browser took the graphics away." });
  });
  module = await createEngine({
    preRun: [(m) => { mount(m.FS, listing); m.FS.chdir("/tree"); m.ENV.TEXEL_ROOT = "/tree"; m.ENV.TEXEL_THREADS = "1"; }],
    instantiateWasm: (imports, done) => {
      WebAssembly.instantiate(compiled, imports).then((instance) => done(instance, compiled));
      return {};
    },
    print: () => {},
    printErr: (text) => console.warn(text),
  });
  module.GL.makeContextCurrent(module.GL.registerContext(gl, { majorVersion: 2, minorVersion: 0, enableExtensionsByDefault: 1 }));
  for (const entry of performance.getEntriesByType("resource"))
    if (!entry.name.includes("/tree/")) bytes += entry.encodedBodySize;
  return { kind: listing.kind, labs: listing.labs };
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
  draw: (args) => picture(ask("draw", args)),
  shown: (args) => picture(ask("shown", args)),
  compare(args) {
    const { result, pictures: [own, expected, difference, heat_map] } = ask("compare", args);
    return result && { ...result, own, expected, difference, heat_map };
  },
  figures: () => ({
    first_picture_ms: firstPicture,
    frame_ms: frameMs,
    bytes,
    renderer: gl.getParameter(0x9246) ?? gl.getParameter(gl.RENDERER),
  }),
  lose: () => gl.getExtension("WEBGL_lose_context")?.loseContext(),
};

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
