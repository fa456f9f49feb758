"""Blender add-on: denoises rendered animations with quell-denoise. Blender 3.4 and newer, Cycles.

Install this file by Edit > Preferences > Add-ons, and name the program there. The panel is in Output properties: it switches on the passes
that quell-denoise reads, renders the animation or takes what was rendered, and puts the clean frames into compositor and sequencer.
"""

bl_info = {
    "name": "quell denoise",
    "author": "quell",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "Properties > Output > quell",
    "description": "Denoises rendered animations by reusing frames, with quell-denoise",
    "category": "Render",
}

import json
import os
import shutil
import subprocess
import tempfile

import bpy

PASSES = (
    "z", "vector", "normal", "emit", "environment",
    "diffuse_direct", "diffuse_indirect", "diffuse_color",
    "glossy_direct", "glossy_indirect", "glossy_color",
    "transmission_direct", "transmission_indirect", "transmission_color",
)  # fmt: skip
VOLUME_PASSES = ("volume_direct", "volume_indirect")  # of Cycles alone


class Problem(Exception):
    """What the user has to know, in a sentence."""


def presets_that_fit(settings, context, typed):
    """Names of presets that have what was typed in them; none where the program is not there yet."""
    try:
        listed = subprocess.run([program_of(context), "--list"], capture_output=True, text=True, timeout=5, check=True).stdout
    except (Problem, OSError, subprocess.SubprocessError):
        return []
    return [name for name in listed.split() if typed.lower() in name]


class QuellSettings(bpy.types.PropertyGroup):
    noisy: bpy.props.StringProperty(
        name="Noisy Frames", description="Folder of the rendered frames", subtype="DIR_PATH", default="//noisy/"
    )
    clean: bpy.props.StringProperty(
        name="Clean Frames", description="Folder of the denoised frames", subtype="DIR_PATH", default="//clean/"
    )
    preset: bpy.props.StringProperty(
        name="Preset", description="Method of quell-denoise. Empty: the one that suits the passes", search=presets_that_fit
    )
    keep_alpha: bpy.props.BoolProperty(name="Keep Alpha", description="Leave the film's alpha as it is, noise and all")
    to_compositor: bpy.props.BoolProperty(name="Compositor", description="Add the clean frames as an image node", default=True)
    to_sequencer: bpy.props.BoolProperty(name="Sequencer", description="Add the clean frames as a strip", default=True)


class QuellPreferences(bpy.types.AddonPreferences):
    bl_idname = __name__

    program: bpy.props.StringProperty(name="quell-denoise", subtype="FILE_PATH", default="quell-denoise")

    def draw(self, context):
        self.layout.prop(self, "program")


def program_of(context):
    name = context.preferences.addons[__name__].preferences.program
    found = shutil.which(bpy.path.abspath(name))
    if not found:
        raise Problem(f"There is no program '{name}': name quell-denoise in the add-on's preferences")
    return found


def pattern(folder, name):
    return os.path.join(bpy.path.abspath(folder), name + ".%04d.exr")


def frames_of(scene):
    return range(scene.frame_start, scene.frame_end + 1, scene.frame_step)


def clean_files(scene, name="clean"):
    return [pattern(scene.quell.clean, name) % number for number in frames_of(scene)]


def noisy_files(scene):
    return [pattern(scene.quell.noisy, "noisy") % number for number in frames_of(scene)]


def check_noisy_files(scene):
    files = noisy_files(scene)
    missing = [file for file in files if not os.path.exists(file)]
    if missing:
        raise Problem(f"{len(missing)} of {len(files)} frames are missing, the first is {missing[0]}: render first, or name their folder")


def check_folders(scene):
    for folder in (scene.quell.noisy, scene.quell.clean):
        if folder.startswith("//") and not bpy.data.filepath:
            raise Problem(f"'{folder}' lies beside the .blend file: save that first, or name another folder")


def switch_on_passes(scene):
    """The passes that quell-denoise reads, of all view layers; and other noise in each frame, without which frames teach nothing."""
    if scene.render.engine != "CYCLES":
        raise Problem("The passes are those of Cycles: choose it as the render engine")
    if scene.render.use_motion_blur:
        raise Problem("With motion blur Cycles renders no Vector pass: switch motion blur off")
    scene.cycles.use_animated_seed = True
    for layer in scene.view_layers:
        for name in PASSES:
            setattr(layer, "use_pass_" + name, True)
        for name in VOLUME_PASSES:
            setattr(layer.cycles, "use_pass_" + name, True)


def times_of(files):
    return [os.path.getmtime(file) if os.path.exists(file) else 0 for file in files]


class Rendering:
    """Renders the animation as multilayer files into the folder of noisy frames."""

    def __init__(self, scene, context="EXEC_DEFAULT"):
        self.scene, image, output = scene, scene.render.image_settings, scene.render
        # What is there and stays, where Overwrite is off, counts as rendered.
        self.before = [time if output.use_overwrite or not time else -1 for time in times_of(noisy_files(scene))]
        self.kept = (output.filepath, image.file_format, image.color_depth, output.use_compositing, output.use_sequencer)
        output.filepath = os.path.join(bpy.path.abspath(scene.quell.noisy), "noisy.####.exr")
        image.file_format = "OPEN_EXR_MULTILAYER"
        # Nodes and strips may show the last clean frames.
        output.use_compositing = output.use_sequencer = False
        try:
            bpy.ops.render.render(context, animation=True, scene=scene.name)
        except RuntimeError:
            self.restore()
            raise

    def restore(self):
        """Leaves the output settings as they were."""
        image, output = self.scene.render.image_settings, self.scene.render
        output.filepath, image.file_format, image.color_depth, output.use_compositing, output.use_sequencer = self.kept

    def done(self):
        """How many frames are."""
        return sum(now != before for now, before in zip(times_of(noisy_files(self.scene)), self.before))

    def end(self):
        """Raises Problem where it was stopped."""
        self.restore()
        if self.done() < len(self.before):
            raise Problem(f"Rendering stopped: {self.done()} of {len(self.before)} frames are rendered, none was denoised")


def frame_list(scene):
    return ["--frames", ",".join(str(number) for number in frames_of(scene)), "--json", "--quiet"]


def arguments_of(scene):
    words = ["--in", pattern(scene.quell.noisy, "noisy"), "--out", pattern(scene.quell.clean, "clean"), *frame_list(scene)]
    words += ["--keep-alpha"] if scene.quell.keep_alpha else []
    return words + (["--preset", scene.quell.preset] if scene.quell.preset else [])


def plain_arguments(scene, map_file):
    """Writes Combined of the clean frames as files with one layer: Blender's sequencer reads no others."""
    layer = min(layer.name for layer in scene.view_layers if layer.use)  # whose name comes first is denoised
    guides = {"albedo": 1, "normal": [0, 0, 1], "depth": 1, "motion": [0, 0]}
    with open(map_file, "w", encoding="utf-8") as file:
        json.dump({"channels": guides, "signals": [{"radiance": layer + ".Combined"}], "picture": ""}, file)
    words = ["--in", pattern(scene.quell.clean, "clean"), "--out", pattern(scene.quell.clean, "picture"), *frame_list(scene)]
    return words + ["--preset", "none", "--layers", "picture", "--map", map_file]


def image_node(tree, image):
    """The node with the clean frames: that of the last time, where there is one."""
    for node in tree.nodes:
        if node.type == "IMAGE" and node.label == "quell":
            break
    else:
        places = [other.location for other in tree.nodes]
        node = tree.nodes.new("CompositorNodeImage")
        node.label = "quell"
        if places:  # beside what is there
            node.location = (min(place.x for place in places) - 300, max(place.y for place in places))
    node.image = image
    return node


def put_into_compositor(scene):
    files = clean_files(scene)
    image = bpy.data.images.load(files[0], check_existing=True)
    image.reload()
    image.source = "SEQUENCE"
    if hasattr(scene, "compositing_node_group"):  # Blender 5
        if scene.compositing_node_group is None:
            scene.compositing_node_group = bpy.data.node_groups.new("Compositor", "CompositorNodeTree")
        tree = scene.compositing_node_group
    else:
        scene.use_nodes = True
        tree = scene.node_tree
    node = image_node(tree, image)
    node.frame_start = scene.frame_start
    node.frame_offset = scene.frame_start - 1
    node.frame_duration = scene.frame_end
    picture = next((output for output in node.outputs if output.name in ("Combined", "Image")), None)
    if picture is None:
        raise Problem(f"{files[0]} has no Combined pass")
    for other in tree.nodes:
        if other.type in ("COMPOSITE", "GROUP_OUTPUT") and other.inputs:
            tree.links.new(picture, other.inputs[0])
    return node


def put_into_sequencer(scene):
    editor = scene.sequence_editor_create() or scene.sequence_editor
    strips = editor.strips if hasattr(editor, "strips") else editor.sequences  # Blender 4.4 renamed them
    for strip in [strip for strip in strips if strip.name == "quell"]:
        strips.remove(strip)
    files = clean_files(scene, "picture")
    channel = 1 + max([strip.channel for strip in strips], default=0)
    strip = strips.new_image(name="quell", filepath=files[0], channel=channel, frame_start=scene.frame_start)
    for file in files[1:]:
        strip.elements.append(os.path.basename(file))
    return strip


def use_results(scene):
    if scene.quell.to_compositor:
        put_into_compositor(scene)
    if scene.quell.to_sequencer:
        put_into_sequencer(scene)


class QUELL_OT_passes(bpy.types.Operator):
    """Switch on the passes that quell-denoise reads, and other noise in each frame"""

    bl_idname = "quell.passes"
    bl_label = "Switch on passes"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        try:
            switch_on_passes(context.scene)
        except Problem as problem:
            self.report({"ERROR"}, str(problem))
            return {"CANCELLED"}
        return {"FINISHED"}


class QUELL_OT_denoise(bpy.types.Operator):
    """Denoise the animation. Esc stops it; frames that are done are kept"""

    bl_idname = "quell.denoise"
    bl_label = "Denoise"

    with_render: bpy.props.BoolProperty(name="Render", description="Render the animation first", default=False)

    doing = ""  # what is at work in a window, for the panel

    @classmethod
    def poll(cls, context):
        if cls.doing:
            cls.poll_message_set("quell is at work: Esc stops it")
        return not cls.doing

    def prepare(self, context):
        """Raises Problem."""
        self.scene, self.rendering = context.scene, None
        check_folders(self.scene)
        self.program = program_of(context)
        if self.with_render:
            switch_on_passes(self.scene)
        return True

    def start(self):
        """Begins to denoise. Raises Problem."""
        scene, program = self.scene, self.program
        check_noisy_files(scene)
        self.files = clean_files(scene)
        self.begun = times_of(self.files)
        self.folder = tempfile.TemporaryDirectory()
        self.runs = [[program, *arguments_of(scene)]]
        if scene.quell.to_sequencer:
            self.runs.append([program, *plain_arguments(scene, os.path.join(self.folder.name, "map.json"))])
        self.summaries = []
        self.begin_run()
        return True

    def begin_run(self):
        # Files and not pipes, which would fill up while nobody reads.
        self.out, self.err = tempfile.TemporaryFile(), tempfile.TemporaryFile()
        self.process = subprocess.Popen(self.runs.pop(0), stdout=self.out, stderr=self.err)

    def goes_on(self):
        """Looks at a run that ended, and begins the next. Raises Problem."""
        if self.process.returncode != 0:
            raise Problem(self.text_of(self.err) or f"quell-denoise ended with {self.process.returncode}")
        self.summaries.append(json.loads(self.text_of(self.out)))
        if not self.runs:
            return False
        self.begin_run()
        return True

    def done(self):
        """How many frames are."""
        return sum(now != begun for now, begun in zip(times_of(self.files), self.begun))

    def text_of(self, file):
        file.seek(0)
        return file.read().decode(errors="replace").strip()

    def end(self):
        """Uses the frames. Raises Problem."""
        use_results(self.scene)
        summary = self.summaries[0]
        for remark in summary["remarks"]:
            self.report({"WARNING"}, remark)
        self.report({"INFO"}, f"{len(summary['written'])} frames denoised with {summary['preset']}")

    def step(self):
        """What follows a run: whether there is more to wait for. Raises Problem."""
        if self.goes_on():
            return True
        self.end()
        return False

    def attempt(self, step, *arguments):
        """What a step returns; None where it failed, which is shown as Blender does."""
        try:
            return step(*arguments)
        except (Problem, OSError, RuntimeError) as problem:
            self.report({"ERROR"}, str(problem))
            return None

    def render(self):
        Rendering(self.scene).end()
        return True

    def execute(self, context):
        more = self.attempt(self.prepare, context) and (not self.with_render or self.attempt(self.render)) and self.attempt(self.start)
        while more:
            self.process.wait()
            more = self.attempt(self.step)
        return {"CANCELLED"} if more is None else {"FINISHED"}

    def start_in_window(self, context):
        """Rendering shows itself, as if Blender's own menu had begun it. Raises Problem."""
        self.prepare(context)
        if self.with_render:
            self.rendering = Rendering(self.scene, "INVOKE_DEFAULT")
        else:
            self.start()
        return True

    def invoke(self, context, event):
        if not self.attempt(self.start_in_window, context):
            return {"CANCELLED"}
        manager = context.window_manager
        self.timer = manager.event_timer_add(0.2, window=context.window)
        manager.progress_begin(0, len(noisy_files(self.scene)))
        manager.modal_handler_add(self)
        self.show(context)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if event.type == "ESC" and not self.rendering:
            self.process.terminate()
            self.process.wait()
            self.finish(context)
            self.report({"WARNING"}, f"Stopped: {self.done()} of {len(self.files)} frames are denoised")
            return {"FINISHED"}  # of what is cancelled, Blender shows errors alone
        if event.type != "TIMER":
            return {"PASS_THROUGH"}
        self.show(context)
        if bpy.app.is_job_running("RENDER") if self.rendering else self.process.poll() is None:
            return {"PASS_THROUGH"}
        more = self.attempt(self.after_rendering if self.rendering else self.step)
        if more:
            return {"RUNNING_MODAL"}
        self.finish(context)
        return {"CANCELLED"} if more is None else {"FINISHED"}

    def after_rendering(self):
        """Raises Problem."""
        rendering, self.rendering = self.rendering, None
        rendering.end()
        return self.start()

    def show(self, context):
        done = self.rendering.done() if self.rendering else self.done()
        doing = f"{done} of {len(noisy_files(self.scene))} frames {'rendered' if self.rendering else 'denoised'}, Esc stops"
        context.window_manager.progress_update(done)
        self.say(context, doing)

    def say(self, context, doing):
        """In the status bar and in the panel; nothing where `doing` is empty."""
        QUELL_OT_denoise.doing = doing
        context.workspace.status_text_set(f"quell: {doing}" if doing else None)
        for window in context.window_manager.windows:
            for area in window.screen.areas:
                if area.type == "PROPERTIES":
                    area.tag_redraw()

    def finish(self, context):
        context.window_manager.event_timer_remove(self.timer)
        context.window_manager.progress_end()
        self.say(context, "")


class QUELL_PT_panel(bpy.types.Panel):
    bl_label = "quell"
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "output"

    def draw(self, context):
        layout, settings = self.layout, context.scene.quell
        layout.use_property_split, layout.use_property_decorate = True, False
        for name in ("noisy", "clean", "preset", "keep_alpha"):
            layout.prop(settings, name)
        column = layout.column(heading="Add to")
        column.prop(settings, "to_compositor")
        column.prop(settings, "to_sequencer")
        layout.operator("quell.passes")
        layout.operator("quell.denoise", text="Render and denoise").with_render = True
        layout.operator("quell.denoise", text="Denoise what was rendered").with_render = False
        if QUELL_OT_denoise.doing:
            layout.label(text=QUELL_OT_denoise.doing, icon="TIME")


CLASSES = (QuellSettings, QuellPreferences, QUELL_OT_passes, QUELL_OT_denoise, QUELL_PT_panel)


def register():
    for each in CLASSES:
        bpy.utils.register_class(each)
    bpy.types.Scene.quell = bpy.props.PointerProperty(type=QuellSettings)


def unregister():
    del bpy.types.Scene.quell
    for each in reversed(CLASSES):
        bpy.utils.unregister_class(each)
