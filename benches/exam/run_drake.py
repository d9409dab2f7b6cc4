#!/usr/bin/env python3
"""Drake: a discrete MultibodyPlant; a box on three prismatic joints, a free ball; contact at points."""

import numpy as np
import pydrake
from pydrake.geometry import Box, HalfSpace, Sphere, ProximityProperties, AddContactMaterial
from pydrake.math import RigidTransform
from pydrake.multibody.plant import AddMultibodyPlantSceneGraph, CoulombFriction
from pydrake.multibody.tree import FixedOffsetFrame, PrismaticJoint, SpatialInertia, UnitInertia
from pydrake.systems.analysis import Simulator
from pydrake.systems.framework import DiagramBuilder
import importlib.metadata

import examlib as E


def build(s, step, approximation):
    builder = DiagramBuilder()
    plant, graph = AddMultibodyPlantSceneGraph(builder, time_step=step)
    if approximation:
        plant.set_discrete_contact_approximation(approximation)
    plant.mutable_gravity_field().set_gravity_vector([0, 0, -E.G])
    friction = CoulombFriction(s["mu"], s["mu"])
    plant.RegisterCollisionGeometry(plant.world_body(), RigidTransform(), HalfSpace(), "floor", friction)
    if s["kind"] == "ball":
        body = plant.AddRigidBody("body", SpatialInertia(1.0, [0, 0, 0], UnitInertia.SolidSphere(E.RADIUS)))
        plant.RegisterCollisionGeometry(body, RigidTransform(), Sphere(E.RADIUS), "ball", friction)
    else:
        # A point of contact that cannot turn: the inner bodies weigh nothing that counts.
        inertia = SpatialInertia(1.0, [0, 0, 0], UnitInertia.SolidBox(0.2, 0.2, 0.2))
        none = SpatialInertia(0.0, [0, 0, 0], UnitInertia(0, 0, 0))
        a, b2, body = plant.AddRigidBody("a", none), plant.AddRigidBody("b", none), plant.AddRigidBody("body", inertia)
        jx = plant.AddJoint(PrismaticJoint("x", plant.world_frame(), a.body_frame(), [1, 0, 0]))
        jy = plant.AddJoint(PrismaticJoint("y", a.body_frame(), b2.body_frame(), [0, 1, 0]))
        plant.AddJoint(PrismaticJoint("z", b2.body_frame(), body.body_frame(), [0, 0, 1]))
        plant.AddJointActuator("ux", jx)
        plant.AddJointActuator("uy", jy)
        plant.RegisterCollisionGeometry(body, RigidTransform(), Sphere(0.1), "foot", friction)
    plant.Finalize()
    return builder.Build(), plant, body


def simulate(approximation=None):
    def run(s, step):
        n, step = E.steps(s, step)
        diagram, plant, body = build(s, step, approximation)
        simulator = Simulator(diagram)
        context = simulator.get_mutable_context()
        inner = plant.GetMyMutableContextFromRoot(context)
        ball = s["kind"] == "ball"
        state = np.zeros(plant.num_multibody_states())
        if ball:
            state[0], state[6] = 1.0, E.RADIUS
        else:
            state[2] = 0.1
        plant.SetPositionsAndVelocities(inner, state)
        push = plant.get_actuation_input_port()
        if not ball:
            push.FixValue(inner, [0.0, 0.0])
        settle = max(1, round(0.5 / step))
        simulator.AdvanceTo(settle * step)
        state = plant.GetPositionsAndVelocities(inner).copy()
        if ball:
            state[4], state[5], state[7:] = 0.0, 0.0, 0.0
            state[10], state[11] = s["v"]
        else:
            state[0], state[1] = s["x"]
            state[3], state[4], state[5] = *s["v"], 0.0
        plant.SetPositionsAndVelocities(inner, state)
        path = E.Path(s)
        at, to = ((4, 5), (10, 11)) if ball else ((0, 1), (3, 4))
        x, y = s["x"]
        vx, vy = s["v"]
        for i in range(n):
            if not ball:
                push.FixValue(inner, list(E.pull(s, i * step, x, y, vx, vy)))
            simulator.AdvanceTo((settle + i + 1) * step)
            q = plant.GetPositionsAndVelocities(inner)
            x, y, vx, vy = float(q[at[0]]), float(q[at[1]]), float(q[to[0]]), float(q[to[1]])
            path.note((i + 1) * step, step, x, y, vx, vy)
        return path

    return run


PROMISES = "Friction regularised so that a body held by it creeps with a velocity that falls with the time step; convex and exact cone."

if __name__ == "__main__":
    from pydrake.multibody.plant import DiscreteContactApproximation as Approximation

    version = importlib.metadata.version("drake")
    E.main(
        "drake.json",
        [
            dict(name="Drake", version=version, settings="as it comes", promises=PROMISES, simulate=simulate()),
            dict(name="Drake", version=version, settings="tuned: contact approximation SAP", promises=PROMISES, simulate=simulate(Approximation.kSap)),
        ],
    )
