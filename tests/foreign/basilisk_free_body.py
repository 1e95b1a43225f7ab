# pip install bsk==2.12.1; python basilisk_free_body.py
import csv
from Basilisk.simulation import spacecraft
from Basilisk.utilities import SimulationBaseClass, macros

simulation = SimulationBaseClass.SimBaseClass()
process = simulation.CreateNewProcess("process")
process.addTask(simulation.CreateNewTask("task", macros.sec2nano(0.02)))
craft = spacecraft.Spacecraft()
craft.hub.mHub = 1.0
craft.hub.IHubPntBc_B = [[1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.5]]
craft.hub.r_CN_NInit = [[0.0], [0.0], [0.0]]
craft.hub.v_CN_NInit = [[0.0], [0.0], [0.0]]
craft.hub.sigma_BNInit = [[0.0], [0.0], [0.0]]
craft.hub.omega_BN_BInit = [[0.1], [2.0], [0.2]]  # in body axes
simulation.AddModelToTask("task", craft)
log = craft.scStateOutMsg.recorder()
simulation.AddModelToTask("task", log)
simulation.InitializeSimulation()
simulation.ConfigureStopTime(macros.sec2nano(4.0))
simulation.ExecuteSimulation()

with open("basilisk.csv", "w", newline="") as file:
    table = csv.writer(file, lineterminator="\n")
    names = [f"{name}_{axis}" for name in ("sigma_BN", "omega_BN_B") for axis in (1, 2, 3)]
    table.writerow(["time_ns", *names])
    for time, sigma, omega in zip(log.times(), log.sigma_BN, log.omega_BN_B):
        table.writerow([int(time), *map(float, sigma), *map(float, omega)])
