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
  bumps.anisotropy = 8;
  scene.background = environment;
  scene.add(new THREE.Mesh(new THREE.SphereGeometry(1, 128, 64), new THREE.MeshPhongMaterial({ color: 0xffffff, envMap: environment, normalMap: bumps })));
  draw();
  const first = performance.now();
  const bytes = [...performance.getEntriesByType("navigation"), ...performance.getEntriesByType("resource")]
    .reduce((sum, entry) => sum + (entry.encodedBodySize || 0), 0);
  return { first_picture_ms: first, bytes };
}

window.peer = { ready: start(), draw };
