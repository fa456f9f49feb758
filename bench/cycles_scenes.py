# Renders one of three small scenes with Blender's Cycles (apt-get install --no-install-recommends blender; tested with 3.4.1), 48 frames long:
#   blender -b --factory-startup -noaudio -P cycles_scenes.py -- lamp|train|brass OUT_FOLDER SPP FIRST LAST WIDTH HEIGHT [box|default]
# box: samples at the pixels' centres; default: Cycles' own filter, by which samples lie anywhere within a pixel and a half. The seed differs
# from frame to frame. Multi-layer EXR: Combined, light and colour passes, Depth, Normal, Position, Vector (to the last and to the next
# frame), IndexOB. bench/cycles.sh calls this.
import bpy, sys, math, os
name, out, spp, first, last, width, height = (lambda a: (a[0], a[1], *map(int, a[2:7])))(sys.argv[sys.argv.index("--") + 1:])
pixel_filter = (sys.argv[sys.argv.index("--") + 8:] + ["box"])[0]
N = 48
bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene
scene.render.engine = 'CYCLES'
cycles = scene.cycles
cycles.device, cycles.samples, cycles.use_adaptive_sampling, cycles.use_denoising = 'CPU', spp, False, False
if pixel_filter == 'box': cycles.pixel_filter_type, cycles.filter_width = 'BOX', 0.01
cycles.max_bounces, cycles.sample_clamp_indirect = 4, 0
cycles.caustics_reflective = cycles.caustics_refractive = False
cycles.use_animated_seed = True
render = scene.render
render.resolution_x, render.resolution_y, render.resolution_percentage = width, height, 100
render.image_settings.file_format, render.image_settings.color_depth, render.image_settings.exr_codec = 'OPEN_EXR_MULTILAYER', '16', 'ZIP'
render.filepath = os.path.join(out, 'frame_####')
render.use_persistent_data = True
scene.frame_start, scene.frame_end = first, last
scene.view_settings.view_transform = 'Standard'
layer = scene.view_layers[0]
layer.name = 'ViewLayer'
for p in ('z', 'normal', 'vector', 'position', 'object_index', 'diffuse_direct', 'diffuse_indirect', 'diffuse_color', 'glossy_direct',
          'glossy_indirect', 'glossy_color', 'emit', 'environment'):
    setattr(layer, 'use_pass_' + p, True)
world = bpy.data.worlds.new('World')
scene.world, world.use_nodes = world, True

def sky(r, g, b): world.node_tree.nodes['Background'].inputs[0].default_value = (r, g, b, 1)
def material(n, color, rough=0.6, metal=0.0, emit=0.0, checker=0):
    m = bpy.data.materials.new(n)
    m.use_nodes = True
    b = m.node_tree.nodes['Principled BSDF']
    b.inputs['Base Color'].default_value, b.inputs['Roughness'].default_value, b.inputs['Metallic'].default_value = (*color, 1), rough, metal
    if emit: b.inputs['Emission'].default_value, b.inputs['Emission Strength'].default_value = (*color, 1), emit
    if checker:
        t = m.node_tree.nodes.new('ShaderNodeTexChecker')
        t.inputs['Scale'].default_value = checker
        t.inputs[1].default_value, t.inputs[2].default_value = (*color, 1), (*[0.4 * c for c in color], 1)
        m.node_tree.links.new(t.outputs['Color'], b.inputs['Base Color'])
    return m
count = [0]
def add(op, mat, at, scale=(1, 1, 1), turn=(0, 0, 0), **k):
    op(location=at, rotation=turn, **k)
    o = bpy.context.object
    o.scale = scale
    o.data.materials.append(mat)
    count[0] += 1
    o.pass_index = count[0]
    return o
def move(o, what, keys):
    for f, v in keys: setattr(o, what, v), o.keyframe_insert(what, frame=f)
    for c in o.animation_data.action.fcurves:
        for k in c.keyframe_points: k.interpolation = 'LINEAR'
def light(kind, at, energy, size, turn=(0, 0, 0), color=(1, 1, 1)):
    l = bpy.data.lights.new('Light', kind)
    l.energy, l.color = energy, color
    if kind == 'AREA': l.size = size
    else: l.shadow_soft_size = size
    o = bpy.data.objects.new('Light', l)
    scene.collection.objects.link(o)
    o.location, o.rotation_euler = at, turn
    return o
def camera(at, target, lens=35):
    c = bpy.data.cameras.new('Camera')
    c.lens = lens
    o, e = bpy.data.objects.new('Camera', c), bpy.data.objects.new('Target', None)
    scene.collection.objects.link(o), scene.collection.objects.link(e)
    o.location, e.location = at, target
    t = o.constraints.new('TRACK_TO')
    t.target, t.track_axis, t.up_axis = e, 'TRACK_NEGATIVE_Z', 'UP_Y'
    scene.camera = o
    return o, e
P, half = bpy.ops.mesh, math.pi / 2

if name == 'lamp':      # a lamp swings: every shadow moves, no surface does, and a second light goes on at frame 36
    sky(.02, .02, .03)
    add(P.primitive_plane_add, material('floor', (.7, .66, .6), .9, checker=12), (0, 0, 0), (6, 6, 1))
    add(P.primitive_plane_add, material('wall', (.6, .62, .7), .9), (0, 3, 0), (6, 6, 1), (half, 0, 0))
    for i in range(7): add(P.primitive_cylinder_add, material('post', (.5, .3, .2), .7), (-3 + i, .8 + .5 * (i % 2), .6), (.08, .08, .6))
    add(P.primitive_torus_add, material('ring', (.2, .6, .4), .5), (-.6, -.8, .6), turn=(.9, .3, 0))
    lamp = light('POINT', (0, 0, 3), 220, .25, color=(1, .85, .6))
    move(lamp, 'location', [(1, (-2, -.5, 3)), (16, (2, -.2, 2.8)), (32, (-2, -.5, 3)), (48, (2, -.2, 2.8))])
    other = light('AREA', (3, -2, 3), 0, .8, (math.radians(40), math.radians(35), 0), (.6, .75, 1))
    for f, e in ((1, 0), (35, 0), (36, 120)): other.data.energy = e; other.data.keyframe_insert('energy', frame=f)
    for c in other.data.animation_data.action.fcurves:
        for k in c.keyframe_points: k.interpolation = 'CONSTANT'
    camera((.4, -5, 2.6), (0, .4, .6))
elif name == 'train':   # cars pass a window: striped sunlight sweeps a textured room while the camera walks sideways
    sky(.25, .3, .4)
    add(P.primitive_plane_add, material('floor', (.65, .5, .35), .8, checker=20), (0, 0, 0), (4, 4, 1))
    add(P.primitive_plane_add, material('back', (.75, .7, .62), .9), (0, 4, 1.5), (4, 1.5, 1), (half, 0, 0))
    add(P.primitive_plane_add, material('top', (.8, .8, .8), .9), (0, 0, 3), (4, 4, 1))
    add(P.primitive_plane_add, material('right', (.7, .75, .7), .9), (4, 0, 1.5), (1.5, 4, 1), (0, half, 0))
    for y, h in ((-3.2, .8), (-.6, .35), (1.9, .4), (3.6, .4)): add(P.primitive_cube_add, material('left', (.8, .76, .7), .9), (-4, y, 1.5), (.1, h, 1.5))
    for z, h in ((.4, .4), (2.75, .25)): add(P.primitive_cube_add, material('sill', (.8, .76, .7), .9), (-4, 0, z), (.1, 4, h))
    for i in range(9):
        car = add(P.primitive_cube_add, material('car', (.3, .1, .1), .5), (-7, -12 + 2.2 * i, 2.4), (.3, .8, 1.6))
        move(car, 'location', [(1, (-7, -12 + 2.2 * i, 2.4)), (48, (-7, -6 + 2.2 * i, 2.4))])
    for i, c in enumerate(((.8, .3, .2), (.3, .5, .8), (.5, .7, .3))): add(P.primitive_monkey_add, material('head%d' % i, c, .4), (-1.6 + 1.7 * i, 1.4, .75), (.6, .6, .6), (0, 0, .5 * i))
    sun = light('SUN', (0, 0, 5), 4, .02)
    sun.rotation_euler = (0, math.radians(-58), math.radians(8))
    eye, _ = camera((.8, -3.6, 1.6), (-.4, 1.2, .9), 24)
    move(eye, 'location', [(1, (.2, -3.6, 1.6)), (48, (1.8, -3.5, 1.7))])
else:                   # brass: metal of three roughnesses turns above a rough metal floor; small bright lamps are reflected
    sky(.04, .05, .07)
    add(P.primitive_plane_add, material('floor', (.55, .5, .45), .3, 1, checker=10), (0, 0, 0), (6, 6, 1))
    add(P.primitive_plane_add, material('wall', (.5, .25, .2), .8, checker=8), (0, 3, 0), (6, 6, 1), (half, 0, 0))
    for i, (r, m) in enumerate(((.08, 1), (.25, 1), (.45, 1))):
        o = add((P.primitive_torus_add, P.primitive_monkey_add, P.primitive_cube_add)[i], material('brass%d' % i, (.85, .6, .25), r, m), (-1.9 + 1.9 * i, .4, .9), (.7, .7, .7))
        move(o, 'rotation_euler', [(1, (.4, 0, 0)), (48, (.9, .3, 2.4))])
    for i in range(5):
        b = add(P.primitive_uv_sphere_add, material('bulb%d' % i, ((1, .8, .5), (.4, .7, 1))[i % 2], emit=9), (-2.4 + 1.2 * i, 1.9, 2.1), (.12, .12, .12))
    ball = add(P.primitive_uv_sphere_add, material('ball', (.2, .6, .5), .5, checker=6), (-2.6, -1, .3), (.3, .3, .3))
    move(ball, 'location', [(1, (-2.6, -1, .3)), (48, (2.6, -1.1, .3))])
    light('AREA', (0, -2, 4.5), 160, 1.5, (math.radians(20), 0, 0))
    eye, _ = camera((0, -4.6, 1.9), (0, .3, .7))
    move(eye, 'location', [(1, (-.8, -4.6, 1.9)), (48, (.8, -4.6, 2))])
bpy.ops.render.render(animation=True)
