// SPDX-License-Identifier: MIT
// The net first, what was kept second: the pages are always the newest, and work without a net after the first visit. What
// every page needs is kept at once; what a lab needs besides (pictures, models) when its page has drawn and says so. The
// build fills in both lists.
const kept = "texel-labs";
const shell = /* shell */ [];
const rest = /* rest */ [];

self.addEventListener("install", (event) => {
  self.skipWaiting();
  event.waitUntil(caches.open(kept).then((cache) => Promise.all(shell.map((file) => cache.add(file).catch(() => {})))));
});
self.addEventListener("activate", (event) => event.waitUntil(self.clients.claim()));

self.addEventListener("fetch", (event) => {
  const { request } = event;
  if (request.method !== "GET" || !request.url.startsWith(self.registration.scope)) return;
  event.respondWith(answer(request));
});

self.addEventListener("message", (event) => {
  if (event.data.keep) event.waitUntil(keepRest(event.data.keep));
});

/** The lab whose file it is ("05"), or nothing: textures and models are of all. */
const labOf = (file) => /(?:^|\/)(\d\d)_\w+[/.]/.exec(file)?.[1] ?? /steps\/(\d)\./.exec(file)?.[1].padStart(2, "0");

/** What a lab needs, one file after the other: what a user does meanwhile comes first. */
async function keepRest(lab) {
  const cache = await caches.open(kept);
  for (const file of rest) {
    if ((labOf(file) ?? lab) !== lab) continue;
    const url = new URL(file, self.registration.scope).href;
    if (!(await cache.match(url))) await cache.add(url).catch(() => {});
  }
}

/** A page's address with a look in it is the same file. */
const address = (request) => request.url.split(/[?#]/)[0];

async function answer(request) {
  const cache = await caches.open(kept);
  try {
    const fresh = await fetch(request);
    if (fresh.ok && fresh.status === 200) cache.put(address(request), fresh.clone());
    return fresh;
  } catch (error) {
    const old = await cache.match(address(request));
    if (old) return old;
    throw error;
  }
}
