"""Runs a builder script and writes its scene: python3 -m morse.builder.run SCRIPT [ARGUMENT...]

The JSON goes to the file descriptor that CCMORSE_SCENE_FD names, or to standard output. A script
that fails leaves its traceback and a line "[ERROR][MORSE] ..." on standard error, status 1.
"""

import json
import logging
import os
import sys
import traceback

import morse
from morse.builder import places


def _script_frames(error):
    """The frames of a traceback that are the user's, or of libraries: none of ours."""
    frames = [frame for frame in traceback.extract_tb(error.__traceback__)
              if not places.is_ours(frame.filename)]
    return frames or traceback.extract_tb(error.__traceback__)


def _complain(error):
    from morse.builder.scene import SceneError
    if isinstance(error, SceneError):  # of the script as a whole
        sys.stderr.write("[ERROR][MORSE] %s: %s\n" % (sys.argv[0], error))
        sys.stderr.flush()
        return
    if not isinstance(error, SyntaxError) or error.__traceback__.tb_next is not None:
        sys.stderr.write("Traceback (most recent call last):\n")
        sys.stderr.write("".join(traceback.format_list(_script_frames(error))))
    text = "".join(traceback.format_exception_only(type(error), error))
    sys.stderr.write(text)
    last = _script_frames(error)[-1:]
    where = "%s:%d: " % (last[0].filename, last[0].lineno) if last else ""
    sys.stderr.write("[ERROR][MORSE] %s%s\n" % (where, text.strip().splitlines()[-1]))
    sys.stderr.flush()


def _prepare(script):
    """What MORSE's environments have on their paths, where the script lies in one."""
    folder = os.path.dirname(script)
    for path in (folder, os.path.join(folder, "src")):
        if os.path.isdir(path) and path not in sys.path:
            sys.path.insert(0, path)
    resources = os.path.join(folder, "data")
    if os.path.isdir(resources):
        known = os.environ.get("MORSE_RESOURCE_PATH", "")
        if resources not in known.split(":"):
            os.environ["MORSE_RESOURCE_PATH"] = resources + (":" + known if known else "")


def run_script(script, arguments=()):
    """Runs a script as the main program; returns build()'s scene. Raises what it raises."""
    path = os.path.abspath(script)
    _prepare(path)
    morse.building = True  # for what may be more than a builder script: morse.testing.testing.main
    # As MORSE does: what is meant for the script follows "--".
    sys.argv = [path, "--"] + list(arguments)
    main = type(sys)("__main__")
    main.__file__ = path
    main.__builtins__ = __builtins__
    sys.modules["__main__"] = main
    with open(path, "rb") as file:
        code = compile(file.read(), path, "exec")
    try:
        exec(code, main.__dict__)
    except SystemExit as ended:
        if ended.code not in (None, 0):
            raise
    from morse.builder import scene
    return scene.build()


def main():
    if len(sys.argv) < 2:
        sys.stderr.write("usage: python3 -m morse.builder.run SCRIPT [ARGUMENT...]\n")
        return 2
    target = os.environ.pop("CCMORSE_SCENE_FD", None)
    out = sys.stdout
    if target is not None:
        os.set_inheritable(int(target), False)  # not for what the script starts
        out = os.fdopen(int(target), "w", encoding="utf-8")
    logging.basicConfig(level=logging.INFO, stream=sys.stderr,
                        format="[%(levelname)s][%(name)s] %(message)s")
    try:
        text = json.dumps(run_script(sys.argv[1], sys.argv[2:]), allow_nan=False)
    except SystemExit as ended:
        if isinstance(ended.code, str):
            sys.stderr.write("[ERROR][MORSE] %s\n" % ended.code)
        return ended.code if isinstance(ended.code, int) else 1
    except KeyboardInterrupt:
        return 130
    except BaseException as error:  # whatever a script may raise is the user's to see
        sys.stdout.flush()
        _complain(error)
        return 1
    sys.stdout.flush()
    out.write(text + "\n")
    out.flush()
    return 0


if __name__ == "__main__":
    sys.exit(main())
