"""Runs the measured programs and reads what they say."""

import contextlib
import json
import os
import re
import resource
import statistics
import subprocess
import sys
import time


class Failed(Exception):
    pass


class Programs:
    def __init__(self, build, folder):
        self.cli = os.path.join(build, "bin", "trundle-cli")
        self.bare = {name: os.path.join(build, "bench", f"bare_{name}") for name in ["ode", "mujoco"]}
        self.trundle = os.path.join(build, "bin", "trundle")
        self.camera_bench = os.path.join(build, "bench", "camera_bench")
        self.window_bench = os.path.join(build, "bench", "window_bench")
        self.ray_bench = os.path.join(build, "bench", "ray_bench")
        self.folder = folder

    def write(self, name, text):
        path = os.path.join(self.folder, name + ".sim")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def run(self, path, *options):
        """One run of the product; its JSON object."""
        return json.loads(_output([self.cli, "run", path, "--json", *options]))

    def seconds(self, *arguments):
        """Wall time of one whole run of the program, from its start to its end."""
        start = time.perf_counter()
        _output([self.cli, *arguments])
        return time.perf_counter() - start

    def bare_run(self, count, columns, rows, seconds, engine="ode"):
        words = [self.bare[engine], "-n", str(count), "-nx", str(columns), "-ny", str(rows), "-t", str(seconds)]
        return {key: float(value) for key, value in re.findall(r"(\w+)=(\S+)", _output(words))}

    def tick_cost(self, path, ticks, robots):
        """Processor time of the product, us per robot and tick, without start and load; and its memory at the end of the run, kB."""
        def run(duration):
            with processor_time() as time_taken:
                answer = self.run(path, "--duration", str(duration))
            return time_taken[0], answer["peak_memory_kb"]
        whole, memory = run(ticks / 100)
        return 1e6 * (whole - run(0.01)[0]) / (ticks - 1) / robots, memory

    def bare_cost(self, count, columns, rows, ticks, engine="ode"):
        """The same of the bare loop, and its contacts per robot and tick."""
        def run(duration):
            with processor_time() as time_taken:
                answer = self.bare_run(count, columns, rows, duration, engine)
            return time_taken[0], answer
        whole, answer = run(ticks / 100)
        return 1e6 * (whole - run(0.01)[0]) / (ticks - 1) / count, answer["kb"], answer["contacts_per_robot"]

    def peer_cost(self, program, count, ticks):
        """The same of a reference program that takes odebench's options."""
        def run(duration):
            with processor_time() as time_taken:
                self.peer_run(program, count, duration)
            return time_taken[0]
        return 1e6 * (run(ticks / 100) - run(0.01)) / (ticks - 1) / count

    def camera(self, path, camera, pictures):
        """Seconds that pictures take; a JSON object of [10 %, median, mean]."""
        return json.loads(_output([self.camera_bench, path, camera, str(pictures)]))

    def rays(self, *words):
        """One measurement of ray_bench; its JSON object."""
        return json.loads(_output([self.ray_bench, *map(str, words)]))

    def window(self, *words):
        """One measurement of window_bench; its JSON object."""
        return json.loads(_output([self.window_bench, *map(str, words)], self._alone()))

    def window_seconds(self, *words):
        """Wall time of the window's whole program."""
        start = time.perf_counter()
        _output([self.trundle, *words], self._alone())
        return time.perf_counter() - start

    def _alone(self):
        """No display, and settings of its own."""
        home = os.path.join(self.folder, "home")
        os.makedirs(home, mode=0o700, exist_ok=True)
        folders = {f"XDG_{name}": home for name in ["CONFIG_HOME", "DATA_HOME", "STATE_HOME", "CACHE_HOME", "RUNTIME_DIR"]}
        return os.environ | folders | {"QT_QPA_PLATFORM": "offscreen"}

    @staticmethod
    def peer_run(program, count, seconds):
        """A reference program that takes odebench's options and prints RTF=<number>."""
        words = [program, "-n", str(count), "-broad", "grid", "-solver", "step", "-maxc", "2", "-t", str(seconds)]
        return float(re.search(r"RTF=(\S+)", _output(words)).group(1))


@contextlib.contextmanager
def processor_time():
    """Gives a list whose only value is, after the block, what the programs that ended in it used: s."""
    def used():
        usage = resource.getrusage(resource.RUSAGE_CHILDREN)
        return usage.ru_utime + usage.ru_stime
    taken, before = [0.0], used()
    yield taken
    taken[0] = used() - before


def _output(words, environment=None):
    done = subprocess.run(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=1800,
                          env=environment)
    if done.returncode != 0:
        raise Failed(f"{' '.join(words)}: exit code {done.returncode}\n{done.stderr[-2000:]}")
    return done.stdout


def interleaved(repetitions, measurements):
    """Calls each of the named measurements in turn, several times over, so that a busy moment hits all alike."""
    values = {name: [] for name in measurements}
    for _ in range(repetitions):
        for name, measure in measurements.items():
            values[name].append(measure())
    return values


def median(values):
    return statistics.median(values)


def progress(text):
    print(f"bench: {text}", file=sys.stderr, flush=True)
