#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads and drives the real program as a screen reader does: over AT-SPI, from another process.

Usage: read_by_atspi.py PROGRAM SCAN
Prints the tree of what is shown. Fails where something that takes input has no name, or where the holes cannot be filled
by the names alone.
"""
import subprocess
import sys
import time

import gi

gi.require_version("Atspi", "2.0")
from gi.repository import Atspi, GLib  # noqa: E402

TAKES_INPUT = {
    "push button", "check box", "radio button", "combo box", "spin button", "slider", "text", "table", "tree", "list",
    "menu item", "check menu item", "radio menu item", "menu", "page tab", "toggle button", "password text",
}
# Qt's own parts of a control that has a name itself: the editor of a spin box, the arrows of a row of tabs.
PARTS = {"spin button", "combo box"}
deepest, tries, skipped = 40, 15, 77


def sought(find, seconds):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        while GLib.MainContext.default().iteration(False):  # what has changed arrives as events
            pass
        found = find()
        if found:
            return found
        time.sleep(0.3)
    return None


def wait_for(find, seconds, what):
    return sought(find, seconds) or sys.exit(f"read_by_atspi: {what} did not come within {seconds} s")


def children(node):
    try:
        return [c for c in (node.get_child_at_index(i) for i in range(node.get_child_count())) if c]
    except GLib.Error:
        return []  # gone meanwhile


def is_showing(node):
    states = node.get_state_set()
    return states.contains(Atspi.StateType.VISIBLE) and states.contains(Atspi.StateType.SHOWING)


def walk(node, depth=0, parent=""):
    """Yields (depth, role, name, role of the parent, node) of what is on the screen; not the cells of tables."""
    if depth > deepest:
        return
    role, name = node.get_role_name(), node.get_name() or ""
    yield depth, role, name, parent, node
    if role in ("table", "tree table", "tree", "list", "combo box"):
        return
    for child in children(node):
        if child.get_role_name() in ("menu", "menu item") or is_showing(child):
            yield from walk(child, depth + 1, role)


def application(pid):
    desktop = Atspi.get_desktop(0)
    desktop.clear_cache()
    for app in children(desktop):
        if app.get_process_id() == pid and children(app):
            return app
    return None


def named(app, role, beginning):
    for _, found, name, _, node in walk(app):
        if found == role and name.startswith(beginning):
            return node
    return None


def cells(table):
    grid = table.get_table_iface()
    for row in range(grid.get_n_rows()):
        yield [grid.get_accessible_at(row, column).get_name() for column in range(grid.get_n_columns())]


def started(command):
    """The program, and what the bus knows of it.

    Qt 5.15 may register before it has reached the bus ("Not connected to D-Bus server"), and is then never heard of: two
    times out of three here. So the program is started anew until it is heard.
    """
    for _ in range(tries):
        program = subprocess.Popen(command)
        app = sought(lambda: application(program.pid), 6)
        if app:
            return program, app
        program.kill()
        program.wait()
    print(f"read_by_atspi: in {tries} starts, Qt did not reach the bus of AT-SPI", file=sys.stderr)
    sys.exit(skipped)


def main():
    Atspi.get_desktop(0).set_cache_mask(Atspi.Cache.NONE)  # ask anew each time
    program, app = started(sys.argv[1:3])
    try:
        table = wait_for(lambda: named(app, "table", "Boundary loops"), 60, "the table of holes")
        wait_for(lambda: any(True for _ in cells(table)), 60, "the first hole")
        nameless, count = [], 0
        for depth, role, name, parent, node in walk(app):
            print("  " * depth + role + (f" '{name}'" if name else ""))
            if role not in TAKES_INPUT or parent in PARTS or role == "text" and parent == "combo box":
                continue
            count += 1
            if not name.strip():
                nameless.append(f"{role} in {parent}")
        for row in cells(table):
            print("  row:", " | ".join(row))
        if nameless:
            sys.exit("read_by_atspi: without a name: " + ", ".join(nameless))
        if count < 60:
            sys.exit(f"read_by_atspi: only {count} controls were found")
        button = wait_for(lambda: named(app, "push button", "Fill and smooth"), 10, "the button that fills")
        action = button.get_action_iface()
        action.do_action(0)

        def filled():
            rows = list(cells(table))
            states = [row[-1] for row in rows if "hole" in row]
            return states if states and not any(s in ("open", "filled", "running") for s in states) else None

        print("after Fill and smooth:", wait_for(filled, 120, "the end of the flow"))
        print(f"{count} controls, all with names")
    finally:
        program.kill()
        program.wait()


if __name__ == "__main__":
    main()
