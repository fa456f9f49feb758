// Drawing pictures into canvases, and reading their pixels.

/// Makes the canvas as fine as the screen, clears it, and returns its context with the size and the scale to draw in.
function begin_canvas(canvas) {
    const ratio = window.devicePixelRatio;
    const width = Math.round(canvas.clientWidth * ratio);
    const height = Math.round(canvas.clientHeight * ratio);
    // Setting the size throws the buffer away, so it is set only where it changes.
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, {width, height});
    const context = canvas.getContext("2d");
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, width, height);
    return {context, ratio, width, height};
}

/// Draws the bitmap, or says why there is none, in the canvas's part between two x.
function draw_layer(target, viewport, box, bitmap, absence, from, to) {
    const {context, ratio, height} = target;
    context.save();
    context.beginPath();
    context.rect(from, 0, to - from, height);
    context.clip();
    if (bitmap) draw_bitmap(context, ratio, viewport, box, bitmap);
    else draw_absence(context, ratio, absence, from, to, height);
    context.restore();
}

function draw_bitmap(context, ratio, viewport, box, bitmap) {
    const place = viewport.placement(box);
    const scale = place.scale * ratio;
    // Smoothing helps pictures that are made smaller; where a pixel is seen as a square, it would hide what was rendered.
    context.imageSmoothingEnabled = scale < 1 || (scale > 1 && scale < 2);
    context.imageSmoothingQuality = "high";
    // Whole pixels as the corners: else even an unscaled picture would be blurred, and one that fits would leave a dim seam.
    const [left, top] = [Math.round(place.x * ratio), Math.round(place.y * ratio)];
    const right = Math.round(place.x * ratio + viewport.size.width * scale);
    const bottom = Math.round(place.y * ratio + viewport.size.height * scale);
    context.drawImage(bitmap, left, top, right - left, bottom - top);
}

function draw_absence(context, ratio, absence, from, to, height) {
    context.fillStyle = getComputedStyle(document.documentElement).getPropertyValue("--on-screen");
    context.font = `${13 * ratio}px system-ui, sans-serif`;
    context.textAlign = "center";
    context.textBaseline = "middle";
    if (to - from > 60 * ratio) context.fillText(absence, (from + to) / 2, height / 2, to - from - 12 * ratio);
}

/// Outlines the pixel that the pointer is at, in the other views than the one with the pointer.
function draw_marker(target, viewport, box, view) {
    if (!viewport.pointed || viewport.pointed.view === view) return;
    const {context, ratio} = target;
    const place = viewport.placement(box);
    const side = Math.max(place.scale, 7);
    const x = (place.x + (viewport.pointed.x + 0.5) * place.scale - side / 2) * ratio;
    const y = (place.y + (viewport.pointed.y + 0.5) * place.scale - side / 2) * ratio;
    context.lineWidth = 3 * ratio;
    context.strokeStyle = "#000a";
    context.strokeRect(x, y, side * ratio, side * ratio);
    context.lineWidth = ratio;
    context.strokeStyle = "#fff";
    context.strokeRect(x, y, side * ratio, side * ratio);
}

const probe = Object.assign(document.createElement("canvas"), {width: 1, height: 1}).getContext("2d", {willReadFrequently: true});

/// The pixel's red, green and blue; pictures of another size than the report's are read where they are drawn.
function read_pixel(bitmap, size, pixel) {
    const x = Math.floor((pixel.x + 0.5) * bitmap.width / size.width);
    const y = Math.floor((pixel.y + 0.5) * bitmap.height / size.height);
    probe.clearRect(0, 0, 1, 1);
    probe.drawImage(bitmap, x, y, 1, 1, 0, 0, 1, 1);
    return [...probe.getImageData(0, 0, 1, 1).data.slice(0, 3)];
}
