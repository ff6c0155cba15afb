// As in render/frame/make_frame_block.cpp.
const kFinishedRows = 1440;
const kMostCoarse = 1.5;

// The uniforms of the frame: the bytes that the program has sent along, with what changes from picture to picture.
class FrameBlock {
    constructor(gpu, slide, slots) {
        const {gl} = gpu;
        this.gl = gl;
        this.slots = slots;
        this.bytes = Uint8Array.from(atob(slide.info.frame), letter => letter.charCodeAt(0)).buffer;
        // Where each member lies. C++ and std140 have them one after another.
        this.places = {};
        let at = 0;
        const members = slide.file('frame.glsl').matchAll(/^\s+(mat4|i?vec4) (\w+)(?:\[(\w+)\])?;/gm);
        for (const [, type, name, count] of members) {
            this.places[name] = at;
            at += (type === 'mat4' ? 64 : 16) * (count ? slots[count] : 1);
        }
        this.buffer = gl.createBuffer();
        gl.bindBuffer(gl.UNIFORM_BUFFER, this.buffer);
        gl.bufferData(gl.UNIFORM_BUFFER, this.bytes, gl.DYNAMIC_DRAW);
        gl.bindBufferBase(gl.UNIFORM_BUFFER, slots.SLOT_FRAME, this.buffer);
    }

    // A member's numbers, to read and to write.
    floats(member, count = 4) {
        return new Float32Array(this.bytes, this.places[member], count);
    }

    integers(member) {
        return new Int32Array(this.bytes, this.places[member], 4);
    }

    get sun() {
        return [...this.floats('sun', 3)];
    }

    // `view`: of viewOf(). `samples`: per pixel of the screen along an edge.
    setView({clip, eye, forward, right, up, near, pixel}, samples) {
        this.floats('clip_from_world', 16).set(clip);
        this.floats('eye').set(eye);  // and keeps its w
        this.floats('ray_forward').set([...forward, near]);
        this.floats('ray_middle').set(forward);
        this.floats('ray_right').set(right);
        this.floats('ray_up').set(up);
        this.floats('material').set([pixel, samples], 1);
        const rows = 2 * Math.hypot(...up) / pixel;  // of samples
        this.floats('lower_rolling').set([Math.min(Math.max(Math.log2(kFinishedRows / rows), 0), kMostCoarse)], 3);
    }

    // `overlay`: of slide.info.overlays, or null; `stops`: four numbers each.
    setOverlay(overlay, stops) {
        const kind = this.slots.OVERLAY_SPEED;  // shaders ask only whether there is one
        this.integers('overlay').set(overlay ? [kind, overlay.stops.length, overlay.stepped ? 1 : 0] : [0, 0, 0]);
        if (overlay) this.floats('stops', stops.length).set(stops);
    }

    // `point`: of the ground, m; null: none.
    setRing(point) {
        this.floats('ring').set(point ? [point.x, point.y, point.radius, 1] : [0, 0, 0, 0]);
        if (point) this.floats('ring_colour').set(point.colour);
    }

    // `extent`: of what a ghost had reached, or none.
    setExtent(extent) {
        this.floats('contours')[2] = extent ? 1 : 0;
    }

    send() {
        const {gl} = this;
        gl.bindBuffer(gl.UNIFORM_BUFFER, this.buffer);
        gl.bufferSubData(gl.UNIFORM_BUFFER, 0, this.bytes);
    }
}
