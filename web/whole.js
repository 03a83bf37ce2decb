"use strict";

/**
 * Says that a page is not whole. It stands before all else: of a file that was cut off, the last scripts are missing, which
 * would show the page or say why they cannot.
 */
document.addEventListener("DOMContentLoaded", () => {
  const told = document.getElementById("notice");
  if (document.body.hasAttribute("data-ready") || (told && !told.hidden)) return;
  const box = told || document.body.appendChild(document.createElement("p"));
  box.className = "notice";
  box.hidden = false;
  box.textContent = "This page is not whole: its file was cut off. Copy it again, or make it anew.";
});
