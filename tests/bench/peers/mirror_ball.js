// SPDX-License-Identifier: MIT
// Lab 9's default look by three.js: a mirror ball with the same cube map and normal map, seen alike.
import * as THREE from "three";

const antialias = new URL(location.href).searchParams.has("antialias");
const canvas = document.querySelector("canvas");
const renderer = new THREE.WebGLRenderer({ canvas, antialias });
renderer.setSize(canvas.width, canvas.height, false);

const scene = new THREE.Scene();
const camera = new THREE.PerspectiveCamera(60, 1, 0.1, 100);
camera.position.set(0, 0, 2.5);
camera.lookAt(0, 0, 0);

/** Draws, and waits until it is done. */
function draw() {
  const begin = performance.now();
  renderer.render(scene, camera);
  const gl = renderer.getContext();
  gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  return performance.now() - begin;
}

async function start() {
  const [environment, bumps] = await Promise.all([
    new THREE.CubeTextureLoader().setPath("assets/cube_maps/scene/").loadAsync(["px.png", "nx.png", "py.png", "ny.png", "pz.png", "nz.png"]),
    new THREE.TextureLoader().loadAsync("assets/normal_maps/bump.png"),
  ]);
  bumps.wrapS = bumps.wrapT = THREE.RepeatWrapping;
  bumps.repeat.set(2, 2);
  // Where lab 9's lie: u is 0 in front and grows to the left, v grows down.
  bumps.rotation = Math.PI;
  bumps.offset.set(0.5, 0);
  scene.background = environment;
  // MixOperation: the mirror's colour alone. The default multiplies it by the light, and there is none.
  const mirror = new THREE.MeshPhongMaterial({ envMap: environment, combine: THREE.MixOperation, normalMap: bumps, normalScale: new THREE.Vector2(0.4, 0.4) });
  scene.add(new THREE.Mesh(new THREE.SphereGeometry(1, 128, 64), mirror));
  draw();
  const first = performance.now();
  const bytes = [...performance.getEntriesByType("navigation"), ...performance.getEntriesByType("resource")]
    .reduce((sum, entry) => sum + (entry.encodedBodySize || 0), 0);
  return { first_picture_ms: first, bytes };
}

window.peer = { ready: start(), draw };
