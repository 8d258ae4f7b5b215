// The extension: starts the language server, and offers its commands, tasks and the diagram.
import * as vscode from "vscode";
import { LanguageClient, State } from "vscode-languageclient/node";
import { compiler } from "./compiler.js";
import { Diagrams } from "./diagram.js";
import { explain, Explanations, SCHEME } from "./explain.js";
import { AsemecTasks, run } from "./tasks.js";

const SELECTOR = [
  { scheme: "file", language: "aseme" },
  { scheme: "untitled", language: "aseme" },
  { scheme: "file", language: "python" }, // the classes of activities: from there to the model
];

/** @type {LanguageClient | undefined} */
let client;

export async function activate(context) {
  const diagrams = new Diagrams(context.extensionUri, () => client);
  const output = vscode.window.createOutputChannel("ASEME", { log: true });
  context.subscriptions.push(
    output,
    diagrams,
    vscode.workspace.registerTextDocumentContentProvider(SCHEME, new Explanations()),
    vscode.commands.registerCommand("aseme.showDiagram", (uri, position) => diagrams.show(uri, position)),
    vscode.commands.registerCommand("aseme.restartServer", () => restart(context, output)),
    vscode.commands.registerCommand("aseme.explainDiagnostic", () => explain()),
    vscode.commands.registerCommand("aseme.runTeam", () => run(vscode.window.activeTextEditor?.document.uri)),
    // The lenses that the server shows above models and teams.
    vscode.commands.registerCommand("asemec.diagram", (uri, position) => diagrams.show(uri, position)),
    vscode.commands.registerCommand("asemec.run", ({ file }) => run(vscode.Uri.file(file))),
    vscode.workspace.onDidChangeConfiguration((event) => {
      if (event.affectsConfiguration("aseme.command")) restart(context, output);
    }),
    vscode.workspace.onDidGrantWorkspaceTrust(() => restart(context, output)),
  );
  if (vscode.workspace.isTrusted) {
    context.subscriptions.push(vscode.tasks.registerTaskProvider("asemec", new AsemecTasks()));
    await start(output);
  }
}

export async function deactivate() {
  await client?.stop();
}

async function restart(context, output) {
  const before = client;
  client = undefined;
  if (before) await before.dispose();
  await start(output);
  if (client?.state === State.Running) vscode.window.setStatusBarMessage("The ASEME language server runs.", 4000);
}

async function start(output) {
  const [command, ...before] = compiler();
  const server = { command, args: [...before, "lsp"] };
  client = new LanguageClient("aseme", "ASEME", server, {
    documentSelector: SELECTOR,
    outputChannel: output,
    initializationOptions: {
      prove: {
        onSave: vscode.workspace.getConfiguration("aseme").get("prove.onSave"),
        budget: vscode.workspace.getConfiguration("aseme").get("prove.budget"),
        robots: vscode.workspace.getConfiguration("aseme").get("prove.robots"),
      },
    },
    synchronize: {
      configurationSection: "aseme",
      fileEvents: vscode.workspace.createFileSystemWatcher("**/*.{aseme,proto,py,toml}"),
    },
    markdown: { isTrusted: false, supportHtml: false },
    middleware: { provideCodeLenses, executeCommand },
  });
  try {
    await client.start();
  } catch (error) {
    output.error(String(error));
    const settings = "Settings";
    const chosen = await vscode.window.showErrorMessage(
      `The ASEME language server could not be started as \`${[command, ...server.args].join(" ")}\`. ` +
        'In the clone of aseme-dsl: pip install ".[editor]"',
      settings,
    );
    if (chosen === settings) vscode.commands.executeCommand("workbench.action.openSettings", "aseme.command");
  }
}

/** The server's commands. The page of a diagnostic is shown beside the text, not in a window of its own. */
async function executeCommand(command, given, next) {
  return command === "aseme.explain" ? explain(given[0]) : next(command, given);
}

/** The server's lenses whose command there is; a diagram is asked for at the place of its lens. */
async function provideCodeLenses(document, token, next) {
  const [lenses, known] = await Promise.all([next(document, token), vscode.commands.getCommands(true)]);
  return (lenses ?? [])
    .filter((lens) => lens.command && known.includes(lens.command.command))
    .map((lens) => {
      if (lens.command.command === "asemec.diagram") lens.command.arguments = [document.uri, lens.range.start];
      return lens;
    });
}
