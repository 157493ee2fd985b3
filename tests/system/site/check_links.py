#!/usr/bin/env python3
"""Checks the site that the target `docs` makes, as it lies in a folder: nothing but the standard library is needed.

    check_links.py FOLDER [--pages REPOSITORY]

Every link, image, script and stylesheet of every HTML page is followed, and every link that Doxygen's search and
navigation hold in JavaScript: the file must be there, and in it what stands behind `#`. Nothing may be loaded from
elsewhere. Every page must be reached from index.html. With --pages, the navigation must name each Markdown page of the
repository. All faults are printed; the exit code is 1 if there is one.
"""
import argparse
import posixpath
import re
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote

LOADED = {("img", "src"), ("script", "src"), ("link", "href"), ("iframe", "src"), ("object", "data"), ("source", "src")}
# In files of Doxygen's search, '../a.html#b'; in those of its navigation, "a.html#b".
SEARCH_LINK = re.compile(r"'(\.\./[^']*)'")
NAVIGATION_LINK = re.compile(r'"([^"\s]*\.html(?:#[^"]*)?)"')


class PageReader(HTMLParser):
    """What a page refers to, [(address, whether it is loaded with the page)], and the anchors in it."""

    def __init__(self):
        super().__init__()
        self.references, self.anchors, self.text = [], set(), 0

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.anchors.update(values[key] for key in ("id", "name") if values.get(key))
        for key in ("href", "src", "data"):
            if values.get(key) is not None and not (tag == "object" and key == "src"):
                self.references.append((values[key], (tag, key) in LOADED))

    def handle_data(self, data):
        self.text += len(data.strip())


def style_references(text):
    return [(address.strip("\"'"), True) for address in re.findall(r"url\(([^)]*)\)", text)]


class Site:
    def __init__(self, folder):
        self.files = {file.relative_to(folder).as_posix(): file for file in folder.rglob("*") if file.is_file()}
        self.anchors, self.references, self.faults = {}, {}, []
        for name, file in self.files.items():
            if name.endswith(".html"):
                reader = PageReader()
                reader.feed(file.read_text(errors="replace"))
                self.anchors[name], self.references[name] = reader.anchors, reader.references
                if reader.text == 0:
                    self.faults.append(f"{name}: is empty")
            elif name.endswith(".css"):
                self.references[name] = style_references(file.read_text())
            elif name.startswith("search/") and name.endswith(".js"):
                self.references[name] = [(address, False) for address in SEARCH_LINK.findall(file.read_text())]
            elif name.endswith(".js") and "/" not in name:
                self.references[name] = [(address, False) for address in NAVIGATION_LINK.findall(file.read_text())]

    def target(self, name, address):
        """(file, anchor) that an address leads to, seen from a file of the site."""
        path, _, anchor = address.partition("#")
        path = posixpath.normpath(posixpath.join(posixpath.dirname(name), unquote(path))) if path else name
        return path, unquote(anchor)

    def check(self):
        for name, references in sorted(self.references.items()):
            for address, is_loaded in references:
                fault = self.fault_of(name, address, is_loaded)
                if fault:
                    self.faults.append(f"{name}: {address}: {fault}")
        for name in sorted(set(self.anchors) - self.reached()):
            self.faults.append(f"{name}: no page leads there")

    def fault_of(self, name, address, is_loaded):
        if address.startswith(("data:", "javascript:")):
            return None
        if re.match(r"[a-z]+:|//", address):
            if is_loaded:
                return "is loaded from elsewhere"
            return None if re.match(r"https?://[^/]+\.|mailto:", address) else "an address of an unknown kind"
        path, anchor = self.target(name, address)
        if path not in self.files:
            return "no such file"
        if anchor and anchor not in self.anchors.get(path, ()):
            return "no such anchor"
        return None

    def navigation(self):
        """Files that the navigation names."""
        names = (name for name in self.references if name.startswith("nav") and name.endswith(".js"))
        return {self.target(name, address)[0] for name in names for address, _ in self.references[name]}

    def reached(self):
        """Files to which there is a way from the main page: by links, or by the navigation beside each page."""
        found = {"index.html"} | self.navigation()
        found |= {name for name in self.anchors if name.startswith("search/")}  # the frame of what a search finds
        ahead = list(found)
        while ahead:
            name = ahead.pop()
            for address, _ in self.references.get(name, ()):
                path = self.target(name, address)[0]
                if path in self.files and path not in found:
                    found.add(path)
                    ahead.append(path)
        return found


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("folder", type=Path)
    parser.add_argument("--pages", type=Path)
    arguments = parser.parse_args()
    site = Site(arguments.folder)
    if "index.html" not in site.files:
        sys.exit(f"{arguments.folder}: no index.html")
    site.check()
    if arguments.pages:
        known = site.navigation()
        for file in [*arguments.pages.glob("*.md"), *arguments.pages.glob("docs/*.md")]:
            if ("index.html" if file.stem == "README" else f"{file.stem}.html") not in known:
                site.faults.append(f"{file.relative_to(arguments.pages)}: the navigation does not name it")
    for fault in site.faults:
        print(fault)
    links = sum(len(references) for references in site.references.values())
    print(f"{len(site.anchors)} pages, {links} links, {len(site.faults)} faults")
    sys.exit(1 if site.faults else 0)


if __name__ == "__main__":
    main()
