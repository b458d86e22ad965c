"""How fast cameras are: tables of RESULTS.md by camera_bench, and the thesis's camera experiment by trundle-cli."""

import os

import experiments
import report
import svg_plot
from programs import median, progress

WANTED = {(64, 48): 2500, (320, 240): 600, (640, 480): 250}  # pictures a second
RATIO = 1.3


def measure(programs, options, results, page):
    return pictures(programs, options, results, page) + swarms(programs, options, results, page)


def pictures(programs, options, results, page):
    """Pictures a second with 50 robots in view, against a bare OSG loop."""
    rows, failed = [], []
    for (width, height), wanted in WANTED.items():
        progress(f"cameras, {width} x {height}")
        path = programs.write(f"seen{width}", experiments.seen(50, width, height))
        runs = [programs.camera(path, "tower/eye", 30 if options.quick else 200) for _ in range(1 if options.quick else options.repetitions)]
        best = min(runs, key=lambda run: run["product"][1])
        ratio = min(run["product"][1] / run["bare"][1] for run in runs)
        rate = 1 / best["product"][1]
        lost = median([run["product"][2] / (run["product"][2] + run["tick"]) for run in runs])
        rows.append([f"{width} x {height}", wanted, round(rate), round(1000 * best["product"][1], 2), round(1000 * best["bare"][1], 2), round(ratio, 2), round(1000 * median([run["tick"] for run in runs]), 2), round(100 * lost), round(100 * max(run["differing"] for run in runs), 1)])
        if rate < wanted:
            failed.append(f"cameras of {width} x {height}: {rate:.0f} pictures/s, {wanted} are wanted")
        if rows[-1][-1] > 1:
            failed.append(f"cameras of {width} x {height}: {rows[-1][-1]} % of the bytes are not those of the bare loop, which so draws something else")
        if ratio > RATIO:
            failed.append(f"cameras of {width} x {height}: {ratio:.2f} times the bare loop's time, at most {RATIO} is wanted")
    header = ["picture", "wanted [1/s]", "pictures/s", "one picture [ms]", "bare OSG loop [ms]", "ratio", "one tick of 51 robots [ms]", "of the time, a picture in every tick [%]", "bytes unlike the bare loop's [%]"]
    report.write_csv(os.path.join(results, "cameras.csv"), header, rows)
    report.put_table(page, "cameras", header, rows)
    return failed


def swarms(programs, options, results, page):
    """Robots with cameras against real-time factor (the experiment of the thesis's section 4.3)."""
    counts = [1, 5, 20] if options.quick else [1, 2, 5, 10, 20, 50]
    sizes = [(64, 48), (320, 240)]
    rows, series = [], {"no pictures": [], **{f"{w} x {h}": [] for w, h in sizes}}
    for count in counts:
        progress(f"robots with cameras, {count}")
        seconds = (10 if options.quick else 20) if count <= 5 else 4 if options.quick else 10
        row = [count]
        for name, (width, height), seeing in [("no pictures", sizes[0], False)] + [(f"{w} x {h}", (w, h), True) for w, h in sizes]:
            path = programs.write(f"cameras{count}{name.replace(' ', '')}", experiments.camera_robots(count, width, height, seeing, seconds))
            runs = [programs.run(path) for _ in range(1 if options.quick else max(1, options.repetitions // 2))]
            row.append(round(max(run["real_time_factor"] for run in runs), 2))
            series[name].append((count, row[-1]))
        rows.append(row)
    header = ["robots with a camera, 10 pictures/s each", *(f"real-time factor, {name}" for name in series)]
    report.write_csv(os.path.join(results, "camera_robots.csv"), header, rows)
    report.put_table(page, "camera-robots", header, rows)
    with open(os.path.join(results, "camera_robots.svg"), "w", encoding="utf-8") as file:
        file.write(svg_plot.log_plot("Robots with cameras: real-time factor, 10 pictures/s each", "robots", "real-time factor", series))
    return []
