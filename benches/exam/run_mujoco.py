#!/usr/bin/env python3
"""MuJoCo: a box on three slide joints (it cannot turn), a free ball; both cones, as they come and tuned."""

import mujoco

import examlib as E

XML = """
<mujoco>
  <option timestep="{step}" gravity="0 0 -10" cone="{cone}" {option}/>
  <worldbody>
    <geom name="floor" type="plane" size="50 50 1" friction="{mu} 0 0" condim="3" {contact}/>
    <body name="body" pos="{x} {y} {z}">{inside}</body>
  </worldbody>
</mujoco>"""
BLOCK = """<joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 1 0"/><joint type="slide" axis="0 0 1"/>
<geom type="box" size="0.1 0.1 0.1" mass="1" friction="{mu} 0 0" condim="3" {contact}/>"""
BALL = """<freejoint/><geom type="sphere" size="0.5" mass="1" friction="{mu} 0 0" condim="3" {contact}/>"""


def simulate(cone, option="", contact=""):
    def run(s, step):
        n, step = E.steps(s, step)
        ball = s["kind"] == "ball"
        inside = (BALL if ball else BLOCK).format(mu=s["mu"], contact=contact)
        xml = XML.format(step=step, cone=cone, option=option, contact=contact, mu=s["mu"], inside=inside, x=0, y=0, z=E.RADIUS if ball else 0.1)
        m = mujoco.MjModel.from_xml_string(xml)
        d = mujoco.MjData(m)
        # Let the contact settle before the question begins.
        for _ in range(max(1, round(1.0 / step))):
            mujoco.mj_step(m, d)
        d.time = 0.0
        d.qvel[:] = 0.0
        d.qpos[0], d.qpos[1] = s["x"]
        d.qvel[0], d.qvel[1] = s["v"]
        path = E.Path(s)
        force = d.xfrc_applied[1]
        q, v = d.qpos, d.qvel
        for i in range(n):
            x, y, vx, vy = float(q[0]), float(q[1]), float(v[0]), float(v[1])
            force[0], force[1] = E.pull(s, i * step, x, y, vx, vy)
            mujoco.mj_step(m, d)
            path.note((i + 1) * step, step, float(q[0]), float(q[1]), float(v[0]), float(v[1]))
        return path

    return run


PROMISES = "Soft contacts with regularised friction: a body under a steady pull creeps by design; 'impratio' and 'solref' say how much."
TUNED = dict(option='impratio="100" solver="Newton" iterations="200" tolerance="1e-12"', contact='solref="0.004 1" solimp="0.99 0.999 0.001"')

if __name__ == "__main__":
    E.main(
        "mujoco.json",
        [
            dict(name="MuJoCo, pyramidal cone", version=mujoco.__version__, settings="as it comes", promises=PROMISES, simulate=simulate("pyramidal")),
            dict(name="MuJoCo, elliptic cone", version=mujoco.__version__, settings="as it comes", promises=PROMISES, simulate=simulate("elliptic")),
            dict(name="MuJoCo, elliptic cone", version=mujoco.__version__, settings="tuned: impratio 100, solref 0.004, solimp 0.99 0.999, 200 iterations to 1e-12",
                 promises=PROMISES, simulate=simulate("elliptic", **TUNED)),
        ],
    )
