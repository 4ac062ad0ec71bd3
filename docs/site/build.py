#!/usr/bin/env python3
"""Builds the site of the guide and the reference with Doxygen: build.py OUT. Fails for a public symbol without a
text, and for a link that leads nowhere.

A run of declarations without an empty line between them shares the text at its top, and members of a struct may
be told by the struct's own text, as the headers have it; so are enumerations within it. Constructors, operators and
ids of extensions need none."""
import html.parser
import os
import pathlib
import re
import shutil
import subprocess
import sys
import urllib.parse

ROOT = pathlib.Path(__file__).resolve().parents[2]


def public_headers():
    listed = (ROOT / "cmake/PublicHeaders.cmake").read_text()
    return ["sdk/burin/" + name for name in re.findall(r"^  ([\w/]+\.h)", listed, re.M)]


def run_doxygen(out):
    """Returns the lines of its complaints."""
    inputs = ["docs", "sdk/burin/abi", "sdk/burin/plugin", "sdk/burin/math", "sdk/burin/host/c/burin.h"]
    inputs += public_headers()
    settings = (ROOT / "docs/site/Doxyfile").read_text()
    settings += f"INPUT = {' '.join(inputs)}\nOUTPUT_DIRECTORY = \"{out}\"\n"
    settings += "INPUT_FILTER = \"python3 docs/site/filter.py\"\n"
    done = subprocess.run(["doxygen", "-"], input=settings, cwd=ROOT, capture_output=True, text=True, check=True)
    return [line for line in done.stderr.splitlines() if line.strip()]


def shares_text(file, line):
    """Whether the declaration at this line follows another one directly."""
    before = pathlib.Path(file).read_text().splitlines()[int(line) - 2].strip()
    return before.startswith("#define") or before.endswith((";", "}")) and before != "};"


def is_fault(complaint):
    found = re.match(r"(.+):(\d+): warning: (.*)", complaint)
    if not found:
        return True
    file, line, what = found.groups()
    member = re.match(r"Member (.*) \(([\w ]+)\) of (?:struct|class|namespace|file) (\S+) is not documented", what)
    if not member:
        return True
    name, kind, owner = member.groups()
    last = owner.split("::")[-1]
    if kind in ("variable", "enumeration") and "namespace" not in what:
        return False
    if name.startswith(("operator", "BURIN_EXT_")) or re.match(rf"{last}\(", name):
        return False
    return not shares_text(file, line)


class Page(html.parser.HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.links, self.anchors = [], set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.anchors |= {given[key] for key in ("id", "name") if given.get(key)}
        self.links += [given[key] for key in ("href", "src") if given.get(key)]


def broken_links(site):
    pages = {path.resolve(): Page(path) for path in site.glob("*.html")}
    for path, page in pages.items():
        for link in page.links:
            place = urllib.parse.urlsplit(link)
            # Doxygen links to the heading of nested classes even where all of them are private.
            if place.scheme or place.fragment == "nested-classes":
                continue
            target = (path.parent / urllib.parse.unquote(place.path)).resolve() if place.path else path
            if not target.exists():
                yield f"{path.name}: {link} is not there"
            elif place.fragment and target in pages and place.fragment not in pages[target].anchors:
                yield f"{path.name}: {link} has no such place"


def copy_linked_files(site):
    """The files of other folders that documents link to, pictures too."""
    for document in (ROOT / "docs").glob("*.md"):
        for link in re.findall(r"\]\(\.\./([\w/.]+)\)", document.read_text(encoding="utf-8")):
            source, target = ROOT / link, site / "files" / link
            if source.is_file():
                target.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(source, target)


def main():
    out = pathlib.Path(sys.argv[1])
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    faults = [line for line in run_doxygen(out.resolve()) if is_fault(line)]
    copy_linked_files(out / "html")
    faults += broken_links(out / "html")
    for fault in faults:
        print(fault, file=sys.stderr)
    if faults:
        sys.exit(f"docs: {len(faults)} faults")
    print(os.path.relpath(out / "html/index.html"))


main()
