#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The list of components is SPDX 2.3, complete, the same each time, and found wrong where a file is another.

Usage: check_sbom.py SBOM_PY BUILD PROGRAM...
Exit code 77: no dpkg, or not built by ninja.
"""
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

sbom, build, *programs = sys.argv[1:]
if not all(map(shutil.which, ["dpkg-query", "ldd", "readelf", "ninja"])) or not os.path.exists(f"{build}/build.ninja"):
    print("needs dpkg-query, ldd, readelf and a build by ninja")
    sys.exit(77)


def output_of(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def make(folder):
    subprocess.run([sys.executable, sbom, "make", "--version", "1.2.3", "--build", build, "--programs", *programs, "--",
                    str(folder)], check=True, env={**os.environ, "SOURCE_DATE_EPOCH": "1700000000"})
    return folder / "loopmend-1.2.3.spdx.json"


def refusal(folder):
    done = subprocess.run([sys.executable, sbom, "check", str(folder)], capture_output=True, text=True)
    return done.stderr.strip() if done.returncode else ""


def expect(holds, what):
    if not holds:
        sys.exit(f"FAILED: {what}")


with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    (folder / "loopmend-1.2.3.tar.xz").write_bytes(b"sources")
    (folder / "loopmend_1.2.3_amd64.deb").write_bytes(b"package")
    made = make(folder)
    bytes_before = made.read_bytes()
    expect(make(folder).read_bytes() == bytes_before, "the same files give the same list")
    document = json.loads(bytes_before)

    # SPDX 2.3, as its specification has it.
    expect(document["spdxVersion"] == "SPDX-2.3" and document["dataLicense"] == "CC0-1.0", "version and licence")
    expect(document["creationInfo"]["created"] == "2023-11-14T22:13:20Z", "the date is SOURCE_DATE_EPOCH")
    expect(re.fullmatch(r"urn:uuid:[0-9a-f-]{36}", document["documentNamespace"]), "a namespace of its own")
    packages = document["packages"]
    ids = [p["SPDXID"] for p in packages]
    expect(len(set(ids)) == len(ids), "each component has its own id")
    expect(all(re.fullmatch(r"SPDXRef-[A-Za-z0-9.-]+", one) for one in ids), "ids are of letters, digits, . and -")
    for package in packages:
        expect(package["name"] and package["versionInfo"] and package["downloadLocation"], f"{package['SPDXID']} is whole")
    known = set(ids) | {"SPDXRef-DOCUMENT"}
    related = set()
    for relation in document["relationships"]:
        ends = {relation["spdxElementId"], relation["relatedSpdxElement"]}
        expect(ends <= known, f"{ends} are components")
        related |= ends
    expect(related == known, "every component is related to another")

    # Each library that a program names is in a package of the list, in the version that dpkg has.
    listed = {p["name"]: p for p in packages if "externalRefs" in p}
    files = set()
    for package, entry in listed.items():
        for version, architecture in [output_of("dpkg-query", "-W", "-f", "${Version} ${Architecture}\n", package)
                                      .splitlines()[0].split()]:
            expect(entry["versionInfo"] == version, f"{package} is {version}")
            locator = entry["externalRefs"][0]["referenceLocator"]
            expect(locator.startswith(f"pkg:deb/debian/{package}@") and f"arch={architecture}" in locator, locator)
        files |= {os.path.basename(line) for line in output_of("dpkg-query", "-L", package).splitlines()}
    for program in programs:
        named = re.findall(r"\(NEEDED\).*\[(.*)\]", output_of("readelf", "-d", program))
        expect(len(named) > 5, f"{program} loads libraries")
        for soname in named:
            # Names that the system chooses between (BLAS) are in no package; their choice is.
            chosen = os.path.basename(os.path.realpath(f"/etc/alternatives/{soname}-x86_64-linux-gnu"))
            expect(soname in files or chosen in files, f"{soname} of {program} is in a listed package")
    for package in ["libeigen3-dev", "libcgal-dev", "libcli11-dev", "nlohmann-json3-dev"]:  # nothing of them is loaded
        expect(package in listed, f"{package}, whose headers are compiled in, is listed")
    expect(not any("gtest" in package for package in listed), "what only tests use is not listed")

    # The checksums, by another program.
    sums = {p["packageFileName"]: p["checksums"][0]["checksumValue"] for p in packages if "packageFileName" in p}
    expect(sums == {p: hashlib.sha256((folder / p).read_bytes()).hexdigest()
                    for p in ["loopmend-1.2.3.tar.xz", "loopmend_1.2.3_amd64.deb"]}, "checksums")

    expect("SHA256SUMS" in refusal(folder), "checksums that are missing are told")
    lines = subprocess.run(["sha256sum", *sorted(os.listdir(folder))], cwd=folder, capture_output=True, text=True,
                           check=True).stdout
    (folder / "SHA256SUMS").write_text(lines)
    expect(refusal(folder) == "", "what was made is in order")
    (folder / "loopmend_1.2.3_amd64.deb").write_bytes(b"Package")
    expect(refusal(folder).count("loopmend_1.2.3_amd64.deb is another file") == 2, "another file is told by both lists")
    (folder / "loopmend_1.2.3_amd64.deb").write_bytes(b"package")
    (folder / "more.deb").write_bytes(b"")
    expect(refusal(folder).count("more.deb is not in") == 2, "a further file is told")
    (folder / "more.deb").unlink()
    (folder / "loopmend-1.2.3.tar.xz").unlink()
    expect(refusal(folder).count("loopmend-1.2.3.tar.xz is only in") == 2, "a missing file is told")
print(f"{len(packages)} components, {len(document['relationships'])} relations")
