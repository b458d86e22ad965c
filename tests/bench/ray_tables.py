"""What the rays of range sensors take, beside a loop over ODE's geoms."""

import os

import experiments
import report
from programs import interleaved, median, progress

WANTED = {"plane": 0.05, "mesh": 0.12}  # us per ray, update included
WANTED_LIDARS = {"plane": 0.15, "mesh": 0.4}  # ms per tick


def measure(programs, options, results, page):
    rows, failed = [], []
    for floor in WANTED:
        for robots in [100] if options.quick else [100, 1000]:
            for beams, reach, parts in [(24, 1, 1), (360, 5, 1), (360, 5, 5)]:
                progress(f"rays, {robots} robots, {beams} beams of {reach} m, {floor}, {parts} geoms each")
                words = [robots, beams, reach, floor, parts, 7 if options.quick else 11]
                runs = interleaved(options.repetitions, {"rays": lambda: programs.rays(*words)})["rays"]
                fan, again, single, loop, update = [median(run[key] for run in runs) for key in ["fan", "again", "rays", "loop", "update"]]
                rows.append([floor, robots, parts, f"{beams} of {reach} m", round(fan, 3), round(again, 3), round(single, 3), round(loop, 3),
                             round(median(run["loop"] / run["fan"] for run in runs)), round(update, 1)])
                worst = max(run["difference"] for run in runs)
                if worst > 1e-9:
                    failed.append(f"rays of {beams} beams at {robots} robots, {floor}: the methods differ by {worst:.1e} m")
                if fan > WANTED[floor] and parts == 1:
                    failed.append(f"{fan:.3f} us per ray of {beams} beams at {robots} robots, {floor}; {WANTED[floor]} is wanted")
    header = ["floor", "robots", "geoms of each", "beams", "fan [us per ray]", "the same again", "single rays", "loop over ODE's geoms", "loop / fan",
              "update per tick [us]"]
    report.write_csv(os.path.join(results, "rays.csv"), header, rows)
    report.put_table(page, "rays", header, rows)
    return failed + lidars(programs, options, results, page)


def lidars(programs, options, results, page):
    """What lidars of 360 beams at 10 Hz on 100 robots add to a run, by processor time, for each tick of 10 ms: wandering robots on the plane, and
    floating ones above the mesh, whose lidars look down at it by 5 degrees."""
    rows, failed, seconds = [], [], 10 if options.quick else 30
    without = experiments.small_crowd(100, seconds)
    for floor, wanted in WANTED_LIDARS.items():
        progress(f"lidars, {floor}")
        is_plane = floor == "plane"
        text = without if is_plane else experiments.above_hills(without, 12, programs.folder)
        more = experiments.with_lidars(text, 0 if is_plane else 5)
        paths = {"without": programs.write(f"no_lidars_{floor}", text), "with": programs.write(f"lidars_{floor}", more)}
        costs = interleaved(options.repetitions,
                            {name: lambda path=path: programs.tick_cost(path, 100 * seconds, 1)[0] for name, path in paths.items()})
        added = median(a - b for a, b in zip(costs["with"], costs["without"])) / 1000
        rows.append([floor, f"{median(costs['without']) / 1000:.2f}", f"{added:.3f}", f"at most {wanted}"])
        if added > wanted:
            failed.append(f"100 lidars on the {floor} add {added:.3f} ms to a tick; at most {wanted} is wanted")
    header = ["floor", "tick of 100 robots without lidars [ms]", "their lidars [ms]", "wanted"]
    report.write_csv(os.path.join(results, "lidars.csv"), header, rows)
    report.put_table(page, "lidars", header, rows)
    return failed
