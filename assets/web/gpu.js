// WebGL 2 in the words of this page: textures on units, targets, meshes.

// A place as a matrix of viewOf() has it: x, y and w, by which they are divided.
function projected(clip, [x, y, z]) {
    return [0, 1, 3].map(row => clip[row] * x + clip[4 + row] * y + clip[8 + row] * z + clip[12 + row]);
}

class Gpu {
    constructor(gl) {
        this.gl = gl;
        this.noVertices = gl.createVertexArray();
        this.rectangles = gl.createVertexArray();
        this.corners = gl.createBuffer();
        gl.bindVertexArray(this.rectangles);
        gl.bindBuffer(gl.ARRAY_BUFFER, this.corners);
        this.attribute(0, 4, 16, 0, 1);
        gl.bindVertexArray(null);
    }

    // ---- textures ----

    bind(unit, texture) {
        this.gl.activeTexture(this.gl.TEXTURE0 + unit);
        this.gl.bindTexture(this.gl.TEXTURE_2D, texture);
    }

    // A texture on its unit.
    texture(unit, format, width, height, filter, data = null) {
        const {gl} = this, texture = gl.createTexture();
        this.bind(unit, texture);
        gl.texStorage2D(gl.TEXTURE_2D, 1, format, width, height);
        for (const which of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
            gl.texParameteri(gl.TEXTURE_2D, which, filter);
        this.clampToEdge();
        if (data) this.upload(unit, texture, width, height, data);
        return texture;
    }

    // The same with all its coarser levels.
    mipMapped(unit, format, width, height, data) {
        const {gl} = this, texture = gl.createTexture();
        this.bind(unit, texture);
        gl.texStorage2D(gl.TEXTURE_2D, Math.floor(Math.log2(Math.max(width, height))) + 1, format, width, height);
        this.upload(unit, texture, width, height, data);
        gl.generateMipmap(gl.TEXTURE_2D);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_NEAREST);
        return texture;
    }

    clampToEdge() {
        const {gl} = this;
        for (const which of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T])
            gl.texParameteri(gl.TEXTURE_2D, which, gl.CLAMP_TO_EDGE);
    }

    // Floats or bytes, of one to four parts, as the array's length has it. One byte alone is a whole number.
    upload(unit, texture, width, height, data) {
        const {gl} = this, parts = data.length / (width * height), isFloat = data instanceof Float32Array;
        this.bind(unit, texture);
        gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
        const format = [isFloat ? gl.RED : gl.RED_INTEGER, gl.RG, gl.RGB, gl.RGBA][parts - 1];
        gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, format, isFloat ? gl.FLOAT : gl.UNSIGNED_BYTE, data);
    }

    // ---- targets ----

    target(colours, depth = null) {
        const {gl} = this, target = gl.createFramebuffer(), attachment = i => gl.COLOR_ATTACHMENT0 + i;
        gl.bindFramebuffer(gl.FRAMEBUFFER, target);
        const attach = (to, texture) => gl.framebufferTexture2D(gl.FRAMEBUFFER, to, gl.TEXTURE_2D, texture, 0);
        colours.forEach((texture, i) => attach(attachment(i), texture));
        if (depth) attach(gl.DEPTH_ATTACHMENT, depth);
        gl.drawBuffers(colours.length > 0 ? colours.map((_, i) => attachment(i)) : [gl.NONE]);
        return target;
    }

    into(target, width, height) {
        const {gl} = this;
        gl.bindFramebuffer(gl.FRAMEBUFFER, target);
        gl.viewport(0, 0, width, height);
    }

    copy(from, to, width, height, what) {
        const {gl} = this;
        gl.bindFramebuffer(gl.READ_FRAMEBUFFER, from);
        gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, to);
        gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, what, gl.NEAREST);
    }

    // ---- meshes ----

    attribute(location, parts, stride, offset, divisor = 0) {
        const {gl} = this;
        gl.enableVertexAttribArray(location);
        gl.vertexAttribPointer(location, parts, gl.FLOAT, false, stride, offset);
        gl.vertexAttribDivisor(location, divisor);
    }

    // Vertices of some columns of numbers; `attributes`: how many of them are one attribute each. With `divisor` 1, each
    // row is an instance.
    vertices(columns, attributes, divisor = 0) {
        const {gl} = this, width = columns.length, numbers = new Float32Array(width * columns[0].length);
        columns.forEach((column, k) => column.forEach((value, i) => numbers[width * i + k] = value));
        return this.interleaved(numbers, attributes, divisor).array;
    }

    // The same of numbers vertex after vertex.
    interleaved(numbers, attributes, divisor = 0) {
        const {gl} = this, width = attributes.reduce((sum, parts) => sum + parts, 0);
        const array = gl.createVertexArray(), buffer = gl.createBuffer();
        gl.bindVertexArray(array);
        gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
        gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.STATIC_DRAW);
        let first = 0;
        attributes.forEach((parts, location) => {
            this.attribute(location, parts, 4 * width, 4 * first, divisor);
            first += parts;
        });
        gl.bindVertexArray(null);
        return {array, buffer};
    }

    // Triangles of the vertices of an array; by default they have no attributes but their numbers.
    mesh(indices, array = this.gl.createVertexArray()) {
        const {gl} = this;
        gl.bindVertexArray(array);
        gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
        gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.STATIC_DRAW);
        gl.bindVertexArray(null);
        return {array, count: indices.length};
    }

    // Triangles that change from picture to picture; `attributes` as in vertices().
    growing(attributes) {
        const {gl} = this, {array, buffer} = this.interleaved(new Float32Array(0), attributes), elements = gl.createBuffer();
        gl.bindVertexArray(array);
        gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, elements);
        gl.bindVertexArray(null);
        return {array, buffer, elements, count: 0};
    }

    refill(mesh, numbers, indices) {
        const {gl} = this;
        gl.bindVertexArray(mesh.array);
        gl.bindBuffer(gl.ARRAY_BUFFER, mesh.buffer);
        gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.STREAM_DRAW);
        gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.STREAM_DRAW);
        gl.bindVertexArray(null);
        mesh.count = indices.length;
    }

    // ---- drawing ----

    // Calls `draw` with some tests on; they are off everywhere else.
    enabled(tests, draw) {
        for (const test of tests) this.gl.enable(test);
        draw();
        for (const test of tests) this.gl.disable(test);
    }

    drawMesh(shader, {array, count}) {
        const {gl} = this;
        shader.use();
        gl.bindVertexArray(array);
        gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_INT, 0);
    }

    // Draws vertices that have no attributes but their numbers.
    drawNumbers(shader, first, count) {
        const {gl} = this;
        if (count === 0) return;
        shader.use();
        gl.bindVertexArray(this.noVertices);
        gl.drawArrays(gl.TRIANGLES, first, count);
    }

    // One triangle that covers the target.
    fill(shader) {
        this.drawNumbers(shader, 0, 3);
    }

    // Rectangles of the target: left, bottom, right, top of each, from −1 to 1.
    drawRectangles(shader, corners) {
        const {gl} = this;
        if (corners.length === 0) return;
        shader.use();
        gl.bindVertexArray(this.rectangles);
        gl.bindBuffer(gl.ARRAY_BUFFER, this.corners);
        gl.bufferData(gl.ARRAY_BUFFER, Float32Array.from(corners), gl.STREAM_DRAW);
        gl.drawArraysInstanced(gl.TRIANGLES, 0, 6, corners.length / 4);
    }
}
