"""Uses examples/blender/quell_denoise.py in Blender without a window:
blender --background --factory-startup --python-exit-code 1 --python add_on.py -- QUELL_DENOISE SOURCE_FOLDER"""

import os
import sys
import tempfile

import bpy

denoise, source = sys.argv[sys.argv.index("--") + 1 :]


def refusal(operator, **settings):
    """What Blender shows of an operator's error."""
    try:
        operator(**settings)
    except RuntimeError as error:
        return str(error)
    raise AssertionError("it was not refused")


def difference(a, b):
    """Mean squared error of two images of one size, as far as a screen shows them."""
    pairs = list(zip(a.pixels, b.pixels))
    return sum((min(x, 1) - min(y, 1)) ** 2 for x, y in pairs) / len(pairs)


with tempfile.TemporaryDirectory() as folder:
    # Blender's own way of installing a file.
    os.environ["BLENDER_USER_SCRIPTS"] = folder
    bpy.ops.preferences.addon_install(filepath=os.path.join(source, "examples/blender/quell_denoise.py"), overwrite=True)
    bpy.ops.preferences.addon_enable(module="quell_denoise")
    preferences = bpy.context.preferences.addons["quell_denoise"].preferences

    scene = bpy.context.scene
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = 64, 36, 100
    scene.frame_start, scene.frame_end = 3, 6
    # A floor under a large lamp: soft shadows, which are noisy.
    bpy.ops.mesh.primitive_plane_add(size=30, location=(0, 0, -1))
    bpy.data.objects["Light"].data.type = "AREA"
    bpy.data.objects["Light"].data.size = 8
    settings = scene.quell
    assert "save that first" in refusal(bpy.ops.quell.denoise)
    settings.noisy, settings.clean = os.path.join(folder, "noisy"), os.path.join(folder, "clean")

    scene.render.engine = "BLENDER_WORKBENCH"
    assert "Cycles" in refusal(bpy.ops.quell.passes)
    scene.render.engine = "CYCLES"
    scene.cycles.samples, scene.cycles.use_denoising = 1, False
    scene.render.use_motion_blur = True
    assert "motion blur" in refusal(bpy.ops.quell.passes)
    scene.render.use_motion_blur = False
    assert bpy.ops.quell.passes() == {"FINISHED"}
    layer = scene.view_layers[0]
    assert layer.use_pass_vector and layer.use_pass_glossy_color and layer.cycles.use_pass_volume_direct
    assert scene.cycles.use_animated_seed

    preferences.program = "no-such-program"
    assert "no-such-program" in refusal(bpy.ops.quell.denoise)
    preferences.program = denoise
    assert "render first" in refusal(bpy.ops.quell.denoise)
    assert {"general", "svgf"} <= set(sys.modules["quell_denoise"].presets_that_fit(None, bpy.context, "g"))
    before = (scene.render.filepath, scene.render.image_settings.file_format)

    assert bpy.ops.quell.denoise(with_render=True) == {"FINISHED"}
    assert (scene.render.filepath, scene.render.image_settings.file_format) == before
    names = [f"{name}.{number:04}.exr" for name in ("clean", "noisy", "picture") for number in (3, 4, 5, 6)]
    assert sorted(os.listdir(settings.clean) + os.listdir(settings.noisy)) == names

    # The compositor shows the clean Combined, and has the denoised signals as passes.
    [node] = [node for node in scene.node_tree.nodes if node.label == "quell"]
    assert node.image.source == "SEQUENCE" and node.image.type == "MULTILAYER"
    [composite] = [node for node in scene.node_tree.nodes if node.type == "COMPOSITE"]
    assert composite.inputs[0].links[0].from_node == node
    assert composite.inputs[0].links[0].from_socket.name == "Combined"
    assert "denoised_diffuse" in [output.name for output in node.outputs], [output.name for output in node.outputs]
    assert {"Depth", "Vector", "DiffCol"} <= {output.name for output in node.outputs}

    # The sequencer has all frames.
    [strip] = scene.sequence_editor.sequences
    assert (strip.frame_start, strip.frame_final_duration) == (3, 4)
    assert [element.filename for element in strip.elements] == [f"picture.{number:04}.exr" for number in (3, 4, 5, 6)]
    assert strip.elements[0].orig_width == 64  # Blender could read it

    # What the compositor makes of frame 6 is closer to the truth than what was rendered.
    def rendered(name, with_nodes, samples):
        scene.render.use_sequencer, scene.use_nodes, scene.cycles.samples = False, with_nodes, samples
        scene.frame_set(6)
        scene.render.image_settings.file_format = "OPEN_EXR"
        scene.render.filepath = os.path.join(folder, name + ".exr")
        bpy.ops.render.render(write_still=True)
        return bpy.data.images.load(scene.render.filepath)

    truth, noisy, clean = rendered("truth", False, 256), rendered("noisy", False, 1), rendered("clean", True, 1)
    assert difference(clean, truth) < 0.5 * difference(noisy, truth), (difference(clean, truth), difference(noisy, truth))
    scene.use_nodes, scene.render.use_sequencer = True, True

    # A frame that is lacking is named.
    os.rename(os.path.join(settings.noisy, "noisy.0005.exr"), os.path.join(folder, "away.exr"))
    assert "noisy.0005.exr" in refusal(bpy.ops.quell.denoise)
    os.rename(os.path.join(folder, "away.exr"), os.path.join(settings.noisy, "noisy.0005.exr"))

    # A second time takes the place of the first.
    assert bpy.ops.quell.denoise() == {"FINISHED"}
    assert len([node for node in scene.node_tree.nodes if node.label == "quell"]) == 1
    assert len(scene.sequence_editor.sequences) == 1
    settings.keep_alpha = True
    assert "--keep-alpha" in sys.modules["quell_denoise"].arguments_of(scene)
    settings.preset = "best"
    assert "there is no preset 'best'" in refusal(bpy.ops.quell.denoise)
    bpy.ops.preferences.addon_disable(module="quell_denoise")
    assert not hasattr(bpy.types.Scene, "quell")
print("the add-on denoises what Cycles renders")
