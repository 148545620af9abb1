"""Runs the tests of the table's rows (table/README.md): run_table.py [--out RESULTS] [WORD...]

Each row gets a line "[ID] pass (how far)" or "[ID] FAIL: why (FILE:LINE)" in RESULTS, or on the
standard output where it fails and no file is named. With words, only rows whose id has one of them
count. CCMORSE names the program.
"""

import argparse
import collections
import os
import sys

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "table"))

from support import PYTHON, environment  # noqa: E402

# Our package, not Debian's of the same name.
sys.path.insert(0, PYTHON)

import builder_rows  # noqa: E402
import rows  # noqa: E402
import simulator_rows  # noqa: E402

ENTRIES = {"components.csv": builder_rows.check_component_entry,
           "fields.csv": builder_rows.check_field_entry,
           "properties.csv": builder_rows.check_property_entry,
           "presets.csv": builder_rows.check_preset_entry,
           "modifiers.csv": builder_rows.check_modifier_entry}
# In this order: messages to the fields of actuators have time go on, which services do without.
RUNS = ("components.csv", "modifiers.csv", "properties.csv", "presets.csv", "services.csv",
        "fields.csv")
QUIT = "service.simulation.quit"  # comes last
OF_NO_COMPONENT = ("*", "simulation", "time", "communication", "Victim", "Human", "BasePR2")


def attempt(results, row, function):
    """Adds what comes of a test of a row to what came of others."""
    try:
        status = function(row)
    except Exception as error:  # whatever is wrong belongs to the row
        text = str(error) if isinstance(error, builder_rows.Wrong) else "%s: %s" % (
            type(error).__name__, error)
        results[row["id"]] = "FAIL: %s (%s)" % (" ".join(text.split()), row["place"])
        return
    if not results.get(row["id"], "").startswith("FAIL") and status:
        results[row["id"]] = "pass (%s)" % status


def run(tables, ccmorse):
    """Id -> "pass ..." or "FAIL ..." of all rows."""
    results = {}
    sys.argv = ["run_table.py"]
    for row in tables["builder.csv"]:
        attempt(results, row, builder_rows.check_builder_row)
    for table in RUNS:
        for row in tables[table]:
            component = row["component"]
            if component.split(" ")[0] in OF_NO_COMPONENT:
                continue
            results[row["id"]] = "pass (%s)" % builder_rows.status_of(
                builder_rows.entry_of(component))
            check = ENTRIES.get(table, builder_rows.check_service_entry)
            attempt(results, row, check)
            if results[row["id"]] == "pass (simulated)":
                results[row["id"]] = "pass (accepted)"  # until a run has shown it
    runs = simulator_rows.Runs(tables, ccmorse, environment())
    try:
        methods = {"components.csv": runs.component, "modifiers.csv": runs.modifier,
                   "fields.csv": runs.field, "properties.csv": runs.property,
                   "presets.csv": runs.preset, "services.csv": runs.service}
        for table in RUNS:
            for row in tables[table]:
                if row["id"] != QUIT and not results.get(row["id"], "").startswith("FAIL"):
                    attempt(results, row, methods[table])
        quits = [row for row in tables["services.csv"] if row["id"] == QUIT]
        attempt(results, quits[0], runs.service)
    finally:
        runs.close()
    return results


def forgive(results):
    """Lets rows pass that pending.csv has, and complains of those there that need it no longer."""
    done = []
    for name, reason in rows.pending().items():
        if name not in results:
            done.append("%s (there is no such row)" % name)
        elif results[name].startswith("FAIL"):
            results[name] = "pass (pending)"
        else:
            done.append(name)
    results["nothing_pending_is_done"] = "pass (table)" if not done else (
        "FAIL: these pass now, take their lines out of tests/morse/table/pending.csv: " +
        ", ".join(done))


OWN = ("nothing_pending_is_done", "nothing_is_missing")  # tests of the tables themselves


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out")
    parser.add_argument("words", nargs="*")
    options = parser.parse_args()
    tables = rows.all_rows()
    results = run(tables, os.environ["CCMORSE"])
    forgive(results)
    missing = builder_rows.missing_rows(tables)
    results["nothing_is_missing"] = ("FAIL: no row has " + "; ".join(missing) if missing else
                                     "pass (table)")
    kinds, wrong = collections.Counter(), 0
    text = []
    for name in [row["id"] for table in tables.values() for row in table] + list(OWN):
        if options.words and not any(word in name for word in options.words):
            continue
        line = "[%s] %s" % (name, results[name])
        text.append(line + "\n")
        bad = results[name].startswith("FAIL")
        wrong += bad
        kinds[name.split(".")[0], "FAIL" if bad else results[name][6:-1]] += 1
        if bad and not options.out:
            print(line)
    if options.out:
        with open(options.out, "w", encoding="utf-8") as file:
            file.writelines(text)
    for (kind, status), count in sorted(kinds.items()):
        print("%-12s %-10s %4d" % (kind, status, count))
    print("%d rows, %d wrong" % (sum(kinds.values()), wrong))
    # Of a row that is wrong its own test tells.
    return 1 if wrong and not options.out else 0


if __name__ == "__main__":
    sys.exit(main())
