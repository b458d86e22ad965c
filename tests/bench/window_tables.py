"""How fast the window answers: tables of RESULTS.md by window_bench."""

import os
import time

import experiments
import report
from programs import median, progress

TYPING_MS, FILTER_MS, GAP_MS, START_MS, PICTURES, RATIO, SENSORS_MS = 150, 50, 100, 1000, 30, 1.3, 33


def measure(programs, options, results, page):
    failed = []

    def table(name, header, rows):
        report.write_csv(os.path.join(results, f"window_{name}.csv"), header, rows)
        report.put_table(page, f"window-{name}", header, rows)

    for part in (answers, gaps, starts, frames, sensors):
        failed += part(programs, options, table)
    return failed


def wanted(what, value, most, unit="ms"):
    return [f"{what}: {value} {unit}, at most {most} is wanted"] if value > most else []


def answers(programs, options, table):
    """From a key to its picture."""
    progress("typing and filtering")
    text = programs.write("long", experiments.long_text())
    typed = programs.window("typing", text, 6 if options.quick else 30)
    tree = programs.write("tree", experiments.singles(110))
    filtered = programs.window("filter", tree, 1 if options.quick else 4)
    rows = []
    for what, found, most in [(f"a letter of a name in {typed['lines']} lines, tree and view show it", typed["name"], TYPING_MS),
                              (f"a digit of a place in {typed['lines']} lines, the view shows it", typed["place"], TYPING_MS),
                              (f"a letter in the filter of {filtered['nodes']} rows, the tree shows it", filtered["filter"], FILTER_MS)]:
        rows.append([what, found["count"], round(found["median"], 1), round(found["p95"], 1), round(found["worst"], 1), most])
    table("answers", ["key press", "keys", "median [ms]", "95 % [ms]", "worst [ms]", "wanted [ms]"], rows)
    return [line for row in rows for line in wanted(f"{row[0]} (95 %)", row[3], row[5])]


def gaps(programs, options, table):
    """How long events wait while 300 robots are loaded, run, saved, dragged."""
    phases, memory = {}, []
    for _ in range(1 if options.quick else options.repetitions):
        progress("gaps, 300 robots")
        found = programs.window("gaps", programs.write("robots300", experiments.singles(300)))
        memory.append(found)
        for phase in found["phases"]:
            phases.setdefault(phase["phase"], []).append(phase)
    rows, failed = [], []
    for name, runs in phases.items():
        values = [run["gap_ms"] for run in runs]
        worst = max(runs, key=lambda run: run["gap_ms"])
        rows.append([name, round(median(values), 1), round(max(values), 1), round(median([run["busy_ms"] for run in runs]), 1)])
        progress(f"  {name}: {max(values):.0f} ms; its longest event {worst['event']}, {worst['event_ms']:.0f} ms")
        failed += wanted(f"gap, {name}", rows[-1][1], GAP_MS)
    worst = max(rows, key=lambda row: row[1])
    rows.append([f"the worst of them: {worst[0]}", *worst[1:]])
    table("gaps", [f"300 robots, {len(memory)} runs", f"longest gap, median [ms] (wanted: {GAP_MS})", "of all runs [ms]", "busy, median [ms]"], rows)
    table("memory", ["the window's memory", "MB"],
          [[what, round(median([run[key] for run in memory]))] for what, key in
           [("Welcome page", "empty_mb"), ("300 robots opened and drawn", "opened_mb"),
            ("after all of the above", "worked_mb"), ("at most", "peak_mb")]])
    return failed


def starts(programs, options, table):
    """From the start of the process to what a person sees."""
    progress("start of the window")
    sample = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "configs", "experiments", "linear_motion.sim")
    welcome, window, picture, whole = [], [], [], []
    for _ in range(3 if options.quick else 10):
        welcome.append(programs.window("start", f"{1000 * time.monotonic():.3f}")["window_ms"])
        found = programs.window("start", f"{1000 * time.monotonic():.3f}", sample)
        window.append(found["window_ms"])
        picture.append(found["picture_ms"])
        whole.append(1000 * programs.window_seconds(sample, "--quit"))
    rows = [[name, round(min(values)), round(median(values)), round(max(values))] for name, values in
            [("window painted, Welcome page", welcome), ("window painted, with linear_motion.sim asked for", window),
             ("its first 3D picture painted", picture),
             ("the whole program with it, until its finest picture is there and it has left", whole)]]
    table("start", ["from the start of the process", "min [ms]", "median [ms]", "max [ms]"], rows)
    return wanted("start to first window", rows[0][2], START_MS) + wanted("start to first picture", rows[2][2], START_MS)


def frames(programs, options, table):
    """30 robots in software."""
    progress("pictures of 30 robots")
    found = programs.window("frames", programs.write("crowd30", experiments.crowd(30, 1000)), 2 if options.quick else 5)
    size = f"{found['width']}x{found['height']}"
    ratio = round(found["served"]["median"] / found["bare"]["median"], 2)
    rows = [[f"pictures a second in the view at {size} while they run", round(found["pictures_per_second"], 1), f"at least {PICTURES}"],
            ["bare OSG loop, a picture [ms]", round(found["bare"]["median"], 2), ""],
            ["render service, request to pixels [ms]", round(found["served"]["median"], 2), ""],
            ["service / bare loop", ratio, f"at most {RATIO}"],
            ["painting a picture in the window [ms]", round(found["painted"]["median"], 2), ""]]
    table("pictures", [f"30 robots, {found['renderer']}", "measured", "wanted"], rows)
    failed = wanted("service against the bare OSG loop", ratio, RATIO, "times")
    if found["pictures_per_second"] < PICTURES:
        failed.append(f"{found['pictures_per_second']:.1f} pictures a second of 30 robots, {PICTURES} are wanted")
    return failed


def sensors(programs, options, table):
    """Processor time of the fans over the view and of the Sensors dock for 20 lidars of 360 beams."""
    progress("20 lidars")
    found = programs.window("sensors", programs.write("lidars20", experiments.lidars(20)), 0.5 if options.quick else 2)
    fans = found["view_with_fans"]["median"] - found["view"]["median"]
    parts = [("their fans over the 3D view", fans), ("values and traces of their cards", found["values"]["median"]),
             ("painting the cards of one turn", found["cards"]["median"])]
    total = sum(ms for _, ms in parts)
    rows = [[what, round(ms, 2), ""] for what, ms in parts] + [["together", round(total, 2), f"at most {SENSORS_MS}"]]
    table("sensors", [f"{found['lidars']} lidars of 360 beams, for each picture", "processor time [ms]", "wanted"], rows)
    return wanted("sensors in the window", round(total, 2), SENSORS_MS)
