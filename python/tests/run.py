# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the tests of some files. Usage: run.py FILE...

Exit code: 0 all well, 1 something is not, 77 pytest or the module is missing, or every test was skipped (the reasons are printed).
"""
import sys
from pathlib import Path

SKIPPED = 77


class Count:
    """How many tests ran to their end."""

    ran = 0

    def pytest_runtest_logreport(self, report):
        self.ran += report.when == "call" and not report.skipped


def main():
    try:
        import pytest
    except ImportError:
        print("skipped: pytest is missing (Debian: python3-pytest)")
        return SKIPPED
    try:
        import loopmend
    except ModuleNotFoundError as error:
        print(f"skipped: the module is not built: {error}")
        return SKIPPED
    print("loopmend", loopmend.__version__, "of", Path(loopmend.__file__).parent)
    count = Count()
    code = pytest.main(["-q", "-rs", "-p", "no:cacheprovider", *sys.argv[1:]], plugins=[count])
    if code == 0 and count.ran == 0:
        return SKIPPED
    return int(code != 0)


if __name__ == "__main__":
    sys.exit(main())
