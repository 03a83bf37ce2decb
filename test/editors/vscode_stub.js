// What the extension uses of Visual Studio Code, for extension_test.js: it keeps what it is asked for, and tells of what the
// test does. `vscode-languageclient` is replaced as well: its server is another test's matter.
"use strict";

const fs = require("fs");
const Module = require("module");

const said = { commands: {}, messages: [], panels: [], tasks: [], clients: [], executed: [], providers: {} };
const values = {};
const listeners = { selection: [], save: [], configuration: [] };
const disposable = { dispose() {} };

class Uri {
  constructor(path) {
    this.path = path;
    this.fsPath = path;
    this.scheme = "file";
  }
  toString() {
    return "file://" + this.path;
  }
  static parse(text) {
    return new Uri(text.replace(/^file:\/\//, ""));
  }
}

class Document {
  constructor(path, languageId = "scc") {
    this.uri = new Uri(path);
    this.fileName = path;
    this.languageId = languageId;
    this.isUntitled = false;
    this.isDirty = false;
    this.text = fs.readFileSync(path, "utf8");
    this.saved = 0;
  }
  getText() {
    return this.text;
  }
  offsetAt(offset) {
    return offset;
  }
  async save() {
    this.saved += 1;
    fs.writeFileSync(this.fileName, this.text);
    this.isDirty = false;
    return true;
  }
}

const documents = new Map();
const document = (path) => {
  if (!documents.has(path)) documents.set(path, new Document(path));
  return documents.get(path);
};

const vscode = {
  Uri,
  ViewColumn: { Beside: -2 },
  TaskScope: { Workspace: 2 },
  TaskPanelKind: { Dedicated: 2 },
  ProcessExecution: class {
    constructor(process, args, options) {
      Object.assign(this, { process, args, options });
    }
  },
  Task: class {
    constructor(definition, scope, name, source, execution, problemMatchers) {
      Object.assign(this, { definition, scope, name, source, execution, problemMatchers });
    }
  },
  commands: {
    registerCommand: (name, command) => {
      said.commands[name] = command;
      return disposable;
    },
    executeCommand: async (...words) => said.executed.push(words),
  },
  tasks: {
    registerTaskProvider: (type, provider) => {
      said.providers[type] = provider;
      return disposable;
    },
    executeTask: async (task) => said.tasks.push(task),
  },
  window: {
    activeTextEditor: undefined,
    showErrorMessage: async (text) => void said.messages.push(text),
    showInformationMessage: async (text) => void said.messages.push(text),
    createWebviewPanel: (type, title, column, options) => {
      const panel = { type, title, column, options, webview: { html: "" }, closing: [], revealed: 0 };
      panel.onDidDispose = (then) => panel.closing.push(then);
      panel.dispose = () => panel.closing.forEach((then) => then());
      panel.reveal = () => (panel.revealed += 1);
      said.panels.push(panel);
      return panel;
    },
    onDidChangeTextEditorSelection: (then) => (listeners.selection.push(then), disposable),
  },
  workspace: {
    getConfiguration: () => ({ get: (name, otherwise) => (name in values ? values[name] : otherwise) }),
    openTextDocument: async (uri) => document(uri.path),
    createFileSystemWatcher: () => disposable,
    onDidSaveTextDocument: (then) => (listeners.save.push(then), disposable),
    onDidChangeConfiguration: (then) => (listeners.configuration.push(then), disposable),
  },
};

class LanguageClient {
  constructor(id, name, server, client) {
    Object.assign(this, { id, name, server, client, started: 0, stopped: 0 });
    said.clients.push(this);
  }
  async start() {
    this.started += 1;
    if (values.program === "/nowhere/scc") throw new Error("spawn ENOENT");
  }
  async stop() {
    this.stopped += 1;
  }
}

const load = Module._load;
Module._load = (name, ...rest) => {
  if (name === "vscode") return vscode;
  if (name === "vscode-languageclient/node") return { LanguageClient, TransportKind: { stdio: 0 } };
  return load(name, ...rest);
};

module.exports = { vscode, said, values, listeners, document };
