// How many samples a pixel of the screen has along an edge: fewer while the picture moves and takes long, more of a
// picture that stays.

const kInMotion = [0.3, 0.4, 0.5, 0.65, 0.8, 1];
const kAtRest = [2, 1.5, 1];
const kFluent = 40, kPatient = 250;  // ms that a picture may take in motion; at rest beyond one sample a pixel
const kMostSamples = 9e6;

class Resolution {
    constructor() {
        this.inMotion = 1;
        this.cost = 0;  // ms of a picture with one sample a pixel
        this.held = 0;  // what tests ask for; 0: nothing
    }

    know(cost) {
        this.cost = cost;
        this.inMotion = Math.max(kInMotion[0], ...kInMotion.filter(scale => scale * scale * cost <= kFluent));
    }

    // Learns from the time between two pictures in motion, ms.
    adapt(elapsed) {
        this.mean = this.mean ? 0.75 * this.mean + 0.25 * elapsed : elapsed;
        const now = kInMotion.indexOf(this.inMotion);
        let next = now;
        if (this.mean > kFluent) next = now - (this.mean > 3 * kFluent ? 2 : 1);
        if (this.mean < kFluent / 2) next = now + 1;
        next = clamp(next, 0, kInMotion.length - 1);
        if (next === now) return;
        this.inMotion = kInMotion[next];
        this.mean = 0;
    }

    // `pixels`: of the picture.
    atRest(pixels) {
        return kAtRest.find(scale => {
            const more = scale * scale;
            return scale === 1 || (more * pixels < kMostSamples && more * this.cost < kPatient);
        });
    }
}
