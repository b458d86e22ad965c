#!/usr/bin/env python3
"""What texts of 64 MiB cost that are wrong from end to end, empty, or valid: memory above that of a small text, and processor time, for `check` and the window.

    python3 tests/bench/large_texts.py --build build/release [--mib 64] [--kinds wrong_keys,blank_lines] [--programs cli,window]

Prints a table for RESULTS.md. The window opens each file without a display, takes a picture as soon as it has drawn everything, and ends.
"""

import argparse
import os
import subprocess
import sys
import tempfile
import time


def numbered(pattern):
    """The pattern again and again, with a number that counts in place of {}."""
    def text(size):
        parts, length, i = [], 0, 0
        while length < size:
            part = pattern.replace("{}", str(i))
            parts.append(part)
            length += len(part)
            i += 1
        return "".join(parts)
    return text


def repeated(pattern, head="", tail=""):
    return lambda size: head + pattern * max(1, (size - len(head) - len(tail)) // len(pattern)) + tail


KINDS = {
    "wrong_keys": numbered("Light l{} { Sped=1 }\n"),
    "wrong_assignments": numbered("Sped{}=1\n"),
    "unknown_kinds": numbered("Foo f{} { A=1 }\n"),
    "unclosed_blocks": repeated("Robot r {\n"),
    "open_braces": repeated("{"),
    "close_braces": repeated("}"),
    "close_brace_lines": repeated("}\n"),
    "deep_nesting": repeated("Body b { "),
    "wrong_imports": numbered("#import missing{}.sim\n"),
    "wrong_modules": numbered("#loadModule missing{}\n"),
    "wrong_directives": repeated("#include x\n"),
    "one_line_of_words": repeated("abc "),
    "one_long_word": repeated("a"),
    "one_long_string": repeated("a", 'Material m { Texture="', '" }\n'),
    "one_long_number": repeated("1"),
    "one_long_list": repeated("1,", "Tick="),
    "one_long_sum": repeated("1+", "Param a = $("),
    "open_parentheses": repeated("(", "Param a = $("),
    "wrong_values": numbered("Param p{} = $(q{})\n"),
    "circular_params": numbered("Param p{} = $(p{})\n"),
    "comments_in_a_sum": repeated("//\n", "Param a = $(1\n", "+ 1)\n"),
    "numbered_comments": repeated("Foo f { A=1 } // #1\n"),
    "wrong_units": numbered("Light l{} { Pos=1 parsec,0,0 }\n"),
    "repeated_params": repeated("Param p = 1\n"),
    "robots_of_one_config": numbered("Robot r{} { Config=Missing Pos=1,2,0 leftMotor.Resistance=3 }\n"),
    "missing_pictures": numbered("Material m{} { ColorRGB=1,0,0 Texture=no{} }\n"),
    "missing_pictures_long_names": numbered("Material m{} { ColorRGB=1,0,0 Texture=" + "n" * 1200 + "{} }\n"),
    "open_strings": repeated('Param p = "x\n'),
    "unnamed_robots": repeated("Robot {}\n"),
    "blank_lines": repeated("\n"),
    "blank_lines_crlf": repeated("\r\n"),
    "spaces": repeated(" "),
    "indented_blank_lines": repeated("    \n"),
    "empty_comments": repeated("//\n"),
    "comments": repeated("// what was written here once, line by line\n"),
    "open_comment": repeated("a", "/* "),
    "block_comments": repeated("/**/"),
    "control_characters": repeated("\x01"),
    "control_lines": repeated("\x02\x03\n"),
    "zero_bytes": repeated("\0"),
    "bad_utf8": lambda size: b"\xff" * size,
    "invisible_signs": repeated("\u200b"),
    "letters_of_others": repeated("\u00e4\u4e2d "),
    "punctuation": repeated("=.,+-*/^"),
    "random_bytes": lambda size: __import__("random").Random(1).randbytes(size),
    # Valid, like the comments and blank lines above.
    "long_title": repeated("a", 'Title = "', '"\n'),
    "long_sum": repeated("+1", "Param a = $(1", ")\n"),
    "valid_params": numbered("Param p{} = 1\n"),
    "valid_materials": numbered("Material m{} { ColorRGB=1,0,0 }\n"),
    "utf16": lambda size: b"\xff\xfe" + "Robot r {\n".encode("utf-16-le") * (size // 20),
}


def write(path, kind, size):
    """In a process of its own: the memory that this one has had counts in what it starts."""
    if child := os.fork():
        os.waitpid(child, 0)
        return
    text = KINDS[kind](size)
    with open(path, "wb") as file:
        file.write((text if isinstance(text, bytes) else text.encode())[:size])
    os._exit(0)


def measured(command, environment, limit):
    """Processor time in s, peak of the resident memory in MB, exit status; None where it took longer than the limit."""
    started = time.monotonic()
    child = subprocess.Popen(command, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    while True:
        done, status, usage = os.wait4(child.pid, os.WNOHANG)
        seconds = time.monotonic() - started
        if done:
            child.returncode = os.waitstatus_to_exitcode(status)
            return usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024 / 1e6, child.returncode
        if seconds > limit:
            child.kill()
            _, status, usage = os.wait4(child.pid, 0)
            child.returncode = os.waitstatus_to_exitcode(status)
            return usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024 / 1e6, None
        time.sleep(0.01)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default="build/release")
    parser.add_argument("--mib", type=float, default=64)
    parser.add_argument("--kinds", default=",".join(kind for kind in KINDS if not kind.startswith("valid_")),
                        help="those that start with valid_ only if named: of 64 MiB they take several GB")
    parser.add_argument("--programs", default="cli,window")
    parser.add_argument("--view", default="perspective", help="of the window; text shows the text pane")
    parser.add_argument("--limit", type=float, default=120, help="seconds for each")
    options = parser.parse_args()
    programs = {}
    with tempfile.TemporaryDirectory() as folder:
        environment = dict(os.environ, QT_QPA_PLATFORM="offscreen", HOME=folder, XDG_STATE_HOME=folder + "/state", XDG_CONFIG_HOME=folder + "/config",
                           LIBGL_ALWAYS_SOFTWARE="1")
        path, picture = os.path.join(folder, "text.sim"), os.path.join(folder, "picture.png")
        if "cli" in options.programs:
            programs["check"] = [os.path.join(options.build, "bin/trundle-cli"), "check", "--json", path]
        if "window" in options.programs:
            programs["window"] = [os.path.join(options.build, "bin/trundle"), "--view", options.view, "--screenshot", picture, "--quit", path]
        with open(path, "w", encoding="utf-8") as file:
            file.write("Duration = 1s\n")
        small = {name: measured(command, environment, options.limit) for name, command in programs.items()}
        print("small text: " + ", ".join(f"{name} {s:.2f} s, {mb:.0f} MB, exit {code}" for name, (s, mb, code) in small.items()), file=sys.stderr)
        print("| text | " + " | ".join(f"{name}, memory more [MB] | processor time more [s]" for name in programs) + " |")
        print("|---|" + "---|---|" * len(programs), flush=True)
        for kind in options.kinds.split(","):
            write(path, kind, int(options.mib * 1024 * 1024))
            cells = []
            for name, command in programs.items():
                seconds, megabytes, code = measured(command, environment, options.limit)
                worst = "" if code in (0, 1) else " (cut off)" if code is None else f" (exit {code})"
                cells += [f"{megabytes - small[name][1]:.0f}", f"{seconds - small[name][0]:.1f}{worst}"]
            print(f"| {kind} | " + " | ".join(cells) + " |", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
