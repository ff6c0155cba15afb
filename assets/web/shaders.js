// Shaders: the program's own files as WebGL 2 compiles them.
const kHead = '#version 300 es\n' + ['float', 'int', 'sampler2D', 'sampler2DArray', 'usampler2D']
    .map(type => `precision highp ${type};\n`).join('');
// 32-bit floats that not every device can filter.
const kFilteredByHand = /\btexture\((sun_ceiling|shade_map),/g;

// One program. It compiles in the background until it is first used.
class Shader {
    constructor(gl, files, constants, vertex, fragment, out) {
        this.gl = gl;
        this.files = files;
        this.constants = constants;
        this.name = fragment[fragment.length - 1];
        this.units = new Map();
        this.program = gl.createProgram();
        this.stages = [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]].map(([kind, list]) => {
            const stage = gl.createShader(kind);
            gl.shaderSource(stage, this.translate(list, out));
            gl.compileShader(stage);
            gl.attachShader(this.program, stage);
            return stage;
        });
        gl.linkProgram(this.program);
    }

    // Units and slots are set by name later; `out` is which of two colours for one target is kept.
    translate(list, out) {
        const text = list.map(name => this.files(name)).join('\n')
            .replace(/layout\(std140, binding = \w+\)/g, 'layout(std140)')
            .replace(/layout\(binding = (\w+)\) (uniform \w+ (\w+);)/g, (_, slot, rest, sampler) => {
                this.units.set(sampler, this.constants[slot]);
                return rest;
            })
            .replace(/layout\(location = \d\) uniform/g, 'uniform')
            .replace(/layout\(location = 0, index = (\d)\) out /g, (_, index) => Number(index) === out ? 'out ' : '');
        const filtered = text.replace(kFilteredByHand, 'bilinear($1,');
        return kHead + (filtered === text ? '' : this.files('bilinear.glsl')) + filtered;
    }

    use() {
        const gl = this.gl;
        if (this.stages) this.finish();
        gl.useProgram(this.program);
    }

    finish() {
        const gl = this.gl;
        if (!gl.getProgramParameter(this.program, gl.LINK_STATUS) && !gl.isContextLost()) {
            const logs = [...this.stages.map(stage => gl.getShaderInfoLog(stage)), gl.getProgramInfoLog(this.program)];
            const [fact] = logs.join('').split('\n');
            throw new Error(`The graphics driver of this browser does not compile ${this.name}: ${fact}`);
        }
        for (const stage of this.stages) gl.deleteShader(stage);
        this.stages = null;
        gl.useProgram(this.program);
        for (const [sampler, unit] of this.units) gl.uniform1i(this.at(sampler), unit);
        for (const [block, slot] of [['Frame', this.constants.SLOT_FRAME], ['Powder', this.constants.SLOT_POWDER]]) {
            const index = gl.getUniformBlockIndex(this.program, block);
            if (index !== gl.INVALID_INDEX) gl.uniformBlockBinding(this.program, index, slot);
        }
    }

    at(uniform) { return this.gl.getUniformLocation(this.program, uniform); }
}

class Shaders {
    // `files`: the text of a file by its name.
    constructor(gl, files) {
        this.gl = gl;
        this.files = files;
        this.parallel = gl.getExtension('KHR_parallel_shader_compile');
        this.all = [];
        this.constants = {};
        for (const [, name, value] of files('slots.glsl').matchAll(/^#define (\w+) ([\w.]+)/gm))
            this.constants[name] = this.constants[value] ?? Number(value);
    }

    // Starts to compile a program from lists of files.
    add(vertex, fragment, out = 0) {
        const shader = new Shader(this.gl, this.files, this.constants, vertex, fragment, out);
        this.all.push(shader);
        return shader;
    }

    // Waits until all are compiled, and leaves the browser free meanwhile.
    async ready() {
        const {gl, parallel} = this;
        const isPending = ({program}) => !gl.getProgramParameter(program, parallel.COMPLETION_STATUS_KHR);
        while (parallel && !gl.isContextLost() && this.all.some(isPending))
            await new Promise(resolve => setTimeout(resolve, 4));
        for (const shader of this.all) if (shader.stages) shader.finish();
    }
}
