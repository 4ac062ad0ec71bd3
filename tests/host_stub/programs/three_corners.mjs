// Opens a mesh by three.js and writes what it sees: usage: node three_corners.mjs FILE OUT. OUT gets a line
// "x y z r g b" for each corner of each triangle: its place in three.js's world, where y is up, and its colour
// in linear light, which three.js works in.
import { readFileSync, writeFileSync } from 'node:fs';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';
import { OBJLoader } from 'three/examples/jsm/loaders/OBJLoader.js';
import { PLYLoader } from 'three/examples/jsm/loaders/PLYLoader.js';
import { Group, Mesh, Vector3 } from 'three';

const [file, out] = process.argv.slice(2);
const bytes = readFileSync(file);
const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);

async function load() {
  if (file.endsWith('.ply')) return new Group().add(new Mesh(new PLYLoader().parse(buffer)));
  if (file.endsWith('.obj')) return new OBJLoader().parse(bytes.toString());
  return (await new GLTFLoader().parseAsync(buffer, '')).scene;
}

const scene = await load();
scene.updateMatrixWorld(true);
const lines = [];
scene.traverse((thing) => {
  if (!thing.isMesh) return;
  const { index, attributes } = thing.geometry;
  const corners = index ? index.count : attributes.position.count;
  for (let i = 0; i < corners; ++i) {
    const vertex = index ? index.getX(i) : i;
    const place = new Vector3().fromBufferAttribute(attributes.position, vertex).applyMatrix4(thing.matrixWorld);
    const colour = new Vector3().fromBufferAttribute(attributes.color, vertex);
    lines.push([...place.toArray(), ...colour.toArray()].join(' '));
  }
});
writeFileSync(out, lines.join('\n') + '\n');
