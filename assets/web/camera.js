// The camera: where it is, how hands move it, and what it sees. Metres: x east and y north from vertex (0, 0), z up,
// above the datum.

const kDegree = Math.PI / 180;
const kLowestElevation = 3, kHighestElevation = 89;  // degrees
const kGrazing = 0.15;  // sine below which a ray is too flat to drag the ground with
const kGlide = 0.08;  // s, in which the rest of the way to the goal falls to 1/e

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const along = (point, direction, way) => point.map((v, i) => v + way * direction[i]);
const clamp = (value, low, high) => Math.max(low, Math.min(high, value));

// Heights of the ground in the slide, and of the invented ground around it.
class Ground {
    constructor(slide) {
        const {nx, ny, dx} = slide.info.grid;
        this.slide = slide;
        this.width = (nx - 1) * dx;
        this.breadth = (ny - 1) * dx;
        this.side = Math.max(this.width, this.breadth);
        this.cell = dx;
        this.rough = slide.info.surroundings ? slide.array('rough') : null;
        if (this.rough) {
            this.roughSize = slide.info.arrays.rough.size;
            this.roughPlace = roughPlace(slide);
        }
    }

    inside(x, y) {
        return x >= 0 && y >= 0 && x <= this.width && y <= this.breadth;
    }

    // −Infinity where there is none.
    heightAt(x, y) {
        const {nx, ny, dx} = this.slide.info.grid;
        if (this.inside(x, y)) return bilinear(this.slide.surface, nx, ny, x / dx, y / dx);
        if (!this.rough) return -Infinity;
        const {x: west, y: south, cell} = this.roughPlace;
        return bilinear(this.rough, this.roughSize[0], this.roughSize[1], (x - west) / cell, (y - south) / cell);
    }

    // Metres from a point to the ground, about.
    distanceTo([x, y, z]) {
        const below = z - this.heightAt(x, y);
        let least = below;
        for (const reach of [0.5, 1, 1.5, 2.5])
            for (let k = 0; k < 12; ++k) {
                const r = reach * below, angle = 30 * kDegree * k;
                const height = this.heightAt(x + r * Math.cos(angle), y + r * Math.sin(angle));
                least = Math.min(least, Math.hypot(r, Math.max(0, z - height)));
            }
        return Math.min(least, this.side);
    }
}

// Place of the first rough height and the distance between two, from the frame's uniforms: its layout is in the
// program's own frame.glsl, where a matrix has 64 bytes and a vector 16.
function roughPlace(slide) {
    const members = [...slide.file('frame.glsl').matchAll(/^\s*(mat4|i?vec4)\s+(\w+)/gm)];
    let at = 0;
    for (const [, type, name] of members) {
        if (name === 'beyond') break;
        at += type === 'mat4' ? 64 : 16;
    }
    const frame = Uint8Array.from(atob(slide.info.frame), letter => letter.charCodeAt(0));
    const view = new DataView(frame.buffer, at);
    return {x: view.getFloat32(0, true), y: view.getFloat32(4, true), cell: view.getFloat32(8, true)};
}

// Between the four values around a place in cells; outside, of the border.
function bilinear(values, columns, rows, x, y) {
    const u = clamp(x, 0, columns - 1.0001), v = clamp(y, 0, rows - 1.0001);
    const column = Math.floor(u), row = Math.floor(v), a = u - column, b = v - row, i = row * columns + column;
    return (values[i] * (1 - a) + values[i + 1] * a) * (1 - b) +
        (values[i + columns] * (1 - a) + values[i + columns + 1] * a) * b;
}

// Unit vectors of a camera and where its eye is.
function poseOf({target, azimuth, elevation, distance}) {
    const a = azimuth * kDegree, e = elevation * kDegree;
    const backward = [Math.sin(a) * Math.cos(e), Math.cos(a) * Math.cos(e), Math.sin(e)];
    return {
        eye: along(target, backward, distance), forward: backward.map(v => -v), right: [-Math.cos(a), Math.sin(a), 0],
        up: [-Math.sin(a) * Math.sin(e), -Math.cos(a) * Math.sin(e), Math.cos(e)],
    };
}

// What a camera sees in a picture of so many samples. Rays are forward + x · right + y · up with x and y from −1 to 1.
// `clip`: column by column, to reversed depth without a far end (z is `near`, w the distance along `forward`).
// `pixel`: height of a sample at a distance of 1.
function viewOf(camera, width, height, ground) {
    const {eye, forward, right, up} = poseOf(camera), aspect = width / height;
    const half = Math.tan(camera.fieldOfView / 2 * kDegree) * clamp(1.25 / aspect, 1, 2.1);
    const near = clamp(0.25 * ground.distanceTo(eye), 0.1, ground.side);
    const x = right.map(v => v / (half * aspect)), y = up.map(v => v / half);
    const clip = Float32Array.from([
        x[0], y[0], 0, forward[0],
        x[1], y[1], 0, forward[1],
        x[2], y[2], 0, forward[2],
        -dot(x, eye), -dot(y, eye), near, -dot(forward, eye),
    ]);
    return {eye, forward, right: right.map(v => v * half * aspect), up: up.map(v => v * half), clip, near,
            pixel: 2 * half / height, width, height};
}

// Where the ray through a point of the picture, x and y from −1 to 1, meets the ground; null in the sky.
function pickGround(view, x, y, ground) {
    const ray = view.forward.map((v, i) => v + x * view.right[i] + y * view.up[i]);
    const direction = ray.map(v => v / Math.hypot(...ray));
    const above = way => {
        const [px, py, pz] = along(view.eye, direction, way);
        return pz - ground.heightAt(px, py);
    };
    const farthest = 9 * ground.side + Math.hypot(...view.eye);
    for (let way = 0, height = above(0); way < farthest;) {
        const next = way + Math.max(0.4 * ground.cell, Math.min(0.3 * height, 0.02 * ground.side));
        const then = above(next);
        if (then < 0) {
            let over = way, under = next;
            for (let k = 0; k < 24; ++k) {
                const middle = (over + under) / 2;
                if (above(middle) < 0) under = middle;
                else over = middle;
            }
            return along(view.eye, direction, over);
        }
        way = next;
        height = then;
    }
    return null;
}

// A camera that people move. It glides to where hands send it and stays above the ground.
class Camera {
    // `smooth`: whether it glides.
    constructor(slide, ground, smooth) {
        const {target: [x, y, z], azimuth_deg, elevation_deg, distance_m, field_of_view_deg} = slide.info.camera;
        this.ground = ground;
        this.smooth = smooth;
        this.fieldOfView = field_of_view_deg;
        this.home = this.clear({target: [x, y, z - slide.info.grid.datum], azimuth: azimuth_deg,
                                elevation: elevation_deg, distance: distance_m});
        this.goal = this.home;
        this.set(this.home);
    }

    set({target, azimuth, elevation, distance}) {
        Object.assign(this, {target, azimuth, elevation, distance});
    }

    get pose() {
        return {target: this.target, azimuth: this.azimuth, elevation: this.elevation, distance: this.distance};
    }

    viewOf(width, height) {
        return viewOf(this, width, height, this.ground);
    }

    isClear(pose) {
        const {eye} = poseOf(pose), margin = Math.max(2, 0.008 * this.ground.side, this.ground.cell);
        return !(eye[2] <= this.ground.heightAt(eye[0], eye[1]) + margin);
    }

    // The pose, raised until its eye is well above the ground.
    clear(pose) {
        let raised = pose;
        while (!this.isClear(raised) && raised.elevation < kHighestElevation)
            raised = {...raised, elevation: Math.min(kHighestElevation, raised.elevation + 0.25)};
        while (!this.isClear(raised)) raised = {...raised, target: along(raised.target, [0, 0, 1], this.ground.cell)};
        return raised;
    }

    // `at once`: without gliding, as under a moving finger.
    send(pose, atOnce) {
        this.goal = this.clear(pose);
        if (atOnce || !this.smooth) this.set(this.goal);
    }

    get arrived() {
        return this.isAt(this.goal);
    }

    isAt({target, azimuth, elevation, distance}) {
        return this.azimuth === azimuth && this.elevation === elevation && this.distance === distance &&
            this.target.every((v, i) => v === target[i]);
    }

    // Moves on toward the goal. Returns whether it moved.
    glide(seconds) {
        if (this.arrived) return false;
        const {goal} = this, share = 1 - Math.exp(-seconds / kGlide), mix = (a, b) => a + (b - a) * share;
        const next = {
            target: this.target.map((v, i) => mix(v, goal.target[i])), azimuth: mix(this.azimuth, goal.azimuth),
            elevation: mix(this.elevation, goal.elevation),
            distance: Math.exp(mix(Math.log(this.distance), Math.log(goal.distance))),
        };
        const rest = Math.hypot(...next.target.map((v, i) => v - goal.target[i])) / goal.distance +
            Math.abs(Math.log(next.distance / goal.distance)) + kDegree * (Math.abs(next.azimuth - goal.azimuth) +
            Math.abs(next.elevation - goal.elevation));
        this.set(rest < 5e-4 ? goal : this.clear(next));
        return true;
    }

    // Turns by degrees about a point, which stays where it is in the picture.
    turn(azimuth, elevation, pivot = this.goal.target, atOnce = false) {
        const from = this.goal, old = poseOf(from), offset = from.target.map((v, i) => v - pivot[i]);
        const turned = {
            ...from, azimuth: from.azimuth + azimuth,
            elevation: clamp(from.elevation + elevation, Math.min(kLowestElevation, from.elevation),
                             Math.max(kHighestElevation, from.elevation)),
        };
        const {forward, right, up} = poseOf(turned);
        turned.target = along(along(along(pivot, right, dot(offset, old.right)), up, dot(offset, old.up)), forward,
                              dot(offset, old.forward));
        this.send(turned, atOnce);
    }

    // Changes the distance to a point by a factor; the point stays where it is in the picture. Nearer, it stops before
    // the ground.
    zoom(factor, pivot = this.goal.target, atOnce = false) {
        const from = this.goal, away = Math.hypot(...poseOf(from).eye.map((v, i) => v - pivot[i]));
        const wanted = clamp(away * factor, Math.min(away, 2 * this.ground.cell), Math.max(away, 6 * this.ground.side));
        const share = wanted / away;
        const pose = {...from, distance: from.distance * share,
                      target: from.target.map((v, i) => pivot[i] + (v - pivot[i]) * share)};
        if (share > 1 || this.isClear(pose)) this.send(pose, atOnce);
    }

    // Moves until a point of the ground lies at a place of the picture, x and y from −1 to 1: at the eye's height, or
    // beside a flat ray. If ground is in the way, it backs off.
    drag(pivot, x, y, view) {
        const {eye} = view, from = this.goal, farthest = 6 * this.ground.side;
        const ray = view.forward.map((v, i) => v + x * view.right[i] + y * view.up[i]);
        const rise = pivot[2] - eye[2], isFlat = Math.abs(ray[2]) < kGrazing * Math.hypot(...ray) || rise / ray[2] <= 0;
        const depth = Math.min(isFlat ? dot(pivot.map((v, i) => v - eye[i]), view.forward) : rise / ray[2], farthest);
        for (let share = 0; share < 1; share += 1 / 32) {
            const way = depth * (farthest / depth) ** share;
            const pose = {...from, target: from.target.map((v, i) => v + pivot[i] - way * ray[i] - eye[i])};
            if (!this.isClear(pose)) continue;
            this.send(pose, true);
            return;
        }
    }

    // Moves to the right and away from the eye, by shares of the distance; half a side beyond the slide at most.
    pan(right, away, atOnce = false) {
        const from = this.goal, a = from.azimuth * kDegree, {width, breadth, side} = this.ground;
        const [x, y, z] = along(along(from.target, [-Math.cos(a), Math.sin(a), 0], right * from.distance),
                                [-Math.sin(a), -Math.cos(a), 0], away * from.distance);
        const target = [clamp(x, -0.5 * side, width + 0.5 * side), clamp(y, -0.5 * side, breadth + 0.5 * side), z];
        this.send({...from, target}, atOnce);
    }

    // Stays where it is now.
    stop() {
        this.goal = this.pose;
    }

    goHome() {
        const turns = 360 * Math.round((this.azimuth - this.home.azimuth) / 360);
        this.set({...this.pose, azimuth: this.azimuth - turns});
        this.send(this.home);
    }
}
