"""How long the run waits for a controller with a fault: from the call to the end of its tick, by wall time."""

import os
import sys
import time

import report
from programs import median, progress

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
sys.path.insert(0, os.path.join(ROOT, "core", "sdk", "python"))
import trundle  # noqa: E402

WANTED_MS = 100
LIMIT_S = 1  # of a call that does not return: 20 times its Budget of 20 ms, one second at least
FAULTS = {"Zoo": ["segv", "abort", "_exit", "throw", "thread crashes", "loop", "block and loop"],
          "Sick": ["segv", "leave", "divide", "loop", "sleep"]}
HANGS = {"loop", "block and loop", "sleep"}


def experiment(kind, action, isolation):
    """Ten robots beside the one with the fault, which comes after half a second."""
    module = {"Zoo": "zoo", "Sick": "sick.py"}[kind]
    budget = " Budget=20" if action in HANGS else ""
    return ("Tick = 0.01\n#import robots/simple_robot.sim\n#import arenas/open_floor.sim\n#loadModule controllers/random_drive\n"
            f"#loadModule {module}\nStatic floor {{ Config=OpenFloor }}\n"
            f"Robot bad {{ Config=SimpleRobot Pos=0,-3,0 {kind} brain {{ Action=\"{action}\" Isolation={isolation}{budget} }} }}\n"
            "Grid good { Config=SimpleRobot Count=5,2 Spacing=0.8 RandomDrive brain { Isolation=module } }\n")


def seconds_of_fault(programs, path, modules):
    """Of the tick with the fault."""
    with trundle.Simulation(path, modules=modules, program=programs.cli, console=None) as sim:
        for _ in range(100):
            begin = time.perf_counter()
            sim.step(1)
            taken = time.perf_counter() - begin
            if sim.status()["stopped"]:
                return taken
    raise RuntimeError(f"{path}: no fault")


def measure(programs, options, build, results, page):
    modules = [os.path.join(build, "tests", "modules", "zoo"), os.path.join(ROOT, "tests", "flow", "python")]
    rows, failed = [], []
    for kind, actions in FAULTS.items():
        for action in actions:
            for isolation in ["module", "robot"]:
                progress(f"faults, {kind} {action}, {isolation}")
                path = programs.write("fault", experiment(kind, action, isolation))
                limit = LIMIT_S if action in HANGS else 0
                times = [1000 * (seconds_of_fault(programs, path, modules) - limit) for _ in range(options.repetitions)]
                rows.append(["Python" if kind == "Sick" else "C++", action, isolation, limit, round(median(times), 1), round(max(times), 1)])
                if median(times) > WANTED_MS:
                    failed.append(f"the fault {action} of {kind}, Isolation = {isolation}, takes {median(times):.0f} ms, {WANTED_MS} are wanted")
    header = ["controller in", "fault", "Isolation", "limit of the call [s]", "beyond that [ms], median", "worst"]
    report.write_csv(os.path.join(results, "faults.csv"), header, rows)
    report.put_table(page, "faults", header, rows)
    return failed
