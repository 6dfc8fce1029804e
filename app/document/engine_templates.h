// SPDX-License-Identifier: GPL-3.0-or-later
// What the engine says, part by part, and how the window says it.
#pragma once

#include <QCoreApplication>

#include <vector>

namespace loopmend {

/// A part of a message of the engine; %1, %2 ... stand for its numbers and names, in this order.
struct EngineTemplate {
  const char* words;           ///< of the window, in English; translated, %1 and %2 may be in another order
  const char* engine = words;  ///< of the engine, where it is another text: it names an option of the command line
};

/// The table for engine_words.h. Parts are what stands between ". ", "; ", ": " and within a last pair of parentheses.
class EngineTemplates {
  Q_DECLARE_TR_FUNCTIONS(loopmend::EngineTemplates)

 public:
  static std::vector<EngineTemplate> of_patches();  ///< initial patches, filling, flows, regions, surfaces
  static std::vector<EngineTemplate> of_files();    ///< reading and writing, sessions, damage in files
  static std::vector<EngineTemplate> of_formats();  ///< glTF, 3MF, and what a format does not keep
};

}  // namespace loopmend
