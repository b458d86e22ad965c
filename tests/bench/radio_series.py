#!/usr/bin/env python3
"""Runs the radio experiments many times and writes their tables and plots into the guide (resources/guide/radio_experiments.md).

  turn        bearings found against true bearings, over angles and distances (configs/experiments/turn_angle.sim)
  navigation  does the robot reach the target, for each layout (configs/experiments/network_navigation.sim and network_navigation/)

Each run is `trundle-cli run FILE --seed N --set ...`. Seeds are drawn anew every time unless --first-seed is given; they stand in the CSV
files beside the tables (tests/bench/results), so that every run can be repeated.
"""

import argparse
import concurrent.futures
import csv
import json
import math
import os
import secrets
import statistics
import subprocess
import sys
import tempfile

import report
import svg_figures

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
EXPERIMENTS = os.path.join(ROOT, "configs", "experiments")
GUIDE = os.path.join(ROOT, "resources", "guide")
RESULTS = os.path.join(HERE, "results")
PAGE = os.path.join(GUIDE, "radio_experiments.md")
NAVIGATION = os.path.join(RESULTS, "radio_navigation.csv")

# name: (file, is it a grid, what it is)
LAYOUTS = {
    "square": ("network_navigation.sim", True, "4 x 4 motes, 3 m apart"),
    "line": ("network_navigation/line.sim", True, "6 motes in a row, 3 m apart"),
    "wide": ("network_navigation/wide.sim", True, "7 x 3 motes, 3 m apart"),
    "pillars": ("network_navigation/pillars.sim", True, "the square, with 9 pillars"),
    "scattered": ("network_navigation/scattered.sim", False, "20 motes anywhere in 12 m x 12 m"),
    "sparse": ("network_navigation/sparse.sim", False, "14 motes anywhere in 12 m x 12 m"),
    "walls": ("network_navigation/walls.sim", False, "20 motes and 3 walls in 12 m x 12 m"),
}
# What each model needs so that motes reach each other over some 5 m, and the robot a little more.
MODELS = {
    "ideal": [],
    "two_ray": ["air.Model=two_ray", "power=-3", "robot.radio.MinReceivePower=-60"],
    "log_distance": ["air.Model=log_distance", "air.Exponent=3", "air.Shadowing=4", "power=-15", "least=-75"],
}
AHEAD = 0.31       # of the AMR's antenna before its middle, m
NEAR = 1.0         # antenna to target, m: it is there
POWER = -25        # of the motes where a model sets none, dBm
PEAK_GAIN = 9.0    # of the AMR's antenna, dBi
WANTED = {True: 95, False: 90}  # of 100 runs, under ideal: grids, others


class Cli:
    def __init__(self, build, jobs):
        self.program = os.path.join(os.path.abspath(build), "bin", "trundle-cli")
        self.jobs = jobs

    def run(self, file, folder, sets=(), seed=None, duration=None):
        """One run; its JSON object, and what its controllers said."""
        words = [self.program, "run", os.path.join(EXPERIMENTS, file), "--json", "--log-dir", folder]
        words += [word for value in sets for word in ("--set", value)]
        words += ["--seed", str(seed)] if seed is not None else []
        words += ["--duration", str(duration)] if duration is not None else []
        done = subprocess.run(words, stdin=subprocess.DEVNULL, capture_output=True, text=True)
        if done.returncode != 0:
            raise SystemExit(f"{' '.join(words)}: exit code {done.returncode}\n{done.stderr[-2000:]}")
        return json.loads(done.stdout), done.stderr

    def many(self, function, arguments):
        """The answers in the order of the arguments."""
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            return list(pool.map(function, arguments))


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def progress(text):
    print(f"radio: {text}", file=sys.stderr, flush=True)


# --- bearings -------------------------------------------------------------------------------------------------------------------

def wrapped(degrees):
    return (degrees + 180) % 360 - 180


def bearing_errors(cli, angle, seed, sets):
    """{distance [m]: (true bearing, error, packets)} of one turn."""
    with tempfile.TemporaryDirectory(prefix="trundle-radio-") as folder:
        cli.run("turn_angle.sim", folder, [f"angle={angle}", *sets], seed)
        found = {int(row["sender"]): row for row in rows_of(os.path.join(folder, "bearings.csv"))}
    errors = {}
    for distance in range(1, 6):
        true = wrapped(angle + 72 * (distance - 1))
        row = found.get(distance)
        errors[distance] = (true, wrapped(float(row["bearing [deg]"]) - true), int(row["packets"])) if row else (true, None, 0)
    return errors


def share_within(errors, share):
    """The error that `share` of them do not exceed."""
    ordered = sorted(errors)
    return ordered[min(len(ordered) - 1, math.ceil(share * len(ordered)) - 1)]


def turns(cli, options):
    failed, rows, lines = [], [], []
    for model, sets in [("ideal", []), ("two_ray", ["air.Model=two_ray"]), ("log_distance", ["air.Model=log_distance", "air.Exponent=3", "air.Shadowing=4"])]:
        angles = [360 / options.angles * i - 180 for i in range(options.angles)]
        progress(f"bearings, {model}, {len(angles)} turns")
        results = cli.many(lambda pair: bearing_errors(cli, pair[1], options.seeds[pair[0] % len(options.seeds)], sets), list(enumerate(angles)))
        everything = []
        for distance in range(1, 6):
            found = [result[distance] for result in results]
            lines += [[model, distance, f"{true:.1f}", "" if error is None else f"{error:.3f}", packets] for true, error, packets in found]
            errors = [abs(error) for _, error, _ in found if error is not None]
            everything += errors
            lost = len(found) - len(errors)
            rows.append([model, distance, len(found), round(statistics.median(errors), 2), round(share_within(errors, 0.95), 2), round(max(errors), 2), lost])
            if lost and model == "ideal":
                failed.append(f"{lost} bearings at {distance} m were not found")
        rows.append([model, "all", len(everything), round(statistics.median(everything), 2), round(share_within(everything, 0.95), 2), round(max(everything), 2), ""])
        if model == "ideal" and (statistics.median(everything) > 3 or share_within(everything, 0.95) > 10):
            failed.append("bearings under ideal: median at most 3 deg and 95 % within 10 deg are wanted")
    report.write_csv(os.path.join(RESULTS, "radio_bearings.csv"), ["model", "distance [m]", "true [deg]", "error [deg]", "packets"], lines)
    header = ["model", "distance [m]", "turns", "median error [deg]", "95 % within [deg]", "largest [deg]", "not found"]
    report.put(PAGE, "bearings", report.markdown(header, rows))
    series = {f"{distance} m": sorted((float(line[2]), float(line[3])) for line in lines if line[0] == "ideal" and line[1] == distance and line[3])
              for distance in (1, 3, 5)}
    svg_figures.save(os.path.join(GUIDE, "pictures", "bearing_error.svg"),
                     svg_figures.plot("Bearing found less true bearing (ideal)", "true bearing [deg]", "error [deg]", series))
    return failed


# --- navigation -----------------------------------------------------------------------------------------------------------------

def hangs_together(folder, model):
    """Whether every mote has a way to the target over links that work in both directions, and the robot hears one at least."""
    power = next((float(value.split("=")[1]) for value in MODELS[model] if value.startswith("power=")), POWER)
    margins = {}  # a LinkMatrix is about full power, 0 dBm
    for row in rows_of(os.path.join(folder, "links.csv")):
        if float(row["time [s]"]) == 0:
            margins[row["from"], row["to"]] = (float(row["margin [dB]"]) + power, float(row["receive gain [dBi]"]))
    radios = {name for name, _ in margins}
    robot = next(name for name in radios if name.startswith("robot"))
    target = next(name for name in radios if name.startswith("target"))
    reached, edge = {target}, [target]
    while edge:
        here = edge.pop()
        for there in radios - reached - {robot}:
            if margins[here, there][0] >= 0 and margins[there, here][0] >= 0:
                reached.add(there)
                edge.append(there)
    hears = any(margin - gain + PEAK_GAIN >= 0 for (_, to), (margin, gain) in margins.items() if to == robot)
    return hears and reached == radios - {robot}


def navigate(cli, layout, model, seed, keep=None):
    """One run; None where its network does not hang together."""
    file, _, _ = LAYOUTS[layout]
    with tempfile.TemporaryDirectory(prefix="trundle-radio-") as folder:
        cli.run(file, folder, MODELS[model], seed, duration=0.02)
        if not hangs_together(folder, model):
            return None
        run, said = cli.run(file, folder, MODELS[model], seed)
        legs = rows_of(os.path.join(folder, "navigation.csv"))
        if keep is not None:
            keep.update(run=run, path=rows_of(os.path.join(folder, "path.csv")))
    robot, target = run["robots"]["robot_0"], run["robots"]["target_0"]
    heading = math.radians(robot["hpr"][0])
    x, y = robot["pos"][0] + AHEAD * math.cos(heading), robot["pos"][1] + AHEAD * math.sin(heading)
    away = math.hypot(x - target["pos"][0], y - target["pos"][1])
    says = bool(legs) and legs[-1]["mote"] == "arrived"
    return {"seed": seed, "says": says, "away": away, "reached": says and away <= NEAR,
            "time": float(legs[-1]["time [s]"]) if says else float("nan"), "legs": sum(row["mote"] != "arrived" for row in legs),
            "hops": max((int(row["hops"]) for row in legs), default=0), "words": said}


def series_of(cli, options, layout, model):
    """Runs of seeds whose networks hang together, and the seeds whose networks did not."""
    wanted = options.runs if model == "ideal" else math.ceil(options.runs / 5)
    runs, apart = [], []
    seeds = iter(options.seeds)
    while len(runs) < wanted:
        some = [seed for seed, _ in zip(seeds, range(wanted - len(runs)))]
        if not some:
            break
        answers = cli.many(lambda seed: navigate(cli, layout, model, seed), some)
        runs += [answer for answer in answers if answer]
        apart += [seed for seed, answer in zip(some, answers) if not answer]
    return runs, apart


def navigation(cli, options):
    """Series that are not run now keep what the CSV file has of them."""
    failed = []
    known = rows_of(NAVIGATION) if os.path.exists(NAVIGATION) else []
    for model in options.model or MODELS:
        for layout in options.layout or LAYOUTS:
            runs, apart = series_of(cli, options, layout, model)
            known = [row for row in known if (row["model"], row["layout"]) != (model, layout)]
            for run in runs:
                result = "reached" if run["reached"] else "wrongly sure" if run["says"] else "not there"
                known.append({"model": model, "layout": layout, "seed": run["seed"], "result": result, "antenna to target [m]": f"{run['away']:.3f}",
                              "time [s]": f"{run['time']:.2f}", "legs": run["legs"], "hops": run["hops"]})
            known += [{"model": model, "layout": layout, "seed": seed, "result": "left out"} for seed in apart]
            there = sum(run["reached"] for run in runs)
            progress(f"{model}, {layout}: {there} of {len(runs)} reached" +
                     "".join(f"; not: seed {run['seed']}, {run['away']:.1f} m away" for run in runs if not run["reached"]))
            wanted = WANTED[LAYOUTS[layout][1]]
            if model == "ideal" and (not runs or there * 100 < wanted * len(runs)):
                failed.append(f"{layout} under ideal: {there} of {len(runs)} reached, {wanted} % are wanted")
            tell_navigation(known)
    return failed


def tell_navigation(known):
    names = ["model", "layout", "seed", "result", "antenna to target [m]", "time [s]", "legs", "hops"]
    report.write_csv(NAVIGATION, names, [[row.get(name, "") for name in names] for row in known])
    rows = []
    for model in MODELS:
        for layout, (_, _, what) in LAYOUTS.items():
            of = {result: [row for row in known if (row["model"], row["layout"], row["result"]) == (model, layout, result)]
                  for result in ("reached", "wrongly sure", "not there", "left out")}
            there = of["reached"]
            runs = there + of["wrongly sure"] + of["not there"]
            if not runs:
                continue
            typical = [round(statistics.median(float(row[name]) for row in there)) if there else "-" for name in ("time [s]", "legs")]
            rows.append([model, layout, what, len(runs), len(of["left out"]), len(there), len(of["wrongly sure"]), max(int(row["hops"]) for row in runs), *typical])
    header = ["model", "layout", "what", "runs", "seeds left out", "reached", "wrongly sure", "most hops", "median time [s]", "median legs"]
    report.put(PAGE, "navigation", report.markdown(header, rows))


def paths(cli, options):
    """One run of some layouts as maps."""
    for layout in ("square", "scattered", "walls"):
        progress(f"map of {layout}")
        for seed in options.seeds:
            kept = {}
            if navigate(cli, layout, "ideal", seed, kept):
                break
        robots = kept["run"]["robots"]
        motes = [robot["pos"][:2] for name, robot in robots.items() if name.startswith("motes")]
        way = [(float(row["x [m]"]), float(row["y [m]"])) for row in kept["path"]]
        svg_figures.save(os.path.join(GUIDE, "pictures", f"navigation_{layout}.svg"),
                         svg_figures.map_of(f"{layout}, seed {seed}", {"mote": motes, "target": [robots["target_0"]["pos"][:2]], "start": way[:1]}, way))
    return []


SECTIONS = {"turn": turns, "paths": paths, "navigation": navigation}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default=os.path.join(ROOT, "build", "release"), help="build folder (default: build/release)")
    parser.add_argument("--runs", type=int, default=100, help="for each layout under ideal; a fifth of that under the other models (default %(default)s)")
    parser.add_argument("--angles", type=int, default=72, help="turns for the bearings (default %(default)s)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="at the same time (default %(default)s)")
    parser.add_argument("--first-seed", type=int, help="seeds count up from this one; by default they are drawn")
    parser.add_argument("--layout", action="append", choices=LAYOUTS, help="only this one; may be repeated")
    parser.add_argument("--model", action="append", choices=MODELS, help="only this one; may be repeated")
    parser.add_argument("--dry", action="store_true", help="write nothing into the tree")
    parser.add_argument("--only", action="append", choices=SECTIONS, help="only this section; may be repeated")
    options = parser.parse_args()
    first = options.first_seed if options.first_seed is not None else secrets.randbelow(10**9)
    options.seeds = range(first, first + 20 * options.runs)
    if options.dry:
        report.write_csv = report.put = svg_figures.save = lambda *_: None
    cli = Cli(options.build, options.jobs)
    complaints = []
    for name in options.only or SECTIONS:
        complaints += SECTIONS[name](cli, options)
    for complaint in complaints:
        progress("NOT MET: " + complaint)
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
