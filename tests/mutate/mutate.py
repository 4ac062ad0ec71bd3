#!/usr/bin/env python3
"""Changes one operator of the SDK at a time and looks whether the tests notice.

usage: mutate.py [FOLDER...] [--count N] [--seed S]

FOLDER: of sdk/burin, as chart, or a room of one, as chart/front; all without. Works on a copy of the last commit in build/mutate. A change counts as
caught when the tests of its folder or those of `host` fail, or do not end. Changes that do not compile are
drawn anew. Prints the others, which are equivalent or ask for a test. Exit code 0: at least 95 percent were
caught; 1: fewer; 2: the usage is wrong or the unchanged tests fail.
"""

import argparse
import filecmp
import pathlib
import random
import re
import shutil
import subprocess
import sys

CHANGES = {
    " < ": " <= ", " <= ": " < ", " > ": " >= ", " >= ": " > ", " == ": " != ", " != ": " == ", " + ": " - ",
    " - ": " + ", " * ": " / ", " / ": " * ", " && ": " || ", " || ": " && ", " += ": " -= ", " -= ": " += ",
    "std::min(": "std::max(", "std::max(": "std::min(",
}
OPERATOR = re.compile("|".join(re.escape(operator) for operator in CHANGES))
# Lines whose operators are none of a computation.
SKIPPED = re.compile(r"^\s*(//|#|template|using|static_assert|friend|auto operator|bool operator)")
LONGEST = 900  # seconds that the tests of a folder may take

HERE = pathlib.Path(__file__).resolve().parents[2]
SOURCE, BUILD = HERE / "build/mutate/source", HERE / "build/mutate/build"
COMMIT = HERE / "build/mutate/commit"


def run(*command, seconds=None):
    try:
        done = subprocess.run(command, cwd=SOURCE, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL, timeout=seconds)
        return done.returncode == 0
    except subprocess.TimeoutExpired:
        return False


def copy_last_commit():
    """Writes what differs only: what the last run left changed is built anew, and nothing else."""
    shutil.rmtree(COMMIT, ignore_errors=True)
    COMMIT.mkdir(parents=True)
    SOURCE.mkdir(exist_ok=True)
    archive = subprocess.run(["git", "archive", "HEAD"], cwd=HERE, check=True, stdout=subprocess.PIPE).stdout
    subprocess.run(["tar", "-x"], cwd=COMMIT, check=True, input=archive)
    files = {path.relative_to(COMMIT) for path in COMMIT.rglob("*") if path.is_file()}
    for path in list(SOURCE.rglob("*")):
        if path.is_file() and path.relative_to(SOURCE) not in files:
            path.unlink()
    for name in files:
        if not (SOURCE / name).is_file() or not filecmp.cmp(COMMIT / name, SOURCE / name, shallow=False):
            (SOURCE / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(COMMIT / name, SOURCE / name)
    (SOURCE.parent / "shared").unlink(missing_ok=True)
    if (HERE.parent / "shared").is_dir():
        (SOURCE.parent / "shared").symlink_to(HERE.parent / "shared")
    # What a change leaves unused is no fault of the change.
    return run("cmake", "-G", "Ninja", "-B", str(BUILD), "-DCMAKE_BUILD_TYPE=Release", "-DBURIN_WERROR=OFF")


def builds(test):
    return run("cmake", "--build", str(BUILD), "--target", test)


def passes(test):
    return run(str(BUILD / "bin" / test), "--gtest_brief=1", "--gtest_fail_fast", seconds=LONGEST)


def tests_of(folder):
    return list(dict.fromkeys([f"{folder.split('/')[0]}_test", "host_test"]))


def is_noticed(folder):
    """Whether a test of the folder fails now; None where it does not compile."""
    for test in tests_of(folder):
        if not builds(test):
            return None
        if not passes(test):
            return True
    return False


def places(folder):
    """(file, offset of an operator, the operator) for all that may be changed."""
    for path in sorted((SOURCE / "sdk/burin" / folder).rglob("*")):
        if path.suffix not in (".cpp", ".h"):
            continue
        offset = 0
        for line in path.read_text(encoding="utf-8").splitlines(keepends=True):
            code = re.sub(r'"(\\.|[^"\\])*"', lambda text: "x" * len(text[0]), line.split("//")[0])
            if not SKIPPED.match(line):
                for found in OPERATOR.finditer(code):
                    yield path, offset + found.start(), found[0]
            offset += len(line)


def told(path, text, offset, operator):
    line = text.count("\n", 0, offset) + 1
    return f"{path.relative_to(SOURCE)}:{line}: '{operator.strip()}' as '{CHANGES[operator].strip()}'"


def is_caught(folder, path, offset, operator):
    """None where the change does not compile."""
    text = path.read_text(encoding="utf-8")
    path.write_text(text[:offset] + CHANGES[operator] + text[offset + len(operator):], encoding="utf-8")
    try:
        caught = is_noticed(folder)
        if caught is not None:
            print("caught" if caught else "NOT CAUGHT", told(path, text, offset, operator), flush=True)
        return caught
    finally:
        path.write_text(text, encoding="utf-8")


def main():
    tested = sorted(path.parent.name for path in HERE.glob("sdk/burin/*/CMakeLists.txt")
                    if (HERE / "tests" / path.parent.name).is_dir())
    parser = argparse.ArgumentParser(prog="./dev mutate")
    parser.add_argument("folders", nargs="*", metavar="FOLDER", help=", ".join(tested))
    parser.add_argument("--count", type=int, default=20, metavar="N")
    parser.add_argument("--seed", type=int, default=1, metavar="S")
    options = parser.parse_args()
    unknown = [folder for folder in options.folders
               if folder.split("/")[0] not in tested or not (HERE / "sdk/burin" / folder).is_dir()]
    if unknown or options.count < 1:
        parser.error(f"no folder '{unknown[0]}'" if unknown else "--count must be above 0")
    folders = options.folders or tested
    if not copy_last_commit():
        print("mutate: the last commit cannot be configured", file=sys.stderr)
        return 2
    for test in dict.fromkeys(test for folder in folders for test in tests_of(folder)):
        if not builds(test) or not passes(test):
            print(f"mutate: {test} fails without a change", file=sys.stderr)
            return 2
    left = [(folder, *place) for folder in folders for place in places(folder)]
    random.Random(options.seed).shuffle(left)
    caught = []
    while left and len(caught) < options.count:
        if (verdict := is_caught(*left.pop())) is not None:
            caught.append(verdict)
    print(f"seed {options.seed}: {sum(caught)} of {len(caught)} changes were caught")
    return 0 if sum(caught) >= 0.95 * len(caught) else 1


if __name__ == "__main__":
    sys.exit(main())
