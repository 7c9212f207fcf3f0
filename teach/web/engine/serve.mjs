// SPDX-License-Identifier: MIT
// node teach/web/engine/serve.mjs FOLDER [PORT]: serves a folder on this machine, compressed as most hosts do. Prints the link.
import { createReadStream, statSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";
import { createGzip } from "node:zlib";

const types = {
  ".html": "text/html; charset=utf-8", ".mjs": "text/javascript", ".js": "text/javascript", ".css": "text/css",
  ".json": "application/json", ".wasm": "application/wasm", ".svg": "image/svg+xml", ".png": "image/png", ".jpg": "image/jpeg", ".webp": "image/webp",
  ".woff2": "font/woff2", ".webmanifest": "application/manifest+json",
};
const isSmaller = (type) => /^(text|application)\/|svg/.test(type);

/** Serves a folder below `prefix`; gives {url, close}. Port 0 is any that is free. */
export async function serve(folder, prefix = "/", port = 0) {
  const server = createServer((request, response) => {
    const path = decodeURIComponent(new URL(request.url, "http://localhost").pathname);
    let file = path.startsWith(prefix) ? join(folder, normalize(`/${path.slice(prefix.length)}`)) : null;
    let status = file === null ? null : statSync(file, { throwIfNoEntry: false });
    if (status?.isDirectory()) {
      file = join(file, "index.html");
      status = statSync(file, { throwIfNoEntry: false });
    }
    if (!status?.isFile()) {
      response.writeHead(404).end("There is no such file.");
      return;
    }
    const type = types[extname(file)] ?? "application/octet-stream";
    const head = { "content-type": type, "cache-control": "no-cache" };
    const accepted = request.headers["accept-encoding"] ?? "", packed = statSync(`${file}.br`, { throwIfNoEntry: false });
    if (packed && /\bbr\b/.test(accepted)) {
      response.writeHead(200, { ...head, "content-encoding": "br", "content-length": packed.size, vary: "accept-encoding" });
      if (request.method === "HEAD") response.end();
      else createReadStream(`${file}.br`).pipe(response);
      return;
    }
    const zips = isSmaller(type) && /\bgzip\b/.test(accepted);
    if (zips) response.writeHead(200, { ...head, "content-encoding": "gzip", vary: "accept-encoding" });
    else response.writeHead(200, { ...head, "content-length": status.size });
    if (request.method === "HEAD") response.end();
    else if (zips) createReadStream(file).pipe(createGzip()).pipe(response);
    else createReadStream(file).pipe(response);
  });
  await new Promise((done) => server.listen(port, "127.0.0.1", done));
  return {
    url: `http://localhost:${server.address().port}${prefix}`,
    close() {
      server.closeAllConnections?.();
      server.close();
    },
  };
}

if (process.argv[1] === new URL(import.meta.url).pathname) {
  const [folder, port = "8080"] = process.argv.slice(2);
  const { url } = await serve(folder, "/", Number(port));
  console.log(`open ${url}   (Ctrl+C ends it)`);
}
