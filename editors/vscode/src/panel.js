"use strict";

const path = require("path");
const vscode = require("vscode");
const { checkAt, checksOf } = require("./checks");
const { run } = require("./program");

// While someone moves through the text, no page is made.
const STILL = 250;

/** @param {string} text */
const escaped = (text) =>
  text.replace(/[&<>"]/g, (mark) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[mark] || mark);

/** A page with words alone: it runs no script. @param {string} title @param {string} text */
const plainPage = (title, text) => `<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'">
<style>pre { white-space: pre-wrap; font-family: var(--vscode-editor-font-family); }</style></head>
<body><h3>${escaped(title)}</h3><pre>${escaped(text)}</pre></body></html>`;

/**
 * The page of `scc view` beside a model, of the check at the cursor: it follows the cursor from check to check, and the
 * file when it is saved.
 */
class Panel {
  /** @param {vscode.TextDocument} document @param {{program: string, seconds: number}} settings @param {() => void} closed */
  constructor(document, settings, closed) {
    this.document = document;
    this.settings = settings;
    /** @type {string | undefined} */
    this.check = undefined;
    /** @type {NodeJS.Timeout | undefined} */
    this.timer = undefined;
    /** @type {AbortController | undefined} */
    this.running = undefined;
    this.panel = vscode.window.createWebviewPanel(
      "scc.view",
      path.basename(document.fileName),
      { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true },
      { enableScripts: true, retainContextWhenHidden: true, localResourceRoots: [] },
    );
    this.panel.onDidDispose(() => {
      clearTimeout(this.timer);
      if (this.running) this.running.abort();
      closed();
    });
  }

  /** Shows a check, if it is not shown: at once, or when the cursor has been still. @param {string | undefined} check */
  follow(check) {
    if (check === this.check && this.timer === undefined) return;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => {
      this.timer = undefined;
      if (check !== this.check) this.show(check);
    }, STILL);
  }

  /** Follows the cursor. @param {number} offset */
  moved(offset) {
    this.follow(checkAt(this.document.getText(), offset));
  }

  /** Makes the page of the saved file anew. */
  saved() {
    const names = checksOf(this.document.getText()).map((check) => check.name);
    return this.show(this.check !== undefined && names.includes(this.check) ? this.check : undefined);
  }

  /** Shows the page of a check, or of all of them. @param {string | undefined} check */
  async show(check) {
    clearTimeout(this.timer);
    this.timer = undefined;
    this.check = check;
    if (this.running) this.running.abort();
    const mine = new AbortController();
    this.running = mine;
    const file = this.document.fileName;
    const title = path.basename(file) + (check === undefined ? "" : `: ${check}`);
    this.panel.title = title;
    const args = ["view", file, `--seconds=${this.settings.seconds}`, "-o", "-"];
    if (check !== undefined) args.push("--check", check);
    try {
      const { out, err } = await run(this.settings.program, args, path.dirname(file), mine.signal);
      if (this.running !== mine) return;
      // Verdicts give the exit code; a page is there whatever they are.
      this.panel.webview.html = out.startsWith("<!DOCTYPE html>") ? out : plainPage(title, err || "scc wrote no page");
    } catch (error) {
      const { name, code, message } = /** @type {NodeJS.ErrnoException} */ (error);
      if (name === "AbortError" || this.running !== mine) return;
      this.panel.webview.html = plainPage(
        title,
        code === "ENOENT" ? `There is no program ${this.settings.program}: see the setting scc.program.` : message,
      );
    } finally {
      if (this.running === mine) this.running = undefined;
    }
  }
}

module.exports = { Panel };
