#!/bin/sh
# Measures this machine: rewrites the tables and the plot of docs/performance.md, then prints what a
# scan, a tick, the start, and the introduction program in lock-step over TCP take. Needs ./check's
# build and a quiet machine, for about 6 minutes. Run: sh benchmarks/run.sh
set -eu
cd "$(dirname "$0")/.."
bin=build/release/bin
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

python3 benchmarks/report.py measure "$bin"
python3 benchmarks/report.py write
"$bin/scan_benchmark" --benchmark_min_time=1

# From the start of the process to its end after one tick: an upper bound of the start to the first
# tick. The smallest of seven, as the machine may be busy.
/usr/bin/env python3 - "$bin" <<'PY'
import json, os, resource, subprocess, sys, tempfile, time
program = os.path.join(sys.argv[1], "ccmorse")
command = [program, "run", "syrotek", "--pace", "max", "--for", "0.016", "--port", "0",
           "--stream-port", "0", "-q"]
times = []
for _ in range(7):
    start = time.perf_counter()
    subprocess.run(command, check=True)
    times.append(time.perf_counter() - start)
peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
print(f"process start to first tick and end: {min(times) * 1000:.1f} ms (median "
      f"{sorted(times)[3] * 1000:.1f}), peak memory {peak:.1f} MB")

factors = []
for _ in range(5):
    with tempfile.TemporaryDirectory() as folder:
        report = os.path.join(folder, "report.json")
        simulator = subprocess.Popen(
            [program, "run", "syrotek", "--pace", "lockstep", "--for", "120", "--port", "0",
             "--stream-port", "0", "--report", report], stdout=subprocess.PIPE, text=True)
        for line in simulator.stdout:
            if line.startswith("MORSE services"):
                port = line.split()[-1]
                break
        subprocess.run([os.path.join(sys.argv[1], "intro"), "--port", port], check=True,
                       env={**os.environ, "IMR_LOG": "info"}, stdout=subprocess.DEVNULL)
        simulator.communicate()
        with open(report) as file:
            factors.append(json.load(file)["real_time_factor"])
factors.sort()
print(f"introduction program in lock-step over TCP: {factors[2]:.0f} simulated s per wall s "
      f"(median of 5; {factors[0]:.0f} to {factors[-1]:.0f})")
PY
