// SPDX-License-Identifier: GPL-3.0-or-later
document.addEventListener("DOMContentLoaded", () => {
  // Draws the formulas: arithmatex leaves them as \( \) and \[ \].
  renderMathInElement(document.body, {
    delimiters: [
      { left: "\\(", right: "\\)", display: false },
      { left: "\\[", right: "\\]", display: true },
    ],
  });
  // A short option such as --stitch 0.5 goes to the next line as a whole; of a longer one, or in a table, at least --stitch.
  for (const code of document.querySelectorAll("p > code, li > code, td > code, th > code")) {
    if (code.textContent.length <= (code.closest("table") ? 14 : 24)) code.classList.add("whole");
    else code.innerHTML = code.innerHTML.replace(/--\w+/g, '<span class="whole">$&</span>');
  }
  // A telephone shows a whole window too small to read: each picture leads to itself alone.
  for (const picture of document.querySelectorAll(".md-content img")) {
    const link = document.createElement("a");
    link.href = picture.src;
    picture.replaceWith(link);
    link.append(picture);
  }
});
