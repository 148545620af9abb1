"""Writes the tests of the table's rows for CTest: list_tests.py RESULTS FILE

Each is a line of RESULTS, which MorseTable.run writes (run_table.py).
"""

import sys

sys.dont_write_bytecode = True

import rows  # noqa: E402


def main():
    results, target = sys.argv[1:]
    lines = []
    names = [row["id"] for table in rows.all_rows().values() for row in table]
    for name in names + ["nothing_pending_is_done", "nothing_is_missing"]:
        test = "MorseTable." + name
        lines.append('add_test("%s" grep -F -m 1 "[%s] " "%s")' % (test, name, results))
        lines.append('set_tests_properties("%s" PROPERTIES FIXTURES_REQUIRED MorseTable '
                     'PASS_REGULAR_EXPRESSION "^[^ ]+ pass")' % test)
    with open(target, "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
