# SPDX-License-Identifier: GPL-3.0-or-later
# What Doxygen would misread in comments: "#V" is a number of vertices and no link, "\r" a character and no command.
/^[[:space:]]*#/! s/#([A-Za-z])/\\#\1/g
/^[[:space:]]*\/\// s/\\([rnt])\b/\\\\\1/g
