#!/usr/bin/env python3
"""Measures this machine and writes the figures of docs/performance.md.

Usage: report.py measure BIN   runs `ccmorse bench` of the build in BIN, writes benchmarks/results.json
       report.py write         writes the tables between the marks of docs/performance.md and
                               docs/images/performance.svg from benchmarks/results.json
"""

import json
import math
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
RESULTS = ROOT / "benchmarks" / "results.json"
PAGE = ROOT / "docs" / "performance.md"
PLOT = ROOT / "docs" / "images" / "performance.svg"

ROBOTS = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000]
STRETCH = 2.0  # wall-clock s of each measurement; of three the median counts

# Simulated seconds per wall-clock second by robots, measured on two cores of an AMD EPYC (Zen 3
# class, 2.45 GHz), Debian 12, world loading excluded, median of 3, the fleet that `ccmorse bench
# fleet` simulates. Where a range was measured, its middle.
PEERS = {
    "Stage 4.3, 10 Hz": {1: 287, 10: 19.5, 100: 1.69, 1000: 0.161},
    "Stage 4.3, 100 Hz": {1: 100, 10: 24.6, 100: 1.63, 1000: 0.136},
    "ARGoS 3, 1 thread": {1: 555, 10: 26.6, 100: 1.35, 1000: 0.059},
    "ARGoS 3, 2 threads": {1: 133, 10: 34.4, 100: 2.48, 1000: 0.112},
    "MVSim 0.8.3, 100 Hz": {1: 333, 10: 24.3, 100: 1.85, 1000: 0.140},
}
DRAWN_PEERS = ["Stage 4.3, 10 Hz", "ARGoS 3, 2 threads", "MVSim 0.8.3, 100 Hz"]


# --- Measuring


def bench(program, *words):
    done = subprocess.run([program, "bench", *words, "--json"], check=True, stdout=subprocess.PIPE)
    return json.loads(done.stdout)


def fleet(program, robots, threads):
    """The median of three runs by simulated seconds per wall-clock second."""
    def run(seconds):
        return bench(program, "fleet", "--robots", str(robots), "--threads", str(threads),
                     "--seconds", f"{min(max(seconds, 0.5), 1e6):.1f}")
    seconds = run(1000 / robots)["sim_s_per_wall_s"] * STRETCH
    runs = sorted((run(seconds) for _ in range(3)), key=lambda r: r["sim_s_per_wall_s"])
    return runs[1]


def measure(folder):
    program = str(pathlib.Path(folder) / "ccmorse")
    results = bench(program, "all")
    results["fleets"] = []
    for robots in ROBOTS:
        print(f"measuring: {robots} robots", file=sys.stderr)
        results["fleets"].append({"one_thread": fleet(program, robots, 1),
                                  "all_threads": fleet(program, robots, 0)})
    RESULTS.write_text(json.dumps(results, indent=1) + "\n")


# --- Writing


def number(value):
    """Three digits that count, and no exponent."""
    if value is None:
        return "-"
    if value >= 100:
        digits = 10 ** max(len(str(int(value))) - 3, 0)
        return f"{round(value / digits) * digits:,}"
    return f"{value:.3g}"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|---" * len(head) + "|"]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines)


def verdict(row):
    if row["met"] is None:
        return "not measured"
    if not row["met"]:
        return "**no**"
    return "yes, and the aim" if row["aim_met"] else "yes"


def figures(results):
    rows = [[row["what"], row["unit"], number(row["required"]), number(row["aim"]),
             number(row["measured"]), verdict(row)] for row in results["rows"]]
    return f"Measured on: {results['machine']}.\n\n" + table(
        ["", "unit", "required", "aim", "measured", "met?"], rows)


def growth(results):
    rows = []
    for pair in results["fleets"]:
        one, every = pair["one_thread"], pair["all_threads"]
        robots = one["robots"]
        rows.append([number(robots), number(one["sim_s_per_wall_s"]),
                     number(every["sim_s_per_wall_s"]),
                     number(1e6 / (one["sim_s_per_wall_s"] * robots)),
                     number(every["rays_per_s"] * 1e-6), number(every["peak_rss_mb"]),
                     number(every["load_s"])])
    return table(["robots", "sim s / wall s, one thread", "all threads",
                  "us a robot and simulated s, one thread", "M rays/s, all threads", "memory, MB",
                  "load, s"], rows)


def comparison(results):
    ours = {p["all_threads"]["robots"]: p["all_threads"]["sim_s_per_wall_s"]
            for p in results["fleets"]}
    counts = [1, 10, 100, 1000]
    rows = [["CCMorse, all threads"] + [number(ours[n]) for n in counts]]
    rows += [[name] + [number(speed[n]) for n in counts] for name, speed in PEERS.items()]
    best = {n: max(speed[n] for speed in PEERS.values()) for n in counts}
    rows.append(["CCMorse against the best of them"] +
                [f"{number(ours[n] / best[n])} times" for n in counts])
    return table(["simulated s per wall s"] + [f"N = {n}" for n in counts], rows)


def plot(results):
    """Robots against simulated seconds per wall-clock second, both logarithmic, as SVG."""
    left, top, width, height = 70, 40, 500, 380
    x_low, x_high, y_low, y_high = 0.0, math.log10(6000), -2.0, 5.0

    def x(robots):
        return left + width * (math.log10(robots) - x_low) / (x_high - x_low)

    def y(speed):
        return top + height * (y_high - math.log10(speed)) / (y_high - y_low)

    out = []

    def text(at_x, at_y, words, anchor="start", extra=""):
        out.append(f'<text x="{at_x:.1f}" y="{at_y:.1f}" text-anchor="{anchor}"{extra}>{words}</text>')

    def line(x1, y1, x2, y2, style):
        out.append(f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" {style}/>')

    for exponent in range(int(y_low), int(y_high) + 1):
        at = y(10 ** exponent)
        line(left, at, left + width, at, 'stroke="#dddddd"')
        label = f"{10 ** exponent:,}" if exponent >= 0 else f"{10 ** exponent:g}"
        text(left - 8, at + 4, label, "end")
    for robots in (1, 10, 100, 1000):
        line(x(robots), top, x(robots), top + height, 'stroke="#dddddd"')
        text(x(robots), top + height + 18, f"{robots:,}", "middle")
    line(left, y(1), left + width, y(1), 'stroke="#888888" stroke-dasharray="6 4"')
    text(left + 6, y(1) + 16, "real time", extra=' fill="#666666"')
    text(left + width / 2, top + height + 40, "robots, each with a laser of 682 beams at 10 Hz",
         "middle")
    text(left - 50, top - 16, "simulated seconds per wall-clock second", extra=' font-weight="bold"')

    series = [
        ("CCMorse, all threads", "#0b5fa5", 3,
         {p["all_threads"]["robots"]: p["all_threads"]["sim_s_per_wall_s"]
          for p in results["fleets"]}),
        ("CCMorse, one thread", "#6aaede", 2,
         {p["one_thread"]["robots"]: p["one_thread"]["sim_s_per_wall_s"]
          for p in results["fleets"]}),
    ]
    for name, color in zip(DRAWN_PEERS, ("#d62828", "#e08a00", "#5a8f29")):
        series.append((name, color, 2, PEERS[name]))
    for position, (name, color, stroke, points) in enumerate(series):
        places = [(x(n), y(speed)) for n, speed in sorted(points.items())]
        path = " ".join(f"{px:.1f},{py:.1f}" for px, py in places)
        out.append(f'<polyline points="{path}" fill="none" stroke="{color}" stroke-width="{stroke}"/>')
        out += [f'<circle cx="{px:.1f}" cy="{py:.1f}" r="3" fill="{color}"/>' for px, py in places]
        at = top + 24 + 20 * position
        line(left + width + 20, at - 4, left + width + 44, at - 4,
             f'stroke="{color}" stroke-width="{stroke}"')
        text(left + width + 52, at, name)
    body = "\n".join(out)
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 800 480" font-family="sans-serif" '
            f'font-size="13">\n<rect width="800" height="480" fill="#ffffff"/>\n{body}\n</svg>\n')


def write():
    results = json.loads(RESULTS.read_text())
    page = PAGE.read_text()
    for mark, made in (("figures", figures), ("growth", growth), ("comparison", comparison)):
        begin, end = f"<!-- {mark}: written by benchmarks/run.sh -->\n", f"\n<!-- end of {mark} -->"
        before, rest = page.split(begin)
        page = before + begin + made(results) + end + rest.split(end)[1]
    PAGE.write_text(page)
    PLOT.write_text(plot(results))


def main():
    words = sys.argv[1:]
    if len(words) == 2 and words[0] == "measure":
        measure(words[1])
    elif words == ["write"]:
        write()
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main()
