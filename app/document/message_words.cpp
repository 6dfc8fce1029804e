// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/message_words.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <iterator>

namespace loopmend::labels {
namespace {

/// A text that names an option of the command line, and what the window says in its place.
struct Substitute {
  const char* text;
  const char* of_window;
};

const Substitute substitutes[] = {
    {"--boundary exact runs the flow itself",
     QT_TRANSLATE_NOOP("Message", "the Boundary \"Exact\" runs the flow itself")},
    {"Choose another folder for the output, or --materials reference.",
     QT_TRANSLATE_NOOP("Message", "Choose another folder for the output.")},
    {"a lower density needs fewer", QT_TRANSLATE_NOOP("Message", "a lower Density needs fewer")},
    {"a lower density may help", QT_TRANSLATE_NOOP("Message", "a lower Density may help")},
    {"stitching joins them", QT_TRANSLATE_NOOP("Message", "Stitch in the tab Patch joins them")},
    {"--weld joins their vertices",
     QT_TRANSLATE_NOOP("Message", "Repair\u2026 in the tab Patch can join their vertices")},
    {"the polyhedron is no simple surface: edges with more than two faces, faces that meet at a vertex alone, or faces "
     "that are double or without area. Repair it first.",
     QT_TRANSLATE_NOOP(
         "Message",
         "the polyhedron is no simple surface: edges with more than two faces, faces that meet at a vertex alone, or "
         "faces that are double or without area. First press Repair\u2026 in the tab Patch.")},
    {"close it, or let its boundary loops become smooth curves (--open)",
     QT_TRANSLATE_NOOP("Message", "close it, or tick Smooth boundaries")},
    {"--repair removes such fragments",
     QT_TRANSLATE_NOOP("Message", "Repair\u2026 in the tab Patch removes such fragments")},
    {"--edges round runs the flow", QT_TRANSLATE_NOOP("Message", "without Sharp edges the flow runs")},
    {"its edges are too short for its size: left open; a smaller density needs less memory",
     QT_TRANSLATE_NOOP("Message",
                       "its edges are too short for its size: left open; a smaller Density needs less memory")},
    {"about %1 new vertices would take %2 MB of memory, and %3 MB are free for it: left open; a smaller density needs "
     "less",
     QT_TRANSLATE_NOOP(
         "Message",
         "about %1 new vertices would take %2 MB of memory, and %3 MB are free for it: left open; a smaller "
         "Density needs less")},
    {"not enough memory for this hole: left open; a smaller density needs less",
     QT_TRANSLATE_NOOP("Message", "not enough memory for this hole: left open; a smaller Density needs less")},
    {"not tried, but may help: to remove loose fragments in its way (--repair), to trim the boundary (--trim-boundary "
     "3), "
     "or a strip across the hole (--bridge)",
     QT_TRANSLATE_NOOP("Message",
                       "not tried, but may help: to remove loose fragments in its way (Repair\u2026 in the tab Patch), "
                       "Trim there, or a "
                       "strip across the hole (Bridge in the tab Tools)")},
    {"a base (--base) closes it below the surface",
     QT_TRANSLATE_NOOP("Message", "a base closes it below the surface (loopmend fill --base)")},
    {"remove what crosses (--trim-crossing)",
     QT_TRANSLATE_NOOP("Message", "Trim crossing triangles in the menu Patch may help")},
    {"'loopmend blend --loops 1:%1,1:%2' may join the two by one surface",
     QT_TRANSLATE_NOOP("Message", "Blend in the tab Tools may join the two by one surface")},
    {"%1 is there, and no batch wrote it: move it away, or give --overwrite",
     QT_TRANSLATE_NOOP("Message", "%1 is there, and no batch wrote it: move it away, or tick Replace other files")},
    {"%1 is there, and no batch wrote it, or it has changed since: move it away, or give --overwrite",
     QT_TRANSLATE_NOOP("Message",
                       "%1 is there, and no batch wrote it, or it has changed since: move it away, or tick Replace "
                       "other files")},
    {"the system starts no further process: %1. A smaller --jobs needs fewer.",
     QT_TRANSLATE_NOOP("Message", "the system starts no further process: %1. Close other programs.")},
    {"this machine could not draw a picture of %1x%2 pixels. Try a smaller --size.",
     QT_TRANSLATE_NOOP("Message", "this machine could not draw a picture of %1x%2 pixels. Try a smaller size.")},
    {"vertices of more digits than the single precision that the file declares, rounded to it (--double keeps them)",
     QT_TRANSLATE_NOOP("Message",
                       "vertices of more digits than the single precision that the file declares, rounded to it")}};

QString window_text(const std::string& text) {
  const auto* const found = std::find_if(std::begin(substitutes), std::end(substitutes),
                                         [&](const Substitute& one) { return one.text == text; });
  return QCoreApplication::translate("Message", found == std::end(substitutes) ? text.c_str() : found->of_window);
}

QString as_it_is(const std::string& text) {
  QString words = QString::fromStdString(text);
  bool is_number = false;
  words.toDouble(&is_number);
  return is_number ? words.replace(QLatin1Char('.'), QLocale().decimalPoint()) : words;
}

}  // namespace

QString in_words(const Message& message) {
  if (message.is_verbatim) return as_it_is(message.text);
  const QString text = window_text(message.text);
  QString words;
  for (int at = 0; at < text.size(); ++at) {
    const int k = text[at] == QLatin1Char('%') && at + 1 < text.size() ? text[at + 1].digitValue() : 0;
    if (k < 1 || k > static_cast<int>(message.arguments.size())) {
      words += text[at];
    } else {
      words += in_words(message.arguments[k - 1]);
      ++at;
    }
  }
  return words;
}

}  // namespace loopmend::labels
