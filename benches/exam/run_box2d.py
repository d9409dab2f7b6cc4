#!/usr/bin/env python3
"""Box2D (pybox2d): the tasks that happen on a line, seen from the side; the ball's moment of inertia is that of a solid ball."""

import Box2D as b2

import examlib as E


def simulate(velocity_iterations, position_iterations):
    def run(s, step):
        n, step = E.steps(s, step)
        world = b2.b2World(gravity=(0, -E.G), doSleep=False)
        floor = world.CreateStaticBody(position=(0, 0))
        floor.CreateEdgeFixture(vertices=[(-100, 0), (100, 0)], friction=s["mu"])
        ball = s["kind"] == "ball"
        z = E.RADIUS if ball else 0.1
        body = world.CreateDynamicBody(position=(0, z), fixedRotation=not ball, linearDamping=0, angularDamping=0)
        if ball:
            body.CreateCircleFixture(radius=E.RADIUS, density=1, friction=s["mu"])
            body.massData = b2.b2MassData(mass=1, center=(0, 0), I=0.4 * E.RADIUS**2)
        else:
            body.CreatePolygonFixture(box=(0.1, 0.1), density=25, friction=s["mu"])
        for _ in range(max(1, round(0.5 / step))):
            world.Step(step, velocity_iterations, position_iterations)
        body.position = (s["x"][0], body.position[1])
        body.linearVelocity = (s["v"][0], 0)
        body.angularVelocity = 0
        mass = body.mass
        path = E.Path(s)
        for i in range(n):
            x, vx = body.position[0], body.linearVelocity[0]
            ax, _ = E.pull(s, i * step, x, 0.0, vx, 0.0)
            body.ApplyForceToCenter((mass * ax, 0), True)
            world.Step(step, velocity_iterations, position_iterations)
            path.note((i + 1) * step, step, body.position[0], 0.0, body.linearVelocity[0], 0.0)
        return path

    return run


PROMISES = "A two-dimensional engine for games, in single precision; Coulomb friction by sequential impulses."

if __name__ == "__main__":
    E.main(
        "box2d.json",
        [
            dict(name="Box2D", version=b2.__version__, settings="as the manual has it: 8 and 3 iterations", promises=PROMISES, tasks=E.ON_A_LINE, simulate=simulate(8, 3)),
            dict(name="Box2D", version=b2.__version__, settings="tuned: 50 and 20 iterations", promises=PROMISES, tasks=E.ON_A_LINE, simulate=simulate(50, 20)),
        ],
    )
