#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The notices of what is compiled into the Python module: name, version and licence texts of every package whose headers its
objects were compiled with (ninja's records), as dpkg or pip have them.

  notices.py --build DIR... --module FILE [--contained] OUTPUT

--build: one folder, or that of the module and that of the engine which it was linked with. --contained: the libraries that the module
loads are in the wheel, with their licences here; without it they are loaded from the system.

Exit code 0; without dpkg the file says that
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


# Part of every system that a manylinux wheel runs on (PEP 599), and what packaging/make_wheels leaves out: no wheel contains them.
NOT_CONTAINED = re.compile(r"(libc|libm|ld-linux.*|libpthread|libdl|librt|libz|libexpat|libstdc\+\+|libgcc_s|liblapack|libblas|libgfortran"
                           r"|libquadmath|libcrypto)[-.]")


def notices(builds, module, contained):
    headers = set()
    for build in builds:
        headers |= sbom.headers_of(build, folders=("engine/", "python/"), where=r"/usr/|.*/(site|dist)-packages/")
    loaded, named = sbom.libraries_of(module)
    chosen = {name for name in loaded if not NOT_CONTAINED.match(name)} if contained else {name for name in named if name in loaded}
    libraries = sorted(set(sbom.packages_of({loaded[name] for name in chosen}).values()))
    texts = {**licences_of_debian(set(sbom.packages_of(headers).values())), **licences_of_pip(headers)}
    out = HEAD + "\nParts of these packages are compiled in:\n\n"
    out += "".join(f"  {name}\n" for name in texts)
    out += ("\nThese libraries are in loopmend.libs:\n\n" if contained else
            "\nThese are loaded from the system, and are not contained:\n\n")
    out += "".join(f"  {name}\n" for name in libraries)
    if contained:
        for name, text in licences_of_debian(set(libraries)).items():
            if text not in texts.values():
                texts[name] = text
    for name, text in texts.items():
        out += section(name, text)
    for licence in sorted({name for text in texts.values() for name in COMMON.findall(text)}):
        path = pathlib.Path("/usr/share/common-licenses") / licence
        if path.exists():
            out += section(f"The licence that is called {licence} above", path.read_text(encoding="utf-8"))
    return out


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", required=True, type=pathlib.Path, nargs="+")
    parser.add_argument("--contained", action="store_true")
    parser.add_argument("--module", required=True, type=pathlib.Path)
    parser.add_argument("output", type=pathlib.Path)
    arguments = parser.parse_args()
    if shutil.which("dpkg-query"):
        text = notices(arguments.build, arguments.module, arguments.contained)
    else:
        text = HEAD + "\nThe notices of other packages could not be collected: this was built without dpkg, whose records have them.\n"
    arguments.output.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
