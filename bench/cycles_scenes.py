# Renders a small scene with Blender's Cycles (apt-get install --no-install-recommends blender; tested with 3.4.1), 48 frames long:
#   blender -b --factory-startup -noaudio -P cycles_scenes.py -- SCENE OUT_FOLDER SPP FIRST LAST WIDTH HEIGHT [box|default [SEED [window]]]
# box: Cycles' filter of that name, which is always a pixel wide: samples lie anywhere within their pixel. default: Cycles' own filter, by
# which they lie anywhere within a pixel and a half. With both the first sample of a pixel lies at its centre. The seed differs from frame to
# frame. Multi-layer EXR: Combined, light and colour passes, Depth, Normal, Vector (to the last and to the next frame).
# lamp, train, brass have Position and IndexOB too; their passes are clean and complete. In the others colour passes, alpha or sums are not:
#   fog (volume passes), dof (depth of field), film (transparent film), glass (no transmission passes), mblur (motion blur: Vector is 0),
#   gamut (components below 0, wants python3-openimageio), and as controls leaves (outdoors) and tiles (indoors, fine textures).
# street, office, crossing, night, fur and chrome were chosen on; of bench/held_out.sh, to which nothing is fitted: kitchen, market, stairs,
# garden, workshop. Of bench/gauntlet.sh: horizon, screen, zoom, drips. bench/render_cycles.sh calls this.
import bpy, sys, math, os, random
name, out, spp, first, last, width, height = (lambda a: (a[0], a[1], *map(int, a[2:7])))(sys.argv[sys.argv.index("--") + 1:])
pixel_filter, seed = (sys.argv[sys.argv.index("--") + 8:] + ["box", "0"][len(sys.argv) - sys.argv.index("--") - 8:])[:2]
N = 48
bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene
scene.render.engine = 'CYCLES'
cycles = scene.cycles
cycles.device, cycles.samples, cycles.use_adaptive_sampling, cycles.use_denoising = 'CPU', spp, False, False
if pixel_filter == 'box': cycles.pixel_filter_type = 'BOX'
cycles.max_bounces, cycles.sample_clamp_indirect = 4, 0
cycles.caustics_reflective = cycles.caustics_refractive = False
cycles.use_animated_seed, cycles.seed = True, int(seed)
render = scene.render
render.resolution_x, render.resolution_y, render.resolution_percentage = width, height, 100
render.image_settings.file_format, render.image_settings.color_depth, render.image_settings.exr_codec = 'OPEN_EXR_MULTILAYER', '16', 'ZIP'
windows = {'kitchen': (60, 35), 'market': (90, 60), 'stairs': (170, 120), 'garden': (130, 60), 'workshop': (130, 85)}    # left and bottom, of 480x270
if 'window' in sys.argv:    # a quarter of the frame costs a quarter, and its pixels are as fine as the whole's
    x, y = windows[name]
    render.use_border = render.use_crop_to_border = True
    render.border_min_x, render.border_max_x, render.border_min_y, render.border_max_y = x / 480, x / 480 + .5, y / 270, y / 270 + .5
render.filepath = os.path.join(out, 'frame_####')
render.use_persistent_data = True
scene.frame_start, scene.frame_end = first, last
scene.view_settings.view_transform = 'Standard'
layer = scene.view_layers[0]
layer.name = 'ViewLayer'
def passes(*names):
    for p in names: setattr(layer, 'use_pass_' + p, True)
passes('z', 'normal', 'vector', 'diffuse_direct', 'diffuse_indirect', 'diffuse_color', 'glossy_direct', 'glossy_indirect', 'glossy_color', 'emit',
       'environment')
if name in ('lamp', 'train', 'brass'): passes('position', 'object_index')
elif name != 'glass': passes('transmission_direct', 'transmission_indirect', 'transmission_color')
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
def pattern(n, dark, bright, scale, kind='Noise', **k):
    m = material(n, bright, **k)
    t, r = m.node_tree.nodes.new('ShaderNodeTex' + kind), m.node_tree.nodes.new('ShaderNodeValToRGB')
    t.inputs['Scale'].default_value = scale
    a, b = r.color_ramp.elements
    a.position, a.color, b.position, b.color = .4, (*dark, 1), .6, (*bright, 1)
    m.node_tree.links.new(m.node_tree.nodes.new('ShaderNodeTexCoord').outputs['Object'], t.inputs['Vector'])
    m.node_tree.links.new(t.outputs['Distance' if kind == 'Voronoi' else 'Fac'], r.inputs['Fac'])
    m.node_tree.links.new(r.outputs['Color'], m.node_tree.nodes['Principled BSDF'].inputs['Base Color'])
    return m
def glassy(n, color):
    m = material(n, color, rough=0)
    m.node_tree.nodes['Principled BSDF'].inputs['Transmission'].default_value = 1
    return m
def volume(n, color, density, clouds=0):
    m = bpy.data.materials.new(n)
    m.use_nodes = True
    m.node_tree.nodes.clear()
    new, link = m.node_tree.nodes.new, m.node_tree.links.new
    v = new('ShaderNodeVolumePrincipled')
    v.inputs['Color'].default_value, v.inputs['Density'].default_value = (*color, 1), density
    link(v.outputs[0], new('ShaderNodeOutputMaterial').inputs['Volume'])
    if clouds:
        t, r = new('ShaderNodeTexNoise'), new('ShaderNodeMapRange')
        t.inputs['Scale'].default_value, t.inputs['Detail'].default_value = clouds, 4
        r.inputs['From Min'].default_value, r.inputs['From Max'].default_value, r.inputs['To Max'].default_value = .45, .7, density
        ball, times = new('ShaderNodeTexGradient'), new('ShaderNodeMath')     # none at the sides of the box
        ball.gradient_type, times.operation = 'SPHERICAL', 'MULTIPLY'
        for to in t, ball: link(new('ShaderNodeTexCoord').outputs['Object'], to.inputs['Vector'])
        link(t.outputs['Fac'], r.inputs['Value'])
        link(r.outputs[0], times.inputs[0])
        link(ball.outputs['Fac'], times.inputs[1])
        link(times.outputs[0], v.inputs['Density'])
    layer.cycles.use_pass_volume_direct = layer.cycles.use_pass_volume_indirect = True
    cycles.volume_bounces = 2
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
def strips(n, mat, places, width, height, seed):    # leaves or hairs: one mesh of quadrilaterals that stand and lean at random
    chance, points, faces = random.Random(seed), [], []
    for x, y, z in places:
        turn, w, h = chance.uniform(0, 2 * math.pi), width * chance.uniform(.7, 1.3), height * chance.uniform(.6, 1.2)
        c, s, lean, tip = w * math.cos(turn), w * math.sin(turn), chance.uniform(-.6, .6) * h, chance.uniform(-.6, .6) * h
        i = len(points)
        points += [(x, y, z), (x + c + .5 * lean, y + s + .5 * tip, z + .5 * h), (x + lean, y + tip, z + h), (x - c + .5 * lean, y - s + .5 * tip, z + .5 * h)]
        faces.append((i, i + 1, i + 2, i + 3))
    mesh = bpy.data.meshes.new(n)
    mesh.from_pydata(points, [], faces)
    mesh.materials.append(mat)
    o = bpy.data.objects.new(n, mesh)
    scene.collection.objects.link(o)
    return o
def places(number, seed, low, high):
    chance = random.Random(seed)
    return [[chance.uniform(a, b) for a, b in zip(low, high)] for _ in range(number)]
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
elif name == 'brass':   # brass: metal of three roughnesses turns above a rough metal floor; small bright lamps are reflected
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
elif name == 'fog':     # a lamp swings behind posts in a room full of fog that is open to the sky; the camera walks slowly
    sky(.3, .36, .45)
    add(P.primitive_plane_add, material('floor', (.7, .6, .5), .8, checker=16), (0, 0, 0), (5, 5, 1))
    add(P.primitive_plane_add, pattern('wall', (.25, .3, .45), (.7, .7, .6), 4), (-1.2, 4, 1.5), (2.6, 1.5, 1), (half, 0, 0))
    add(P.primitive_plane_add, pattern('side', (.5, .25, .2), (.75, .6, .4), 5), (-3.6, 0, 1.5), (1.5, 4, 1), (0, half, 0))
    for i in range(6): add(P.primitive_cylinder_add, material('post', (.5, .3, .2), .6), (-2.5 + i, 1 + .4 * (i % 2), 1), (.09, .09, 1))
    add(P.primitive_monkey_add, material('head', (.3, .6, .4), .4), (.4, -.6, .6), (.6, .6, .6), (0, 0, .3))
    add(P.primitive_cube_add, volume('fog', (.9, .92, 1), .09), (0, 0, 1.4), (9, 9, 3))
    lamp = light('POINT', (0, 2, 2), 130, .15, color=(1, .8, .55))
    move(lamp, 'location', [(1, (-2, 2.2, 1.7)), (12, (2, 2, 1.9)), (24, (-2, 2.2, 1.7)), (36, (2, 2, 1.9)), (48, (-2, 2.2, 1.7))])
    light('AREA', (2, -3, 4), 120, 1, (math.radians(35), math.radians(25), 0), (.7, .8, 1))
    eye, _ = camera((.4, -5, 1.7), (0, .6, 1))
    move(eye, 'location', [(1, (-.2, -5, 1.7)), (48, (1.2, -4.7, 1.8))])
elif name == 'dof':     # a wide aperture under a pan: textured things and small lamps near and far, one row in focus, sky behind
    sky(.45, .55, .7)
    add(P.primitive_plane_add, pattern('floor', (.2, .16, .12), (.75, .65, .5), 30), (0, 4, 0), (12, 9, 1))
    add(P.primitive_plane_add, material('far', (.75, .7, .6), .9, checker=24), (-2, 9, 1.2), (4, 1.2, 1), (half, 0, 0))
    for i, y in enumerate((-2.6, -1.8, .5, .9, 3, 5)):
        for j in range(3):
            what = (pattern('p', (.1, .2, .5), (.8, .8, .7), 6), material('q', (.8, .35, .2), .4, checker=10), pattern('r', (.15, .4, .15), (.8, .75, .3), 9))[(i + j) % 3]
            x = (-1.9 + 1.7 * j + .4 * (i % 2)) * (1 + .18 * i)
            add((P.primitive_cube_add, P.primitive_uv_sphere_add, P.primitive_monkey_add)[(i + 2 * j) % 3], what, (x, y, .32), (.32, .32, .32), (0, 0, .4 * i + j))
    for i in range(8): add(P.primitive_uv_sphere_add, material('bulb', ((1, .75, .4), (.5, .8, 1))[i % 2], emit=3), (-4 + 1.1 * i, 7 + .3 * (i % 3), 1 + .4 * (i % 3)), (.08, .08, .08))
    sun = light('SUN', (0, 0, 5), 2.2, .05, (math.radians(50), math.radians(20), 0), (1, .93, .8))
    eye, target = camera((0, -5.2, 1.3), (0, 1, .5), 40)
    eye.data.dof.use_dof, eye.data.dof.focus_distance, eye.data.dof.aperture_fstop = True, 5.9, .25
    move(eye, 'location', [(1, (-.3, -5.2, 1.3)), (48, (1.5, -5.2, 1.3))])
    move(target, 'location', [(1, (-.6, 1, .5)), (48, (2.6, 1, .5))])
elif name == 'leaves':  # outdoors: a pan over textured ground, grass and leaves that swing
    sky(.5, .65, .9)
    add(P.primitive_plane_add, pattern('ground', (.12, .08, .05), (.5, .42, .28), 50), (0, 4, 0), (14, 12, 1))
    add(P.primitive_cube_add, pattern('bark', (.1, .06, .04), (.45, .32, .22), 12), (-1.4, 1.2, 1.2), (.2, .2, 1.2))
    add(P.primitive_cube_add, material('stones', (.6, .58, .55), .8, checker=9), (1.8, 3, .5), (1.2, .3, .5))
    for i, (dark, bright) in enumerate((((.05, .2, .03), (.3, .55, .12)), ((.2, .22, .03), (.65, .6, .15)), ((.25, .08, .03), (.75, .4, .1)))):
        o = strips('crown%d' % i, pattern('leaf%d' % i, dark, bright, 8), [(x - 1.4, y + 1.2, z) for x, y, z in places(140, i, (-1.1, -1.1, 1.2), (1.1, 1.1, 2.6))], .11, .3, i)
        move(o, 'rotation_euler', [(1 + 6 * k, (.03 * (-1) ** (k + i), .02 * (-1) ** k, 0)) for k in range(9)])
        strips('grass%d' % i, pattern('blade%d' % i, dark, bright, 10), places(350, 9 + i, (-5, -2, 0), (5, 5, 0)), .035, .32, 5 + i)
    light('SUN', (0, 0, 5), 3, .02, (math.radians(42), math.radians(-28), 0), (1, .94, .82))
    eye, target = camera((0, -4.4, 1.4), (0, 1, .9), 32)
    move(eye, 'location', [(1, (-.4, -4.4, 1.4)), (48, (.8, -4.4, 1.5))])
    move(target, 'location', [(1, (-1, 1, .9)), (48, (2.8, 1, .9))])
elif name == 'film':    # transparent film: smoke, hair and leaves turn and pass before nothing, so that alpha is noisy
    render.film_transparent = True
    sky(.3, .36, .45)
    add(P.primitive_cylinder_add, material('plate', (.65, .5, .4), .5, checker=9), (0, .3, -.06), (1.9, 1.9, .06))
    head = add(P.primitive_monkey_add, pattern('head', (.5, .2, .12), (.85, .6, .4), 5), (-.9, .2, .75), (.65, .65, .65))
    o = strips('hair', material('hair', (.55, .35, .15), .4), [(.6 * math.cos(k), .45 * math.sin(k), .25 + .2 * math.cos(3 * k)) for k in range(300)], .012, .7, 1)
    o.parent, o.scale = head, (1, 1, 1)
    move(head, 'rotation_euler', [(1, (0, 0, -.5)), (48, (.3, 0, 1.4))])
    o = strips('leaves', pattern('leaf', (.08, .25, .05), (.45, .6, .15), 9), [(x + 1, y, z) for x, y, z in places(120, 2, (-.5, -.5, 0), (.5, .5, 1.2))], .06, .35, 3)
    move(o, 'location', [(1, (-.1, 0, 0)), (48, (.8, 0, .1))])
    smoke = add(P.primitive_cube_add, volume('smoke', (.75, .75, .8), 12, 2.2), (.2, .9, 1.1), (1.4, .8, 1.2))
    move(smoke, 'location', [(1, (.2, .9, 1.1)), (48, (1.2, .9, 1.4))])
    add(P.primitive_uv_sphere_add, glassy('drop', (.8, .95, 1)), (.1, -.9, .3), (.3, .3, .3))
    add(P.primitive_uv_sphere_add, material('bulb', (1, .7, .4), emit=2.5), (1.5, -.4, .25), (.1, .1, .1))
    light('AREA', (-2.5, -2.5, 4), 260, 1, (math.radians(35), math.radians(-30), 0), (1, .93, .85))
    light('POINT', (3, 2, 2.5), 90, .3, color=(.6, .75, 1))
    eye, _ = camera((0, -5.4, 1.9), (.1, .2, .75))
    move(eye, 'location', [(1, (-.2, -5.4, 1.9)), (48, (.6, -5.4, 2))])
elif name == 'glass':   # glass things turn before textures, another enters at frame 4, and no transmission passes are rendered
    sky(.35, .42, .5)
    cycles.max_bounces = cycles.transmission_bounces = 8
    add(P.primitive_plane_add, material('floor', (.7, .62, .5), .7, checker=16), (0, 0, 0), (6, 6, 1))
    add(P.primitive_plane_add, pattern('wall', (.2, .3, .5), (.8, .7, .5), 4), (0, 3, 0), (6, 6, 1), (half, 0, 0))
    for i, c in enumerate(((.8, .25, .2), (.25, .7, .3), (.85, .7, .2))): add(P.primitive_cube_add, material('block', c, .5, checker=4), (-2 + 2 * i, 1.9, .4), (.35, .35, .4))
    for i, op in enumerate((P.primitive_torus_add, P.primitive_monkey_add)):
        o = add(op, glassy('glass%d' % i, ((.95, 1, .97), (1, .9, .8))[i]), (-1.1 + 2 * i, -.2, .8), (.65, .65, .65), (.9, 0, 0))
        move(o, 'rotation_euler', [(1, (.9 - .9 * i, 0, 0)), (48, (1.3 - .9 * i, .8, 2.6))])
    ball = add(P.primitive_uv_sphere_add, glassy('ball', (.85, .95, 1)), (-4, -1.4, .5), (.5, .5, .5))
    bpy.ops.object.shade_smooth()
    move(ball, 'location', [(1, (-2.85, -1.4, .5)), (12, (-1, -1.4, .5)), (48, (3, -1.4, .5))])
    light('AREA', (-1, -2, 4.5), 260, 1.2, (math.radians(20), math.radians(-10), 0))
    eye, _ = camera((0, -5, 1.9), (0, .3, .7))
    move(eye, 'location', [(1, (-.1, -5, 1.9)), (48, (.5, -5, 2))])
elif name == 'mblur':   # the shutter is open half of the frame time: things pass, turn and roll, and the camera pans
    sky(.35, .42, .5)
    render.use_motion_blur, render.motion_blur_shutter = True, .5
    add(P.primitive_plane_add, material('floor', (.7, .62, .5), .8, checker=14), (0, 1, 0), (8, 6, 1))
    add(P.primitive_plane_add, pattern('wall', (.2, .3, .45), (.75, .7, .6), 4), (0, 3.5, 0), (8, 4, 1), (half, 0, 0))
    for i in range(5): add(P.primitive_cylinder_add, material('post', (.55, .3, .2), .6), (-3 + 1.5 * i, 1.8, .7), (.1, .1, .7))
    train = add(P.primitive_cube_add, material('train', (.8, .3, .2), .4, checker=6), (0, .6, .45), (.8, .3, .35))
    move(train, 'location', [(1, (-2.6, .6, .45)), (24, (4, .6, .45)), (48, (-4, .6, .45))])
    wheel = add(P.primitive_monkey_add, pattern('wheel', (.1, .35, .2), (.7, .8, .4), 6), (-1, -.9, .8), (.6, .6, .6))
    move(wheel, 'rotation_euler', [(1, (0, 0, 0)), (48, (0, 18, 0))])
    ball = add(P.primitive_uv_sphere_add, material('ball', (.3, .5, .85), .3, checker=8), (2, -1, .4), (.4, .4, .4))
    move(ball, 'location', [(1, (2.6, -1, .4)), (16, (-.2, -1.4, 1.2)), (32, (2.6, -1, .4)), (48, (0, -1.2, .6))])
    bulb = add(P.primitive_uv_sphere_add, material('bulb', (1, .8, .5), emit=4), (0, 2.4, 2), (.1, .1, .1))
    move(bulb, 'location', [(1, (-2, 2.4, 1.9)), (16, (2.4, 2.4, 1.6)), (32, (-2.4, 2.4, 1.9)), (48, (2.4, 2.4, 1.6))])
    light('AREA', (-1, -2, 4.5), 260, 1.2, (math.radians(20), math.radians(-10), 0), (1, .94, .86))
    eye, target = camera((0, -5, 1.8), (0, .4, .8))
    move(target, 'location', [(1, (-.2, .4, .8)), (48, (1.6, .4, .8))])
elif name == 'tiles':   # indoors: fine textures everywhere, a moving lamp, and the camera walks
    sky(.1, .12, .15)
    add(P.primitive_plane_add, material('floor', (.75, .72, .65), .5, checker=48), (0, 0, 0), (4, 4, 1))
    add(P.primitive_plane_add, pattern('back', (.2, .3, .4), (.8, .78, .7), 14), (0, 3, 0), (4, 3, 1), (half, 0, 0))
    add(P.primitive_plane_add, material('left', (.45, .65, .6), .6, checker=40), (-3, 0, 0), (3, 4, 1), (0, half, 0))
    add(P.primitive_plane_add, material('right', (.7, .45, .35), .6, checker=40), (3, 0, 0), (3, 4, 1), (0, half, 0))
    for i in range(3): add((P.primitive_cube_add, P.primitive_uv_sphere_add, P.primitive_torus_add)[i], pattern('thing%d' % i, (.25, .12, .08), (.85, .75, .4), 16), (-1.5 + 1.5 * i, .6 * (i % 2), .5), (.45, .45, .45), (.3 * i, 0, .5))
    lamp = light('POINT', (0, 0, 2.4), 140, .2, color=(1, .86, .66))
    move(lamp, 'location', [(1, (-1.2, -1, 2.4)), (24, (1.2, -.6, 2.2)), (48, (-1.2, -1, 2.4))])
    light('AREA', (1, -1, 2.9), 50, 1.5, color=(.8, .9, 1))
    eye, _ = camera((0, -4.4, 1.6), (0, .4, .8), 28)
    move(eye, 'location', [(1, (-.8, -4.4, 1.6)), (48, (2.2, -4, 1.7))])
elif name == 'gamut':   # grey textures, and one red ball, under lamps of pure colours; see out_of_gamut
    sky(.01, .02, .06)
    add(P.primitive_plane_add, material('floor', (.7, .7, .7), .6, checker=14), (0, 0, 0), (6, 6, 1))
    add(P.primitive_plane_add, pattern('wall', (.3, .3, .3), (.8, .8, .8), 4), (0, 3, 0), (6, 6, 1), (half, 0, 0))
    for i in range(3): add((P.primitive_cube_add, P.primitive_monkey_add, P.primitive_torus_add)[i], material('grey%d' % i, (.7, .7, .7), (.6, .3, .15)[i], (0, 0, 1)[i]), (-1.8 + 1.8 * i, .4, .6), (.55, .55, .55), (.2 * i, 0, .4))
    ball = add(P.primitive_uv_sphere_add, material('ball', (.8, .1, .05), .4), (2, -1.2, .35), (.35, .35, .35))
    move(ball, 'location', [(1, (2, -1.2, .35)), (48, (-2, -1.2, .35))])
    add(P.primitive_uv_sphere_add, material('bulb', (.1, 1, .05), emit=1), (-2.2, -.8, .25), (.2, .2, .2))
    for i, c in enumerate(((1, 0, 0), (0, 1, 0), (0, 0, 1))):
        l = light('AREA', (-3 + 3 * i, -1.5, 3), (90, 55, 150)[i], .6, (math.radians(20), math.radians(-40 + 40 * i), 0), c)
        move(l, 'location', [(1, (-3 + 3 * i, -1.5, 3)), (48, (-2 + 3 * i, -.5, 3))])
    eye, _ = camera((0, -5, 2), (0, .3, .7))
    move(eye, 'location', [(1, (-.2, -5, 2)), (48, (1, -5, 2))])
elif name == 'street':  # outdoors under a pan: house fronts of fine texture, wires, poles, a fence, a tree, people-sized things walk
    sky(.55, .7, .95)
    add(P.primitive_plane_add, pattern('asphalt', (.1, .1, .11), (.3, .29, .28), 40), (0, 4, 0), (16, 12, 1))
    for i, c in enumerate(((.7, .35, .25), (.75, .7, .55), (.45, .55, .65), (.65, .6, .3))):
        add(P.primitive_cube_add, material('front%d' % i, c, .8, checker=22 + 6 * i), (-6 + 4 * i, 7 + .5 * (i % 2), 2), (1.9, .6, 2 + .4 * i))
    for i in range(9): add(P.primitive_cylinder_add, material('pole', (.35, .33, .3), .6), (-6 + 1.5 * i, 2.4 + .6 * (i % 3), 1.3), (.025, .025, 1.3))
    for i in range(5): add(P.primitive_cylinder_add, material('wire', (.05, .05, .05), .6), (0, 2.4 + .3 * i, 2.1 + .12 * i), (.008, .008, 9), (0, half, .02 * i))
    for i in range(40): add(P.primitive_cube_add, material('fence', (.8, .78, .7), .7), (-5 + .25 * i, 1.4, .28), (.03, .02, .28))
    for i in range(2):
        o = strips('crown%d' % i, pattern('leaf%d' % i, (.04, .15, .03), ((.35, .5, .1), (.6, .45, .1))[i], 8), [(x + 2.4, y + 3, z) for x, y, z in places(200, 40 + i, (-1, -1, 1.4), (1, 1, 3))], .1, .26, i + 7)
        move(o, 'rotation_euler', [(1 + 5 * k, (.02 * (-1) ** (k + i), .015 * (-1) ** k, 0)) for k in range(10)])
    for i, c in enumerate(((.8, .2, .15), (.2, .4, .8), (.85, .75, .3))):
        o = add(P.primitive_cylinder_add, material('walker%d' % i, c, .7, checker=5), (-2 + i, .6 + .5 * i, .5), (.16, .16, .5))
        move(o, 'location', [(1, (-2.4 + 1.6 * i, .6 + .5 * i, .5)), (48, (1.2 + (-1.4) ** i, .6 + .5 * i, .5))])
    light('SUN', (0, 0, 5), 3.2, .01, (math.radians(50), math.radians(30), 0), (1, .95, .85))
    eye, target = camera((0, -4.4, 1.5), (0, 1, 1), 30)
    move(eye, 'location', [(1, (.6, -4.4, 1.5)), (48, (-.8, -4.2, 1.5))])
    move(target, 'location', [(1, (1.6, 1, 1)), (48, (-2.4, 1, 1.1))])
elif name == 'office':  # indoors: a lamp swings, a screen flickers (and is dark from frame 15 to 17), a fan turns before a light
    sky(.05, .06, .08)
    add(P.primitive_plane_add, material('floor', (.5, .42, .34), .7, checker=14), (0, 0, 0), (4, 4, 1))
    add(P.primitive_plane_add, material('back', (.78, .76, .7), .9), (0, 3, 1.5), (4, 1.5, 1), (half, 0, 0))
    add(P.primitive_plane_add, material('left', (.7, .5, .42), .9), (-3, 0, 1.5), (1.5, 4, 1), (0, half, 0))
    add(P.primitive_plane_add, material('top', (.8, .8, .8), .9), (0, 0, 3), (4, 4, 1))
    add(P.primitive_cube_add, material('desk', (.5, .32, .2), .4), (-.3, 1.2, .75), (1.4, .6, .04))
    for x in (-1.6, 1): add(P.primitive_cube_add, material('leg', (.3, .3, .3), .5), (x, 1.2, .36), (.05, .5, .36))
    add(P.primitive_monkey_add, material('head', (.7, .6, .5), .5), (.6, 1.1, 1), (.25, .25, .25), (0, 0, .5))
    add(P.primitive_cube_add, material('chair', (.2, .3, .5), .8), (.2, -.1, .4), (.3, .3, .4), (0, 0, .4))
    screen = material('screen', (.5, .7, 1), emit=1)
    add(P.primitive_plane_add, screen, (-.7, 1.4, 1.2), (.55, .34, 1), (half, 0, .15))
    e = screen.node_tree.nodes['Principled BSDF'].inputs['Emission Strength']
    for f in range(1, 49): e.default_value = 0 if f % 16 in (15, 0, 1) and f > 1 else 2 + 1.5 * (f * 7 % 5) / 4; e.keyframe_insert('default_value', frame=f)
    for b in range(4):
        o = add(P.primitive_cube_add, material('blade', (.6, .6, .62), .5), (1.6, .6, 2.2), (.62, .09, .015), (0, 0, b * half))
        move(o, 'rotation_euler', [(1, (0, 0, b * half)), (48, (0, 0, b * half + 16))])
    light('AREA', (1.6, .6, 2.9), 60, .35, color=(1, .95, .9))
    lamp = light('POINT', (0, 0, 2), 45, .08, color=(1, .78, .5))
    move(lamp, 'location', [(1, (-1.8, .2, 1.9)), (12, (.2, .2, 1.7)), (24, (-1.8, .2, 1.9)), (36, (.2, .2, 1.7)), (48, (-1.8, .2, 1.9))])
    eye, _ = camera((1.4, -3.4, 1.7), (-.4, 1, 1), 26)
    move(eye, 'location', [(1, (1.2, -3.4, 1.7)), (48, (1.9, -3.2, 1.7))])
elif name == 'crossing':    # things pass before others in both directions, near and far, under one area light
    sky(.12, .14, .18)
    add(P.primitive_plane_add, material('floor', (.6, .6, .55), .8, checker=10), (0, 0, 0), (6, 6, 1))
    add(P.primitive_plane_add, pattern('wall', (.3, .2, .15), (.75, .65, .5), 4), (0, 3, 0), (6, 6, 1), (half, 0, 0))
    for i in range(3): add(P.primitive_monkey_add, material('head%d' % i, ((.8, .6, .3), (.4, .6, .7), (.7, .4, .5))[i], .5), (-1.8 + 1.8 * i, 1.6, .75), (.55, .55, .55), (0, 0, .4 * i - .4))
    for i, (y, c) in enumerate(((-.9, (.2, .6, .3)), (-.2, (.75, .7, .2)), (.6, (.7, .25, .2)), (1, (.3, .35, .8)))):
        o = add((P.primitive_cube_add, P.primitive_uv_sphere_add, P.primitive_torus_add, P.primitive_cylinder_add)[i], material('mover%d' % i, c, .6, checker=(0, 8, 0, 6)[i]), (0, y, .7), ((.25, .08, .7), (.35, .35, .35), (.4, .4, .4), (.15, .15, .7))[i], (0, 0, 0) if i != 2 else (half, 0, 0))
        a = (-2.6, 2.4, -2, 3)[i]
        move(o, 'location', [(1, (a, y, .7)), (24, (-a, y, .7)), (48, (a, y, .7))])
    light('AREA', (-1.5, -2, 4), 220, 1.2, (math.radians(28), math.radians(-20), 0), (1, .95, .9))
    camera((0, -4.8, 1.7), (0, .4, .75))
elif name == 'night':   # a room at night: small lamps of many colours, one blinks, one sweeps like a lighthouse; the camera walks
    sky(.004, .006, .012)
    add(P.primitive_plane_add, pattern('floor', (.25, .15, .1), (.5, .35, .22), 12, 'Wave'), (0, 0, 0), (4, 4, 1))
    add(P.primitive_plane_add, material('back', (.65, .65, .7), .9), (0, 3.2, 1.5), (4, 1.6, 1), (half, 0, 0))
    add(P.primitive_plane_add, material('right', (.55, .65, .55), .9), (3, 0, 1.5), (1.5, 4, 1), (0, half, 0))
    for i in range(6): add(P.primitive_cube_add, material('book%d' % i, ((.7, .2, .2), (.2, .3, .7), (.8, .7, .4))[i % 3], .7), (-2 + .5 * i, 2.4, .25 + .1 * (i % 3)), (.14, .3, .25 + .1 * (i % 3)), (0, 0, .1 * i))
    add(P.primitive_monkey_add, material('head', (.8, .75, .7), .35), (.9, .8, .6), (.5, .5, .5), (0, 0, -.3))
    add(P.primitive_torus_add, material('ring', (.8, .6, .3), .3, 1), (-1, .3, .5), (.45, .45, .45), (half, 0, .4))
    for i in range(12): add(P.primitive_uv_sphere_add, material('bulb%d' % i, ((1, .6, .3), (.4, .6, 1), (.5, 1, .5))[i % 3], emit=6), (-2.6 + .45 * i, 2.9, 2 + .25 * math.sin(i)), (.05, .05, .05))
    blink = material('blink', (1, .25, .2), emit=1)
    add(P.primitive_cube_add, blink, (2.2, 1.8, .9), (.12, .12, .12))
    e = blink.node_tree.nodes['Principled BSDF'].inputs['Emission Strength']
    for f in range(1, 49): e.default_value = 12 * (f // 4 % 2); e.keyframe_insert('default_value', frame=f)
    spot = light('SPOT', (0, -.5, 2.6), 260, .05, color=(1, .9, .7))
    spot.data.spot_size = .8
    move(spot, 'rotation_euler', [(1, (.9, 0, -1.2)), (24, (.9, 0, 1.2)), (48, (.9, 0, -1.2))])
    eye, _ = camera((0, -3.6, 1.6), (.2, 1, .9), 28)
    move(eye, 'location', [(1, (-.6, -3.6, 1.6)), (48, (.8, -3.4, 1.6))])
elif name == 'fur':     # a hairy ball rolls past a hairy rug's edge; sunlight through a lattice that moves
    sky(.3, .36, .45)
    add(P.primitive_plane_add, pattern('floor', (.35, .25, .18), (.65, .5, .36), 9), (0, 1, 0), (7, 6, 1))
    add(P.primitive_plane_add, material('wall', (.7, .72, .7), .9), (0, 3.4, 0), (7, 4, 1), (half, 0, 0))
    strips('rug', material('rug', (.6, .2, .22), .9), places(2600, 3, (-2.2, -1, 0), (1.2, 1.6, 0)), .008, .22, 3)
    ball = add(P.primitive_uv_sphere_add, material('skin', (.5, .35, .2), .8), (0, 0, .6), (.5, .5, .5))
    o = strips('coat', material('coat', (.85, .6, .3), .6), [(.95 * math.cos(a) * math.cos(b), .95 * math.sin(a) * math.cos(b), .95 * math.sin(b) - .1) for a, b, _ in places(1500, 5, (0, -1.5, 0), (6.283, 1.5, 1))], .012, .45, 6)
    o.parent = ball
    move(ball, 'location', [(1, (-1.6, .2, .6)), (48, (1.8, .2, .6))])
    move(ball, 'rotation_euler', [(1, (0, 0, 0)), (48, (0, 5, 0))])
    add(P.primitive_monkey_add, material('head', (.3, .5, .6), .4), (1.5, 1.6, .6), (.6, .6, .6), (0, 0, -.4))
    for i in range(12):
        slat = add(P.primitive_cube_add, material('slat', (.4, .3, .2), .7), (-3 + .5 * i, -1, 4), (.12, 3, .05))
        move(slat, 'location', [(1, (-3 + .5 * i, -1, 4)), (48, (-1.4 + .5 * i, -1, 4))])
    light('SUN', (0, 0, 5), 4, .01, (math.radians(30), math.radians(-14), 0), (1, .94, .82))
    eye, _ = camera((0, -4.6, 1.8), (0, .6, .6))
    move(eye, 'location', [(1, (.3, -4.6, 1.8)), (48, (-.5, -4.6, 1.8))])
elif name == 'chrome':  # rough metal plates and balls of several roughnesses reflect moving things; the camera circles
    sky(.15, .18, .24)
    add(P.primitive_plane_add, material('floor', (.5, .52, .55), .18, 1, checker=6), (0, 0, 0), (6, 6, 1))
    add(P.primitive_plane_add, pattern('wall', (.2, .35, .3), (.75, .7, .5), 3), (0, 3.2, 0), (6, 4, 1), (half, 0, 0))
    for i in range(5): add(P.primitive_uv_sphere_add, material('ball%d' % i, ((.9, .9, .9), (.95, .7, .3), (.9, .5, .4))[i % 3], .05 + .1 * i, 1), (-2.2 + 1.1 * i, .9 - .3 * (i % 2), .5), (.45, .45, .45)), bpy.ops.object.shade_smooth()
    o = add(P.primitive_cube_add, material('box', (.2, .45, .8), .5, checker=4), (0, -.9, .35), (.3, .3, .3))
    move(o, 'location', [(1, (-1.8, -.9, .35)), (48, (1.8, -.9, .35))])
    move(o, 'rotation_euler', [(1, (0, 0, 0)), (48, (0, 0, 3))])
    lamp = add(P.primitive_uv_sphere_add, material('bulb', (1, .8, .5), emit=14), (0, 0, 2), (.14, .14, .14))
    move(lamp, 'location', [(1, (1.5, .2, 1.9)), (24, (-1.5, .2, 1.9)), (48, (1.5, .2, 1.9))])
    light('AREA', (1.5, -2.5, 4), 140, .8, (math.radians(30), math.radians(20), 0), (.9, .95, 1))
    eye, _ = camera((0, -4.6, 1.7), (0, .5, .6))
    move(eye, 'location', [(1, (1, -4.5, 1.7)), (48, (-1, -4.5, 1.6))])
elif name == 'kitchen':  # sunlight through curtains that blow, on glossy tiles, steel and glaze; a kettle is carried, the camera walks
    sky(1.6, 1.9, 2.4)
    add(P.primitive_plane_add, material('floor', (.55, .5, .45), .25, checker=16), (0, 0, 0), (3.2, 3, 1))
    add(P.primitive_plane_add, pattern('tiles', (.55, .68, .72), (.88, .86, .8), 9, 'Brick', rough=.12), (0, 2.4, 1.4), (3.2, 1.4, 1), (half, 0, 0))
    add(P.primitive_plane_add, material('top', (.85, .84, .8), .9), (0, 0, 2.8), (3.2, 3, 1))
    add(P.primitive_plane_add, material('right', (.75, .55, .35), .8), (3, 0, 1.4), (1.4, 3, 1), (0, half, 0))
    for y, z, h, v in ((-2.2, 1.4, .9, 1.4), (2.1, 1.4, .5, 1.4), (.2, .45, 1.6, .45), (.2, 2.5, 1.6, .3), (.2, 1.5, .04, .8)): add(P.primitive_cube_add, material('left', (.8, .8, .76), .85), (-3, y, z), (.08, h, v))
    for i in range(14):
        a = i * .9
        o = add(P.primitive_cube_add, material('curtain', (.8, .45, .3) if i % 2 else (.85, .8, .7), .9), (-2.75, -1.3 + .23 * i, 1.6), (.012, .085, .85))
        move(o, 'rotation_euler', [(1 + 6 * k, (.12 * math.sin(a + 1.3 * k), .16 * math.cos(a + 1.1 * k), .9 * math.sin(a * .7 + k))) for k in range(9)])
    add(P.primitive_cube_add, pattern('counter', (.2, .2, .22), (.5, .48, .46), 30, rough=.2), (.2, 1.9, .9), (2.4, .5, .04))
    for i in range(5): add(P.primitive_cube_add, pattern('door%d' % i, (.3, .16, .08), (.5, .3, .16), 5, 'Wave', rough=.35), (-1.7 + .95 * i, 1.9, .43), (.46, .46, .41))
    for i, r in enumerate((.08, .2, .35)): add(P.primitive_cylinder_add, material('pot%d' % i, (.8, .78, .76), r, 1), (-1.3 + .5 * i, 1.9, 1.06 + .03 * i), (.18, .18, .12 + .03 * i)), bpy.ops.object.shade_smooth()
    for i in range(7): add(P.primitive_uv_sphere_add, material('fruit%d' % i, ((.85, .35, .05), (.7, .1, .08), (.5, .65, .1))[i % 3], .3), (.5 + .15 * (i % 4), 1.75 + .14 * (i // 4), 1.02), (.075, .075, .075)), bpy.ops.object.shade_smooth()
    for i in range(6): add(P.primitive_cylinder_add, material('ladle', (.75, .75, .78), .25, 1), (1.1 + .16 * i, 2.32, 1.75), (.012, .012, .22 + .03 * (i % 3)))
    kettle = add(P.primitive_uv_sphere_add, material('kettle', (.9, .5, .35), .18, 1), (0, 1.2, 1.1), (.2, .2, .17))
    bpy.ops.object.shade_smooth()
    move(kettle, 'location', [(1, (1.9, .9, 1.15)), (28, (.1, .8, 1.35)), (48, (-1.3, 1.1, 1.2))])
    sun = light('SUN', (0, 0, 5), 14, .012, (0, math.radians(-57), math.radians(-14)), (1, .9, .75))
    eye, target = camera((.9, -2.6, 1.6), (-.2, 1.6, 1.05), 25)
    move(eye, 'location', [(1, (1.3, -2.6, 1.55)), (48, (.2, -2.35, 1.65))])
elif name == 'market':  # outdoors: striped awnings, cobbles, heaps of fruit, lanterns; people-sized things pass before each other
    sky(.3, .38, .5)
    add(P.primitive_plane_add, pattern('cobbles', (.2, .19, .18), (.5, .46, .42), 40, 'Voronoi', rough=.7), (0, 2, 0), (7, 6, 1))
    for i, c in enumerate(((.75, .6, .45), (.6, .35, .28), (.7, .68, .55), (.45, .5, .55))): add(P.primitive_cube_add, pattern('house%d' % i, [.7 * x for x in c], c, 6, 'Brick', rough=.9), (-5 + 3.4 * i, 6 + .6 * (i % 2), 2), (1.6, .6, 2.2 + .5 * (i % 3)))
    for i in range(4):
        x = -3.3 + 2.2 * i
        add(P.primitive_cube_add, pattern('awning%d' % i, ((.75, .1, .08), (.1, .35, .2), (.1, .2, .5), (.8, .55, .1))[i], (.9, .88, .82), 2.2, 'Wave', rough=.9), (x, 2.6, 1.75), (.95, .6, .015), (-.3, 0, 0))
        add(P.primitive_cube_add, pattern('stall%d' % i, (.25, .15, .08), (.5, .34, .2), 7, 'Wave'), (x, 2.5, .35), (.85, .45, .35))
        for s in (-.88, .88): add(P.primitive_cylinder_add, material('post', (.4, .3, .2), .6), (x + s, 2.1, .8), (.025, .025, .8))
        chance = random.Random(60 + i)
        for k in range(26): add(P.primitive_uv_sphere_add, material('fruit%d' % (k % 3), (((.85, .4, .05), (.6, .7, .15), (.7, .1, .1)), ((.5, .1, .3), (.8, .75, .2), (.2, .45, .1)))[i % 2][k % 3], .4), (x + chance.uniform(-.7, .7), 2.15 + chance.uniform(0, .5), .74 + chance.uniform(0, .1)), (.075, .075, .075), segments=14, ring_count=8)
    for i in range(9):
        o = add(P.primitive_plane_add, material('flag%d' % i, ((.8, .15, .1), (.9, .75, .2), (.15, .4, .7))[i % 3], .9, checker=2), (-4 + i, 1.5 + .1 * (i % 2), 2.25), (.16, .2, 1), (half, 0, 0))
        move(o, 'rotation_euler', [(1 + 6 * k, (half + .35 * math.sin(i + 1.7 * k), 0, .3 * math.cos(i + k))) for k in range(9)])
    add(P.primitive_cylinder_add, material('rope', (.15, .12, .1), .8), (0, 1.5, 2.46), (.01, .01, 7), (0, half, 0))
    for i in range(7):
        c, y, v = ((.2, .3, .5), (.6, .2, .2), (.5, .5, .3), (.15, .35, .25), (.7, .6, .5), (.3, .2, .35), (.2, .2, .22))[i], .1 + .3 * i, (-1) ** i * (1.1 + .35 * (i % 3))
        body = add(P.primitive_cylinder_add, pattern('coat%d' % i, [.4 * x for x in c], c, 5, ('Wave', 'Checker', 'Noise')[i % 3]), (0, y, .5), (.19, .15, .5))
        head = add(P.primitive_uv_sphere_add, material('skin%d' % i, ((.7, .5, .38), (.35, .22, .15))[i % 2], .6), (0, y, 1.17), (.13, .13, .16))
        x = (-2.4 + 1.3 * i if i % 2 else 2.8 - 1.2 * i) - v
        for o, z in (body, .5), (head, 1.17): move(o, 'location', [(1 + 4 * k, (x + v * k / 6, y, z + .03 * (k % 2))) for k in range(13)])
    for i in range(5): add(P.primitive_uv_sphere_add, material('lantern%d' % i, (1, .6, .25), emit=2.5), (-3 + 1.6 * i, 3, 1.45), (.09, .09, .12))
    light('SUN', (0, 0, 5), 3.6, .015, (math.radians(42), math.radians(-32), 0), (1, .93, .82))
    eye, target = camera((0, -3.2, 1.55), (0, 2, 1), 27)
    move(eye, 'location', [(1, (-1, -3.2, 1.5)), (48, (.9, -3, 1.6))])
    move(target, 'location', [(1, (-1.1, 2, 1)), (48, (.5, 2, 1.05))])
elif name == 'stairs':  # a staircase at night: a bare bulb swings behind banisters, a sign flickers, someone climbs
    sky(.003, .004, .009)
    add(P.primitive_plane_add, pattern('floor', (.18, .17, .16), (.42, .4, .36), 5, 'Checker', rough=.3), (0, 0, 0), (4, 4, 1))
    add(P.primitive_plane_add, pattern('plaster', (.45, .4, .32), (.68, .63, .54), 2.5, rough=.9), (0, 2.6, 1.8), (4, 1.8, 1), (half, 0, 0))
    add(P.primitive_plane_add, material('left', (.5, .58, .55), .85), (-2.8, 0, 1.8), (1.8, 4, 1), (0, half, 0))
    add(P.primitive_plane_add, material('top', (.7, .7, .68), .9), (0, 0, 3.6), (4, 4, 1))
    for i in range(11):
        add(P.primitive_cube_add, pattern('step', (.25, .13, .07), (.42, .25, .14), 6, 'Wave', rough=.4), (-1.9 + .36 * i, 1.8, .1 + .19 * i), (.18, .75, .1))
        add(P.primitive_cube_add, material('riser', (.6, .57, .5), .8), (-2.06 + .36 * i, 1.8, .095 * i), (.015, .74, .095 * i + .01))
        for k in (0, 1): add(P.primitive_cylinder_add, material('banister', (.12, .1, .1), .35, .8), (-1.98 + .36 * i + .18 * k, 1.08, .62 + .19 * i + .095 * k), (.014, .014, .42))
    add(P.primitive_cylinder_add, material('rail', (.35, .18, .08), .25), (-.1, 1.08, 2.0), (.035, .035, 2.25), (0, math.radians(62.2), 0))
    bulb = light('POINT', (0, .2, 2.4), 70, .05, color=(1, .74, .42))
    shade = add(P.primitive_cone_add, material('shade', (.1, .25, .2), .4), (0, .2, 2.6), (.2, .2, .12))
    for o, up in (bulb, 0), (shade, .22): move(o, 'location', [(1 + 6 * k, (.1 + 1.0 * (-1) ** k, .1 + .25 * math.sin(k), 2.25 + up)) for k in range(9)])
    sign = material('sign', (1, .15, .35), emit=1)
    for i in range(4): add(P.primitive_torus_add, sign, (1.1 + .42 * i, 2.5, 2.75 - .1 * (i % 2)), (.17, .17, .17), (half, 0, 0), major_segments=32, minor_radius=.12)
    e = sign.node_tree.nodes['Principled BSDF'].inputs['Emission Strength']
    for f in range(1, 49): e.default_value = (9, 9, 7, 0, 8, 2, 9, 9, 0, 0, 6)[f * 5 % 11]; e.keyframe_insert('default_value', frame=f)
    for c in sign.node_tree.animation_data.action.fcurves:
        for k in c.keyframe_points: k.interpolation = 'CONSTANT'
    body, head = add(P.primitive_cylinder_add, pattern('coat', (.1, .12, .3), (.3, .35, .6), 4, 'Checker'), (0, 1.6, 1), (.17, .14, .45)), add(P.primitive_uv_sphere_add, material('skin', (.6, .42, .32), .6), (0, 1.6, 1.6), (.12, .12, .15))
    for o, z in (body, .75), (head, 1.35): move(o, 'location', [(1, (-1.9, 1.7, z + .1)), (48, (1.1, 1.7, z + 1.68))])
    for i in range(3): add(P.primitive_cube_add, pattern('crate%d' % i, (.3, .2, .1), (.55, .4, .22), 3, 'Brick'), ((1.2, 1.75, 1.45)[i], (.35, .6, .45)[i], (.25, .25, .72)[i]), (.25, .25, .22 + .03 * (i < 2)), (0, 0, .3 * i))
    add(P.primitive_cylinder_add, material('bin', (.6, .62, .6), .3, 1), (-1.2, .1, .35), (.24, .24, .35))
    eye, target = camera((.6, -3.4, 1.5), (0, 1.2, 1.25), 26)
    move(eye, 'location', [(1, (.9, -3.5, 1.4)), (48, (.1, -3.2, 1.75))])
elif name == 'garden':  # outdoors: fine grass, flowers, canes and a net before a hedge, clouds in the sky, a swing swings, the camera pans
    new, link = world.node_tree.nodes.new, world.node_tree.links.new
    t, r = new('ShaderNodeTexNoise'), new('ShaderNodeValToRGB')
    t.inputs['Scale'].default_value, t.inputs['Detail'].default_value = 3, 6
    a, b = r.color_ramp.elements
    a.position, a.color, b.position, b.color = .42, (.22, .36, .62, 1), .66, (.85, .87, .9, 1)
    link(new('ShaderNodeTexCoord').outputs['Generated'], t.inputs['Vector'])
    link(t.outputs['Fac'], r.inputs['Fac'])
    link(r.outputs['Color'], world.node_tree.nodes['Background'].inputs[0])
    add(P.primitive_plane_add, pattern('earth', (.09, .07, .04), (.2, .22, .08), 22), (0, 2, 0), (8, 7, 1))
    strips('grass', pattern('blade', (.05, .2, .03), (.3, .5, .1), 3, rough=.7), places(16000, 21, (-4.5, -1.5, 0), (4.5, 5, 0)), .008, .2, 22)
    for i, c in enumerate(((.85, .2, .3), (.9, .8, .2), (.6, .4, .85))): strips('flowers%d' % i, material('petal%d' % i, c, .8), places(150, 30 + i, (-3, -.4, .16), (3, 3, .26)), .04, .05, 33 + i)
    o = strips('hedge', pattern('leaf', (.03, .12, .03), (.22, .36, .08), 9, rough=.5), places(9000, 24, (-6, 4.6, 0), (6, 5.4, 1.5)), .06, .12, 25)
    for i in range(15): add(P.primitive_cylinder_add, material('cane', (.65, .5, .28), .7), (-2.9 + .32 * i, 1.3 + .25 * (i % 3), .75), (.012, .012, .8), (.05 * (-1) ** i, .06 * (i % 4 - 1.5), 0))
    for i in range(26): add(P.primitive_cylinder_add, material('net', (.85, .85, .8), .8), (1.4 + .07 * i, 2.6, .7), (.006, .006, .7))
    for i in range(10): add(P.primitive_cylinder_add, material('net', (.85, .85, .8), .8), (2.3, 2.6, .14 * i + .07), (.006, .006, .9), (0, half, 0))
    for x in (-1.5, .1): add(P.primitive_cylinder_add, material('frame', (.45, .12, .1), .4), (x, .9, .9), (.035, .035, .9))
    add(P.primitive_cylinder_add, material('frame', (.45, .12, .1), .4), (-.7, .9, 1.8), (.035, .035, .85), (0, half, 0))
    pivot = bpy.data.objects.new('Pivot', None)
    scene.collection.objects.link(pivot)
    pivot.location = (-.7, .9, 1.8)
    for o in [add(P.primitive_cylinder_add, material('rope', (.7, .62, .45), .9), (x, 0, -.62), (.012, .012, .62)) for x in (-.28, .28)] + [add(P.primitive_cube_add, pattern('seat', (.3, .18, .08), (.6, .42, .2), 6, 'Wave'), (0, 0, -1.24), (.34, .15, .025))]: o.parent = pivot
    move(pivot, 'rotation_euler', [(1 + 4 * k, (.6 * math.sin(k * 1.1), 0, 0)) for k in range(13)])
    crown = strips('crown', pattern('crown', (.06, .2, .04), (.4, .5, .12), 7, rough=.6), [(x * (1 - .2 * z), y, z + 1.9) for x, y, z in places(1600, 27, (-.9, -.8, -.5), (.9, .8, .9))], .06, .11, 28)
    crown.location = (1.7, 3.4, 0)
    move(crown, 'rotation_euler', [(1 + 6 * k, (.025 * (-1) ** k, .02 * math.sin(k), .01 * k)) for k in range(9)])
    add(P.primitive_cylinder_add, pattern('trunk', (.14, .09, .06), (.32, .24, .17), 8), (1.7, 3.4, .85), (.1, .1, .9))
    ball = add(P.primitive_uv_sphere_add, material('ball', (.9, .25, .15), .3, checker=6), (0, 0, .22), (.17, .17, .17))
    move(ball, 'location', [(1, (1.9, .1, .2)), (48, (-1.5, .5, .2))])
    move(ball, 'rotation_euler', [(1, (0, 0, 0)), (48, (2, -14, 0))])
    light('SUN', (0, 0, 5), 3.4, .01, (math.radians(48), math.radians(22), 0), (1, .95, .85))
    eye, target = camera((0, -3, 1.25), (0, 2, .75), 30)
    move(eye, 'location', [(1, (.3, -3, 1.2)), (48, (-.3, -2.9, 1.3))])
    move(target, 'location', [(1, (1.2, 2, .75)), (48, (-1.2, 2, .75))])
elif name == 'workshop':    # indoors: rough metal everywhere, a robot's arm turns its joints and welds, boxes ride on a belt, a saw turns
    sky(.02, .025, .03)
    add(P.primitive_plane_add, pattern('floor', (.25, .26, .27), (.42, .41, .4), 3, rough=.35), (0, 0, 0), (5, 5, 1))
    add(P.primitive_plane_add, pattern('back', (.3, .35, .38), (.5, .54, .55), 12, 'Wave', rough=.5, metal=.9), (0, 3.2, 1.7), (5, 1.7, 1), (half, 0, 0))
    add(P.primitive_plane_add, material('right', (.65, .6, .45), .85), (3.4, 0, 1.7), (1.7, 5, 1), (0, half, 0))
    add(P.primitive_cube_add, pattern('belt', (.04, .04, .04), (.13, .13, .13), 10, 'Wave', rough=.6), (0, .7, .45), (3.6, .35, .05))
    for i in range(8): add(P.primitive_cylinder_add, material('roll', (.7, .7, .72), .3, 1), (-3.2 + .9 * i, .33, .45), (.05, .05, .04), (half, 0, 0))
    for i in range(8):
        o = add(P.primitive_cube_add, (pattern('card%d' % i, (.35, .24, .13), (.6, .45, .28), 3, 'Brick'), material('tin%d' % i, (.75, .75, .78), .28, 1), material('blue%d' % i, (.1, .25, .6), .3))[i % 3], (0, .7, .66), (.2, .2, .16), (0, 0, .3 * (i % 3)))
        move(o, 'location', [(1, (-4.4 + 1.05 * i, .7, .66)), (48, (-2.3 + 1.05 * i, .7, .66))])
    paint, steel = material('paint', (.85, .35, .05), .35), material('steel', (.6, .6, .62), .3, 1)
    add(P.primitive_cylinder_add, paint, (-.5, 1.8, .35), (.4, .4, .35))
    joint = []
    for i, at in enumerate(((-.5, 1.8, .75), (0, 0, 1.0), (0, 0, .85))):
        j = bpy.data.objects.new('Joint%d' % i, None)
        scene.collection.objects.link(j)
        j.location = at
        j.parent = joint[-1] if joint else None
        joint.append(j)
        for o in add(P.primitive_uv_sphere_add, steel, (0, 0, 0), (.17 - .03 * i,) * 3), add(P.primitive_cube_add, paint, (0, 0, (.5, .42, .2)[i]), (.11 - .02 * i, .13 - .02 * i, (.42, .34, .2)[i])): o.parent = j
    for j, size, pace in zip(joint, (.5, .9, .8), (.8, 1.1, 1.5)): move(j, 'rotation_euler', [(1 + 4 * k, (.55 * size + .25 * size * math.sin(pace * k), .7 * size * math.cos(.7 * pace * k), .2 * math.sin(k))) for k in range(13)])
    spark = light('POINT', (0, 0, .48), 0, .04, color=(.65, .8, 1))
    spark.parent = joint[2]
    for f in range(1, 49): spark.data.energy = (110, 60, 140, 90, 0, 120, 80)[f * 3 % 7]; spark.data.keyframe_insert('energy', frame=f)
    blade = add(P.primitive_cylinder_add, material('blade', (.75, .75, .76), .2, 1, checker=3), (1.9, 1.6, 1.05), (.42, .42, .012), (half, 0, 0), vertices=18)
    move(blade, 'rotation_euler', [(1, (half, 0, 0)), (48, (half, 21, 0))])
    add(P.primitive_cube_add, pattern('bench', (.18, .22, .2), (.3, .36, .32), 6, rough=.4, metal=.6), (1.9, 1.6, .4), (.7, .4, .4))
    for i in range(9): add(P.primitive_cylinder_add, material('pipe%d' % i, ((.75, .5, .3), (.7, .7, .72), (.35, .36, .38))[i % 3], .15 + .1 * (i % 3), 1), (-3 + .22 * i, 2.9, 1.5), (.045, .045, 1.5))
    for i in range(10): add(P.primitive_torus_add, material('gear%d' % i, (.6, .55, .45), .4, 1), (-2.2 + .17 * i, -.25 + .1 * (i % 3), .06), (.1, .1, .1), (.3 * (i % 3), .2 * (i % 4), 0))
    for i in range(3): add(P.primitive_cube_add, material('tube%d' % i, (.85, .95, 1), emit=24), (-2 + 2 * i, 1, 3), (.7, .04, .03))
    eye, target = camera((.4, -3.6, 1.7), (.1, 1.2, 1), 26)
    move(eye, 'location', [(1, (1.1, -3.5, 1.6)), (48, (-.4, -3.6, 1.8))])
elif name in ('horizon', 'screen', 'zoom', 'drips'):    # of bench/gauntlet.sh: a yard in which one thing is not in the vectors
    t, r = world.node_tree.nodes.new('ShaderNodeTexVoronoi' if name == 'horizon' else 'ShaderNodeTexGradient'), world.node_tree.nodes.new('ShaderNodeValToRGB')
    if name == 'horizon': t.inputs['Scale'].default_value = 9
    r.color_ramp.elements[0].color, r.color_ramp.elements[1].color = (.15, .25, .5, 1), (.75, .72, .65, 1)
    world.node_tree.links.new(world.node_tree.nodes.new('ShaderNodeTexCoord').outputs['Generated'], t.inputs['Vector'])
    world.node_tree.links.new(t.outputs['Distance' if name == 'horizon' else 'Fac'], r.inputs['Fac'])
    world.node_tree.links.new(r.outputs['Color'], world.node_tree.nodes['Background'].inputs[0])
    add(P.primitive_plane_add, material('ground', (.5, .48, .42), .9, checker=14), (0, 2, 0), (9, 9, 1))
    add(P.primitive_cube_add, material('crate', (.7, .25, .2), .7, checker=4), (-1.5, 1.2, .5), (.5, .5, .5), (0, 0, .5))
    add(P.primitive_cylinder_add, material('post', (.3, .6, .35), .5, checker=6), (1.7, 1.6, .9), (.25, .25, .9))
    ball = add(P.primitive_uv_sphere_add, material('ball', (.8, .75, .3), .6, checker=5), (-.6, 0, .4), (.4, .4, .4))
    move(ball, 'location', [(1, (-.8, 0, .4)), (48, (2, 0, .4))])
    light('AREA', (-2, -2, 4), 260, 1, (.5, -.4, 0))
    eye, target = camera((.2, -4, 1.5), (0, 2, 1), 30)
    if name == 'horizon': move(target, 'location', [(1, (-1, 2, 1)), (48, (6, 2, 1))])   # Cycles' vectors are 0 for the sky
    elif name == 'zoom': eye.data.keyframe_insert('lens', frame=1); eye.data.lens = 60; eye.data.keyframe_insert('lens', frame=48)
    elif name == 'screen':  # a film: coordinates of its texture jump in each frame
        m = material('film', (.8, .8, .8), .8)
        t, at = m.node_tree.nodes.new('ShaderNodeTexVoronoi'), m.node_tree.nodes.new('ShaderNodeMapping')
        t.inputs['Scale'].default_value = 4
        m.node_tree.links.new(m.node_tree.nodes.new('ShaderNodeTexCoord').outputs['Object'], at.inputs['Vector'])
        m.node_tree.links.new(at.outputs[0], t.inputs['Vector'])
        m.node_tree.links.new(t.outputs['Color'], m.node_tree.nodes['Principled BSDF'].inputs['Base Color'])
        add(P.primitive_plane_add, m, (.3, 2.4, 1.2), (1.2, .7, 1), (half, 0, 0))
        for f in range(1, 49): at.inputs['Location'].default_value = (.37 * f, .11 * f, 1.7 * f); at.inputs['Location'].keyframe_insert('default_value', frame=f)
        move(eye, 'location', [(1, (.2, -4, 1.5)), (48, (1.2, -4, 1.5))])
    else:                   # metaballs are another mesh in each frame, without vectors
        m = material('drop', (.6, .65, .75), .4)
        for i, (x, y, z) in enumerate(places(9, 5, (-2.2, 1, 1.4), (2.2, 2, 2.4))):
            bpy.ops.object.metaball_add(type='BALL', radius=.35, location=(x, y, z))
            o = bpy.context.object
            o.data.materials.append(m)
            move(o, 'location', [(1, (x, y, z)), (48, (-x, y, z + 1 - .2 * i))])
else: sys.exit('cycles_scenes.py: no scene ' + name)

def out_of_gamut(file):     # takes the linear colours for Rec.2020 and writes them as Rec.709, where pure ones have components below 0
    import numpy, OpenImageIO as oiio
    matrix = numpy.array([[1.660491, -.587641, -.07285], [-.12455, 1.1329, -.00835], [-.018151, -.100579, 1.11873]], numpy.float32)
    image = oiio.ImageInput.open(file)
    spec, pixels = image.spec(), image.read_image(oiio.FLOAT)
    image.close()
    at = {c: i for i, c in enumerate(spec.channelnames)}
    for c in at:
        if c.endswith('.R'):
            rgb = [at[c[:-1] + letter] for letter in 'RGB']
            pixels[..., rgb] = pixels[..., rgb] @ matrix.T
    to = oiio.ImageOutput.create(file)
    if not (to and to.open(file + '.part.exr', spec) and to.write_image(pixels) and to.close()): sys.exit('cannot write ' + file)
    os.replace(file + '.part.exr', file)
bpy.ops.render.render(animation=True)
if name == 'gamut':
    for f in range(first, last + 1): out_of_gamut(render.frame_path(frame=f))
