import Box2D as b2

for radius in (0.5, 5.0):
    for step in (1 / 64, 1 / 512):
        world = b2.b2World(gravity=(0, -10), doSleep=False)
        floor = world.CreateStaticBody()
        floor.CreateEdgeFixture(vertices=[(-100, 0), (100, 0)], friction=0.1)
        ball = world.CreateDynamicBody(position=(0, radius))
        ball.CreateCircleFixture(radius=radius, density=1, friction=0.1)
        ball.massData = b2.b2MassData(mass=1, center=(0, 0), I=0.4 * radius**2)
        for _ in range(round(0.5 / step)):
            world.Step(step, 8, 3)
        ball.linearVelocity, ball.angularVelocity = (1, 0), 0
        for _ in range(round(1 / step)):
            world.Step(step, 8, 3)
        v, omega = ball.linearVelocity[0], -ball.angularVelocity
        print(f"radius {radius}  step {step:.4f}  height {ball.position[1]:.4f}  v {v:.6f} (5/7 = {5 / 7:.6f})  v/omega {v / omega:.4f}")
