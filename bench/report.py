#!/usr/bin/env python3
"""Tables of what the benches measured: one table a program, a row for each size, a column for each benchmark.

report.py RUN.json... [--json ALL.json] [--readme README.md] [--against OLD.json]

RUN.json are outputs of Google Benchmark (--benchmark_out). Cells are CPU times of one call, the median where a bench was
repeated; of benches that tell their memory there is a table of that, too. --json keeps the figures, --readme puts the
tables between its marks, --against says how they changed. A run may also be an ALL.json of before: then the tables are
written from that.
"""
import argparse
import json
import os
import re
import sys

BEGIN, END = "<!-- figures: written by ./dev bench -->", "<!-- end of figures -->"
MEMORY = ", memory"
NANOSECONDS = {"ns": 1, "us": 1e3, "ms": 1e6, "s": 1e9}
OPTIONS = re.compile(r"/(iterations|repeats|min_time|process_time|real_time|manual_time|threads)(:[^/]*)?")


def figures_of(run):
    """{(benchmark, size): CPU nanoseconds} of one program's run; errors are named on stderr and left out."""
    figures = {}
    for bench in run["benchmarks"]:
        if bench.get("error_occurred"):
            print(f"{bench['name']}: {bench['error_message']}", file=sys.stderr)
            continue
        median = bench.get("aggregate_name") == "median"
        if bench.get("run_type") == "aggregate" and not median:
            continue
        parts = OPTIONS.sub("", bench.get("run_name", bench["name"])).split("/")
        numbers = [p for p in parts if re.fullmatch(r"(\w+:)?-?\d+", p)]
        name = "/".join(p for p in parts if p not in numbers).removeprefix("BM_")
        key = (name, " x ".join(numbers))
        if median or key not in figures:
            figures[key] = bench["cpu_time"] * NANOSECONDS[bench["time_unit"]]
    return figures


def memory_of(run):
    """{(benchmark, size): peak bytes} of those that tell."""
    return {(bench["name"].removeprefix("BM_"), ""): bench["memory_bytes"]
            for bench in run["benchmarks"] if "memory_bytes" in bench}


def bytes_text(count):
    return f"{count / 1e6:.3g} MB" if count < 1e9 else f"{count / 1e9:.3g} GB"


def text_of(nanoseconds):
    for unit, size in (("s", 1e9), ("ms", 1e6), ("us", 1e3)):
        if nanoseconds >= size:
            return f"{nanoseconds / size:.3g} {unit}"
    return f"{nanoseconds:.3g} ns"


def grouped(figures):
    """`process/maze512-1` and the like: what is measured becomes the column, what on the row."""
    if not all(size == "" and name.count("/") == 1 for name, size in figures):
        return figures
    return {tuple(name.split("/")): value for (name, _), value in figures.items()}


def table_of(figures, text=text_of):
    """Rows are sizes, columns benchmarks, both in the order in which they ran."""
    names = list(dict.fromkeys(name for name, _ in figures))
    sizes = list(dict.fromkeys(size for _, size in figures))
    rows = ["| | " + " | ".join(f"`{name}`" for name in names) + " |", "|---" * (len(names) + 1) + "|"]
    for size in sizes:
        cells = [text(figures[name, size]) if (name, size) in figures else "" for name in names]
        rows.append(f"| {size} | " + " | ".join(cells) + " |")
    return "\n".join(rows)


def table_of_program(program, figures):
    text = bytes_text if program.endswith(MEMORY) else text_of
    return f"### {program}\n\n{table_of(grouped(figures) if program.startswith('process') else figures, text)}"


def program_of(run, file):
    return os.path.basename(run.get("context", {}).get("executable", file)).removesuffix(".json")


def changes(old, new):
    rows = ["| bench | size | was | is | ratio |", "|---|---|---|---|---|"]
    for program, figures in new.items():
        text = bytes_text if program.endswith(MEMORY) else text_of
        for (name, size), now in figures.items():
            was = old.get(program, {}).get(f"{name}|{size}")
            if was:
                rows.append(f"| {program} `{name}` | {size} | {text(was)} | {text(now)} | {now / was:.2f} |")
    return "\n".join(rows)


def all_of(files):
    """{program: {(benchmark, size): figure}}, of outputs of benches and of figures that were kept."""
    figures = {}
    for file in files:
        with open(file, encoding="utf-8") as opened:
            run = json.load(opened)
        if "benchmarks" not in run:
            for program, kept in run.items():
                figures[program] = {tuple(key.rsplit("|", 1)): value for key, value in kept.items()}
            continue
        for name, found in ((program_of(run, file), figures_of(run)), (program_of(run, file) + MEMORY, memory_of(run))):
            if found:
                figures[name] = found
    return figures


def rewrite(readme, tables):
    with open(readme, encoding="utf-8") as file:
        text = file.read()
    head, rest = text.split(BEGIN, 1)
    tail = rest.split(END, 1)[1]
    with open(readme, "w", encoding="utf-8") as file:
        file.write(f"{head}{BEGIN}\n\n{tables}\n\n{END}{tail}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", nargs="+", metavar="RUN.json")
    parser.add_argument("--json", metavar="ALL.json")
    parser.add_argument("--readme", metavar="README.md")
    parser.add_argument("--against", metavar="OLD.json")
    options = parser.parse_args()
    all_figures = all_of(options.runs)
    tables = "\n\n".join(table_of_program(program, figures) for program, figures in all_figures.items())
    flat = {p: {f"{name}|{size}": t for (name, size), t in f.items()} for p, f in all_figures.items()}
    if options.json:
        with open(options.json, "w", encoding="utf-8") as file:
            json.dump(flat, file, indent=1)
    if options.readme:
        rewrite(options.readme, tables)
    if options.against:
        with open(options.against, encoding="utf-8") as file:
            print(changes(json.load(file), all_figures))
    else:
        print(tables)


if __name__ == "__main__":
    try:
        main()
    except BrokenPipeError:
        sys.exit(1)
