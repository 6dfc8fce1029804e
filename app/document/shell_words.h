// SPDX-License-Identifier: GPL-3.0-or-later
// Words of a command line, for a POSIX shell, or for cmd on Windows: in shell_words_posix.cpp and shell_words_windows.cpp.
#pragma once

#include "document/opened_scan.h"
#include "evolution/evolution.h"

#include <QString>
#include <QStringList>

namespace loopmend::shell {

/// The shortest decimal that reads back as the same double.
QString exact(double value);
/// A path, in quotes where the shell needs them.
QString quoted(const QString& path);
/// A command that makes a file of these lines, which are words without meaning to the shell.
QString writing(const QString& file, const QStringList& lines);
/// As --flow takes it.
QString word(FlowKind flow);
/// What --loops takes behind the number of a loop: ":flat"; nothing for a smooth one.
QString loop_shape(SeamContinuity shape);
/// --boundary and --continuity, with a blank before each; nothing where they are what the command takes by itself.
QString boundary_options(BoundaryTrust boundary, SeamContinuity continuity);
/// Of `fill`; empty for a smooth patch.
QString relief_options(const ReliefChoice& relief);
/// Of `fill`; empty where sharp edges run on.
QString edges_options(SharpEdges edges, const EdgeEdits& edits);
/// Where a scan's file is; a name to be written to first where it has none.
QString file_of(const OpenedScan& scan, const QString& made = QStringLiteral("surface.ply"));
/// In the same folder, under the same name with something appended: "scan.ply", "-filled.ply" make "scan-filled.ply".
QString beside(const QString& file, const QString& ending);

}  // namespace loopmend::shell
