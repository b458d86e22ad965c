"""CSV files, and Markdown tables between markers of RESULTS.md."""

import csv
import os
import re


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
