// SPDX-License-Identifier: MIT
/**
 * Registers the service worker: after the first visit the pages work without a net. Browsers allow it by HTTPS and on
 * localhost, and never from a file. `lab` ("05"): keeps also what other looks of this lab need, unless the user saves data.
 */
export async function keepOffline(script, lab) {
  if (!("serviceWorker" in navigator) || !location.protocol.startsWith("http") || !window.isSecureContext) return;
  try {
    await navigator.serviceWorker.register(script, { updateViaCache: "none" });
    const { active } = await navigator.serviceWorker.ready;
    if (lab && !navigator.connection?.saveData) active.postMessage({ keep: lab });
  } catch {
    // Then the pages need the net, and nothing else changes.
  }
}
