"use strict";

/** Dark, light, or as the system is. */
const Theme = (() => {
  const name = "scc-theme";
  const kinds = ["system", "dark", "light"];

  /**
   * What was chosen before. A page from a file chooses for itself: what it kept, pages of others would find.
   * @param {boolean} keeps
   */
  function chosen(keeps) {
    try {
      return Math.max(0, keeps ? kinds.indexOf(window.localStorage.getItem(name) || "") : 0);
    } catch (_) {
      return 0;
    }
  }

  /** @param {string} kind */
  function keep(kind) {
    try {
      window.localStorage.setItem(name, kind);
    } catch (_) {
      // Then it is for this page alone.
    }
  }

  /**
   * The button chooses, and all pages of one service follow; `told` hears what it is.
   * @param {HTMLElement} button @param {boolean} keeps @param {(is: string) => void} told
   */
  function start(button, keeps, told) {
    const dark = window.matchMedia("(prefers-color-scheme: dark)");
    let kind = chosen(keeps);
    const show = () => {
      const is = kind === 0 ? (dark.matches ? "dark" : "light") : kinds[kind];
      document.documentElement.setAttribute("data-theme", is);
      button.textContent = ["Theme", "Dark", "Light"][kind];
      button.setAttribute("aria-label", `Theme: ${kinds[kind]}`);
      told(is);
    };
    button.addEventListener("click", () => {
      // First what is unlike the system, then what is like it, then as it.
      const other = dark.matches ? 2 : 1;
      kind = kind === 0 ? other : kind === other ? 3 - other : 0;
      if (keeps) keep(kinds[kind]);
      show();
    });
    dark.addEventListener("change", show);
    window.addEventListener("storage", (event) => {
      if (!keeps || event.key !== name) return;
      kind = chosen(keeps);
      show();
    });
    show();
  }

  return { start };
})();
