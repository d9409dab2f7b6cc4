#!/usr/bin/env python3
"""PyBullet: a box whose rotation is locked, a ball; damping off in both, since it is no friction."""

import pybullet as p

import examlib as E


def simulate(**engine):
    def run(s, step):
        n, step = E.steps(s, step)
        client = p.connect(p.DIRECT)
        try:
            p.setGravity(0, 0, -E.G)
            p.setPhysicsEngineParameter(fixedTimeStep=step, numSubSteps=1, **engine)
            floor = p.createMultiBody(0, p.createCollisionShape(p.GEOM_PLANE))
            p.changeDynamics(floor, -1, lateralFriction=1.0)
            ball = s["kind"] == "ball"
            shape = p.createCollisionShape(p.GEOM_SPHERE, radius=E.RADIUS) if ball else p.createCollisionShape(p.GEOM_BOX, halfExtents=[0.1] * 3)
            z = E.RADIUS if ball else 0.1
            body = p.createMultiBody(1.0, shape, basePosition=[0, 0, z])
            p.changeDynamics(body, -1, lateralFriction=s["mu"], linearDamping=0, angularDamping=0, rollingFriction=0, spinningFriction=0)
            if not ball:
                p.changeDynamics(body, -1, localInertiaDiagonal=[0, 0, 0])
            for _ in range(max(1, round(0.5 / step))):
                p.stepSimulation()
            (_, _, z), turn = p.getBasePositionAndOrientation(body)
            p.resetBasePositionAndOrientation(body, [*s["x"], z], turn)
            p.resetBaseVelocity(body, [*s["v"], 0], [0, 0, 0])
            path = E.Path(s)
            x, y = s["x"]
            vx, vy = s["v"]
            for i in range(n):
                ax, ay = E.pull(s, i * step, x, y, vx, vy)
                p.applyExternalForce(body, -1, [ax, ay, 0], [x, y, z], p.WORLD_FRAME)
                p.stepSimulation()
                (x, y, z), _ = p.getBasePositionAndOrientation(body)
                (vx, vy, _), _ = p.getBaseVelocity(body)
                path.note((i + 1) * step, step, x, y, vx, vy)
            return path
        finally:
            p.disconnect(client)

    return run


PROMISES = "Real-time simulation; friction along two axes of each contact by default, as a cone on request."

if __name__ == "__main__":
    version = str(p.getAPIVersion())
    E.main(
        "pybullet.json",
        [
            dict(name="PyBullet", version="3.2.7", settings="as it comes", promises=PROMISES, simulate=simulate()),
            dict(name="PyBullet", version="3.2.7", settings="tuned: cone friction, 200 iterations to 1e-12",
                 promises=PROMISES, simulate=simulate(enableConeFriction=1, numSolverIterations=200, solverResidualThreshold=1e-12)),
        ],
    )
