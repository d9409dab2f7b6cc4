#!/usr/bin/env python3
"""Siconos (Debian's python3-siconos): Moreau and Jean's time stepping, a contact with Coulomb's cone; the ball is seen from the side."""

import numpy as np
import siconos.kernel as sk
import siconos.numerics as sn

import examlib as E


def simulate(theta, tolerance):
    def run(s, step):
        n, step = E.steps(s, step)
        ball = s["kind"] == "ball"
        if ball:
            # Along, up, and the angle; the point of contact moves with v - R omega.
            mass, h = np.diag([1.0, 1.0, 0.4 * E.RADIUS**2]), np.array([[0.0, 1.0, 0.0], [1.0, 0.0, -E.RADIUS]])
            x, v, weight = [s["x"][0], 0.0, 0.0], [s["v"][0], 0.0, 0.0], np.array([0.0, -E.G, 0.0])
        else:
            mass, h = np.eye(3), np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
            x, v, weight = [*s["x"], 0.0], [*s["v"], 0.0], np.array([0.0, 0.0, -E.G])
        body = sk.LagrangianLinearTIDS(x, v, mass)
        force = sk.SiconosVector(weight)
        body.setFExtPtr(force)
        size = len(h)
        contact = sk.Interaction(sk.NewtonImpactFrictionNSL(0.0, 0.0, s["mu"], size), sk.LagrangianLinearTIR(h))
        model = sk.NonSmoothDynamicalSystem(0.0, s["until"])
        model.insertDynamicalSystem(body)
        model.link(contact, body)
        solver = sk.FrictionContact(size)
        if tolerance:
            solver.numericsSolverOptions().dparam[sn.SICONOS_DPARAM_TOL] = tolerance
        stepping = sk.TimeStepping(model, sk.TimeDiscretisation(0.0, step), sk.MoreauJeanOSI(theta), solver)
        path = E.Path(s)
        q, w = body.q(), body.velocity()
        for i in range(n):
            if not ball:
                # The force in the middle of the step.
                for axis, a in enumerate(E.pull(s, (i + 0.5) * step, q[0], q[1], w[0], w[1])):
                    force.setValue(axis, a)
            stepping.computeOneStep()
            stepping.nextStep()
            q, w = body.q(), body.velocity()
            y, vy = (0.0, 0.0) if ball else (q[1], w[1])
            path.note((i + 1) * step, step, q[0], y, w[0], vy)
        return path

    return run


PROMISES = "Coulomb's law as a cone, solved at each step to a tolerance; sticking exactly; first order in the step where friction changes."

if __name__ == "__main__":
    version = "4.4.0+dfsg-2, Debian bookworm"
    E.main(
        "siconos.json",
        [
            dict(name="Siconos", version=version, settings="as its runner has it: θ = 0.50001", promises=PROMISES, simulate=simulate(0.50001, None)),
            dict(name="Siconos", version=version, settings="tuned: θ = 1/2, solver's tolerance 10⁻¹⁴", promises=PROMISES, simulate=simulate(0.5, 1e-14)),
        ],
    )
