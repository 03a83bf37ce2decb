"use strict";

const path = require("path");
const vscode = require("vscode");
const { LanguageClient, TransportKind } = require("vscode-languageclient/node");
const { checkAt } = require("./checks");
const { Panel } = require("./panel");

/** @type {Client | undefined} */
let client;
/** Panels by the address of their document. @type {Map<string, Panel>} */
const panels = new Map();

function settings() {
  const values = vscode.workspace.getConfiguration("scc");
  return { program: values.get("program", "scc"), seconds: values.get("seconds", 60) };
}

/** @param {string} what @param {unknown} error */
async function explain(what, error) {
  const message = error instanceof Error ? error.message : String(error);
  const { program } = settings();
  const chosen = await vscode.window.showErrorMessage(
    `${what} (${program}): ${message}. Is scc installed, and of a version that has "scc lsp"?`,
    "Open Settings",
  );
  if (chosen) await vscode.commands.executeCommand("workbench.action.openSettings", "scc.program");
}

/** What goes wrong is told once: a start by `explain`, a command by the editor, which shows the reason that the server gives. */
class Client extends LanguageClient {
  starting = true;

  /** @param {string} message @param {unknown} [data] @param {boolean | "force"} [show] */
  error(message, data, show) {
    super.error(message, data, this.starting ? false : show);
  }

  /** @param {{method: string}} type @param {...any} rest  a token, the error, a value, whether it is shown */
  handleFailedRequest(type, ...rest) {
    if (type.method === "workspace/executeCommand") rest[3] = false;
    return super.handleFailedRequest(type, ...rest);
  }
}

async function startServer() {
  const { program } = settings();
  client = new Client(
    "scc",
    "Shape Calculus",
    { command: program, args: ["lsp"], transport: TransportKind.stdio },
    {
      documentSelector: [
        { scheme: "file", language: "scc" },
        { scheme: "untitled", language: "scc" },
      ],
      synchronize: { fileEvents: vscode.workspace.createFileSystemWatcher("**/*.sc") },
      middleware: {
        // The server would show the page in a browser. Its other commands are its own.
        executeCommand: (command, args, next) =>
          command === "scc.showRun" ? commands["scc.showRunHere"](...args) : next(command, args),
      },
    },
  );
  try {
    await client.start();
    client.starting = false;
  } catch (error) {
    client = undefined;
    explain("The language server did not start", error);
  }
}

async function stopServer() {
  const stopped = client;
  client = undefined;
  if (stopped) await stopped.stop();
}

/**
 * The document that a command is about, saved: that of the address, or the one of the present editor.
 * @param {string | vscode.Uri} [uri] @returns {Promise<vscode.TextDocument | undefined>}
 */
async function model(uri) {
  const editor = vscode.window.activeTextEditor;
  const address = typeof uri === "string" ? vscode.Uri.parse(uri) : uri;
  const document = address ? await vscode.workspace.openTextDocument(address) : editor && editor.document;
  if (!document || document.languageId !== "scc") {
    vscode.window.showInformationMessage("This is for the editor of a model (.sc).");
    return undefined;
  }
  if (document.isUntitled || (document.isDirty && !(await document.save()))) {
    vscode.window.showInformationMessage("The model has to be saved first.");
    return undefined;
  }
  return document;
}

/** The check at the cursor, if the editor of the document is the present one. @param {vscode.TextDocument} document */
function atCursor(document) {
  const editor = vscode.window.activeTextEditor;
  if (!editor || editor.document !== document) return undefined;
  return checkAt(document.getText(), document.offsetAt(editor.selection.active));
}

/** @param {string} file @param {string} [check] */
function task(file, check) {
  const { program, seconds } = settings();
  const args = ["check", file, `--seconds=${seconds}`];
  if (check !== undefined) args.push("--check", check);
  const made = new vscode.Task(
    { type: "scc", file, check },
    vscode.TaskScope.Workspace,
    check === undefined ? path.basename(file) : `${path.basename(file)}: ${check}`,
    "scc",
    new vscode.ProcessExecution(program, args, { cwd: path.dirname(file) }),
    "$scc",
  );
  made.presentationOptions = { clear: true, panel: vscode.TaskPanelKind.Dedicated };
  return made;
}

/** @param {vscode.TextDocument} document @param {string} [check] */
function beside(document, check) {
  const address = document.uri.toString();
  let panel = panels.get(address);
  if (panel) panel.panel.reveal(undefined, true);
  else {
    panel = new Panel(document, settings(), () => panels.delete(address));
    panels.set(address, panel);
  }
  return panel.show(check);
}

const commands = {
  /** @param {string} [uri] */
  "scc.checkModel": async (uri) => {
    const document = await model(uri);
    if (document) await vscode.tasks.executeTask(task(document.fileName));
  },
  /** @param {string} [uri] @param {string} [check] */
  "scc.checkHere": async (uri, check) => {
    const document = await model(uri);
    if (!document) return;
    const name = typeof check === "string" ? check : atCursor(document);
    if (name === undefined) vscode.window.showInformationMessage("There is no check at the cursor.");
    else await vscode.tasks.executeTask(task(document.fileName, name));
  },
  /** @param {string} [uri] @param {string} [check] */
  "scc.showRunHere": async (uri, check) => {
    const document = await model(uri);
    if (document) await beside(document, typeof check === "string" ? check : atCursor(document));
  },
  /** @param {string} [uri] */
  "scc.view": async (uri) => {
    const document = await model(uri);
    if (document) await beside(document, atCursor(document));
  },
  "scc.restart": async () => {
    await stopServer();
    await startServer();
  },
};

/** @param {vscode.ExtensionContext} context */
async function activate(context) {
  for (const [name, command] of Object.entries(commands)) {
    context.subscriptions.push(vscode.commands.registerCommand(name, command));
  }
  context.subscriptions.push(
    vscode.window.onDidChangeTextEditorSelection(({ textEditor, selections }) => {
      const panel = panels.get(textEditor.document.uri.toString());
      if (panel) panel.moved(textEditor.document.offsetAt(selections[0].active));
    }),
    vscode.workspace.onDidSaveTextDocument((document) => {
      const panel = panels.get(document.uri.toString());
      if (panel) panel.saved();
    }),
    vscode.workspace.onDidChangeConfiguration((event) => {
      if (event.affectsConfiguration("scc.program")) commands["scc.restart"]();
    }),
    vscode.tasks.registerTaskProvider("scc", {
      provideTasks: () => [],
      resolveTask: ({ definition }) => {
        const made = task(definition.file, definition.check);
        made.definition = definition;
        return made;
      },
    }),
  );
  await startServer();
}

async function deactivate() {
  for (const panel of [...panels.values()]) panel.panel.dispose();
  await stopServer();
}

module.exports = { activate, deactivate };
