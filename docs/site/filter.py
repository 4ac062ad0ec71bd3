#!/usr/bin/env python3
"""Writes a file as Doxygen takes it: comments of C headers, headings and links of documents."""
import pathlib
import re
import sys

path = sys.argv[1]
text = open(path, encoding="utf-8").read()



def label(page, heading):
    """The anchor of a heading, which GitHub makes of its text."""
    words = re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")
    return (page + "_" + words).replace("-", "_")


if path.endswith(".md"):
    page = pathlib.Path(path).stem
    # Doxygen would name the page after the folder that the sources lie in.
    # Code in a title would be shown as tags in the tree of pages.
    text = re.sub(r"\A# (.*)$", lambda h: f"# {h[1].replace('`', '')} {{#page_{page}}}", text, count=1, flags=re.M)
    text = re.sub(r"^(##+ )(.*)$", lambda h: f"{h[1]}{h[2]} {{#{label(page, h[2])}}}", text, flags=re.M)
    text = re.sub(r"\]\((?:(\w+)\.md)?#([\w-]+)\)", lambda a: f"](@ref {label(a[1] or page, a[2])})", text)
    # Headers are pages of the reference; other files lie beside the pages.
    text = re.sub(r"\]\(\.\./sdk/(burin/(?:abi|plugin|math)/[\w/]+\.h)\)", r"](@ref \1)", text)
    text = re.sub(r"\]\(\.\./", "](files/", text)
elif "extern \"C\"" in text:
    # Comments beside a macro that go on in the next lines: in one line, the others empty.
    text = re.sub(
        r"^#define .*\*/\n(?: {20,}/\* .*\*/\n)+",
        lambda d: re.sub(r" \*/\n +/\* ", " ", d[0]) + "\n" * (d[0].count("\n") - 1),
        text, flags=re.M)
    # A full stop before a blank would end the summary.
    text = text.replace(" .. ", " to ")
    # The comment at the top of a header is about the file.
    text = re.sub(r"\A/\* (\S+) - ", r"/** @file \1\n * ", text)
    text = re.sub(r"^( *)/\* ", r"\1/** ", text, flags=re.M)
    text = re.sub(r"(?<=\S)( +)/\* ", r"\1/**< ", text)
# Doxygen would take it for a tag.
text = re.sub(r"^(///.*)<(\w+)>", r"\1\2", text, flags=re.M)
sys.stdout.write(text)
