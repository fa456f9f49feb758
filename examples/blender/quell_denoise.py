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


class QuellSettings(bpy.types.PropertyGroup):
    noisy: bpy.props.StringProperty(
        name="Noisy", description="Folder of the rendered frames", subtype="DIR_PATH", default="//noisy/"
    )
    clean: bpy.props.StringProperty(
        name="Clean", description="Folder of the denoised frames", subtype="DIR_PATH", default="//clean/"
    )
    preset: bpy.props.StringProperty(name="Preset", description="Empty: what suits the passes", default="")
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


def render(scene):
    """Renders the animation as multilayer files into the folder of noisy frames, and leaves the output settings as they were."""
    image, output = scene.render.image_settings, scene.render
    keep = (output.filepath, image.file_format, image.color_depth, output.use_compositing, output.use_sequencer)
    output.filepath = os.path.join(bpy.path.abspath(scene.quell.noisy), "noisy.####.exr")
    image.file_format = "OPEN_EXR_MULTILAYER"
    # Nodes and strips may show the last clean frames.
    output.use_compositing = output.use_sequencer = False
    try:
        bpy.ops.render.render(animation=True, scene=scene.name)
    finally:
        output.filepath, image.file_format, image.color_depth, output.use_compositing, output.use_sequencer = keep


def frame_list(scene):
    return ["--frames", ",".join(str(number) for number in frames_of(scene)), "--json", "--quiet"]


def arguments_of(scene):
    words = ["--in", pattern(scene.quell.noisy, "noisy"), "--out", pattern(scene.quell.clean, "clean"), *frame_list(scene)]
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
        node = tree.nodes.new("CompositorNodeImage")
        node.label = "quell"
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
    """Denoise the animation. Escape stops it; frames that are done are kept"""

    bl_idname = "quell.denoise"
    bl_label = "Denoise"

    with_render: bpy.props.BoolProperty(name="Render", description="Render the animation first", default=False)

    def start(self, context):
        """Begins what takes long. Raises Problem."""
        scene = context.scene
        check_folders(scene)
        program = program_of(context)
        if self.with_render:
            switch_on_passes(scene)
            render(scene)
        self.scene, self.files = scene, clean_files(scene)
        self.begun = [os.path.getmtime(file) if os.path.exists(file) else 0 for file in self.files]
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
        return sum(os.path.exists(file) and os.path.getmtime(file) != time for file, time in zip(self.files, self.begun))

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

    def execute(self, context):
        more = self.attempt(self.start, context)
        while more:
            self.process.wait()
            more = self.attempt(self.step)
        return {"CANCELLED"} if more is None else {"FINISHED"}

    def invoke(self, context, event):
        if not self.attempt(self.start, context):
            return {"CANCELLED"}
        manager = context.window_manager
        self.timer = manager.event_timer_add(0.2, window=context.window)
        manager.progress_begin(0, len(self.files))
        manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if event.type == "ESC":
            self.process.terminate()
            self.process.wait()
            self.finish(context)
            self.report({"WARNING"}, f"Stopped: {self.done()} of {len(self.files)} frames are denoised")
            return {"CANCELLED"}
        if event.type != "TIMER":
            return {"PASS_THROUGH"}
        context.window_manager.progress_update(self.done())
        context.workspace.status_text_set(f"quell: {self.done()} of {len(self.files)} frames, Esc stops")
        if self.process.poll() is None:
            return {"RUNNING_MODAL"}
        more = self.attempt(self.step)
        if more:
            return {"RUNNING_MODAL"}
        self.finish(context)
        return {"CANCELLED"} if more is None else {"FINISHED"}

    def finish(self, context):
        context.window_manager.event_timer_remove(self.timer)
        context.window_manager.progress_end()
        context.workspace.status_text_set(None)


class QUELL_PT_panel(bpy.types.Panel):
    bl_label = "quell"
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "output"

    def draw(self, context):
        layout, settings = self.layout, context.scene.quell
        layout.use_property_split = True
        for name in ("noisy", "clean", "preset", "to_compositor", "to_sequencer"):
            layout.prop(settings, name)
        layout.operator("quell.passes")
        layout.operator("quell.denoise", text="Render and denoise").with_render = True
        layout.operator("quell.denoise", text="Denoise what was rendered").with_render = False


CLASSES = (QuellSettings, QuellPreferences, QUELL_OT_passes, QUELL_OT_denoise, QUELL_PT_panel)


def register():
    for each in CLASSES:
        bpy.utils.register_class(each)
    bpy.types.Scene.quell = bpy.props.PointerProperty(type=QuellSettings)


def unregister():
    del bpy.types.Scene.quell
    for each in reversed(CLASSES):
        bpy.utils.unregister_class(each)
