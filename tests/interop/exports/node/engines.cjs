// Plays charts on SCION and XState: jobs come as JSON on standard input, what is active goes out.
const ts = require("typescript");
const scxml = require("@scion-scxml/scxml");
const Module = require("module");

function scion(job) {
  return new Promise((resolve, reject) => {
    let called = false; // after an error it is called once more
    scxml.documentStringToModel("chart.scxml", job.document, (error, model) => {
      if (error) reject(error);
      if (error || called) return (called = true);
      called = true;
      model.prepare((problem, made) => {
        if (problem) return reject(problem);
        const chart = new scxml.core.Statechart(made);
        chart.on("onError", (fault) => reject(new Error(JSON.stringify(fault))));
        chart.start();
        const found = [chart.getFullConfiguration()];
        for (const step of job.steps) {
          chart.gen({ name: step.event, data: step.data });
          found.push(chart.getFullConfiguration());
        }
        resolve(found.map((ids) => ids.filter((id) => !id.startsWith("$"))));
      });
    });
  });
}

function moduleOf(text, config) {
  const options = { module: ts.ModuleKind.CommonJS, target: ts.ScriptTarget.ES2022, esModuleInterop: true };
  const compiled = ts.transpileModule(text, { compilerOptions: options }).outputText;
  const made = new Module("chart.cjs", module);
  const paths = module.paths;
  const real = made.require.bind(made);
  made.paths = paths;
  made.require = (name) => (name.endsWith(".json") ? config : real(name));
  made._compile(compiled, "chart.cjs");
  return made.exports;
}

async function xstate(job) {
  const { createActor } = require("xstate");
  const { machine } = moduleOf(job.module, JSON.parse(job.config));
  const clock = { setTimeout: () => 0, clearTimeout: () => {} };
  const actor = createActor(machine, { clock });
  actor.subscribe({ error: () => {} });
  actor.start();
  const active = () => actor.getSnapshot();
  const found = [active()];
  for (const step of job.steps) {
    actor.send({ type: step.event, ...step.data });
    found.push(active());
  }
  return found.map((s) => {
    if (s.status === "error") throw s.error;
    return s.status === "done" ? ["asemec_finished"] : s._nodes.map((node) => node.id).filter((id) => id !== "asemec_machine");
  });
}

async function main() {
  const jobs = JSON.parse(require("fs").readFileSync(0, "utf8"));
  const done = [];
  for (const job of jobs) {
    try {
      const late = new Promise((_, reject) => setTimeout(reject, 60000, new Error("no answer")).unref());
      done.push({ active: await Promise.race([job.engine === "scion" ? scion(job) : xstate(job), late]) });
    } catch (error) {
      done.push({ error: String((error && error.stack) || error).slice(0, 2000) });
    }
  }
  process.stdout.write(JSON.stringify(done), () => process.exit(0));
}

main();
