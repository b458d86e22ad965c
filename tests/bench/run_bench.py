#!/usr/bin/env python3
"""Measures Trundle: speed against a bare ODE loop, memory, start and load times, cameras, how the window answers, and how exactly it drives.

Writes results/*.csv and *.svg and the tables of RESULTS.md beside this file. Ratios are taken inside one run, with the two sides
interleaved; absolute figures belong to the machine named in RESULTS.md.
"""

import argparse
import math
import os
import platform
import sys
import tempfile

import camera_tables
import experiments
import fault_tables
import ray_tables
import report
import svg_plot
import window_tables
from programs import Failed, Programs, interleaved, median, progress

HERE = os.path.dirname(os.path.abspath(__file__))
RESULTS = os.path.join(HERE, "results")
PAGE = os.path.join(HERE, "RESULTS.md")
MOST_OF_MUJOCO = 100  # robots; its memory grows with the square of the contacts
ENGINES = ["general", "wheeled", "planar"]
AXLE_X = 0.06  # of the shipped robot's axle in its config frame, m


def machine():
    model = "unknown processor"
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        for line in file:
            if line.startswith("model name"):
                model = line.split(":", 1)[1].strip()
                break
    return f"{model}, {os.cpu_count()} cores, Linux {platform.release().split('-')[0]}"


def simulated_seconds(count, quick):
    seconds = 500 if count <= 2 else 200 if count <= 10 else 40 if count <= 50 else 20 if count <= 200 else 5
    return seconds / 10 if quick else seconds


def alike(programs):
    """Whether both sides simulate the same: until the first bump, one second at least, the first robot must be in the same place."""
    failed = []
    for count in [1, 10, 100]:
        columns, lines = experiments.pattern(count)
        ours = programs.run(programs.write(f"alike{count}", experiments.crowd(count, 1)))["robots"]["crowd_0"]["pos"]
        bare = programs.bare_run(count, columns, lines, 1)
        off = math.hypot(ours[0] - bare["x"], ours[1] - bare["y"])
        if off > 1e-6:
            failed.append(f"bare_ode no longer simulates what the product does: {count} robots, the first is {1000 * off:.4f} mm off after 1 s")
    return failed


def pairs_ratio(over, under):
    """The median of what each run takes against the run beside it: the machine's speed changes by the minute, hardly from one to the next."""
    return median(a / b for a, b in zip(over, under))


def crowded_seconds(count, quick):
    """Long enough that robots crowd at walls and each other."""
    seconds = {1: 500, 10: 200, 100: 60}.get(count, 10)
    return seconds / 10 if quick else seconds


def speed(programs, options):
    """The product's tick against the bare loop's, one robot per square metre, by processor time."""
    rows, failed = [], alike(programs)
    for count in [1, 10, 100] if options.quick else [1, 10, 100, 1000]:
        progress(f"speed, {count} robots")
        columns, lines = experiments.pattern(count)
        seconds = crowded_seconds(count, options.quick)
        ticks = round(100 * seconds)
        path = programs.write(f"crowd{count}", experiments.crowd(count, seconds))
        values = interleaved(options.repetitions, {"product": lambda: programs.tick_cost(path, ticks, count),
                                                   "bare": lambda: programs.bare_cost(count, columns, lines, ticks)})
        ours, bare = [value[0] for value in values["product"]], [value[0] for value in values["bare"]]
        more = median(a - b for a, b in zip(ours, bare))
        overhead = (pairs_ratio(ours, bare) - 1) * 100
        rows.append([count, seconds, round(median(ours), 2), round(median(bare), 2), round(more, 2), round(overhead, 1),
                     values["bare"][0][2], values["product"][0][1], round(values["bare"][0][1])])
        if count == 100 and overhead > 25:
            failed.append(f"overhead at 100 robots is {overhead:.0f} %, at most 25 % is wanted")
    header = ["robots", "simulated [s]", "product [us per robot and tick]", "bare ODE [us]", "overhead [us]", "overhead [%]",
              "contacts per robot and tick", "product, memory at the end [kB]", "bare ODE [kB]"]
    report.write_csv(os.path.join(RESULTS, "speed.csv"), header, rows)
    report.put_table(PAGE, "speed", header, rows)
    return failed + (beside_peer(programs, options) if options.peer else [])


def beside_peer(programs, options):
    """The product's tick against another program's, with robots like those of that program, by processor time."""
    rows, failed = [], []
    for count in [1, 10, 100] if options.quick else [1, 10, 100, 1000]:
        progress(f"beside the peer, {count} robots")
        seconds = crowded_seconds(count, options.quick)
        ticks = round(100 * seconds)
        path = programs.write(f"small{count}", experiments.small_crowd(count, seconds))
        values = interleaved(options.repetitions, {"product": lambda: programs.tick_cost(path, ticks, count)[0],
                                                   "peer": lambda: programs.peer_cost(options.peer, count, ticks)})
        ratio = pairs_ratio(values["peer"], values["product"])
        rows.append([count, seconds, round(median(values["product"]), 2), round(median(values["peer"]), 2), round(ratio, 2)])
        if count == 100 and ratio < 1 / 1.3:
            failed.append(f"at 100 robots the product runs at {ratio:.2f} of the peer's speed, 1 / 1.3 is wanted")
    header = ["robots", "simulated [s]", "product [us per robot and tick]", "peer [us]", "product's speed / peer's"]
    report.write_csv(os.path.join(RESULTS, "peer.csv"), header, rows)
    report.put_table(PAGE, "peer", header, rows)
    return failed


def engines(programs, options):
    """All engines and the bare loops on the same crowd, by processor time; 60 s at 100 robots, so that many of them crowd at walls."""
    rows = []
    for count in [1, 10, 100] if options.quick else [1, 10, 100, 1000]:
        progress(f"engines, {count} robots")
        columns, lines = experiments.pattern(count)
        seconds = crowded_seconds(count, options.quick)
        ticks = round(100 * seconds)
        text = experiments.crowd(count, seconds).replace("Solver = exact", "Solver = auto")
        paths = {name: programs.write(f"{name}{count}", f"Engine = {name}\n" + text) for name in ENGINES}
        sides = {**{name: lambda name=name: programs.tick_cost(paths[name], ticks, count)[0] for name in ENGINES},
                 "ode": lambda: programs.bare_cost(count, columns, lines, ticks)[0]}
        if count <= MOST_OF_MUJOCO and os.path.exists(programs.bare["mujoco"]):
            sides["mujoco"] = lambda: programs.bare_cost(count, columns, lines, ticks, "mujoco")[0]
        values = interleaved(options.repetitions, sides)
        cost = {name: median(value) for name, value in values.items()}
        factor = {name: 1e6 * 0.01 / count / value for name, value in cost.items()}
        ratio = pairs_ratio(values["general"], values["wheeled"])
        names = [*ENGINES, "ode", "mujoco"]
        rows.append([count, seconds] + [round(cost[name], 2) if name in cost else "-" for name in names] +
                    [f"{factor[name]:.3g}" if name in cost else "-" for name in names] +
                    [round(ratio, 1), round(pairs_ratio(values["wheeled"], values["planar"]), 2)])
    header = ["robots", "simulated [s]", "general [us per robot and tick]", "wheeled [us]", "planar [us]", "bare ODE [us]", "bare MuJoCo [us]",
              "general [x real time]", "wheeled [x real time]", "planar [x real time]", "bare ODE [x real time]", "bare MuJoCo [x real time]",
              "wheeled / general, speed", "planar / wheeled, speed"]
    report.write_csv(os.path.join(RESULTS, "engines.csv"), header, rows)
    report.put_table(PAGE, "engines", header, rows)
    return []


def threads(programs, options):
    """The same crowd on one thread and on two, by the clock on the wall, without start and load: for a machine that does nothing else."""
    rows = []
    for count in [100] if options.quick else [100, 1000]:
        progress(f"threads, {count} robots")
        seconds = crowded_seconds(count, options.quick)
        for engine in ["general", "wheeled"]:
            text = f"Engine = {engine}\n" + experiments.crowd(count, seconds).replace("Solver = exact", "Solver = auto")
            paths = {n: programs.write(f"threads{n}", text.replace("Threads = 1", f"Threads = {n}")) for n in [1, 2]}
            values = interleaved(options.repetitions, {n: lambda n=n: programs.run(paths[n]) for n in [1, 2]})
            if {run["state_hash"] for runs in values.values() for run in runs} != {values[1][0]["state_hash"]}:
                raise Failed("the results depend on the number of threads")
            factors = {n: [run["real_time_factor"] for run in runs] for n, runs in values.items()}
            rows.append([engine, count, seconds] + [f"{median(factors[n]):.3g}" for n in [1, 2]] +
                        [round(pairs_ratio(factors[2], factors[1]), 2)])
    header = ["engine", "robots", "simulated [s]", "one thread [x real time]", "two threads", "two / one"]
    report.write_csv(os.path.join(RESULTS, "threads.csv"), header, rows)
    report.put_table(PAGE, "threads", header, rows)
    return []


def crowds(programs, options):
    """Moving robots against real-time factor and memory (the thesis's Tables 4.5 and 4.7)."""
    rows = []
    for count in [1, 10, 100] if options.quick else [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000]:
        progress(f"moving robots, {count}")
        seconds = simulated_seconds(count, options.quick)
        path = programs.write(f"crowd{count}", experiments.crowd(count, seconds))
        runs = [programs.run(path) for _ in range(max(1, options.repetitions // 2))]
        factor = max(run["real_time_factor"] for run in runs)
        rows.append([count, round(factor, 2), round(1e6 * 0.01 / factor / count, 2), max(run["peak_memory_kb"] for run in runs)])
    header = ["robots", "real-time factor", "us per robot and tick", "peak memory [kB]"]
    report.write_csv(os.path.join(RESULTS, "moving_robots.csv"), header, rows)
    report.put_table(PAGE, "moving-robots", header, rows)
    plots = {"real_time_factor.svg": ("Moving robots: real-time factor, tick 10 ms", "real-time factor", {"headless": [(r[0], r[1]) for r in rows]}),
             "memory.svg": ("Moving robots: memory", "peak memory [MB]", {"trundle-cli": [(r[0], r[3] / 1024) for r in rows]})}
    for name, (title, label, series) in plots.items():
        with open(os.path.join(RESULTS, name), "w", encoding="utf-8") as file:
            file.write(svg_plot.log_plot(title, "robots", label, series))
    return []


def starting(programs, options):
    """From the start of the program to its end after one tick, and the load of a large experiment."""
    progress("start and load times")
    first = os.path.join(HERE, "..", "..", "configs", "experiments", "linear_motion.sim")
    logs = os.path.join(programs.folder, "logs")
    large = programs.write("crowd1000", experiments.crowd(1000, 10))
    largest = programs.write("crowd10000", experiments.crowd(10000, 10))
    times = interleaved(options.repetitions if options.quick else 20, {
        "program start alone (--version)": lambda: programs.seconds("--version"),
        "linear_motion: start to end after the first tick": lambda: programs.seconds("run", first, "--duration", "0.01", "--quiet", "--log-dir", logs)})
    times |= interleaved(options.repetitions, {
        "1,000 robots: check": lambda: programs.seconds("check", large),
        "1,000 robots: start to end after the first tick": lambda: programs.seconds("run", large, "--duration", "0.01", "--quiet"),
        "10,000 robots: start to end after the first tick": lambda: programs.seconds("run", largest, "--duration", "0.01", "--quiet")})
    rows = [[name, round(1000 * min(values), 1), round(1000 * median(values), 1)] for name, values in times.items()]
    header = ["what", "best [ms]", "median [ms]"]
    report.write_csv(os.path.join(RESULTS, "start.csv"), header, rows)
    report.put_table(PAGE, "start", header, rows)
    return []


def axle_pose(run):
    """True x, y [m] and heading [deg] of the axle's middle."""
    x, y, heading = run["robots"]["robot0"]["signals"]["base/pose"]
    return x, y, heading  # JSON shows angles in degrees


def straight_lines(programs, options):
    """Commanded against driven distance (the thesis's Table 4.1)."""
    progress("straight lines")
    rows = []
    for speed_mps in [0.3] if options.quick else [0.1, 0.3, 0.5]:
        for distance in [0.5, 2] if options.quick else [0.25, 0.5, 1, 2, 5, -1]:
            x, y, heading = axle_pose(programs.run(programs.write("straight", experiments.straight(distance, speed_mps))))
            driven = x - AXLE_X
            rows.append([distance, speed_mps, f"{driven:.7f}", f"{1000 * (driven - distance):.4f}", f"{1000 * y:.4f}", f"{heading:.5f}"])
    header = ["commanded [m]", "speed [m/s]", "driven [m]", "error [mm]", "sideways [mm]", "heading [deg]"]
    report.write_csv(os.path.join(RESULTS, "straight.csv"), header, rows)
    report.put_table(PAGE, "straight", header, rows)
    return [f"straight {row[0]} m is off by {row[3]} mm" for row in rows if abs(float(row[3])) > 0.05]


def arcs(programs, options):
    """Commanded against driven angle (the thesis's Table 4.2)."""
    progress("arcs")
    rows = []
    for speed_mps, turn in [(0.3, 1)] if options.quick else [(0.1, 1), (0.3, 1), (0.3, 0.5), (0.5, 0.5), (0, 1)]:
        for angle in [360] if options.quick else [90, 180, 360, -360, 720]:
            x, y, heading = axle_pose(programs.run(programs.write("arc", experiments.arc(angle, speed_mps, turn))))
            error = (heading - angle + 180) % 360 - 180
            radius = math.copysign(speed_mps / turn, angle)
            ideal = math.radians(angle)
            off = math.hypot(x - AXLE_X - radius * math.sin(ideal), y - radius * (1 - math.cos(ideal)))
            rows.append([angle, f"{abs(radius):g}", speed_mps, f"{angle + error:.5f}", f"{error:.5f}", f"{1000 * off:.4f}"])
    header = ["commanded [deg]", "radius [m]", "speed [m/s]", "driven [deg]", "error [deg]", "off the ideal end [mm]"]
    report.write_csv(os.path.join(RESULTS, "arcs.csv"), header, rows)
    report.put_table(PAGE, "arcs", header, rows)
    return [f"arc {row[0]} deg at {row[1]} m is off by {row[4]} deg, {row[5]} mm" for row in rows
            if abs(int(row[0])) <= 360 and float(row[2]) == 0.3 and float(row[1]) == 0.3 and (abs(float(row[4])) > 0.02 or float(row[5]) > 0.1)]


def radios(programs, options):
    """What frames in the air cost: motes that float in nothing, each sending once a second, or never, to their neighbours or to all."""
    rows, disturbed = [], "Mac=csma Collisions=true"
    sides = {"silent": (1000, -72, ""), "neighbours": (1, -72, ""), "all": (1, -94, ""), "disturbed": (1, -94, disturbed)}
    for count in [1, 10, 100] if options.quick else [1, 10, 100, 1000]:
        progress(f"radios, {count} motes")
        seconds = (2000 if count <= 10 else 200 if count <= 100 else 20) / (10 if options.quick else 1)
        paths = {name: programs.write(f"motes_{name}_{count}", experiments.motes(count, seconds, *side)) for name, side in sides.items()}
        values = interleaved(options.repetitions, {name: lambda path=path: programs.run(path)["real_time_factor"] for name, path in paths.items()})
        cost = {name: 1e6 / max(value) for name, value in values.items()}  # us for each simulated second
        row = [count, round(cost["silent"])]
        for name in list(sides)[1:]:
            row += [round(cost[name]), round((cost[name] - cost["silent"]) / count, 1) if count >= 100 else "-"]
        rows.append(row)
    header = ["motes", "silent [us/s]", "to neighbours [us/s]", "us per frame", "to all [us/s]", "us per frame", "with CSMA and collisions [us/s]", "us per frame"]
    report.write_csv(os.path.join(RESULTS, "radios.csv"), header, rows)
    report.put_table(PAGE, "radios", header, rows)
    return []


def controllers(programs, options):
    """What the calls of controllers cost in a tick: inside the program by processor time, with the engine that leaves most of it to them; in
    processes of their own by wall time, as the run waits for them. Robots stand still."""
    rows, failed = [], []
    for count, isolations in [(10, ["none", "module", "robot"]), (100, ["none", "module"])]:
        progress(f"controllers, {count} robots")
        seconds = 20 if options.quick else 100
        ticks = round(100 * seconds)
        without = programs.write(f"parked{count}", experiments.parked(count, seconds, False))
        path = programs.write(f"controlled{count}", experiments.parked(count, seconds))
        quick = {key: programs.write(f"planar_{key}{count}", "Engine = planar\n" + experiments.parked(count, seconds, key)) for key in [False, True]}
        sides = {"processor": lambda: programs.tick_cost(quick[False], ticks, 1)[0], "wall": lambda: 1e6 * programs.run(without)["wall_s"] / ticks}
        sides |= {name: lambda name=name: 1e6 * programs.run(path, "--set", f"Isolation={name}")["wall_s"] / ticks for name in isolations}
        sides["none"] = lambda: programs.tick_cost(quick[True], ticks, 1)[0]
        values = interleaved(options.repetitions, sides)
        for name in isolations:
            base = values["processor" if name == "none" else "wall"]
            cost = median(a - b for a, b in zip(values[name], base))
            least = min(values[name]) - min(base)
            hosts = {"none": 0, "module": 1, "robot": count}[name]
            rows.append([count, name, hosts, round(cost, 1), round(least, 1)])
            wanted = {(10, "module"): 100, (100, "none"): 10}.get((count, name))
            if wanted and cost > wanted:
                failed.append(f"controllers of {count} robots with Isolation = {name} take {cost:.0f} us per tick, {wanted} us are wanted")
    header = ["robots", "Isolation", "host processes", "controllers [us per tick], median", "of the fastest runs"]
    report.write_csv(os.path.join(RESULTS, "controllers.csv"), header, rows)
    report.put_table(PAGE, "controllers", header, rows)
    return failed


def faults(programs, options):
    """How soon a fault of a controller is noticed."""
    return fault_tables.measure(programs, options, os.path.abspath(options.build), RESULTS, PAGE)


def windows(programs, options):
    """How fast the window answers."""
    return window_tables.measure(programs, options, RESULTS, PAGE)


def cameras(programs, options):
    """How fast pictures are drawn, and what robots with cameras cost."""
    return camera_tables.measure(programs, options, RESULTS, PAGE)


def rays(programs, options):
    """What rays of range sensors take."""
    return ray_tables.measure(programs, options, RESULTS, PAGE)


SECTIONS = {"straight": straight_lines, "arcs": arcs, "start": starting, "cameras": cameras, "window": windows, "speed": speed, "engines": engines,
            "threads": threads, "crowds": crowds, "controllers": controllers, "faults": faults, "radios": radios, "rays": rays}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default="build/release", help="build folder (default %(default)s)")
    parser.add_argument("--quick", action="store_true", help="fewer and shorter measurements")
    parser.add_argument("--repetitions", type=int, default=5, help="of each measurement (default %(default)s)")
    parser.add_argument("--peer", help="a program with odebench's options to compare with")
    parser.add_argument("--only", action="append", choices=SECTIONS, help="only this section; may be repeated")
    options = parser.parse_args()
    complaints = []
    with tempfile.TemporaryDirectory(prefix="trundle-bench-") as folder:
        programs = Programs(os.path.abspath(options.build), folder)
        try:
            for name in options.only or SECTIONS:
                report.begin_section()
                complaints += SECTIONS[name](programs, options)
        except Failed as fault:
            print(fault, file=sys.stderr)
            return 1
    report.put(PAGE, "machine", machine() + (" (quick run)" if options.quick else ""))
    print(open(PAGE, encoding="utf-8").read())
    for complaint in complaints:
        progress("NOT MET: " + complaint)
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
