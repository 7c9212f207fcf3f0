// SPDX-License-Identifier: MIT
/**
 * Registers the service worker: after the first visit the pages work without a net. Browsers allow it by HTTPS and on
 * localhost, and never from a file. `all`: also what only other looks and labs need, unless the user saves data.
 */
export async function keepOffline(script, all) {
  if (!("serviceWorker" in navigator) || !location.protocol.startsWith("http") || !window.isSecureContext) return;
  try {
    await navigator.serviceWorker.register(script, { updateViaCache: "none" });
    const { active } = await navigator.serviceWorker.ready;
    if (all && !navigator.connection?.saveData) active.postMessage("keep the rest");
  } catch {
    // Then the pages need the net, and nothing else changes.
  }
}
