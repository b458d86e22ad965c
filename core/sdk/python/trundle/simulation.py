# SPDX-License-Identifier: BSD-2-Clause
"""A simulation of one's own: the program trundle-cli as a child process."""

import os
import re
import shutil
import socket
import subprocess
import tempfile

from .remote import Disconnected, Remote, print_line

_LAST_BYTES = 4000
_WORD = re.compile(r"\s*[A-Za-z_][A-Za-z0-9_./\\-]*\s*")
_NO_WORD = re.compile(r'\s*(?:["$]|[-+]?\.?[0-9])')  # how a string, an expression, a number with or without a unit begins


def find_program():
    """The path of trundle-cli: $TRUNDLE_CLI, that of this installation or build folder, or the one in PATH."""
    here = os.path.dirname(os.path.abspath(__file__))
    beside = [os.path.join(here, *[".."] * 4, "bin", "trundle-cli"),  # share/trundle/python/trundle
              os.path.join(here, *[".."] * 4, "build", "release", "bin", "trundle-cli")]  # core/sdk/python/trundle
    given = os.environ.get("TRUNDLE_CLI")
    found = given or next((os.path.normpath(p) for p in beside if os.access(p, os.X_OK)), None) or shutil.which("trundle-cli")
    if not found:
        raise FileNotFoundError("trundle-cli was not found; set TRUNDLE_CLI to its path")
    return found


def _as_in_a_text(value):
    """A value as the language has it. A Python text that is a value there already, or words with commas, stays; others are quoted."""
    if hasattr(value, "tolist"):  # of numpy
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (list, tuple)):
        return ",".join(map(_as_in_a_text, value))
    if not isinstance(value, (str, os.PathLike)):
        return str(value)
    text = os.fspath(value)
    if _NO_WORD.match(text) or all(map(_WORD.fullmatch, text.split(","))):
        return text
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n") + '"'


class Simulation(Remote):
    """Runs an experiment without a window, stepped from here:

        with trundle.Simulation("my.sim") as sim:
            base = sim.robot("rover").differential_drive("base")
            base.move(0.3, 0)
            sim.step(100)
            print(sim.time, base.odometry())

    Raises TextError, with file, line and column, if the text has errors. `sets`: {"rover.Pos": (1, 0, 0)}, or texts
    "rover.Pos=1,0,0"; `modules`: folders whose modules are trusted; `console(time, who, severity, text)` gets what controllers print, None nothing."""

    def __init__(self, file, *, seed=None, sets=(), modules=(), include=(), trust=False, log_dir=None, console=print_line, program=None):
        texts = [f"{path}={_as_in_a_text(value)}" for path, value in sets.items()] if isinstance(sets, dict) else [sets] if isinstance(sets, str) else list(sets)
        if seed is not None:
            texts.append(f"Seed={seed}")
        arguments = [program or find_program(), "serve", os.fspath(file)]
        for option, values in (("--set", texts), ("--modules", modules), ("-I", include)):
            for value in [values] if isinstance(values, (str, os.PathLike)) else values:
                arguments += [option, os.fspath(value)]
        if trust:
            arguments.append("--trust")
        if log_dir is not None:
            arguments += ["--log-dir", os.fspath(log_dir)]
        ours, childs = socket.socketpair()
        self._process, self._errors = None, tempfile.TemporaryFile()
        with childs:
            try:
                self._process = subprocess.Popen(arguments + ["--socket", str(childs.fileno())], stdin=subprocess.DEVNULL,
                                                 stdout=self._errors, stderr=self._errors, pass_fds=[childs.fileno()],
                                                 start_new_session=True)
            except BaseException:
                ours.close()
                self._errors.close()
                raise
        super().__init__(ours, console=console)

    def _receive(self):
        try:
            return super()._receive()
        except (Disconnected, ConnectionResetError):
            raise Disconnected(self._last_words()) from None

    def _last_words(self):
        """How the process has ended, and what it printed last."""
        if self._errors.closed or self._process is None:
            return "the simulation is closed"
        try:
            code = self._process.wait(5)
        except subprocess.TimeoutExpired:
            return "trundle-cli has closed the connection"
        if self._errors.closed:  # by another thread
            return "the simulation is closed"
        self._errors.seek(max(0, self._errors.seek(0, os.SEEK_END) - _LAST_BYTES))
        said = self._errors.read().decode("utf-8", "replace").strip()
        how = f"was ended by signal {-code}" if code < 0 else f"has ended with exit code {code}"
        return f"trundle-cli {how}" + (f":\n{said}" if said else "")

    def close(self):
        """Ends the process; its logs are complete."""
        super().close()
        if self._process is None:
            return
        for give_up in (self._process.terminate, self._process.kill, None):
            try:
                self._process.wait(10 if give_up else None)
                break
            except subprocess.TimeoutExpired:
                give_up()
        self._errors.close()
