#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the published files are made of: a list of components (SBOM) as SPDX 2.3 JSON, from dpkg's records.

  sbom.py make --version V --build DIR --programs FILE... FOLDER   writes FOLDER/loopmend-V.spdx.json
  sbom.py check FOLDER                                             SHA256SUMS and the list fit the files there

Libraries are those that the programs load (ldd); headers those that the engine's and the programs' objects were compiled
with (ninja's records in DIR). The same files and packages give the same bytes; the date is SOURCE_DATE_EPOCH, else 0.
"""
import argparse
import datetime
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys
import uuid

LIST = re.compile(r"loopmend-.*\.spdx\.json")
SUMS = "SHA256SUMS"


def output_of(*command, accept=(0,), text=None):
    done = subprocess.run(command, capture_output=True, text=True, input=text, env={**os.environ, "LC_ALL": "C"})
    if done.returncode not in accept:
        sys.exit(f"sbom: {command[0]} failed: {done.stderr.strip()[:300]}")
    return done.stdout


def sha256(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def names_known_to_dpkg(path):
    """Debian's lists have some files below /lib that are found below /usr/lib."""
    real = os.path.realpath(path)
    names = {path, real}
    names |= {"/usr" + name for name in names if name.startswith("/lib")}
    names |= {name[len("/usr"):] for name in names if name.startswith("/usr/lib")}
    return names


def packages_of(paths):
    """Names of packages, with their architecture where dpkg says it, by file; files of no package are left out."""
    asked = {name: path for path in paths for name in names_known_to_dpkg(path)}
    found = {}
    names = sorted(asked)
    for begin in range(0, len(names), 500):
        for line in output_of("dpkg-query", "-S", *names[begin:begin + 500], accept=(0, 1)).splitlines():
            owners, _, name = line.partition(": ")
            if name in asked:
                found.setdefault(asked[name], owners.split(", ")[0])
    return found


def libraries_of(program):
    """Path by soname, and which of them the program itself names."""
    loaded = {}
    for line in output_of("ldd", str(program)).splitlines():
        match = re.match(r"\s*(\S+) => (/\S+)", line) or re.match(r"\s*()(/\S+) \(", line)
        if match:
            loaded[match[1] or os.path.basename(match[2])] = match[2]
    named = set(re.findall(r"\(NEEDED\).*\[(.*)\]", output_of("readelf", "-d", str(program))))
    return loaded, named


def headers_of(build, folders=("engine/", "app/"), where=r"/usr/"):
    """Headers at such places, a regular expression, that objects of these folders of the build were compiled with."""
    headers, wanted = set(), False
    for line in output_of("ninja", "-C", str(build), "-t", "deps").splitlines():
        if line and not line[0].isspace():
            wanted = line.startswith(folders)
        elif wanted and line.strip():
            path = os.path.normpath(os.path.join(os.path.abspath(build), line.strip()))
            if re.match(where, path):
                headers.add(path)
    return headers


def describe(package):
    fields = ["${Package}", "${Version}", "${Architecture}", "${source:Package}", "${source:Version}", "${Maintainer}",
              "${Homepage}"]
    values = output_of("dpkg-query", "-W", "-f", "\t".join(fields), package).split("\t")
    return dict(zip(["name", "version", "architecture", "source", "source_version", "maintainer", "home"], values))


def debian_version():
    match = re.search(r'^VERSION_ID="?(\d+)', pathlib.Path("/etc/os-release").read_text(encoding="utf-8"), re.M)
    return match[1] if match else "unknown"


def spdx_id(*words):
    return "SPDXRef-" + "-".join(re.sub(r"[^A-Za-z0-9.]+", "-", word) for word in words)


def as_component(about, comment):
    purl = f"pkg:deb/debian/{about['name']}@{about['version'].replace(':', '%3A').replace('+', '%2B')}"
    component = {
        "SPDXID": spdx_id("Package", about["name"]),
        "name": about["name"],
        "versionInfo": about["version"],
        "supplier": "Organization: Debian",
        "downloadLocation": "NOASSERTION",
        "filesAnalyzed": False,
        "licenseConcluded": "NOASSERTION",
        "licenseDeclared": "NOASSERTION",
        "licenseComments": f"/usr/share/doc/{about['name']}/copyright of the package",
        "copyrightText": "NOASSERTION",
        "sourceInfo": f"built by Debian from {about['source']} {about['source_version']}",
        "comment": comment,
        "externalRefs": [{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl",
                          "referenceLocator": f"{purl}?arch={about['architecture']}&distro=debian-{debian_version()}"}],
    }
    if about["home"]:
        component["homepage"] = about["home"]
    return component


def component_list(version, files, programs, build):
    main = spdx_id("Package", "loopmend")
    packages, relations = [], [("SPDXRef-DOCUMENT", "DESCRIBES", main)]
    packages.append({
        "SPDXID": main, "name": "loopmend", "versionInfo": version, "downloadLocation": "NOASSERTION",
        "filesAnalyzed": False, "licenseConcluded": "GPL-3.0-or-later", "licenseDeclared": "GPL-3.0-or-later",
        "copyrightText": "NOASSERTION", "supplier": "Organization: The Loopmend contributors"})
    for path in files:
        entry = {"SPDXID": spdx_id("File", path.name), "name": path.name, "versionInfo": version,
                 "packageFileName": path.name, "downloadLocation": "NOASSERTION", "filesAnalyzed": False,
                 "licenseConcluded": "GPL-3.0-or-later", "licenseDeclared": "GPL-3.0-or-later",
                 "copyrightText": "NOASSERTION",
                 "checksums": [{"algorithm": "SHA256", "checksumValue": sha256(path)}]}
        packages.append(entry)
        relations.append((main, "CONTAINS", entry["SPDXID"]))
    loaded, named = {}, set()
    for program in programs:
        more, direct = libraries_of(program)
        loaded.update(more)
        named |= direct
    owners = packages_of(set(loaded.values()))
    libraries = {}
    for soname, path in loaded.items():
        if path not in owners:
            sys.exit(f"sbom: {path} belongs to no package of dpkg")
        libraries.setdefault(owners[path], set()).add(soname)
    for package in sorted(libraries):
        sonames = sorted(libraries[package])
        component = as_component(describe(package), "loaded: " + ", ".join(sonames))
        packages.append(component)
        if named & set(sonames):
            relations.append((main, "DYNAMIC_LINK", component["SPDXID"]))
        else:
            relations.append((component["SPDXID"], "RUNTIME_DEPENDENCY_OF", main))
    for package in sorted(set(packages_of(headers_of(build)).values()) - set(libraries)):
        component = as_component(describe(package), "its headers are compiled in")
        packages.append(component)
        relations.append((component["SPDXID"], "BUILD_DEPENDENCY_OF", main))
    return packages, relations


def make(arguments):
    folder = arguments.folder
    files = sorted(p for p in folder.iterdir() if p.is_file() and p.name != SUMS and not LIST.fullmatch(p.name))
    packages, relations = component_list(arguments.version, files, arguments.programs, arguments.build)
    content = json.dumps(packages, sort_keys=True)
    created = datetime.datetime.fromtimestamp(int(os.environ.get("SOURCE_DATE_EPOCH", "0")), datetime.timezone.utc)
    document = {
        "spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT",
        "name": f"loopmend-{arguments.version}",
        "documentNamespace": f"urn:uuid:{uuid.uuid5(uuid.NAMESPACE_OID, content)}",
        "creationInfo": {"created": created.strftime("%Y-%m-%dT%H:%M:%SZ"),
                         "creators": ["Tool: loopmend/packaging/sbom.py", "Organization: The Loopmend contributors"]},
        "packages": packages,
        "relationships": [{"spdxElementId": a, "relationshipType": kind, "relatedSpdxElement": b}
                          for a, kind, b in relations]}
    (folder / f"loopmend-{arguments.version}.spdx.json").write_text(json.dumps(document, indent=1) + "\n")


def check(arguments):
    """Exits with a sentence unless every file is listed, in both lists, with its checksum."""
    folder = arguments.folder
    faults = []
    names = {p.name for p in folder.iterdir() if p.is_file()}
    lists = sorted(name for name in names if LIST.fullmatch(name))
    if SUMS not in names or len(lists) != 1:
        sys.exit(f"sbom: {folder} needs {SUMS} and one list of components, and has {sorted(names)}")
    sums = dict(reversed(line.split(None, 1)) for line in (folder / SUMS).read_text().splitlines())
    packages = json.loads((folder / lists[0]).read_text())["packages"]
    listed = {p["packageFileName"]: p["checksums"][0]["checksumValue"] for p in packages if "packageFileName" in p}
    for where, known, wanted in ((SUMS, sums, names - {SUMS}), (lists[0], listed, names - {SUMS, lists[0]})):
        for name in sorted(set(known) ^ wanted):
            faults.append(f"{name} is {'not in' if name in wanted else 'only in'} {where}")
        faults += [f"{name} is another file than {where} says" for name in sorted(wanted & set(known))
                   if known[name] != sha256(folder / name)]
    if faults:
        sys.exit("sbom: " + "; ".join(faults))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    maker = commands.add_parser("make")
    maker.add_argument("--version", required=True)
    maker.add_argument("--build", required=True, type=pathlib.Path)
    maker.add_argument("--programs", required=True, nargs="+", type=pathlib.Path)
    maker.add_argument("folder", type=pathlib.Path)
    commands.add_parser("check").add_argument("folder", type=pathlib.Path)
    arguments = parser.parse_args()
    (make if arguments.command == "make" else check)(arguments)


if __name__ == "__main__":
    main()
