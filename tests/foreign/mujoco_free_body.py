# pip install mujoco==4.0.0; python mujoco_free_body.py
import csv
import mujoco

MODEL = """
<mujoco>
  <option timestep="0.001" gravity="0 0 0"/>
  <worldbody>
    <body name="wing nut">
      <freejoint/>
      <inertial pos="0 0 0" mass="1" diaginertia="1 2 2.5"/>
    </body>
  </worldbody>
</mujoco>
"""

model = mujoco.MjModel.from_xml_string(MODEL)
data = mujoco.MjData(model)
data.qvel[3:6] = [0.1, 2.0, 0.2]  # of a free joint: in body axes

with open("mujoco.csv", "w", newline="") as file:
    table = csv.writer(file, lineterminator="\n")
    table.writerow(["t", "qw", "qx", "qy", "qz", "wx", "wy", "wz"])
    for step in range(4001):
        if step % 20 == 0:
            # qpos[3:7] is w, x, y, z.
            table.writerow(float(value) for value in [data.time, *data.qpos[3:7], *data.qvel[3:6]])
        mujoco.mj_step(model, data)
