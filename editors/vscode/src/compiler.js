// Which asemec is meant.
import { existsSync } from "node:fs";
import { join } from "node:path";
import * as vscode from "vscode";

const IN_ENVIRONMENT = process.platform === "win32" ? ["Scripts", "asemec.exe"] : ["bin", "asemec"];

/** The program and its first arguments: the setting, else the environment of a folder, else the path's. */
export function compiler() {
  const configured = vscode.workspace.getConfiguration("aseme").get("command", []);
  if (configured.length > 0) return configured;
  for (const folder of vscode.workspace.workspaceFolders ?? []) {
    const local = join(folder.uri.fsPath, ".venv", ...IN_ENVIRONMENT);
    if (folder.uri.scheme === "file" && existsSync(local)) return [local];
  }
  return ["asemec"];
}

/** The folder in which it is started: that of the file, or the first of the workspace. */
export function folderOf(uri) {
  const folder = (uri && vscode.workspace.getWorkspaceFolder(uri)) ?? vscode.workspace.workspaceFolders?.[0];
  return folder?.uri.fsPath;
}
