// What the page says: names, numbers and sentences. Given texts are never read as HTML.

const part = id => document.getElementById(id);
// With a narrow blank between thousands that does not break.
const number = (value, digits = 0) =>
    value.toLocaleString('en', {minimumFractionDigits: digits, maximumFractionDigits: digits})
        .replace('-', '−').replaceAll(',', '\u202f');
const signed = (value, digits) => (Number(value.toFixed(digits)) > 0 ? '+' : '') + number(value, digits);
const short = (value, digits) => String(Number(value.toPrecision(digits))).replace('-', '−');

// Adds an element with a text.
function add(parent, tag, text) {
    const element = parent.appendChild(document.createElement(tag));
    if (text !== undefined) element.textContent = text;
    return element;
}

// Replaces the page by a sentence.
function fail(sentence) {
    document.documentElement.dataset.state = 'failed';
    const note = part('note');
    note.hidden = false;
    note.setAttribute('role', 'alert');
    note.textContent = sentence;
}

// Tells a screen reader what has happened; not while it goes on.
function say(text) {
    part('spoken').textContent = text;
}

// Where a point of the grid is: on Earth, between its corners, as "47.30012° N 11.43210° E", or in metres.
function placeOf({georeference, grid}, x, y) {
    if (!georeference) return `${number(x)} m east, ${number(y)} m north`;
    const u = x / ((grid.nx - 1) * grid.dx), v = y / ((grid.ny - 1) * grid.dx);
    const weights = [(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v];  // south-west, south-east, north-west, …
    const [latitude, longitude] = [0, 1].map(axis =>
        georeference.corners.reduce((sum, corner, i) => sum + weights[i] * corner[axis], 0));
    return `${Math.abs(latitude).toFixed(5)}° ${latitude < 0 ? 'S' : 'N'} ` +
        `${Math.abs(longitude).toFixed(5)}° ${longitude < 0 ? 'W' : 'E'}`;
}

// Names and values of what Slide.read() returns.
function rowsOf(info, reading) {
    const share = reading.rolling > 0 ? reading.lowerRolling : reading.lowerStanding;
    return [
        ['Height', `${number(reading.height, 1)} m`],
        ['Standing', `${number(reading.standing, 2)} m`],
        ['Change', `${signed(reading.change, 2)} m`],
        ['Rolling', `${number(reading.rolling, 2)} m`],
        info.two && ['Mixture', `${number(100 * share)} % ${info.lower_material}`],
        ['Speed in plan', `${number(reading.speed, 1)} m/s`],
        ['Deepest flow', `${number(reading.peakDepth, 2)} m`],
        ['Fastest flow', `${number(reading.peakSpeed, 1)} m/s`],
    ].filter(Boolean);
}

// null: nothing is marked.
function showReading(info, reading) {
    part('reading').hidden = !reading;
    if (!reading) return;
    const rows = rowsOf(info, reading), list = part('values-here');
    if (list.children.length === 0)
        for (const [name] of rows) add(list, 'dt', name), add(list, 'dd');
    rows.forEach(([, text], i) => list.children[2 * i + 1].textContent = text);
    part('where').textContent = placeOf(info, reading.x, reading.y);
}

// As the program's own legend: a part of equal width for each stop. null: there is none.
function showLegend(overlay) {
    part('legend').hidden = !overlay;
    if (!overlay) return;
    const {name, unit, stepped, stops} = overlay;
    part('quantity').textContent = `${name}, ${unit}`;
    const rgb = ([, r, g, b]) => `rgb(${[r, g, b].map(v => Math.round(255 * v)).join(' ')})`;
    const colours = stops.map((stop, i) => {
        const last = i + 1 === stops.length, to = stepped || last ? stop : stops[i + 1];
        return `${rgb(stop)} ${100 * i / stops.length}%, ${rgb(to)} ${100 * (i + 1) / stops.length}%`;
    });
    part('colours').style.background = `linear-gradient(to right, ${colours.join(', ')})`;
    part('legend').classList.toggle('many', stops.length > 6);
    part('values').replaceChildren();
    for (const [value] of stops) add(part('values'), 'li', short(value, 3));
}

// Title, one line, and the numbers with how to repeat them.
function describe(info) {
    const {measures: m, grid, error} = info, length = number(info.last * info.tick_s);
    const material = info.two ? `${info.material} on ${info.lower_material}` : info.material;
    part('title').textContent = info.title;
    part('task').hidden = !info.goal;
    if (info.goal)
        part('say').textContent = info.goal.to_beat === undefined ? info.goal.say :
            `${info.goal.say} ${number(info.goal.to_beat)} points were scored before you: beat that. A dashed line shows where that run was.`;
    part('about').textContent = info.about;
    part('site').hidden = !info.site;
    if (info.site) part('site').href = info.site.index;

    const numbers = part('numbers'), table = add(numbers, 'table'), centimetres = metres => short(100 * metres, 2);
    for (const [name, value] of [
        ['Run-out', `${number(m.run_out_m)} m`],
        ['Fall', `${number(m.fall_m)} m`],
        ['Angle of reach', `${number(m.reach_deg, 1)}°`],
        ['Area', `${number(m.extent_ha, 2)} ha`],
        ['Deepest flow', `${number(m.peak_depth_m, 1)} m`],
        ['Fastest, along the slope', `${number(m.peak_speed_slope_m_s, 1)} m/s`],
        ['Fastest, in plan', `${number(m.peak_speed_plan_m_s, 1)} m/s`],
        m.peak_pressure_kpa !== undefined && ['Greatest impact pressure', `${number(m.peak_pressure_kpa, 1)} kPa`],
        [`Swept along by ${length} s`, `${number(m.eroded_m3)} m³`],
        [`Deposited by ${length} s`, `${number(m.deposited_m3)} m³`],
        ['Mass error', info.mass.error_quanta === 0 ? 'none' : `${number(info.mass.error_quanta)} quanta`],
        ['Material', material],
        ['Ground', info.terrain],
        info.licence && ['Licence of the ground', info.licence],
        ['Grid', `${number(grid.nx - 1)} × ${number(grid.ny - 1)} squares of ${short(grid.dx, 4)} m`],
        info.georeference && ['South-west corner', info.georeference.south_west],
        ['Made with', info.program],
    ].filter(Boolean)) {
        const row = table.insertRow();
        add(row, 'th', name).scope = 'row';
        add(row, 'td', value);
    }
    if (info.command) {
        add(numbers, 'h2', 'The same again, and checked');
        const repeat = add(numbers, 'div'), command = add(repeat, 'code', info.command);
        repeat.className = 'repeat';
        addCopyButton(repeat, command);
    }
    add(numbers, 'h2', 'State hash of the end');
    add(numbers, 'code', info.hash);
    add(numbers, 'p', info.live ? 'As the program computed it. Whoever takes the slide over has it computed here first, and compared.' :
        'As the program computed it. This page carries it along and cannot compute it.');
    add(numbers, 'h2', 'What this page keeps');
    add(numbers, 'p', `A state every ${short(info.every * info.tick_s, 2)} s: standing depth within ` +
        `${centimetres(error.depth)} cm, rolling depth within ${centimetres(error.moving)} cm, speed within ` +
        `${short(error.speed, 2)} m/s, ground within ${centimetres(error.ground)} cm. While it plays, it blends between ` +
        'states; what it reads out is of a stored state and of the nearest vertex.');
    if (info.surroundings) add(numbers, 'p', 'The ground beyond the slide is invented. Nothing was simulated there.');
}

function addCopyButton(parent, source) {
    const button = add(parent, 'button', 'Copy');
    button.type = 'button';
    button.addEventListener('click', async () => {
        try {
            await navigator.clipboard.writeText(source.textContent);
        } catch {
            getSelection().selectAllChildren(source);
            document.execCommand('copy');  // where the newer way is not allowed
        }
        button.textContent = 'Copied';
        say('Copied');
        setTimeout(() => button.textContent = 'Copy', 2000);
    });
}
