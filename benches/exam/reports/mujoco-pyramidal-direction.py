import math

import mujoco

XML = """
<mujoco>
  <option timestep="0.001" gravity="0 0 -10" cone="{cone}"/>
  <worldbody>
    <geom type="plane" size="50 50 1" friction="0.15 0 0" condim="3"/>
    <body pos="0 0 0.1">
      <joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 1 0"/><joint type="slide" axis="0 0 1"/>
      <geom type="box" size="0.1 0.1 0.1" mass="1" friction="0.15 0 0" condim="3"/>
    </body>
  </worldbody>
</mujoco>"""

for cone in ("pyramidal", "elliptic"):
    model = mujoco.MjModel.from_xml_string(XML.format(cone=cone))
    data = mujoco.MjData(model)
    for _ in range(1000):
        mujoco.mj_step(model, data)
    data.qvel[:], data.qpos[0], data.qpos[1] = 0, 0, 0
    data.qvel[1] = 1
    data.xfrc_applied[1, 0] = 1
    for _ in range(2000):
        mujoco.mj_step(model, data)
    print(f"{cone:9}  stops {math.hypot(data.qpos[0], data.qpos[1]):.4f} from the start (Coulomb: 0.4250)")
