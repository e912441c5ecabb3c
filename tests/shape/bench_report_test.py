#!/usr/bin/env python3
"""bench/report.py and bench/process.py: figures in, tables out. bench_report_test.py ROOT TAUT"""
import json
import os
import subprocess
import sys
import tempfile

root, taut = sys.argv[1:]


def report(*arguments):
    return subprocess.run([sys.executable, f"{root}/bench/report.py", *arguments], check=True, capture_output=True,
                          text=True).stdout


def run_of(time):
    return {"context": {"executable": "build/a_bench"}, "benchmarks": [
        {"name": "BM_Query/25", "run_name": "BM_Query/25", "cpu_time": time, "time_unit": "us"},
        {"name": "BM_Query/25_median", "run_name": "BM_Query/25", "run_type": "aggregate", "aggregate_name": "median",
         "cpu_time": 2 * time, "time_unit": "us"},
        {"name": "BM_Broken/25", "run_name": "BM_Broken/25", "error_occurred": True, "error_message": "another length"}]}


with tempfile.TemporaryDirectory() as folder:
    def file(name, value):
        path = os.path.join(folder, name)
        with open(path, "w", encoding="utf-8") as out:
            out.write(value if isinstance(value, str) else json.dumps(value))
        return path

    def text(name):
        with open(os.path.join(folder, name), encoding="utf-8") as opened:
            return opened.read()

    # What the program takes as a whole, with its memory.
    subprocess.run([sys.executable, f"{root}/bench/process.py", taut, "--filter", "(process|query)/maze512-8$", "--runs", "1",
                    "--out", os.path.join(folder, "process.json")], check=True, capture_output=True)
    old, readme = file("old.json", run_of(30)), file("README.md", "head\n<!-- figures: written by ./dev bench -->\nold\n"
                                                     "<!-- end of figures -->\ntail\n")
    tables = report(old, os.path.join(folder, "process.json"), "--json", os.path.join(folder, "all.json"), "--readme", readme)
    assert "### a_bench" in tables and "| 25 | 60 us |" in tables, tables
    assert "### process" in tables and "| | `process` | `query` |" in tables and "| maze512-8 | " in tables, tables
    memory = tables.split("### process, memory")[1]
    assert " MB |" in memory, tables
    assert text("README.md") == ("head\n<!-- figures: written by ./dev bench -->\n\n" + tables.strip() +
                                 "\n\n<!-- end of figures -->\ntail\n"), text("README.md")
    # The figures that were kept say the same as the runs, and how the next ones differ.
    assert report(os.path.join(folder, "all.json")) == tables
    changes = report(file("new.json", run_of(15)), "--against", os.path.join(folder, "all.json"))
    assert "| a_bench `Query` | 25 | 60 us | 30 us | 0.50 |" in changes, changes
