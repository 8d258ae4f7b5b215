// Whether tools of others read what is exported: files come as JSON on standard input, what is wrong goes out.
async function bpmn(text) {
  const { BpmnModdle } = await import("bpmn-moddle");
  const { warnings } = await new BpmnModdle().fromXML(text);
  return warnings.map((warning) => String(warning.message));
}

function typescript({ module, config }) {
  const ts = require("typescript");
  const path = require("path");
  const fs = require("fs");
  const folder = fs.mkdtempSync(path.join(__dirname, "checked-"));
  try {
    const file = path.join(folder, "chart.ts");
    fs.writeFileSync(file, module);
    fs.writeFileSync(path.join(folder, "chart.json"), config);
    const options = {
      module: ts.ModuleKind.NodeNext,
      target: ts.ScriptTarget.ES2022,
      moduleResolution: ts.ModuleResolutionKind.NodeNext,
      resolveJsonModule: true,
      esModuleInterop: true,
      strict: true,
      noEmit: true,
      skipLibCheck: true,
      types: [],
    };
    const found = ts.getPreEmitDiagnostics(ts.createProgram([file], options));
    return found.map((item) => ts.flattenDiagnosticMessageText(item.messageText, "\n"));
  } finally {
    fs.rmSync(folder, { recursive: true });
  }
}

async function main() {
  const files = JSON.parse(require("fs").readFileSync(0, "utf8"));
  const found = [];
  for (const file of files) {
    found.push(file.bpmn ? await bpmn(file.bpmn) : typescript(file));
  }
  process.stdout.write(JSON.stringify(found));
}

main();
