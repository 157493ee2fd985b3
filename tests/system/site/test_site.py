#!/usr/bin/env python3
"""What makes the site's pages and what checks its links, on small repositories and sites: each fault is found.

    test_site.py SOURCES
"""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True  # into the sources
SOURCES = Path(sys.argv.pop(1)).resolve()
sys.path.insert(0, str(SOURCES / "docs/site"))

import markdown
import repository_pages

GOOD_SITE = {
    "index.html": '<p><a href="a.html#there">a</a> <img src="i.png"/> <a href="https://example.org">out</a></p>',
    "a.html": '<h1 id="there">a</h1><a href="index.html">back</a> <a href="#there">here</a>',
    "i.png": "", "site.css": "p { background: url(i.png); }",
    "navtreedata.js": 'var NAVTREE = [["a", "index.html", [["b", "a.html#there", null]]]];',
    "search/all_0.js": "var searchData=[['x',['x',['../a.html#there',1,'']]]];",
}


def write(folder, files):
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)


class LinksOfTheSite(unittest.TestCase):
    def check(self, changes, *options):
        with tempfile.TemporaryDirectory() as folder:
            write(Path(folder), {**GOOD_SITE, **changes})
            run = subprocess.run([sys.executable, SOURCES / "tests/system/site/check_links.py", folder, *options],
                                 capture_output=True, text=True, check=False)
        return run.returncode, run.stdout.splitlines()[:-1]

    def test_a_site_without_a_fault(self):
        self.assertEqual(self.check({}), (0, []))

    def test_each_fault_is_named(self):
        for name, text, fault in (
                ("a.html", '<a id="there" href="b.html">x</a>', "a.html: b.html: no such file"),
                ("a.html", '<a id="there" href="../index.html">x</a>', "a.html: ../index.html: no such file"),
                ("a.html", '<a id="there" href="#nowhere">x</a>', "a.html: #nowhere: no such anchor"),
                ("a.html", '<a id="there" href="index.html#x">x</a>', "a.html: index.html#x: no such anchor"),
                ("a.html", '<a id="there" href="file:l:">x</a>', "a.html: file:l:: an address of an unknown kind"),
                ("a.html", '<p id="there">x</p><img src="j.png"/>', "a.html: j.png: no such file"),
                ("a.html", '<p id="there">x</p><script src="https://example.org/x.js"></script>',
                 "a.html: https://example.org/x.js: is loaded from elsewhere"),
                ("a.html", '<a id="there"></a>', "a.html: is empty"),
                ("c.html", "<p>c</p>", "c.html: no page leads there"),
                ("site.css", "p { background: url('j.png'); }", "site.css: j.png: no such file"),
                ("search/all_0.js", "['../a.html#gone',1,'']", "search/all_0.js: ../a.html#gone: no such anchor"),
                ("navtreedata.js", '["x", "gone.html", null]', "navtreedata.js: gone.html: no such file")):
            self.assertEqual(self.check({name: text}), (1, [fault]))

    def test_a_page_that_the_navigation_lacks(self):
        with tempfile.TemporaryDirectory() as folder:
            write(Path(folder), {"README.md": "", "docs/a.md": "", "docs/b.md": ""})
            self.assertEqual(self.check({}, "--pages", folder), (1, ["docs/b.md: the navigation does not name it"]))


class PagesOfTheRepository(unittest.TestCase):
    def convert(self, text, files=()):
        """The page docs/a.md, beside others, for Doxygen; what is wrong with it; the site."""
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder).resolve()
            write(root, {"README.md": "# r\n", "docs/b.md": "# b\n\n## Two `words`, β\n\n## Two words β\n",
                         "docs/a.md": text, "math/x.h": "// 1 < 2\n", "docs/i.png": "", **dict(files)})
            pages = [markdown.Page(root, root / name) for name in ("README.md", "docs/a.md", "docs/b.md")]
            site = repository_pages.Site(root, root / "html", pages)
            result, faults = pages[1].for_doxygen(site)
            site.write()
            shown = {file.relative_to(root / "html").as_posix(): file.read_text()
                     for file in (root / "html").rglob("*.html")}
        return result, faults, shown

    def test_anchors_are_those_of_github(self):
        taken = {}
        for heading, anchor in (("What it costs", "what-it-costs"), ("`bench … --json FILE`", "bench----json-file"),
                                ("What it costs", "what-it-costs-1"), ("[A link](x.md), too", "a-link-too"),
                                ("6. φd = 0", "6-φd--0"), ("/scene/mesh_x", "scenemesh_x")):
            self.assertEqual(markdown.slug(heading, taken), anchor)
            taken[anchor] = True

    def test_links_lead_to_pages_of_the_site(self):
        for link, address in (
                ("../README.md", "index.html"), ("b.md", "b.html"), ("#a", "a.html#a"),
                ("b.md#two-words-β", "b.html#b_two-words-"), ("b.md#two-words-β-1", "b.html#b_two-words--1"),
                ("../math/x.h", "repository/math/x.h.html"), ("../math", "repository/math/index.html"),
                ("https://example.org/x", "https://example.org/x")):
            self.assertEqual(self.convert(f"# a\n\n[t]({link})\n")[:2], (f"# a {{#a}}\n\n[t]({address})\n", []))

    def test_links_that_lead_to_nothing(self):
        for link in ("c.md", "b.md#three", "#b", "../math/y.h", "../../x", "../math/x.h#L1"):
            self.assertEqual(self.convert(f"# a\n\nWords,\nand [`t`\nu]({link})\n")[1],
                             [f"docs/a.md:4: {link} leads to nothing"])

    def test_code_stays_as_it_is(self):
        code = "```cpp\n[a](b) <T> --x **y**\n# no heading\n```\n\n    [a](b) <T>\n\n`[a](b) <T> --x`\n"
        self.assertEqual(self.convert(f"# a\n\n{code}")[0], f"# a {{#a}}\n\n{code}")

    def test_what_doxygen_reads_otherwise(self):
        for text, changed in (
                ("`it's`", "``it's``"), ("| `\\|u1` |", "| <code>\\|u1</code> |"), ("**a:** b", "<b>a:</b> b"),
                ("k <n.l>", "k &lt;n.l>"), ("a --b", "a \\--b"), ("in\n2005. So", "in\n2005\\. So"),
                ("a<br>b", "a<br>b"), ("![a\nb](i.png)", '<img src="repository/docs/i.png" alt="a b"/>\n')):
            self.assertEqual(self.convert(f"# a\n\n{text}\n")[0], f"# a {{#a}}\n\n{changed}\n")

    def test_files_are_shown_line_by_line(self):
        shown = self.convert("# a\n\n[t](../math)\n", {"math/bytes": "\0"}.items())[2]
        self.assertIn('<pre class="numbers">1</pre><pre>// 1 &lt; 2\n</pre>', shown["repository/math/x.h.html"])
        self.assertIn('<a href="../../repository/math/x.h.html">x.h</a>', shown["repository/math/index.html"])
        self.assertIn("1 bytes that are no text", shown["repository/math/bytes.html"])


if __name__ == "__main__":
    unittest.main()
