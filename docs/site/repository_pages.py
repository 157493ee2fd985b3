"""Pages of the site for files and folders of the repository that its Markdown pages link to."""
import html
import shutil
import subprocess
from urllib.parse import unquote

IMAGES = {".png", ".svg", ".jpg"}
MAX_SHOWN = 1 << 20  # bytes; what is larger was generated, and nobody reads it


class Site:
    """Knows where in the site each file of the repository is; write() makes the pages that Doxygen does not."""

    def __init__(self, root, folder, pages):
        self.root, self.folder = root, folder
        self.pages = {page.file: page for page in pages}
        self.files = files_of(root)
        self.listed = {}  # of each folder: what is in it
        for file in self.files:
            for entry in (file, *file.parents):
                if entry != root and entry.is_relative_to(root):
                    self.listed.setdefault(entry.parent, set()).add(entry)
        self.wanted = {}  # files and folders that get a page of their own, in the order they were asked for

    def address_of(self, page, target):
        """Where a link of a page leads in the site, seen from its top folder; None where it leads to nothing."""
        if "://" in target or target.startswith("mailto:"):
            return target
        path, _, anchor = target.partition("#")
        file = (page.folder / unquote(path)).resolve() if path else page.file
        if file in self.pages:
            other = self.pages[file]
            if not anchor:
                return other.address
            return f"{other.address}#{other.labels[anchor]}" if anchor in other.labels else None
        if anchor or not (file in self.files or file in self.listed):
            return None
        return self.address_of_file(file)

    def address_of_file(self, file):
        path = file.relative_to(self.root)
        if file in self.pages:
            return self.pages[file].address
        if path.parent.as_posix() == "include/refraster" and file.suffix == ".h":
            return f"{file.stem.replace('_', '__')}_8h_source.html"  # Doxygen's name for it
        self.wanted.setdefault(file)
        if file.suffix in IMAGES:
            return f"repository/{path}"
        return f"repository/{path}/index.html" if file.is_dir() else f"repository/{path}.html"

    def write(self):
        ahead = [file for file in self.wanted if file.is_dir()]
        while ahead:
            for entry in self.entries_of(ahead.pop()):
                self.address_of_file(entry)
                if entry.is_dir():
                    ahead.append(entry)
        for file in self.wanted:
            target = self.folder / self.address_of_file(file)
            target.parent.mkdir(parents=True, exist_ok=True)
            if file.suffix in IMAGES:
                shutil.copyfile(file, target)
            else:
                target.write_text(self.page(file, self.list_of(file) if file.is_dir() else content_of(file)))

    def entries_of(self, folder):
        """What a folder lists: folders first."""
        return sorted(self.listed.get(folder, ()), key=lambda entry: (entry.is_file(), entry.name))

    def list_of(self, folder):
        up = self.way_up(folder)
        items = []
        for entry in self.entries_of(folder):
            name = html.escape(entry.name) + "/" * entry.is_dir()
            items.append(f'<li><a href="{up}{self.address_of_file(entry)}">{name}</a></li>')
        return "\n".join(["<ul>", *items, "</ul>"])

    def way_up(self, file):
        return "../" * (len(file.relative_to(self.root).parts) + file.is_dir())

    def path_of(self, file):
        """The path in words, each folder that has a page a link to it."""
        words = []
        for part in [file, *file.parents][::-1]:
            if not part.is_relative_to(self.root) or part == self.root:
                continue
            name = html.escape(part.name)
            if part in self.wanted and part != file:
                name = f'<a href="{self.way_up(file)}{self.address_of_file(part)}">{name}</a>'
            words.append(name)
        return " / ".join(words)

    def page(self, file, content):
        name, up = html.escape(file.relative_to(self.root).as_posix()), self.way_up(file)
        return f"""<!DOCTYPE html>
<html lang="en">
<head><meta charset="utf-8"/><meta name="viewport" content="width=device-width, initial-scale=1"/>
<title>refraster: {name}</title><link rel="stylesheet" href="{up}site.css"/></head>
<body class="repository">
<p><a href="{up}index.html">refraster</a></p>
<h1>{self.path_of(file)}</h1>
{content}
</body>
</html>
"""


def files_of(root):
    """The files of the repository; where Git cannot tell, as in an unpacked archive, all that are there."""
    names = None
    if (root / ".git").exists() and shutil.which("git"):
        command = ["git", "-C", str(root), "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
        listing = subprocess.run(command, capture_output=True, check=False)
        names = listing.stdout.decode().split("\0") if listing.returncode == 0 else None
    files = root.rglob("*") if names is None else (root / name for name in names)
    return {file for file in files if file.is_file()}


def content_of(file):
    """A file's text with the numbers of its lines; of one that is no text, or too large, its size."""
    size = file.stat().st_size
    if size > MAX_SHOWN:
        return f"<p>{size} bytes.</p>"
    try:
        text = file.read_bytes().decode()
    except UnicodeDecodeError:
        text = "\0"
    if "\0" in text:
        return f"<p>{size} bytes that are no text.</p>"
    numbers = "\n".join(map(str, range(1, len(text.splitlines()) + 1)))
    return f'<div class="file"><pre class="numbers">{numbers}</pre><pre>{html.escape(text, quote=False)}</pre></div>'
