#!/usr/bin/env python3
"""Makes what Doxygen needs for the site: Markdown with links that lead to pages of the site, and the navigation.

    make_pages.py ROOT PAGES HTML

ROOT is the repository. PAGES is a folder for Markdown files and DoxygenLayout.xml. HTML is the folder that Doxygen will
write to; there come images, and a page for each file and folder of the repository that a page links to. A link that
leads to nothing is an error, and so is a page that navigation.txt leaves out.
"""
import sys
from pathlib import Path
from xml.sax.saxutils import quoteattr

sys.dont_write_bytecode = True  # the repository is left as it is
import repository_pages
from markdown import Page, PageError


def navigation(file):
    """[(group, [name of a page])] of navigation.txt."""
    groups = []
    for line in file.read_text().splitlines():
        if line.startswith("#") or not line.strip():
            continue
        if line.startswith(" "):
            groups[-1][1].append(line.strip())
        else:
            groups.append((line, []))
    return groups


def check_navigation(groups, pages):
    listed = [name for _, names in groups for name in names]
    wanted = {page.name for page in pages if page.name != "README"}
    faults = [f"{name}: no such page" for name in listed if name not in wanted]
    faults += [f"{name}: is not listed" for name in sorted(wanted - set(listed))]
    faults += [f"{name}: is listed more than once" for name in sorted(set(listed)) if listed.count(name) > 1]
    if faults:
        raise PageError("docs/site/navigation.txt: " + "; ".join(faults))


def layout(groups, pages):
    """Doxygen's layout file: the groups of pages, then the public headers."""
    titles = {page.name: page.title for page in pages}
    lines = ['<doxygenlayout version="1.0">', "<navindex>", tab("mainpage", "refraster")]
    for group, names in groups:
        tabs = "\n".join(tab("user", titles[name], f"@ref {name}") for name in names)
        lines.append(tab("usergroup", group, "[none]", tabs))
    headers = (tab("user", "All", "namespacerefraster.html"), tab("classlist", "Types"),
               tab("namespacemembers", "Functions and values"), tab("classmembers", "Members"),
               tab("filelist", "Headers"))
    lines.append(tab("usergroup", "Public headers", "[none]", "\n".join(headers)))
    lines.append('<tab type="pages" visible="no" title=""/>')  # Doxygen's own list of pages, without the groups
    return "\n".join([*lines, "</navindex>", "</doxygenlayout>", ""])


def tab(kind, title, address="", tabs=""):
    return f'<tab type="{kind}" visible="yes" url={quoteattr(address)} title={quoteattr(title)}>{tabs}</tab>'


def main():
    root, pages_folder, html = (Path(argument).resolve() for argument in sys.argv[1:4])
    files = [*sorted(root.glob("*.md")), *sorted((root / "docs").glob("*.md"))]
    pages = [Page(root, file) for file in files]
    groups = navigation(root / "docs/site/navigation.txt")
    check_navigation(groups, pages)
    site = repository_pages.Site(root, html, pages)
    faults = []
    for page in pages:
        text, page_faults = page.for_doxygen(site)
        faults += page_faults
        (pages_folder / f"{page.name}.md").write_text(text)
    if faults:
        raise PageError("\n".join(faults))
    (pages_folder / "DoxygenLayout.xml").write_text(layout(groups, pages))
    site.write()


if __name__ == "__main__":
    try:
        main()
    except PageError as error:
        sys.exit(str(error))
