"""A Markdown page of the repository, as GitHub shows it, turned into one that Doxygen 1.9.4 shows in the same way."""
import html
import re
import unicodedata

# What is left alone, and what is changed: the first that begins at a place decides.
PIECES = re.compile(
    r"(?P<alone>^(?P<indent> *)```.*?^(?P=indent)``` *$|<!--.*?-->|(?:(?<=\n\n)|\A) {4}[^\n]*\n(?:(?: {4}[^\n]*)?\n)*)"
    r"|(?P<ticks>`+)(?P<code>(?:(?!\n\n).)+?)(?P=ticks)(?!`)"
    r"|^(?P<level>#+) +(?P<heading>[^\n]*)$"
    r"|(?P<image>!?)\[(?P<text>(?:`[^`]*`|\\.|[^\[\]`]|\[[^\[\]]*\])*)\]\((?P<target>[^()\s]+)\)"
    r"|\*\*(?P<bold>(?:`[^`]*`|[^*`])+)\*\*"
    r"|(?P<block></?details>(?:\s*<summary>[^\n]*?</summary>)?)"
    r"|(?P<less><)(?=\w)(?!br/?>|https?:)"
    r"|(?P<dashes>(?<![\w-])--)(?=\w)"
    r"|^(?P<number>\d{3,})\.(?= |$)",
    re.MULTILINE | re.DOTALL)


class PageError(Exception):
    """A fault of the pages, in words for their author."""


def slug(heading, taken):
    """The anchor that GitHub gives a heading; those in `taken` are given already."""
    text = re.sub(r"!?\[([^\[\]]*)\]\([^()]*\)", r"\1", heading)
    kept = (c for c in text.lower() if c in "-_ " or unicodedata.category(c)[0] in "LN")
    name = "".join(kept).strip().replace(" ", "-")
    number = 0
    while (name if number == 0 else f"{name}-{number}") in taken:
        number += 1
    return name if number == 0 else f"{name}-{number}"


def code(text):
    """Code in a line. Doxygen ends what stands in single ticks at an apostrophe, and knows no bar in a table's cell."""
    if "\\|" in text:
        return f"<code>{html.escape(text).replace('&#x27;', '&apos;')}</code>"
    return f"``{text}``" if "'" in text else f"`{text}`"


class Page:
    def __init__(self, root, file):
        self.file = file
        self.folder = file.parent
        self.path = file.relative_to(root)
        self.name = file.stem
        self.is_main = self.name == "README"
        self.source = file.read_text()
        self.address = "index.html" if self.is_main else f"{self.name}.html"
        self.title = None
        self.labels = {}  # of GitHub's anchors: Doxygen's, which are one for all pages
        for piece in PIECES.finditer(self.source):
            if piece["level"] is None:
                continue
            anchor = slug(piece["heading"], self.labels)
            label = f"{self.name}_{''.join(c for c in anchor if c.isascii())}"
            if self.title is None:
                self.title, label = piece["heading"].replace("`", ""), self.name
            self.labels[anchor] = label
        self.sections = sum(piece["level"] == "##" for piece in PIECES.finditer(self.source))
        if self.title is None:
            raise PageError(f"{self.path}: has no heading")
        if len(set(self.labels.values())) < len(self.labels):
            raise PageError(f"{self.path}: two headings differ in characters only that an anchor cannot have")

    def for_doxygen(self, site):
        """The text for Doxygen, with as many lines, and what is wrong with its links."""
        return Conversion(self, site).result()


class Conversion:
    def __init__(self, page, site):
        self.page, self.site = page, site
        self.labels = iter(page.labels.values())
        self.levels = []  # of the headings that the next one may stand below
        self.has_contents = not page.is_main and page.sections >= 4
        self.faults = []

    def result(self):
        text = self.convert(self.page.source, 1)
        if self.has_contents:
            text += "\n\\tableofcontents\n"  # wherever it stands, Doxygen shows it first
        return text, self.faults

    def convert(self, text, line):
        """`text` begins in the line of that number."""
        return PIECES.sub(lambda piece: self.changed(piece, line + text.count("\n", 0, piece.start())), text)

    def changed(self, piece, line):
        if piece["code"]:
            return code(piece["code"])
        if piece["level"]:
            return self.heading(len(piece["level"]), piece["heading"])
        if piece["target"]:
            return self.link(piece, line)
        if piece["bold"]:
            return f"<b>{self.convert(piece['bold'], line)}</b>"  # Doxygen sees no bold text before a colon
        if piece["block"]:
            return f"\\htmlonly[block]{piece['block']}\\endhtmlonly"  # unknown to Doxygen
        if piece["less"]:
            return "&lt;"
        if piece["dashes"]:
            return "\\--"  # which would be one long dash
        if piece["number"]:
            return f"{piece['number']}\\."  # which would begin a list
        return piece[0]

    def heading(self, level, text):
        label = next(self.labels)
        if self.page.is_main and not self.levels:
            label = None  # Doxygen's main page has no name
        while self.levels and self.levels[-1] >= level:  # Doxygen takes no #### that has no ### above it
            self.levels.pop()
        self.levels.append(level)
        words = text.replace("`", "").replace("--", "\\--")
        return f"{'#' * len(self.levels)} {words}" + (f" {{#{label}}}" if label else "")

    def link(self, piece, line):
        address = self.site.address_of(self.page, piece["target"])
        if address is None:
            self.faults.append(f"{self.page.path}:{line}: {piece['target']} leads to nothing")
        if piece["image"]:
            words = html.escape(" ".join(piece["text"].split()))
            return f"<img src=\"{address}\" alt=\"{words}\"/>" + "\n" * piece["text"].count("\n")
        return f"[{self.convert(piece['text'], line)}]({address})"
