# pip install pybullet==3.2.7; python pybullet_free_body.py
import csv
import pybullet

pybullet.connect(pybullet.DIRECT)
pybullet.setTimeStep(0.001)
pybullet.setGravity(0, 0, 0)
body = pybullet.createMultiBody(baseMass=1)
pybullet.changeDynamics(body, -1, localInertiaDiagonal=[1, 2, 2.5], linearDamping=0, angularDamping=0)
pybullet.resetBaseVelocity(body, angularVelocity=[0.1, 2.0, 0.2])  # in world axes

with open("pybullet.csv", "w", newline="") as file:
    table = csv.writer(file, lineterminator="\n")
    table.writerow(["t", "x", "y", "z", "w", "wx", "wy", "wz"])
    for step in range(4001):
        if step % 20 == 0:
            _, quaternion = pybullet.getBasePositionAndOrientation(body)  # x, y, z, w
            _, rates = pybullet.getBaseVelocity(body)  # in world axes
            table.writerow([step * 0.001, *quaternion, *rates])
        pybullet.stepSimulation()
