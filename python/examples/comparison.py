"""Planners side by side on one maze, as a table; with pandas, pandas.DataFrame(rows) is it.

usage: comparison.py [MAZE]
"""

import collections
import csv
import statistics
import sys

import taut

space = taut.FreeSpace(taut.read_world_file(sys.argv[1] if len(sys.argv) > 1 else "data/maze_25x25.txt"))
rows = taut.compare(space, runs=5, seed=1)
table = csv.DictWriter(sys.stdout, ["planner", "solved", "ratio", "clearance", "build_seconds", "query_seconds"])
table.writeheader()
by_planner = collections.defaultdict(list)
for row in rows:
    by_planner[row["planner"]].append(row)
for planner, runs in by_planner.items():
    solved = [run for run in runs if run["solved"]]
    numbers = {name: statistics.median(run[name] for run in solved) for name in table.fieldnames[2:] if solved}
    table.writerow({"planner": planner, "solved": f"{len(solved)}/{len(runs)}", **numbers})
