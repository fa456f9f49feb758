// A job type of Flamenco 3 that denoises a sequence: each task has one part of its frames. Put this file into the Manager's folder
// `scripts`, and name the program in its variables (flamenco-manager.yaml), for each platform:
//
//     variables:
//       quell-denoise:
//         values:
//           - {platform: linux, value: /opt/quell/bin/quell-denoise}
//
// A part that was killed goes on behind the frames that it has written: requeue its task.
const JOB_TYPE = {
    label: "quell-denoise",
    description: "Denoise rendered frames",
    settings: [
        { key: "input", type: "string", required: true, description: "Noisy frames, as in //render/frame.%04d.exr" },
        { key: "output", type: "string", required: true, description: "Denoised frames, as in //clean/frame.%04d.exr" },
        { key: "frames", type: "string", required: true, eval: "f'{C.scene.frame_start}-{C.scene.frame_end}'",
          description: "Frames: numbers and ranges, as in 1-48,60" },
        { key: "parts", type: "int32", default: 6, description: "Parts that the frames are split into" },
        { key: "preset", type: "string", default: "", description: "Preset; empty: what suits the files" },
        { key: "layers", type: "string", default: "", description: "Layers to write, with commas between them; empty: all" },
        { key: "keep_alpha", type: "bool", default: false, description: "Leave the film's alpha as it is, noise and all" },
        { key: "map", type: "string", default: "", description: "Channel map of another renderer; empty: none" },
    ],
};

function compileJob(job) {
    const settings = job.settings;
    if (settings.parts < 1) throw "parts: give 1 or more";
    const args = ["--in", settings.input, "--out", settings.output, "--frames", settings.frames.replace(/\s/g, "")];
    for (const name of ["preset", "layers", "map"])
        if (settings[name]) args.push("--" + name, settings[name]);
    if (settings.keep_alpha) args.push("--keep-alpha");
    for (let part = 1; part <= settings.parts; part++) {
        const task = author.Task("denoise-" + part + "-of-" + settings.parts, "misc");
        task.addCommand(author.Command("exec", {
            exe: "{quell-denoise}",
            args: args.concat(["--chunk", part + "/" + settings.parts, "--skip-existing", "--json"]),
        }));
        job.addTask(task);
    }
}
