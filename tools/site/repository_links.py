"""Hook of mkdocs: pages link to sources and to documents outside docs/, which must lead somewhere in the site, too.

Markdown outside docs/ becomes a page below repository/, any other file that a page links to becomes a page of its text,
and a folder a list of its files. Anchors are made as code forges make them, so that one link serves both.
"""

import html
import os
import re
import tempfile

from mkdocs.structure.files import File

_LINK = re.compile(r"(\]\()([^()\s]+)(\))")
_CODE = re.compile(r"`[^`]*`")
_FENCE = re.compile(r"^\s*(```|~~~)")
_TEXT = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>{path}</title></head>
<body><p><a href="{root}index.html">Farrier</a> / {path}</p>
{body}
</body></html>
"""

_made = tempfile.TemporaryDirectory()
_repository = ""


def anchor(heading, separator="-"):
    """The name a code forge gives a heading."""
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", separator)


def _place(path):
    """Where a file or folder of the repository stands in the site's sources."""
    if path.startswith("docs/"):
        return path[len("docs/"):]
    if os.path.isdir(os.path.join(_repository, path)):
        readme = os.path.join(path, "README.md")
        listed = os.path.join(path, "files.html")
        return "repository/" + (readme if os.path.exists(os.path.join(_repository, readme)) else listed)
    return "repository/" + path + ("" if path.endswith((".md", ".png", ".svg")) else ".html")


def _origin(file):
    """The file of the repository a page is made of."""
    return os.path.relpath(file.abs_src_path, _repository)


def _target(origin, link):
    """Path in the repository and anchor, or None for a link that leads elsewhere or nowhere."""
    path, hash_sign, fragment = link.partition("#")
    if not path or "://" in path or path.startswith(("/", "mailto:")):
        return None
    path = os.path.normpath(os.path.join(os.path.dirname(origin), path))
    if path.startswith("..") or not os.path.exists(os.path.join(_repository, path)):
        return None
    return path, hash_sign + fragment


def _rewritten(text, origin, found=None):
    """The text with links as they are in the site; `found` collects what they lead to."""

    def rewrite(match):
        target = _target(origin, match[2])
        if target is None:
            return match[0]
        if found is not None:
            found.add(target[0])
        place = os.path.relpath(_place(target[0]), os.path.dirname(_place(origin)) or ".")
        return match[1] + place + target[1] + match[3]

    lines = []
    fenced = False
    for line in text.split("\n"):
        if _FENCE.match(line):
            fenced = not fenced
        elif not fenced:
            line = _LINK.sub(rewrite, line)
            if line.startswith("|"):  # a bar in code ends no cell here, and an escaped one would show its escape
                line = _CODE.sub(lambda code: code[0].replace("\\|", "|"), line)
        lines.append(line)
    return "\n".join(lines)


def _read(path):
    with open(os.path.join(_repository, path), encoding="utf-8", errors="replace") as file:
        return file.read()


def _listing(path):
    names = sorted(os.listdir(os.path.join(_repository, path)))
    return [os.path.join(path, name) for name in names if os.path.isfile(os.path.join(_repository, path, name))]


def _write(path, config):
    """A page of a source's text, or of a folder's files."""
    place = _place(path)
    root = "../" * place.count("/")
    if os.path.isdir(os.path.join(_repository, path)):
        items = "".join(
            f'<li><a href="{root}{_place(file)}">{html.escape(os.path.basename(file))}</a></li>\n'
            for file in _listing(path) if not file.endswith(".md"))
        body = f"<ul>\n{items}</ul>"
    else:
        body = f"<pre>{html.escape(_read(path))}</pre>"
    made = os.path.join(_made.name, place)
    os.makedirs(os.path.dirname(made), exist_ok=True)
    with open(made, "w", encoding="utf-8") as file:
        file.write(_TEXT.format(path=html.escape(path), root=root, body=body))
    return File(place, _made.name, config["site_dir"], config["use_directory_urls"])


def on_config(config):
    global _repository
    _repository = os.path.dirname(config["config_file_path"])
    config["mdx_configs"].setdefault("toc", {})["slugify"] = anchor
    return config


def on_files(files, config):
    known = set()
    found = {"README.md", "CONTRIBUTING.md", "CHANGELOG.md", "SECURITY.md", "idl/README.md"}
    for page in files.documentation_pages():
        _rewritten(_read(_origin(page)), _origin(page), found)
    while found - known:
        path = sorted(found - known)[0]
        known.add(path)
        if path.startswith("docs/") or path == "docs":
            continue
        if path.endswith(".md"):
            page = File(_place(path), config["docs_dir"], config["site_dir"], config["use_directory_urls"])
            page.abs_src_path = os.path.join(_repository, path)
            files.append(page)
            _rewritten(_read(path), path, found)
        elif os.path.isdir(os.path.join(_repository, path)):
            if _place(path).endswith("README.md"):
                found.add(os.path.join(path, "README.md"))
            else:
                files.append(_write(path, config))
                found.update(file for file in _listing(path) if not file.endswith(".md"))
        else:
            files.append(_write(path, config))
    return files


def on_page_markdown(markdown, page, config, files):
    return _rewritten(markdown, _origin(page.file))
