// The diagram beside the text: it shows the model that the cursor is in, and a click on it leads to the text.
import { randomBytes } from "node:crypto";
import * as vscode from "vscode";

const AFTER_A_MOVE = 80; // milliseconds
const AFTER_A_CHANGE = 300;

export class Diagrams {
  /** @param {vscode.Uri} extension @param {() => import("vscode-languageclient/node").LanguageClient | undefined} client */
  constructor(extension, client) {
    this.extension = extension;
    this.client = client;
    this.panel = undefined;
    this.shown = undefined; // the last answer of the server
    this.asked = 0;
    this.column = vscode.ViewColumn.One;
    this.subscriptions = [
      vscode.window.onDidChangeTextEditorSelection((event) => {
        if (this.follows(event.textEditor)) this.soon(event.textEditor, AFTER_A_MOVE);
      }),
      vscode.window.onDidChangeActiveTextEditor((editor) => {
        if (editor && this.follows(editor)) this.soon(editor, AFTER_A_MOVE);
      }),
      vscode.workspace.onDidChangeTextDocument((event) => {
        const editor = vscode.window.activeTextEditor;
        if (editor && event.document === editor.document && this.follows(editor)) this.soon(editor, AFTER_A_CHANGE);
      }),
    ];
  }

  dispose() {
    clearTimeout(this.timer);
    this.panel?.dispose();
    for (const each of this.subscriptions) each.dispose();
  }

  /** Open the view, at the cursor or at a place. */
  async show(uri, position) {
    const editor = vscode.window.activeTextEditor;
    const document = uri ? await vscode.workspace.openTextDocument(uri) : editor?.document;
    if (!document || document.languageId !== "aseme") return;
    this.column = editor?.viewColumn ?? vscode.ViewColumn.One;
    if (!this.panel) this.open();
    else this.panel.reveal(undefined, true);
    const at = editor?.document === document ? editor.selection.active : new vscode.Position(0, 0);
    await this.draw(document, position ?? at);
  }

  open() {
    const media = vscode.Uri.joinPath(this.extension, "media");
    this.panel = vscode.window.createWebviewPanel(
      "aseme.diagram",
      "Diagram",
      { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true },
      { enableScripts: true, localResourceRoots: [media], retainContextWhenHidden: true },
    );
    this.panel.iconPath = vscode.Uri.joinPath(media, "file.svg");
    const webview = this.panel.webview;
    webview.onDidReceiveMessage((message) => this.clicked(message));
    this.panel.onDidDispose(() => {
      this.panel = undefined;
      this.shown = undefined;
    });
    const nonce = randomBytes(16).toString("hex");
    const style = webview.asWebviewUri(vscode.Uri.joinPath(media, "diagram.css"));
    const script = webview.asWebviewUri(vscode.Uri.joinPath(media, "diagram.js"));
    webview.html = `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:; style-src ${webview.cspSource} 'unsafe-inline'; script-src 'nonce-${nonce}'">
<link rel="stylesheet" href="${style}">
</head>
<body>
<header><h1 id="title"></h1><span id="note" role="status"></span>
<span id="zoom"><button id="out" title="Smaller">−</button><button id="fit" title="Fit into the view">Fit</button><button id="in" title="Larger">+</button></span></header>
<main id="picture" tabindex="0"><p class="hint">Put the cursor into a role, a protocol, goals or use cases.</p></main>
<script nonce="${nonce}" src="${script}"></script>
</body>
</html>`;
  }

  follows(editor) {
    return (
      this.panel !== undefined &&
      editor.document.languageId === "aseme" &&
      vscode.workspace.getConfiguration("aseme").get("diagram.follow", true)
    );
  }

  soon(editor, delay) {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.draw(editor.document, editor.selection.active), delay);
  }

  /** Ask the server for the picture of a place; what comes late, after another question, is dropped. */
  async draw(document, position) {
    const client = this.client();
    if (!client?.isRunning()) return this.say("The language server does not run.");
    const number = ++this.asked;
    let found;
    try {
      found = await client.sendRequest("aseme/diagram", {
        textDocument: client.code2ProtocolConverter.asTextDocumentIdentifier(document),
        position: client.code2ProtocolConverter.asPosition(position),
      });
    } catch (error) {
      return this.say(error.message);
    }
    if (number !== this.asked || !this.panel) return;
    if (found === null) {
      // Nothing is meant here; what was shown stays, without a mark.
      this.panel.webview.postMessage({ here: null, note: "" });
      return;
    }
    const same = this.shown?.svg === found.svg;
    this.shown = found;
    this.panel.title = found.name;
    this.panel.webview.postMessage({
      title: found.title,
      note: found.note,
      here: found.here,
      places: Object.keys(found.elements),
      ...(same ? {} : { svg: found.svg, name: found.name }),
    });
  }

  say(note) {
    this.panel?.webview.postMessage({ note });
  }

  /** Show the place in the text of what was clicked. */
  async clicked({ id }) {
    const client = this.client();
    const place = this.shown?.elements[id];
    if (!place || !client) return;
    const range = client.protocol2CodeConverter.asRange(place.range);
    const uri = client.protocol2CodeConverter.asUri(place.uri);
    const open = vscode.window.visibleTextEditors.find((each) => each.document.uri.toString() === uri.toString());
    const editor = await vscode.window.showTextDocument(uri, { viewColumn: open?.viewColumn ?? this.column });
    editor.selection = new vscode.Selection(range.start, range.start);
    editor.revealRange(range, vscode.TextEditorRevealType.InCenterIfOutsideViewport);
  }
}
