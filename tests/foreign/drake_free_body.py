# pip install drake==1.51.1; python drake_free_body.py
import csv
from pydrake.math import RotationMatrix
from pydrake.multibody.plant import MultibodyPlant
from pydrake.multibody.math import SpatialVelocity
from pydrake.multibody.tree import SpatialInertia, UnitInertia
from pydrake.systems.analysis import Simulator

plant = MultibodyPlant(time_step=0.001)
inertia = SpatialInertia(1, [0, 0, 0], UnitInertia(1, 2, 2.5))
body = plant.AddRigidBody("wing_nut", inertia)
plant.mutable_gravity_field().set_gravity_vector([0, 0, 0])
plant.Finalize()
simulator = Simulator(plant)
context = simulator.get_mutable_context()
velocity = SpatialVelocity(w=[0.1, 2.0, 0.2], v=[0, 0, 0])  # in world axes
plant.SetFreeBodySpatialVelocity(context, body, velocity)

with open("drake.csv", "w", newline="") as file:
    table = csv.writer(file, lineterminator="\n")
    table.writerow(["t", "qw", "qx", "qy", "qz", "wx", "wy", "wz"])
    for step in range(201):
        if step > 0:  # AdvanceTo(0) would take the first step of the plant already
            simulator.AdvanceTo(step * 0.02)
        q = plant.EvalBodyPoseInWorld(context, body).rotation().ToQuaternion()
        w = plant.EvalBodySpatialVelocityInWorld(context, body).rotational()  # in world axes
        table.writerow([float(value) for value in [context.get_time(), q.w(), q.x(), q.y(), q.z(), *w]])
