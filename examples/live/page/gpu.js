// Denoises by WebGPU: dispatches the shaders that quell-shaders has made, as plan.json says.
"use strict";

/// What each pass takes on the device. Browsers may round it, to 0.1 ms.
class GpuClock {
    constructor(device, passes) {
        const bytes = 16 * passes; // two numbers of 64 bits
        this.queries = device.createQuerySet({type: "timestamp", count: 2 * passes});
        this.resolved = device.createBuffer({size: bytes, usage: GPUBufferUsage.QUERY_RESOLVE | GPUBufferUsage.COPY_SRC});
        this.back = device.createBuffer({size: bytes, usage: GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST});
        this.bytes = bytes;
    }

    /// How pass i begins.
    around(i) { return {timestampWrites: {querySet: this.queries, beginningOfPassWriteIndex: 2 * i, endOfPassWriteIndex: 2 * i + 1}}; }

    /// Behind the last pass.
    resolve(encoder) {
        encoder.resolveQuerySet(this.queries, 0, this.bytes / 8, this.resolved, 0);
        encoder.copyBufferToBuffer(this.resolved, 0, this.back, 0, this.bytes);
    }

    /// Milliseconds for each name, once the device is done.
    async times(names) {
        await this.back.mapAsync(GPUMapMode.READ);
        const stamps = new BigInt64Array(this.back.getMappedRange().slice(0)); // nanoseconds
        this.back.unmap();
        const sums = new Map();
        names.forEach((name, i) => sums.set(name, (sums.get(name) ?? 0) + Number(stamps[2 * i + 1] - stamps[2 * i]) / 1e6));
        return Array.from(sums, ([name, ms]) => ({name, ms}));
    }
}

class GpuDenoiser {
    /// Null without WebGPU or without shaders.
    static async make(shaders) {
        const adapter = shaders && await navigator.gpu?.requestAdapter();
        const requiredFeatures = ["timestamp-query"].filter(feature => adapter?.features.has(feature));
        const device = await adapter?.requestDevice({requiredFeatures});
        if (!device) return null;
        const made = new GpuDenoiser();
        made.device = device;
        made.plan = shaders.plan;
        made.clock = requiredFeatures.length ? new GpuClock(device, shaders.plan.passes.length) : null;
        made.times = []; // of the last frame's passes: names and milliseconds
        await made.compile(shaders.texts);
        return made;
    }

    async compile(texts) {
        const {plan, device} = this;
        const types = new Map(plan.buffers.map(({name, access}) => [name, {read: "read-only-storage", read_write: "storage"}[access]]));
        const pipelines = new Map(); // by the shader's name
        const compiled = (name, layout) => {
            if (!pipelines.has(name)) pipelines.set(name, device.createComputePipelineAsync({
                layout, compute: {module: device.createShaderModule({code: texts[name]}), entryPoint: plan.entry_point},
            }));
            return pipelines.get(name);
        };
        this.passes = await Promise.all(plan.passes.map(async ({shader, first = shader, fraction, reads, writes}) => {
            // What the pass uses and no more: devices bind few buffers at once.
            const used = plan.buffers.filter(({name}) => reads.includes(name) || writes.includes(name));
            const entry = (binding, type) => ({binding, visibility: GPUShaderStage.COMPUTE, buffer: {type}});
            const entries = [entry(plan.uniforms.binding, "uniform"), ...used.map(({name, binding}) => entry(binding, types.get(name)))];
            const layout = device.createBindGroupLayout({entries});
            const of_pipeline = device.createPipelineLayout({bindGroupLayouts: [layout]});
            const [later, at_first] = await Promise.all([shader, first].map(name => compiled(name, of_pipeline)));
            return {fraction, used, layout, later, first: at_first};
        }));
        this.uniforms = device.createBuffer({size: plan.uniforms.bytes, usage: GPUBufferUsage.UNIFORM | GPUBufferUsage.COPY_DST});
        this.buffers = {};
    }

    resize(width, height) {
        const {device, plan} = this;
        this.width = width;
        this.height = height;
        this.plane = 4 * width * height; // bytes
        for (const buffer of Object.values(this.buffers)) buffer.destroy();
        this.buffers = {};
        for (const {name, slots} of plan.buffers)
            this.buffers[name] = device.createBuffer({size: Math.max(slots, 1) * this.plane, usage: GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_DST | GPUBufferUsage.COPY_SRC});
        this.buffers.back = device.createBuffer({size: plan.picture.length * this.plane, usage: GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST});
        // What a buffer becomes in the next frame changes places with it.
        const resource = name => ({buffer: this.buffers[name]});
        for (const pass of this.passes)
            pass.groups = [0, 1].map(odd => device.createBindGroup({layout: pass.layout, entries: [
                {binding: plan.uniforms.binding, resource: {buffer: this.uniforms}},
                ...pass.used.map(({name, binding, becomes}) => ({binding, resource: resource(odd && becomes || name)})),
            ]}));
        this.forget();
    }

    /// Starts anew, as behind a cut.
    forget() { this.frame = 0; }

    /// Gives a plane of an input, as floats without padding.
    set_input({buffer, slot}, floats) { this.device.queue.writeBuffer(this.buffers[buffer], slot * this.plane, floats); }

    /// The block of uniforms of a preset that needs no camera. The jitter is of this frame, x and y, and of the one before.
    block(jitter = [0, 0, 0, 0]) {
        const {bytes, members} = this.plan.uniforms, block = new DataView(new ArrayBuffer(bytes));
        const put = (name, put_number, numbers) => {
            const {offset} = members.find(member => member.name === name);
            numbers.forEach((number, i) => block[put_number](offset + 4 * i, number, true));
        };
        put("size", "setInt32", [this.width, this.height, this.frame]);
        put("jitter", "setFloat32", jitter);
        return block;
    }

    /// Denoises the inputs, and resolves to the picture's planes.
    async run(block = this.block()) {
        const {device, plan} = this;
        device.queue.writeBuffer(this.uniforms, 0, block);
        const encoder = device.createCommandEncoder();
        for (const [i, {fraction, groups, first, later}] of this.passes.entries()) {
            const pass = encoder.beginComputePass(this.clock?.around(i));
            pass.setBindGroup(0, groups[this.frame % 2]);
            pass.setPipeline(this.frame === 0 ? first : later);
            const [across, down] = [this.width, this.height].map((pixels, i) => Math.ceil(Math.ceil(pixels / fraction) / plan.workgroup[i]));
            pass.dispatchWorkgroups(across, down);
            pass.end();
        }
        this.clock?.resolve(encoder);
        plan.picture.forEach(({buffer, slot}, i) => encoder.copyBufferToBuffer(this.buffers[buffer], slot * this.plane, this.buffers.back, i * this.plane, this.plane));
        device.queue.submit([encoder.finish()]);
        ++this.frame;
        const {back} = this.buffers;
        await back.mapAsync(GPUMapMode.READ);
        const floats = new Float32Array(back.getMappedRange().slice(0));
        back.unmap();
        if (this.clock) this.times = await this.clock.times(plan.passes.map(({name}) => name));
        return floats;
    }
}
