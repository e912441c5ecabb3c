#!/usr/bin/env python3
"""The car among many roadblocks, judged on generated maps: `taut drive --all` of all planners, both readings of walls.

roadblocks.py TAUT [--maps N] [--samples N] [--seed N] [--roadblocks LIST] [--lane N] [--csv FILE]

Maps take the numbers of roadblocks in turn, and seeds from --seed on. A line a map, reading and planner: samples
reached, mean and worst steps, mean steps over the better of optimist and pessimist with the standard error of that
(the same samples, pair by pair), CPU seconds and peak memory of the whole process; at the end the same over all maps.
Every sample that the clairvoyant reaches has to be reached by all, without a collision; the mean of `policy --policy
expected` has to stay within 2 % of the better of optimist and pessimist, the worst of `--policy worst` within 2 % of
the better's worst, 100 samples within 15 s of CPU, and all within 300 MB: what fails is named, and then the exit code
is 1.
"""
import argparse
import csv
import json
import os
import statistics
import subprocess
import sys
import tempfile

PLANNERS = {
    "clairvoyant": ["--planner", "clairvoyant"],
    "optimist": ["--planner", "optimist"],
    "pessimist": ["--planner", "pessimist"],
    "policy, expected": ["--policy", "expected"],
    "policy, worst": ["--policy", "worst"],
}
MOST_OVER = 1.02
MOST_BYTES = 300e6
MOST_SECONDS_A_HUNDRED = 15


def cpu_and_memory(command):
    """(stdout, CPU seconds, peak bytes) of one process."""
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    out = process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode not in (0, 1, 4):
        raise SystemExit(f"{' '.join(command)}: exit code {process.returncode}")
    return out, usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024


def drive(taut, file, walls, planner):
    """The samples' outcomes and steps, and what they took."""
    command = [taut, "drive", file, "--all", "--walls", walls, *PLANNERS[planner], "--json", "-", "--quiet"]
    out, seconds, peak = cpu_and_memory(command)
    samples = json.loads(out)["result"]["samples"]
    return {
        "outcomes": [s["outcome"] for s in samples],
        "steps": [s["steps"] for s in samples],
        "exact": all(s.get("policy_exact", False) for s in samples),
        "seconds": seconds,
        "bytes": peak,
    }


def mean_of(run):
    reached = [n for n, o in zip(run["steps"], run["outcomes"]) if o == "reached"]
    return statistics.mean(reached) if reached else 0.0


def worst_of(run):
    return max((n for n, o in zip(run["steps"], run["outcomes"]) if o == "reached"), default=0)


def base_of(runs, of):
    """The better of optimist and pessimist, None where neither was driven."""
    return min((runs[p] for p in ("optimist", "pessimist") if p in runs), key=of, default=None)


def over(run, base):
    """Of the mean, in per cent, and its standard error."""
    pairs = [(a, b) for a, b, o, p in zip(run["steps"], base["steps"], run["outcomes"], base["outcomes"])
             if o == p == "reached"]
    if not pairs:
        return 0.0, 0.0
    mean = statistics.mean(b for _, b in pairs)
    differences = [a - b for a, b in pairs]
    error = statistics.stdev(differences) / len(pairs) ** 0.5 if len(pairs) > 1 else 0.0
    return 100 * statistics.mean(differences) / mean, 100 * error / mean


def faults_of(runs, samples):
    """What breaks a promise, in words."""
    faults = []
    measure = runs.get("clairvoyant", next(iter(runs.values())))
    base, least = base_of(runs, mean_of), base_of(runs, worst_of)
    for planner, run in runs.items():
        if "collision" in run["outcomes"]:
            faults.append(f"{planner}: a collision")
        lost = sum(a == "reached" and b != "reached" for a, b in zip(measure["outcomes"], run["outcomes"]))
        if lost:
            faults.append(f"{planner}: {lost} samples lost")
        if planner == "policy, expected" and base and mean_of(run) > MOST_OVER * mean_of(base):
            more, error = over(run, base)
            faults.append(f"{planner}: {more:.1f} % over the better of the two, standard error {error:.1f} %")
        if planner == "policy, worst" and least and worst_of(run) > MOST_OVER * worst_of(least):
            faults.append(f"{planner}: its worst {100 * (worst_of(run) / worst_of(least) - 1):.1f} % over the better's")
        if run["seconds"] > MOST_SECONDS_A_HUNDRED * samples / 100:
            faults.append(f"{planner}: {run['seconds']:.1f} s CPU")
        if run["bytes"] > MOST_BYTES:
            faults.append(f"{planner}: {run['bytes'] / 1e6:.0f} MB")
    return faults


def row_of(runs, planner):
    run, base = runs[planner], base_of(runs, mean_of)
    more, error = over(run, base) if base else (0.0, 0.0)
    return {
        "reached": run["outcomes"].count("reached"),
        "mean": round(mean_of(run), 1),
        "worst": worst_of(run),
        "over": round(more, 2),
        "error": round(error, 2),
        "seconds": round(run["seconds"], 2),
        "megabytes": round(run["bytes"] / 1e6),
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("taut")
    parser.add_argument("--maps", type=int, default=20)
    parser.add_argument("--samples", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--side", type=int, default=50)
    parser.add_argument("--roadblocks", default="12,16,24")
    parser.add_argument("--lane", type=int, help="cells across the narrowest lanes; by default 2, for squares 3")
    parser.add_argument("--walls", default="points,squares")
    parser.add_argument("--planners", default=";".join(PLANNERS), help="separated by semicolons")
    parser.add_argument("--csv")
    options = parser.parse_args()
    numbers = [int(n) for n in options.roadblocks.split(",")]
    planners = options.planners.split(";")
    rows, faults = [], []
    form = "{:>10} {:>5} {:<8} {:<17} {:>7} {:>8} {:>7} {:>7} {:>7} {:>7} {:>6}"
    print(form.format("roadblocks", "seed", "walls", "planner", "reached", "mean", "worst", "over %", "error %",
                      "CPU s", "MB"))
    with tempfile.TemporaryDirectory() as scratch:
        for k in range(options.maps):
            number, seed = numbers[k % len(numbers)], options.seed + k
            file = os.path.join(scratch, "map.txt")
            for walls in options.walls.split(","):
                lane = options.lane or (3 if walls == "squares" else 2)
                subprocess.run([options.taut, "generate", "--kind", "roadblocks", "--size", str(options.side),
                                "--roadblocks", str(number), "--samples", str(options.samples), "--seed", str(seed),
                                "--lane", str(lane), "-o", file], check=True)
                runs = {planner: drive(options.taut, file, walls, planner) for planner in planners}
                for fault in faults_of(runs, options.samples):
                    faults.append(f"{number} roadblocks, seed {seed}, {walls}: {fault}")
                for planner in planners:
                    row = {"roadblocks": number, "seed": seed, "walls": walls, "planner": planner}
                    row |= row_of(runs, planner)
                    rows.append(row)
                    print(form.format(*row.values()), flush=True)
    print("\nover all maps: mean of the means, worst, CPU s, most MB")
    for walls in options.walls.split(","):
        for planner in planners:
            mine = [r for r in rows if r["walls"] == walls and r["planner"] == planner and r["reached"]]
            if mine:
                print(f"  {walls:<8} {planner:<17} {statistics.mean(r['mean'] for r in mine):8.1f} "
                      f"{max(r['worst'] for r in mine):6} {sum(r['seconds'] for r in mine):8.1f} "
                      f"{max(r['megabytes'] for r in mine):5}")
    if options.csv:
        with open(options.csv, "w", newline="") as out:
            writer = csv.DictWriter(out, rows[0].keys())
            writer.writeheader()
            writer.writerows(rows)
    print("\n" + ("\n".join(faults) if faults else "all bars hold"))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
