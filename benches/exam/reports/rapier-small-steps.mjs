import RAPIER from "@dimforge/rapier3d-compat";

await RAPIER.init();
for (let n = 64; n <= 16384; n *= 2) {
  const world = new RAPIER.World({ x: 0, y: 0, z: -10 });
  world.timestep = 1 / n;
  world.numSolverIterations = 32;
  world.createCollider(RAPIER.ColliderDesc.cuboid(100, 100, 1).setTranslation(0, 0, -1).setFriction(0.15));
  const body = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setTranslation(0, 0, 0.1).setCanSleep(false).lockRotations());
  world.createCollider(RAPIER.ColliderDesc.cuboid(0.1, 0.1, 0.1).setFriction(0.15).setMass(1), body);
  for (let i = 0; i < n / 2; i++) world.step();
  body.setTranslation({ x: 0, y: 0, z: body.translation().z }, true);
  body.setLinvel({ x: 0, y: 1, z: 0 }, true);
  for (let i = 0; i < 2 * n; i++) {
    body.resetForces(true);
    body.addForce({ x: 1, y: 0, z: 0 }, true);
    world.step();
  }
  const { x, y } = body.translation();
  console.log(`step 1/${n}  distance ${Math.hypot(x, y).toFixed(7)}  error ${Math.abs(Math.hypot(x, y) - 0.425).toExponential(1)}`);
  world.free();
}
