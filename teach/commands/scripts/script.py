# SPDX-License-Identifier: MIT
"""What the course box's Python scripts share."""
import os
import sys

PROGRAM = f"texel course {os.path.basename(sys.argv[0])}"


def say(text):
    print(f"{PROGRAM}: {text}", file=sys.stderr)


def fail(text, code=2):
    say(text)
    sys.exit(code)


def run(main):
    """Ends the program with the exit code of main; with 3 and a message where standard output cannot be written."""
    if sys.stdout is None:  # it was closed before
        sys.stdout = open("/dev/full", "w", encoding="utf-8")
    sys.stdout.reconfigure(write_through=False)  # argparse does not tell where its help is lost: flush does
    try:
        try:
            code = main()
        except SystemExit as end:  # --help, too
            code = end.code
        sys.stdout.flush()
    except OSError as error:
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # Python writes the rest there as it ends
        say(f"{error.filename or 'cannot write to standard output'}: {error.strerror}")
        code = 3
    sys.exit(code)
