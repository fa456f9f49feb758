// The embedded pictures, decoded when first asked for.

async function decode_picture(index) {
    const image = new Image();
    image.src = by_id(`picture-${index}`).textContent;
    try {
        await image.decode();
        // A bitmap stays decoded; an image's pixels may be dropped by the browser and would then make the next draw stutter.
        return await createImageBitmap(image);
    } catch {
        return null;
    }
}

/// Keeps the pictures used last, as a whole sequence would not fit in memory.
class PictureStore {
    constructor(capacity) {
        this.capacity = capacity;
        this.kept = new Map();
    }

    load(index) {
        const picture = this.kept.get(index) ?? decode_picture(index);
        // A map iterates in the order of insertion: putting the entry at its end marks it as used last.
        this.kept.delete(index);
        this.kept.set(index, picture);
        while (this.kept.size > this.capacity) this.drop_oldest();
        return picture;
    }

    drop_oldest() {
        const [index, picture] = this.kept.entries().next().value;
        this.kept.delete(index);
        picture.then(bitmap => bitmap?.close());
    }
}

/// How many pictures to keep. Four frames' worth is the least: one is shown, one is on its way, one is fetched ahead.
function store_capacity(size, kind_count) {
    const budget = 600e6;
    return Math.max(4 * kind_count, Math.floor(budget / (4 * size.width * size.height)));
}
