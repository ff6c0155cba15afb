// Two slides side by side. The one that was touched last leads, and the other one follows it.

const frames = [...document.querySelectorAll('iframe')];
let leader = 0;

const extentOf = ({nx, ny, dx}) => `${(nx - 1) * dx} ${(ny - 1) * dx}`;

function follow() {
    requestAnimationFrame(follow);
    const pages = frames.map(frame => frame.contentWindow.couloir);
    const isFailed = frame => frame.contentDocument?.documentElement?.dataset.state === 'failed';
    if (frames.some(isFailed)) document.documentElement.dataset.state = 'failed';
    if (!pages.every(page => page)) return;  // they are not there yet
    document.documentElement.dataset.state ??= 'ready';
    const [lead, other] = [pages[leader], pages[1 - leader]];
    // A slide that has ended lets a longer one play on.
    if (!lead.playing && lead.tick >= lead.info.last && other.playing && other.tick < other.info.last) {
        leader = 1 - leader;
        return;
    }
    const shown = lead.shown;
    if (extentOf(lead.info.grid) !== extentOf(other.info.grid)) delete shown.camera;
    other.follow(shown);
}

const pages = JSON.parse(document.getElementById('pages').textContent);
frames.forEach((frame, i) => {
    frame.addEventListener('load', () => {
        for (const type of ['pointerdown', 'wheel', 'keydown', 'input', 'change'])
            frame.contentWindow.addEventListener(type, () => leader = i, {capture: true, passive: true});
    });
    frame.srcdoc = pages[i];
});
follow();
