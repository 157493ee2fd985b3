#!/usr/bin/env python3
"""Holds the site against the Markdown pages as cmark-gfm, GitHub's own reader, has them: word by word the same text.

    compare_text.py SOURCES SITE

Doxygen drops, joins or decorates what it reads otherwise, without a warning. Exit code 77, with a word, where there is
no cmark-gfm.
"""
import difflib
import shutil
import subprocess
import sys
from html.parser import HTMLParser
from pathlib import Path

BREAKS = {"p", "td", "th", "tr", "li", "h1", "h2", "h3", "h4", "h5", "br", "div", "pre", "summary"}
VOID = {"br", "img", "hr", "input", "meta", "link"}
ADDED = {"toc", "ttc", "lineno"}  # classes of what Doxygen adds to a page


class Words(HTMLParser):
    """The words that a reader sees."""

    def __init__(self, html):
        super().__init__()
        self.text, self.depth, self.hidden_from = [], 0, None
        self.feed(html)
        self.words = "".join(self.text).replace("\u200d", "").split()

    def handle_starttag(self, tag, attributes):
        if tag in VOID:
            self.text.append(" ")
            return
        self.depth += 1
        classes = (dict(attributes).get("class") or "").split()
        if self.hidden_from is None and (ADDED & set(classes) or tag in ("script", "style")):
            self.hidden_from = self.depth
        self.text.append(" " if tag in BREAKS else "")

    def handle_endtag(self, tag):
        if tag in VOID:
            return
        if self.hidden_from == self.depth:
            self.hidden_from = None
        self.depth -= 1
        self.text.append(" " if tag in BREAKS else "")

    def handle_data(self, data):
        if self.hidden_from is None:
            self.text.append(data)


def main():
    sources, site = Path(sys.argv[1]), Path(sys.argv[2])
    if not shutil.which("cmark-gfm"):
        print("no cmark-gfm (Debian: scripts/setup docs)")
        sys.exit(77)
    pages, count, differences = [*sorted(sources.glob("*.md")), *sorted((sources / "docs").glob("*.md"))], 0, 0
    for file in pages:
        command = ["cmark-gfm", "-e", "table", "-e", "autolink", "--unsafe", file]
        expected = Words(subprocess.run(command, capture_output=True, text=True, check=True).stdout).words
        html = (site / ("index.html" if file.stem == "README" else f"{file.stem}.html")).read_text()
        # The title stands above: it is compared as the first of the words.
        title = html[html.index('<div class="title">'):html.index('<div class="contents">')]
        found = Words(title + html[html.index('<div class="contents">'):html.index("<!-- contents -->")]).words
        count += len(expected)
        for kind, i, j, k, l in difflib.SequenceMatcher(None, expected, found, autojunk=False).get_opcodes():
            if kind != "equal":
                differences += 1
                print(f"{file.relative_to(sources)}: expected \"{' '.join(expected[i:j])}\" behind "
                      f"\"{' '.join(expected[max(0, i - 6):i])}\", found \"{' '.join(found[k:l])}\"")
    print(f"{len(pages)} pages, {count} words, {differences} differences")
    sys.exit(1 if differences else 0)


if __name__ == "__main__":
    main()
