"""The rows of this folder's tables, and the names of their tests.

The tables hold what MORSE 1.4 has, copied out of its specification (specs: morse.md) and not out of
our own code: one line a class, method, field, property, service, modifier. README.md says what the
columns mean.
"""

import csv
import os

HERE = os.path.dirname(os.path.abspath(__file__))

# File -> what names a row in it, in order; a word that is no column stands for itself.
TABLES = {
    "builder.csv": ("kind", "owner", "name"),
    "components.csv": ("component:", "component"),
    "fields.csv": ("field:", "component", "field"),
    "properties.csv": ("property:", "component", "property"),
    "presets.csv": ("preset:", "component", "property"),
    "services.csv": ("service:", "component", "service"),
    "modifiers.csv": ("modifier:", "component", "modifier"),
}


def load(table):
    """Dicts of a table's rows, with `id`, the name of their test, and `place`, "FILE:LINE"."""
    rows = []
    with open(os.path.join(HERE, table), encoding="utf-8", newline="") as file:
        reader = csv.DictReader(file)
        for row in reader:
            words = [word[:-1] if word.endswith(":") else row[word] for word in TABLES[table]]
            row["id"] = ".".join(word.replace(" ", "_").replace("'", "") for word in words)
            row["place"] = "tests/morse/table/%s:%d" % (table, reader.line_num)
            rows.append(row)
    return rows


def pending():
    """Id -> reason of the rows that are known to fail."""
    with open(os.path.join(HERE, "pending.csv"), encoding="utf-8", newline="") as file:
        return {row["row"]: row["reason"] for row in csv.DictReader(file)}


def all_rows():
    """Table -> its rows."""
    return {table: load(table) for table in TABLES}
