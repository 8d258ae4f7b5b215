// Tasks: check, build and fmt of the project, and the run of a team in a terminal.
import * as vscode from "vscode";
import { compiler, folderOf } from "./compiler.js";

const COMMANDS = ["check", "build", "fmt"];

export class AsemecTasks {
  provideTasks() {
    return (vscode.workspace.workspaceFolders ?? []).flatMap((folder) =>
      COMMANDS.map((command) => task({ type: "asemec", command }, folder)),
    );
  }

  resolveTask(given) {
    return task(given.definition, given.scope);
  }
}

function task(definition, scope) {
  const [program, ...before] = compiler();
  const process = new vscode.ProcessExecution(program, [
    ...before,
    definition.command,
    ...(definition.arguments ?? []),
  ]);
  const matchers = definition.command === "fmt" ? [] : ["$asemec"];
  const made = new vscode.Task(definition, scope, definition.command, "asemec", process, matchers);
  if (definition.command === "build") made.group = vscode.TaskGroup.Build;
  made.presentationOptions = { reveal: vscode.TaskRevealKind.Silent, clear: true };
  return made;
}

/** Play the team of a file, in a terminal. */
export function run(uri) {
  if (!uri) return;
  const [program, ...before] = compiler();
  const terminal = vscode.window.createTerminal({
    name: "asemec run",
    cwd: folderOf(uri),
    shellPath: program,
    shellArgs: [...before, "run", uri.fsPath],
  });
  terminal.show(true);
}
