// SPDX-License-Identifier: GPL-3.0-or-later
// A session in a file: which scans are open, every patch as it is, and how it was looked at. Scans stay in their own files, unless
// they are to be kept in the session; surfaces that were made here are stored whole.
#pragma once

#include "document/packed_session.h"
#include "document/patch_state.h"
#include "scene/look.h"

#include <QByteArray>
#include <QString>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace loopmend {

inline constexpr const char* session_suffix = "loopmend";

struct SessionScan {
  QString path;  ///< absolute; empty: the embedded sample, or made
  std::uint64_t fingerprint = 0;
  QString name;                              ///< of a surface that was made
  std::shared_ptr<const TriangleSoup> made;  ///< a surface that is in no file: it lies in the session itself
  std::string unit;                          ///< as chosen by a person; empty: as the file has it
  KeptFilePtr file;                          ///< its file, where the session holds it; null: it lies elsewhere
  std::map<int, SeamContinuity> shapes{};    ///< chosen for loops, by their numbers
};

struct SessionPatch {
  int scan = 0;                   ///< index into Session::scans
  std::vector<int> loop_numbers;  ///< BoundaryLoop::number, in the order of state.patch.loops
  PatchStatePtr state;            ///< `shape` is not stored
  Acceptance acceptance = Acceptance::pending;
  Timeline timeline;  ///< recorded states, with `state` among them; empty: that alone
};

struct SessionView {
  Viewpoint from;
  Look look;
};
/// Asked on the thread of the window when a session is about to be written.
using ViewSource = std::function<SessionView()>;

struct Session {
  std::vector<SessionScan> scans;
  std::vector<SessionPatch> patches;
  std::optional<SessionView> view;
};

/// Whether the files of scans become a part of the session, so that it needs nothing beside it.
enum class KeepScans { outside, inside };

class Document;
/// How many bytes recorded states may take in a session, and in the copy that survives a crash, which is written again and
/// again.
inline constexpr std::size_t most_recorded = std::size_t{64} << 20;
inline constexpr std::size_t most_recorded_in_copy = std::size_t{16} << 20;

/// As it is now; `view` may be empty. States are shared, so this is fast, and a worker may write it while the window goes on.
/// @param recorded  bytes: above, each timeline gives up every second one of its inner states, as often as needed, and
/// then all but the present one
Session session_of(const Document& document, const ViewSource& view, std::size_t recorded = most_recorded);

/// @param beside  folder of the file: paths are stored relative to it as well, so that both can move together.
QByteArray to_bytes(const Session& session, const QString& beside);

/// Decides which files the session will hold: with KeepScans::inside all, else those alone that are nowhere else.
/// @throws as keep_file().
void keep_scans(Session& session, KeepScans keep);

/// Scans that are not at their absolute path are looked for beside the session.
/// @throws ReadError for anything that is not wholly a session of a known version.
Session session_from_file(const QString& path);

/// Atomically; when cancelled before the file is whole, what was there stays. @throws WriteError.
void write_session(const Session& session, const QString& path, const CancelToken& cancel = {});

bool is_session_path(const QString& path);

}  // namespace loopmend
