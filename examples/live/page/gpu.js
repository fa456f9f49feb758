// Denoises by WebGPU: dispatches the shaders that quell-shaders has made, as plan.json says.
"use strict";

class GpuDenoiser {
    /// Null without WebGPU or without shaders.
    static async make(shaders) {
        const adapter = shaders && await navigator.gpu?.requestAdapter();
        const device = await adapter?.requestDevice();
        if (!device) return null;
        const made = new GpuDenoiser();
        made.device = device;
        made.plan = shaders.plan;
        await made.compile(shaders.texts);
        return made;
    }

    async compile(texts) {
        const {plan, device} = this;
        const kind = {read: "read-only-storage", read_write: "storage"};
        const bindings = plan.buffers.map(({binding, access}) => ({binding, type: kind[access]}));
        bindings.push({binding: plan.uniforms.binding, type: "uniform"});
        this.layout = device.createBindGroupLayout({
            entries: bindings.map(({binding, type}) => ({binding, visibility: GPUShaderStage.COMPUTE, buffer: {type}})),
        });
        const layout = device.createPipelineLayout({bindGroupLayouts: [this.layout]});
        const pipelines = new Map(); // by the shader's name
        const compiled = name => {
            if (!pipelines.has(name)) pipelines.set(name, device.createComputePipelineAsync({
                layout, compute: {module: device.createShaderModule({code: texts[name]}), entryPoint: plan.entry_point},
            }));
            return pipelines.get(name);
        };
        this.passes = await Promise.all(plan.passes.map(async ({shader, first = shader, fraction}) => {
            const [later, at_first] = await Promise.all([shader, first].map(compiled));
            return {fraction, later, first: at_first};
        }));
        this.uniforms = device.createBuffer({size: plan.uniforms.bytes, usage: GPUBufferUsage.UNIFORM | GPUBufferUsage.COPY_DST});
        this.buffers = {};
    }

    resize(width, height) {
        this.width = width;
        this.height = height;
        this.plane = 4 * width * height; // bytes
        for (const buffer of Object.values(this.buffers)) buffer.destroy();
        this.buffers = {};
        for (const {name, slots} of this.plan.buffers)
            this.buffers[name] = this.device.createBuffer({size: Math.max(slots, 1) * this.plane, usage: GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_DST | GPUBufferUsage.COPY_SRC});
        this.buffers.back = this.device.createBuffer({size: this.plan.picture.length * this.plane, usage: GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST});
        // What a buffer becomes in the next frame changes places with it.
        const resource = name => ({buffer: this.buffers[name]});
        this.groups = [0, 1].map(odd => this.device.createBindGroup({layout: this.layout, entries: [
            {binding: this.plan.uniforms.binding, resource: {buffer: this.uniforms}},
            ...this.plan.buffers.map(({name, binding, becomes}) => ({binding, resource: resource(odd && becomes || name)})),
        ]}));
        this.forget();
    }

    /// Starts anew, as behind a cut.
    forget() { this.frame = 0; }

    /// Gives a plane of an input, as floats without padding.
    set_input({slot}, floats) { this.device.queue.writeBuffer(this.buffers.inputs, slot * this.plane, floats); }

    /// The block of uniforms of a preset that needs no camera, without jitter.
    block() {
        const {bytes, members} = this.plan.uniforms, block = new Int32Array(bytes / 4);
        block.set([this.width, this.height, this.frame], members.find(({name}) => name === "size").offset / 4);
        return block;
    }

    /// Denoises the inputs, and resolves to the picture's planes.
    async run(block = this.block()) {
        const {device, plan} = this;
        device.queue.writeBuffer(this.uniforms, 0, block);
        const encoder = device.createCommandEncoder();
        const pass = encoder.beginComputePass();
        pass.setBindGroup(0, this.groups[this.frame % 2]);
        for (const {fraction, first, later} of this.passes) {
            pass.setPipeline(this.frame === 0 ? first : later);
            const [across, down] = [this.width, this.height].map((pixels, i) => Math.ceil(Math.ceil(pixels / fraction) / plan.workgroup[i]));
            pass.dispatchWorkgroups(across, down);
        }
        pass.end();
        plan.picture.forEach(({slot}, i) => encoder.copyBufferToBuffer(this.buffers.picture, slot * this.plane, this.buffers.back, i * this.plane, this.plane));
        device.queue.submit([encoder.finish()]);
        ++this.frame;
        const {back} = this.buffers;
        await back.mapAsync(GPUMapMode.READ);
        const floats = new Float32Array(back.getMappedRange().slice(0));
        back.unmap();
        return floats;
    }
}
