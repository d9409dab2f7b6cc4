// Rapier: one set-up from the command line, one line of JSON back. See examlib.py for the fields.
import RAPIER from "@dimforge/rapier3d-compat";
import { createRequire } from "node:module";

const log = console.log;
console.log = console.warn = () => {};
await RAPIER.init();
const { spec: s, n, step, iterations } = JSON.parse(process.argv[2]);
const begin = process.cpuUsage();
const world = new RAPIER.World({ x: 0, y: 0, z: -10 });
world.timestep = step;
if (iterations) world.numSolverIterations = iterations;
const material = (c) => c.setFriction(s.mu).setRestitution(0);
world.createCollider(material(RAPIER.ColliderDesc.cuboid(100, 100, 1).setTranslation(0, 0, -1)));
const ball = s.kind === "ball";
const z = ball ? 0.5 : 0.1;
const desc = RAPIER.RigidBodyDesc.dynamic().setTranslation(0, 0, z).setCanSleep(false).setLinearDamping(0).setAngularDamping(0);
if (!ball) desc.lockRotations();
const body = world.createRigidBody(desc);
world.createCollider(material(ball ? RAPIER.ColliderDesc.ball(0.5) : RAPIER.ColliderDesc.cuboid(0.1, 0.1, 0.1)).setMass(1), body);
for (let i = 0; i < Math.max(1, Math.round(0.5 / step)); i++) world.step();
body.setTranslation({ x: s.x[0], y: s.x[1], z: body.translation().z }, true);
body.setLinvel({ x: s.v[0], y: s.v[1], z: 0 }, true);
body.setAngvel({ x: 0, y: 0, z: 0 }, true);
let [x, y] = s.x, [vx, vy] = s.v, travelled = 0, before = null;
for (let i = 0; i < n; i++) {
  const t = i * step;
  const ax = s.c + s.r * t + s.s * Math.sin(t) + s.k * (x + 2 * vy);
  const ay = s.k * (y - 2 * vx);
  body.resetForces(true);
  body.addForce({ x: ax, y: ay, z: 0 }, true);
  world.step();
  if (t + step > s.until - s.window + 0.5 * step && before === null) before = x;
  const last = x;
  ({ x, y } = body.translation());
  const v = body.linvel();
  (vx = v.x), (vy = v.y);
  if (before !== null) travelled += Math.abs(x - last);
}
const used = process.cpuUsage(begin);
log(JSON.stringify({ x, y, vx, vy, travelled, way: x - (before ?? 0), cpu: (used.user + used.system) / 1e6 }));
