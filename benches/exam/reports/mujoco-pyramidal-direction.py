import math

import mujoco

XML = """
<mujoco>
  <option timestep="{step}" gravity="0 0 -10" cone="{cone}" impratio="{impratio}"/>
  <worldbody>
    <geom type="plane" size="50 50 1" friction="{mu} 0 0" condim="3" {contact}/>
    <body pos="0 0 0.1">
      <joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 1 0"/><joint type="slide" axis="0 0 1"/>
      <geom type="box" size="0.1 0.1 0.1" mass="1" friction="{mu} 0 0" condim="3" {contact}/>
    </body>
  </worldbody>
</mujoco>"""
TUNED = 'solref="0.004 1" solimp="0.99 0.999 0.001"'


def slide(mu, step, cone, impratio, contact):
    """The state after t = 2 of a box that starts with the velocity 1 across a pull of 1."""
    model = mujoco.MjModel.from_xml_string(XML.format(mu=mu, step=step, cone=cone, impratio=impratio, contact=contact))
    data = mujoco.MjData(model)
    for _ in range(round(1 / step)):
        mujoco.mj_step(model, data)
    data.qvel[:], data.qpos[0], data.qpos[1] = 0, 0, 0
    data.qvel[1] = 1
    data.xfrc_applied[1, 0] = 1
    for _ in range(round(2 / step)):
        mujoco.mj_step(model, data)
    return data


for name, *settings in (("pyramidal", "pyramidal", 1, ""), ("elliptic", "elliptic", 1, ""), ("elliptic, tuned", "elliptic", 100, TUNED)):
    for step in (1e-3, 2.5e-4):
        stopped, turned = slide(0.15, step, *settings), slide(0.05, step, *settings)
        way = math.hypot(stopped.qpos[0], stopped.qpos[1])
        print(f"{name:16} step {step:g}  stops {way:.4f} from the start (Coulomb: 0.4250)  velocity across {turned.qvel[1]:.4f} (Coulomb: 0.3726)")
