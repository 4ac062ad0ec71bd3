// Takes a PLY file as a solid by Manifold, which repairs nothing: usage: node manifold_check.mjs FILE.ply.
// Prints a line "STATUS GENUS VOLUME", where STATUS is NoError for a closed, oriented 2-manifold.
import { readFileSync } from 'node:fs';
import Module from 'manifold-3d';
import { PLYLoader } from 'three/examples/jsm/loaders/PLYLoader.js';

const bytes = readFileSync(process.argv[2]);
const { index, attributes } = new PLYLoader().parse(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength));
const wasm = await Module();
wasm.setup();
const mesh = new wasm.Mesh({
  numProp: 3,
  vertProperties: new Float32Array(attributes.position.array),
  triVerts: new Uint32Array(index.array),
});
let solid;
try {
  solid = new wasm.Manifold(mesh);
} catch (error) {
  console.log(error.code ?? error.message);
  process.exit(0);
}
console.log(solid.status(), solid.genus(), solid.volume());
