# SPDX-License-Identifier: MIT
"""What the scripts of this folder share: the course's tree, its labs, and how a script ends."""
import contextlib
import os
import pathlib
import subprocess
import sys
import tomllib

ROOT = pathlib.Path(__file__).resolve().parents[2]
# texel says which it is when it starts a script.
BIN = pathlib.Path(os.environ["TEXEL"]).parent if "TEXEL" in os.environ else ROOT / "build/release/bin"


class Failure(Exception):
    """What ends the program, and its exit code."""

    def __init__(self, text, code=3):
        super().__init__(text)
        self.code = code


def run(program, main):
    """Ends the script with the exit code of main; an error ends it with a line and 3, or the error's own code."""
    try:
        code = main() or 0
        sys.stdout.flush()
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # Python writes the rest there as it ends
        code = 3
    except Failure as error:
        print(f"{program}: {error}", file=sys.stderr)
        code = error.code
    except OSError as error:
        remedy = "; check the path's spelling" if isinstance(error, FileNotFoundError) else ""
        print(f"{program}: {error.filename or 'standard output'}: {error.strerror}{remedy}", file=sys.stderr)
        code = 3
    sys.exit(code)


@contextlib.contextmanager
def reading(file, remedy):
    """What goes wrong with a file's contents inside is an error of the file."""
    try:
        yield
    except (KeyError, TypeError, ValueError) as error:  # of JSON and TOML, too
        raise Failure(f"{file}: cannot be read ({type(error).__name__}: {error}); {remedy}") from error


def write(file, text):
    """Writes a file beside its place, and renames it: none is ever cut off."""
    file = pathlib.Path(file)
    file.parent.mkdir(parents=True, exist_ok=True)
    part = file.with_name(file.name + ".part")
    part.write_text(text, encoding="utf-8")
    part.replace(file)


def text_of(value):
    """A parameter's value as a lab's command line takes it."""
    if isinstance(value, bool):
        return "on" if value else "off"
    return str(value).removesuffix(".0") if isinstance(value, float) else str(value)


# The tables of a lab.toml that are read here alone: their keys, and those that may be left out.
TABLES = {"bench": ({"case", "teaches", "vary"}, {"cameras", "hard", "plot", "set", "size"}), "claim": ({"source", "says", "found", "see"}, set())}


def check_tables(lab):
    for kind, (needed, more) in TABLES.items():
        for table in lab.get(kind, []):
            if not needed <= set(table) <= needed | more:
                raise ValueError(f"[[{kind}]] has the keys {', '.join(table)}; it must have {', '.join(sorted(needed))}, "
                                 f"and no others but {', '.join(sorted(more)) or 'these'}")


def read_labs(numbers=()):
    """What each labs/NN_name/lab.toml says, and the lab's number; of those with these numbers, or of all. Copies of a folder are no labs."""
    labs = {}
    for file in sorted(ROOT.glob("labs/[0-9][0-9]_*/lab.toml")):
        with reading(file, "build/release/bin/texel list says more"):
            lab = tomllib.loads(file.read_text(encoding="utf-8"))
            if lab["lab"] != file.parent.name:
                continue
            check_tables(lab)
            for bench in lab.get("bench", []):
                bench["size"] = bench.get("size", "256x256")
                bench["set"] = {name: text_of(value) for name, value in bench.get("set", {}).items()}
                bench["vary"] = {name: [text_of(value) for value in values] for name, values in bench["vary"].items()}
            labs[int(lab["lab"][:2])] = lab | {"number": int(lab["lab"][:2])}
    for number in numbers:
        if number not in labs:
            raise Failure(f"there is no lab {number}; the labs are {', '.join(map(str, labs))}", 2)
    return [lab for number, lab in labs.items() if not numbers or number in numbers]


def program_of(lab):
    return BIN / f"lab{lab['lab']}"


def call(*command, env=None):
    """Runs a program, whose output goes where ours goes; whether that went well."""
    sys.stdout.flush()
    try:
        return subprocess.run([*map(str, command)], env=env, check=False).returncode == 0
    except FileNotFoundError as error:
        raise Failure(f"{command[0]}: cannot be started; build it with ./run build") from error


def captured(*command, env=None, errors=subprocess.STDOUT):
    """Runs a program; its returncode, and as stdout what it prints, with its errors unless these go elsewhere."""
    return subprocess.run([*map(str, command)], env=env, stdout=subprocess.PIPE, stderr=errors, text=True, check=False)


def texel(*arguments, env=None):
    if not call(BIN / "texel", *arguments, env=env):
        raise Failure(f"texel {arguments[0]} failed; see its message above")


def labs_option(labs):
    """The numbers of labs as an option of `texel cases`."""
    return ["--labs", ",".join(map(str, labs))] if labs else []
