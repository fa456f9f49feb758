// Compiles a job by examples/farms/flamenco_quell_denoise.js as Flamenco's Manager does, and runs its tasks as a Worker does:
// flamenco.mjs QUELL_DENOISE QUELL_TRACE SOURCE_FOLDER. Flamenco itself is not needed.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import vm from "node:vm";

const [denoise, trace, source] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), "quell-"));
try {
    // What the Manager gives to a script.
    const author = {
        Task: (name, type) => ({ name, type, commands: [], addCommand(command) { this.commands.push(command); } }),
        Command: (name, parameters) => ({ name, parameters }),
    };
    const script = readFileSync(join(source, "examples/farms/flamenco_quell_denoise.js"), "utf8");
    const compiled = (changes) => {
        const context = vm.createContext({ author, print: () => {} });
        vm.runInContext(script + "\nthis.type = JOB_TYPE; this.compile = compileJob;", context);
        const settings = { input: join(folder, "in/frame.%04d.exr"), output: join(folder, "out/frame.%04d.exr"), frames: "0-4, 6", ...changes };
        for (const setting of context.type.settings) settings[setting.key] ??= setting.default;
        for (const setting of context.type.settings) assert.notEqual(settings[setting.key], undefined, setting.key);
        const tasks = [];
        context.compile({ settings, addTask: (task) => tasks.push(task) });
        return tasks;
    };
    execFileSync(trace, ["--scene", "room", "--frames", "7", "--size", "48x27", "--quiet", "--out", join(folder, "in")]);
    const tasks = compiled({ parts: 3, preset: "svgf" });
    assert.equal(tasks.length, 3);
    assert.equal(new Set(tasks.map((task) => task.name)).size, 3);
    const written = tasks.map((task) => {
        assert.equal(task.type, "misc");
        const [{ name, parameters }] = task.commands;
        assert.equal(name, "exec");
        assert.equal(parameters.exe, "{quell-denoise}"); // a variable of the Manager
        return JSON.parse(execFileSync(denoise, parameters.args, { stdio: ["ignore", "pipe", "ignore"] }));
    });
    assert.deepEqual(written.map((each) => each.written), [[0, 1], [2, 3], [4, 6]]);
    assert.deepEqual(written.map((each) => each.preset), ["svgf", "svgf", "svgf"]);
    assert.equal(readdirSync(join(folder, "out")).length, 6);
    assert.equal(compiled({}).length, 6);
    for (const keep_alpha of [false, true])
        assert.equal(compiled({ keep_alpha })[0].commands[0].parameters.args.includes("--keep-alpha"), keep_alpha);
    assert.throws(() => compiled({ parts: 0 }));
} finally {
    rmSync(folder, { recursive: true });
}
