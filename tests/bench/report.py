"""CSV files, and Markdown tables between markers of RESULTS.md."""

import csv
import datetime
import os
import re

_loads = []  # since the section began


def write_csv(path, header, rows):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(header)
        writer.writerows(rows)


def markdown(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    lines += ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]
    return "\n".join(lines)


def begin_section():
    """From here on the machine's load is noted below each table."""
    _loads[:] = [os.getloadavg()[0]]


def sample_load():
    _loads.append(os.getloadavg()[0])


def _load_note():
    sample_load()
    return f"\n\n{datetime.date.today()}, load average {min(_loads):.1f} to {max(_loads):.1f} on {os.cpu_count()} cores." if _loads else ""


def put_table(path, name, header, rows):
    """The table, and how busy the machine was while it was measured."""
    put(path, name, markdown(header, rows) + _load_note())


def put(path, name, text):
    """Replaces what stands between `<!-- begin name -->` and `<!-- end name -->`."""
    with open(path, encoding="utf-8") as file:
        old = file.read()
    begin, end = f"<!-- begin {name} -->", f"<!-- end {name} -->"
    pattern = re.compile(re.escape(begin) + ".*?" + re.escape(end), re.DOTALL)
    if not pattern.search(old):
        raise ValueError(f"{path} has no place for {name}")
    new = pattern.sub(lambda _: f"{begin}\n{text}\n{end}", old)
    with open(path, "w", encoding="utf-8") as file:
        file.write(new)
