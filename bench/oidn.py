# Denoises EXR frames by a network of Open Image Denoise, frame by frame; bench/oidn.sh calls it and says how.
#   oidn.py WEIGHTS_FOLDER base|large IN_PATTERN OUT_PATTERN [FIRST LAST [THREADS]]
# base is rt_hdr_alb_nrm on guides as they are, large rt_hdr_calb_cnrm_large on guides denoised by rt_alb_large and rt_nrm_large first.
# The network is a U-Net of 3x3 convolutions with ReLU, maxima of 2x2 on the way down and the nearest sample on the way up (Afra 2019 to 2024,
# "Intel Open Image Denoise", openimagedenoise.org): the weights' names say which layers there are. Colour goes through a fit to the PU2 curve
# (Aydin et al. 2008) at an exposure that brings the mean of log luminance to .18; the fit's constants are part of the trained weights.
# Wants apt's python3-torch, python3-numpy and python3-openimageio. Prints "milliseconds per frame: N" at the end, files not counted.
import os, struct, sys, time
import numpy, torch
import OpenImageIO as oiio
from torch.nn.functional import conv2d, interpolate, max_pool2d, pad, relu


def weights(path):
    """Tensors of a .tza file: a table of name, shape and place, and 16-bit or 32-bit numbers in the order oihw."""
    data, tensors = open(path, 'rb').read(), {}
    magic, _, _, at = struct.unpack_from('<HBBQ', data)
    if magic != 0x41D7: sys.exit('oidn.py: no weights: ' + path)
    count, = struct.unpack_from('<I', data, at)
    at += 4
    for _ in range(count):
        length, = struct.unpack_from('<H', data, at)
        name, at = data[at + 2:at + 2 + length].decode(), at + 2 + length
        rank = data[at]
        shape = struct.unpack_from('<%dI' % rank, data, at + 1)
        kind, place = struct.unpack_from('<cQ', data, at + 1 + 5 * rank)
        at += 10 + 5 * rank
        numbers = numpy.frombuffer(data, {b'f': '<f4', b'h': '<f2'}[kind], int(numpy.prod(shape)), place)
        tensors[name] = torch.from_numpy(numbers.reshape(shape).astype(numpy.float32))
    return tensors


def network(tensors):
    """A function of an image of size 1 x channels x height x width."""
    names = [n[:-7] for n in tensors if n.endswith('.weight')]
    def layers(x, start, last=None):
        for n in sorted(n for n in names if n.startswith(start)):
            x = conv2d(x, tensors[n + '.weight'], tensors[n + '.bias'], padding=1)
            if n != last: x = relu(x)
        return x
    large = 'enc_conv1a' in names
    def run(image):
        height, width = image.shape[2:]
        x = pad(image, (0, -width % 16, 0, -height % 16))
        kept = [x]
        for level in range(1, 5):
            if level == 1 and not large: x = layers(x, 'enc_conv0')
            x = max_pool2d(layers(x, 'enc_conv%d' % level), 2)
            kept.append(x)
        x = layers(kept.pop(), 'enc_conv5')
        last = 'dec_conv1c' if large else 'dec_conv0'
        for level in range(4, 0, -1): x = layers(torch.cat((interpolate(x, scale_factor=2, mode='nearest'), kept.pop()), 1), 'dec_conv%d' % level, last)
        if not large: x = layers(x, last, last)
        return x[:, :, :height, :width]
    return run


class Curve:
    """How bright a number looks: PU2 over three ranges, 1 at the largest 16-bit number."""
    a, b, c, d, e, f, g = 1412.83765, 1.64593172, .431384981, -.00294139609, .192653254, .00626026094, .998620152
    scale = 1 / (e * numpy.log(65504 + f) + g)
    def forward(s, y): return s.scale * torch.where(y <= 1.5794576e-6, s.a * y, torch.where(y <= .0322087631, s.b * y.clamp(1e-9) ** s.c + s.d, s.e * (y + s.f).log() + s.g))
    def inverse(s, x):
        x = x / s.scale
        return torch.where(x <= .00223151711, x / s.a, torch.where(x <= .370974749, ((x - s.d) / s.b).clamp(1e-9) ** (1 / s.c), ((x - s.g) / s.e).exp() - s.f))


class Display:    # sRGB, which albedo is denoised in
    def forward(s, y): return torch.where(y <= .0031308, 12.92 * y, 1.055 * y.clamp(1e-9) ** (1 / 2.4) - .055)
    def inverse(s, x): return torch.where(x <= .04045, x / 12.92, ((x.clamp(1e-9) + .055) / 1.055) ** 2.4)


def exposure(color):
    """.18 over the geometric mean of luminance, that of blocks of about 16x16 pixels."""
    y = (color * torch.tensor([.212671, .71516, .072169]).view(1, 3, 1, 1)).sum(1, True)
    y = torch.nn.functional.adaptive_avg_pool2d(y, [max(1, (n + 8) // 16) for n in y.shape[2:]])
    y = y[y > 1e-8]
    return .18 / 2 ** float(y.log2().mean()) if y.numel() else 1.


class Denoiser:
    def __init__(self, folder, kind):
        load = lambda name: network(weights(os.path.join(folder, name + '.tza')))
        self.clean = kind == 'large'
        self.color = load('rt_hdr_calb_cnrm_large' if self.clean else 'rt_hdr_alb_nrm')
        if self.clean: self.albedo, self.normal = load('rt_alb_large'), load('rt_nrm_large')
    def __call__(self, color, albedo, normal):
        color, albedo, normal = (torch.nan_to_num(x).clamp(*r) for x, r in ((color, (0, 65504)), (albedo, (0, 1)), (normal, (-1, 1))))
        normal = normal * .5 + .5
        if self.clean:
            albedo = Display().inverse(self.albedo(Display().forward(albedo))).clamp(0, 1)
            normal = self.normal(normal).clamp(0, 1)
        by = exposure(color)
        seen = self.color(torch.cat((Curve().forward(color * by), albedo, normal), 1))
        return Curve().inverse(seen.clamp(0)) / by


def read(path):
    file = oiio.ImageInput.open(path)
    if not file: sys.exit('oidn.py: cannot read ' + path)
    spec, pixels = file.spec(), file.read_image(oiio.FLOAT)
    file.close()
    at = {name: i for i, name in enumerate(spec.channelnames)}
    def layer(names, letters='RGB'):
        for name in names:
            for letters in (letters, letters.lower()):
                found = [(name + '.' if name else '') + c for c in letters]
                if all(c in at for c in found): return torch.from_numpy(pixels[..., [at[c] for c in found]].transpose(2, 0, 1)[None].copy())
        return None
    nothing = torch.zeros(1, 3, spec.height, spec.width)
    cycles = lambda *names: sum((x for x in (layer(['ViewLayer.' + n]) for n in names) if x is not None), nothing)
    color, albedo, normal = layer(['ViewLayer.Combined', '']), layer(['albedo']), layer(['ViewLayer.Normal', 'normal', 'N'], 'XYZ')
    if color is None: sys.exit('oidn.py: no R, G, B in ' + path)
    # What shines, and what lies behind everything, is its own albedo.
    if albedo is None: albedo = cycles('DiffCol', 'GlossCol', 'TransCol') + cycles('Emit', 'Env').clamp(0, 1)
    return color, albedo, nothing if normal is None else normal


def write(path, color):
    pixels = numpy.ascontiguousarray(color[0].numpy().transpose(1, 2, 0))
    file = oiio.ImageOutput.create(path)
    if not (file and file.open(path, oiio.ImageSpec(pixels.shape[1], pixels.shape[0], 3, oiio.HALF)) and file.write_image(pixels) and file.close()):
        sys.exit('oidn.py: cannot write ' + path)


def main(folder, kind, source, to, first=None, last=None, threads=None):
    if threads: torch.set_num_threads(int(threads))
    numbers = range(int(first), int(last) + 1) if first else [n for n in range(10000) if os.path.exists(source % n)]
    denoise, times = Denoiser(folder, kind), []
    for number in numbers:
        frame = read(source % number)
        with torch.no_grad():
            begin = time.perf_counter()
            clean = denoise(*frame)
            times.append(time.perf_counter() - begin)
        write(to % number, clean)
    print('milliseconds per frame: %.1f' % (1000 * sorted(times)[len(times) // 2]))


if __name__ == '__main__':
    if len(sys.argv) < 5: sys.exit('oidn.py: WEIGHTS_FOLDER base|large IN_PATTERN OUT_PATTERN [FIRST LAST [THREADS]]')
    main(*sys.argv[1:])
