"""What the rays of range sensors take, beside a loop over ODE's geoms."""

import os

import report
from programs import interleaved, median, progress

WANTED = {"plane": 0.05, "mesh": 0.12}  # us per ray, update included


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
    return failed
