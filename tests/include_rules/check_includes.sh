#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Who may know whom: checks every #include under ROOT/engine, ROOT/app and ROOT/python, and names each line that breaks a rule.
# Usage: check_includes.sh ROOT
# Exit code: 0 all well, 1 rules broken, 2 nothing to check there.
set -euo pipefail

cd "${1:?Usage: check_includes.sh ROOT}"
mapfile -t files < <(find engine app python -type f \( -name '*.h' -o -name '*.cpp' \) 2>/dev/null | LC_ALL=C sort)
if ((${#files[@]} == 0)); then
  echo "include rules: no sources under $PWD/engine, $PWD/app or $PWD/python" >&2
  exit 2
fi

exec awk '
  BEGIN {
    # What a folder of the engine may include beside itself.
    may["core"] = ""
    may["mesh"] = "core"
    may["io"] = "core mesh"
    may["operators"] = "core mesh"
    may["solvers"] = "core"
    may["remeshing"] = "core mesh"
    may["flows"] = "core mesh operators solvers"
    may["filling"] = "core mesh operators solvers remeshing"
    may["edges"] = "core mesh operators solvers remeshing filling"
    may["analysis"] = "core mesh operators"
    may["split"] = "core mesh operators solvers"
    may["neighborhood"] = "core mesh operators solvers filling split"
    may["evolution"] = "core mesh operators flows solvers remeshing filling neighborhood split"
    may["mirror"] = "core mesh filling"
    may["pipeline"] = "core mesh operators flows filling edges mirror neighborhood split evolution analysis repair"
    may["repair"] = "core mesh"
    may["texture"] = "core mesh operators solvers"
    may["export"] = "core mesh io pipeline texture"
    may["appearance"] = "core mesh io operators filling texture"
    may["samples"] = "core mesh"

    heavy = "^(CGAL/|suitesparse/|SuiteSparse|cholmod|umfpack|Eigen/(Cholmod|UmfPack)Support)"
    qt = "^(Q[A-Z][A-Za-z0-9]*$|Qt[A-Z][A-Za-z]*/|QVTK)"
    vtk = "(^|/)(vtk[A-Za-z0-9_]*\\.h|QVTK[A-Za-z]*\\.h)$"
    # Of Qt 5, what shows something. The undo classes live in the same module, but are no widgets.
    widget = "^(QtWidgets(/|$)|QApplication$|QDesktopWidget$|QMainWindow$|QSystemTrayIcon$|QShortcut$|QAction|QLabel$|" \
             "QMenu|QStatusBar$|QToolBar$|QToolTip$|QWhatsThis$|QSplitter$|QSplashScreen$|QSlider$|QDial$|QStyle|" \
             "QRubberBand$|QFrame$|QGraphics|QTabBar$|QHeaderView$|QCompleter$|QVTK|" \
             "Q[A-Za-z]*(Widget|Dialog|Box|Button|View|Layout|Edit|Item|ScrollBar|ScrollArea|ProgressBar)$)"
  }

  FNR == 1 {
    split(FILENAME, part, "/")
    house = part[1]
    folder = FILENAME ~ /^[^\/]*\/[^\/]*\// ? part[2] : ""
    is_header = FILENAME ~ /\.h$/
    sees_vtk = sees_engine = 0
  }

  /^[ \t]*#[ \t]*include[ \t]*[<"]/ {
    text = $0
    sub(/^[ \t]*#[ \t]*include[ \t]*/, "", text)
    quoted = substr(text, 1, 1) == "\""
    sub(/^[<"]/, "", text)
    sub(/[>"].*$/, "", text)
    first = text ~ /\// ? substr(text, 1, index(text, "/") - 1) : ""
    if (house != "python" && first == "pybind11") broken("only python/src includes pybind11")
    else if (house == "engine") check_engine()
    else if (house == "python") check_python()
    else check_app()
  }

  function broken(rule) {
    printf "%s:%d: includes %s: %s\n", FILENAME, FNR, text, rule
    ++count
  }

  function check_engine() {
    if (text ~ vtk) broken("the engine never sees VTK")
    else if (text ~ qt) broken("the engine never sees Qt")
    else if (text ~ heavy) {
      if (is_header) broken("CGAL and SuiteSparse stay inside .cpp files")
    } else if (first == "OpenMesh") {
      if (folder == "core" || folder == "solvers") broken(folder " knows Eigen alone, not OpenMesh")
    } else if (first in may) {
      if (first != folder && index(" " may[folder] " ", " " first " ") == 0)
        broken("engine/" folder " may include " (may[folder] == "" ? "no other folder" : may[folder]))
    } else if (text ~ /^(\.\.|app)\// || (quoted && first != "")) {
      broken("the engine includes its own folders only, by \"folder/file.h\"")
    }
  }

  function check_python() {
    if (text ~ vtk || text ~ qt || text ~ heavy) broken("python/src knows no Qt, VTK, CGAL or SuiteSparse")
    else if (quoted && first != "" && !(first in may)) broken("python/src includes the engine alone")
  }

  function is_widget(name) {
    sub(/^QtWidgets\/QUndo/, "QUndo", name)
    return name ~ widget && name !~ /^QUndo(Command|Stack|Group)$/
  }

  function check_app() {
    is_vtk = text ~ vtk
    is_engine = first in may
    sees_vtk = sees_vtk || is_vtk
    sees_engine = sees_engine || is_engine
    if (text ~ heavy) broken("CGAL and SuiteSparse stay inside the engine")
    else if (folder == "document" && is_vtk) broken("app/document knows no VTK")
    else if (folder ~ /^(document|cli)$/ && is_widget(text)) broken("app/" folder " knows no widgets")
    else if (folder != "scene" && FILENAME != "app/polydata_program.cpp" && sees_vtk && sees_engine && (is_vtk || is_engine)) {
      broken("only app/scene and app/polydata_program.cpp include both VTK and engine headers")
      sees_vtk = sees_engine = 0
    }
    # Kept for the second look: what comes in through headers of the app.
    place[++includes] = FILENAME ":" FNR
    from[includes] = FILENAME
    to[includes] = text
    if (is_vtk) brings_vtk[FILENAME] = 1
    if (is_widget(text)) brings_widgets[FILENAME] = 1
  }

  function check_indirect(  i, changed) {
    do {
      changed = 0
      for (i = 1; i <= includes; ++i) {
        if (("app/" to[i]) in brings_vtk && !(from[i] in brings_vtk)) changed = brings_vtk[from[i]] = 1
        if (("app/" to[i]) in brings_widgets && !(from[i] in brings_widgets)) changed = brings_widgets[from[i]] = 1
      }
    } while (changed)
    for (i = 1; i <= includes; ++i) {
      if (from[i] ~ /^app\/document\// && ("app/" to[i]) in brings_vtk)
        indirect(i, "app/document knows no VTK")
      if (from[i] ~ /^app\/(document|cli)\// && ("app/" to[i]) in brings_widgets)
        indirect(i, (from[i] ~ /document/ ? "app/document" : "app/cli") " knows no widgets")
    }
  }

  function indirect(i, rule) {
    printf "%s: includes %s, which brings in what must not be here: %s\n", place[i], to[i], rule
    ++count
  }

  END {
    check_indirect()
    if (count > 0) {
      printf "include rules: %d broken\n", count
      exit 1
    }
    printf "include rules: %d files, all well\n", ARGC - 1
  }
' "${files[@]}"
