// What a diagnostic means: the page of `asemec explain`, beside the text.
import { execFile } from "node:child_process";
import { promisify } from "node:util";
import * as vscode from "vscode";
import { compiler, folderOf } from "./compiler.js";

export const SCHEME = "asemec-explain";

export class Explanations {
  async provideTextDocumentContent(uri) {
    const [program, ...before] = compiler();
    try {
      const done = await promisify(execFile)(program, [...before, "explain", code(uri)], {
        cwd: folderOf(),
        env: { ...process.env, NO_COLOR: "1" },
      });
      return done.stdout;
    } catch (error) {
      return error.stderr || String(error);
    }
  }
}

function code(uri) {
  return uri.path.replace(/^\/|\.txt$/g, "");
}

/** Show the page of a code: the given one, the one under the cursor, or one that is asked for. */
export async function explain(given) {
  const wanted = typeof given === "string" ? given : await choose();
  if (!wanted || !/^\w+$/.test(wanted)) return;
  const uri = vscode.Uri.from({ scheme: SCHEME, path: `/${wanted}.txt` });
  const document = await vscode.workspace.openTextDocument(uri);
  await vscode.window.showTextDocument(document, { viewColumn: vscode.ViewColumn.Beside, preview: true });
}

async function choose() {
  const editor = vscode.window.activeTextEditor;
  const here = editor
    ? vscode.languages
        .getDiagnostics(editor.document.uri)
        .filter((each) => each.source === "asemec" && each.range.intersection(editor.selection))
    : [];
  const codes = [...new Set(here.map((each) => String(each.code?.value ?? each.code)))];
  if (codes.length === 1) return codes[0];
  if (codes.length > 1) return vscode.window.showQuickPick(codes, { placeHolder: "Which diagnostic?" });
  return vscode.window.showInputBox({ prompt: "The code of a diagnostic", placeHolder: "E101" });
}
