#!/usr/bin/env python3
"""Does what docs/course/student.md tells students, to the letter: its ```sh blocks, in their order.

    handbook_test.py SOURCE_DIR BINARY_DIR

Blocks marked `install` are left out, as what they do is there already. HOME is a temporary folder,
and the source tree a folder of links, so that nothing is written into the real one. Checks that each
block ends well, that the report is there, and that the vehicle of step 5 beats the template.
"""

import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile

SKIPPED = 77


def blocks(text):
    """The code of all blocks that are to be run."""
    return [code for mark, code in re.findall(r"^```sh([^\n]*)\n(.*?)^```$", text, re.M | re.S)
            if mark.strip() != "install"]


def make_tree(source, binary, place):
    """The source tree as a student has it, with this build as its build/release."""
    os.makedirs(place + "/build")
    for name in os.listdir(source):
        if name not in ("build", ".git"):
            os.symlink(os.path.join(source, name), os.path.join(place, name))
    os.symlink(binary, place + "/build/release")


def run(source, binary, folder):
    home = folder + "/home"
    tree = folder + "/ccmorse"
    os.mkdir(home)
    make_tree(source, binary, tree)
    with open(source + "/docs/course/student.md", encoding="utf-8") as page:
        code = blocks(page.read())
    assert len(code) >= 5, f"only {len(code)} blocks were found"
    # Like a terminal that stays open: one shell for all. It stops at what fails, and says where it
    # was.
    script = "set -e\n" + "\n".join(
        f"echo '--- block {number}'\n{block}" for number, block in enumerate(code, 1))
    keep = {name: os.environ[name] for name in ("PATH", "LANG") if name in os.environ}
    # What is left running after a failure must neither hold up the test nor outlive it.
    log = folder + "/log"
    with open(log, "w", encoding="utf-8") as out:
        shell = subprocess.Popen(["bash", "-c", script], cwd=tree, env={**keep, "HOME": home},
                                 stdin=subprocess.DEVNULL, stdout=out, stderr=subprocess.STDOUT,
                                 start_new_session=True)
        try:
            status = shell.wait(timeout=float(os.environ.get("HANDBOOK_S", "270")))
        except subprocess.TimeoutExpired:
            status = "(not over in time)"
        finally:
            try:
                os.killpg(shell.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
    with open(log, encoding="utf-8", errors="replace") as out:
        output = out.read()
    print(output)
    assert status == 0, f"a block failed with status {status}"
    scores = [float(score) for score in re.findall(r"^score ([0-9.]+) of 100", output, re.M)]
    assert len(scores) == 2, f"{len(scores)} scores instead of the template's and the vehicle's"
    assert "Obstacle avoidance: intro" in output, "the submission's name is missing"
    print(f"template {scores[0]}, vehicle {scores[1]}")
    assert scores[1] > scores[0] + 20, "the vehicle is hardly better than the template"
    report = home + "/robots/intro/report.html"
    assert os.path.getsize(report) > 10000, "the report is too short"


def main():
    probe = subprocess.run(["bwrap", "--unshare-all", "--ro-bind", "/", "/", "--proc", "/proc",
                            "/bin/true"], check=False) if shutil.which("bwrap") else None
    if probe is None or probe.returncode != 0:
        print("skipped: no sandbox can be made here")
        return SKIPPED
    with tempfile.TemporaryDirectory() as folder:
        run(os.path.realpath(sys.argv[1]), os.path.realpath(sys.argv[2]), folder)
    return 0


if __name__ == "__main__":
    sys.exit(main())
