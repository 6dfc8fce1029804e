#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The notices of what is compiled into the Python module: name, version and licence texts of every package whose headers its
objects were compiled with (ninja's records), as dpkg or pip have them.

  notices.py --build DIR --module FILE OUTPUT

Libraries that the module loads from the system are named; they are no part of it. Exit code 0; without dpkg the file says that
the notices could not be collected.
"""
import argparse
import pathlib
import re
import shutil
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "packaging"))
sys.dont_write_bytecode = True
import sbom  # noqa: E402

COMMON = re.compile(r"/usr/share/common-licenses/([A-Za-z0-9.-]*[A-Za-z0-9])")
HEAD = """Third-party notices of the Python module of Loopmend

Loopmend itself is under the GNU General Public License, version 3 or later: see LICENSE.
"""


def licences_of_pip(headers):
    """Texts by "name version" for headers of packages that pip has installed."""
    texts = {}
    for header in headers:
        match = re.match(r"(.*/(?:site|dist)-packages)/([A-Za-z0-9_]+)/", header)
        if not match:
            continue
        for about in pathlib.Path(match[1]).glob(match[2] + "-*.dist-info"):
            name = " ".join(about.name[:-len(".dist-info")].rsplit("-", 1))
            files = sorted(p for p in about.rglob("*") if re.match(r"(LICEN[CS]E|COPYING|NOTICE)", p.name))
            texts[name] = "\n".join(p.read_text(encoding="utf-8", errors="replace") for p in files)
    return texts


def licences_of_debian(packages):
    """Texts by "name version"; the packages of one source have one text."""
    texts = {}
    for package in sorted(packages):
        about = sbom.describe(package)
        path = pathlib.Path("/usr/share/doc") / about["name"] / "copyright"
        if not path.exists():
            sys.exit(f"notices: {path} is missing, so the licence of {package} is not known")
        text = path.read_text(encoding="utf-8", errors="replace")
        known = [name for name, other in texts.items() if other == text]
        name = f"{about['name']} {about['version']}"
        if known:
            texts[f"{known[0]}, {name}"] = texts.pop(known[0])
        else:
            texts[name] = text
    return texts


def section(title, text):
    return f"\n{'=' * 100}\n{title}\n{'=' * 100}\n\n{text.strip()}\n"


def notices(build, module):
    headers = sbom.headers_of(build, folders=("engine/", "python/"), where=r"/usr/|.*/(site|dist)-packages/")
    loaded, named = sbom.libraries_of(module)
    libraries = sorted(set(sbom.packages_of({loaded[name] for name in named if name in loaded}).values()))
    texts = {**licences_of_debian(set(sbom.packages_of(headers).values())), **licences_of_pip(headers)}
    out = HEAD + "\nParts of these packages are compiled in:\n\n"
    out += "".join(f"  {name}\n" for name in texts)
    out += "\nThese are loaded from the system, and are not contained:\n\n"
    out += "".join(f"  {name}\n" for name in libraries)
    for name, text in texts.items():
        out += section(name, text)
    for licence in sorted({name for text in texts.values() for name in COMMON.findall(text)}):
        path = pathlib.Path("/usr/share/common-licenses") / licence
        if path.exists():
            out += section(f"The licence that is called {licence} above", path.read_text(encoding="utf-8"))
    return out


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", required=True, type=pathlib.Path)
    parser.add_argument("--module", required=True, type=pathlib.Path)
    parser.add_argument("output", type=pathlib.Path)
    arguments = parser.parse_args()
    if shutil.which("dpkg-query"):
        text = notices(arguments.build, arguments.module)
    else:
        text = HEAD + "\nThe notices of other packages could not be collected: this was built without dpkg, whose records have them.\n"
    arguments.output.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
