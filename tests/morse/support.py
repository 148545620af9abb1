"""What the tests of the builder share."""

import json
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
SOURCE = os.path.dirname(os.path.dirname(HERE))
SCRIPTS = os.path.join(HERE, "scripts")
PYTHON = os.path.join(SOURCE, "python")


def environment(**more):
    """For a process: our package first, and no data of MORSE's but our own stand-ins."""
    result = {name: value for name, value in os.environ.items() if not name.startswith("MORSE_")}
    result["PYTHONPATH"] = PYTHON
    result["PYTHONDONTWRITEBYTECODE"] = "1"
    result.setdefault("CCMORSE_MORSE_DATA", "off")
    result.update(more)
    return result


class Built:
    """A script that has been run through the builder alone."""

    def __init__(self, script, *arguments, **variables):
        path = script if os.path.isabs(script) else os.path.join(SCRIPTS, script)
        reader, writer = os.pipe()
        process = subprocess.Popen(
            [sys.executable, "-m", "morse.builder.run", path] + list(arguments),
            env=environment(CCMORSE_SCENE_FD=str(writer), **variables), pass_fds=[writer],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)
        os.close(writer)
        with os.fdopen(reader, encoding="utf-8") as pipe:
            text = pipe.read()
        self.output = process.communicate()[0]
        self.status = process.returncode
        self.result = json.loads(text) if text else {}
        self.scene = self.result.get("scene")
        self.path = path

    def robots(self):
        return [robot["name"] for robot in self.scene["robots"]]

    def robot(self, name):
        return next(robot for robot in self.scene["robots"] if robot["name"] == name)

    def components(self, robot="robot"):
        return [component["name"] for component in self.robot(robot)["components"]]

    def component(self, full):
        robot, name = full.split(".", 1)
        return next(component for component in self.robot(robot)["components"]
                    if component["name"] == name)

    def notes(self):
        """(line, text) of what is not simulated, in the script itself."""
        return [(note["line"], note["text"]) for note in self.result["notes"]
                if note["file"] == self.path]

    def objects(self):
        """Name -> description of robots and other objects without parent."""
        return {item["name"]: item for item in self.result["description"]["objects"]}

    def settings(self):
        return self.result["description"]["environment"]
