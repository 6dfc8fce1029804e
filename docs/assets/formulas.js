// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the formulas: arithmatex leaves them as \( \) and \[ \].
document.addEventListener("DOMContentLoaded", () =>
  renderMathInElement(document.body, {
    delimiters: [
      { left: "\\(", right: "\\)", display: false },
      { left: "\\[", right: "\\]", display: true },
    ],
  })
);
