// A tree that is some pixels high: branches jut out at its edges and carry snow. A group has the outline of its tops.
in vec4 dark;
in vec4 bright;
flat in vec4 shape;
out vec4 colour;

void main() {
    vec2 place = vec2(dark.w, bright.w);
    float shade, snowy;
    if (shape.y < 0.0) {
        float left = 1.0 - place.y, side = abs(place.x);
        float branch = fract(1.1 * side - left * shape.y + step(0.0, place.x) * 0.37);  // 0 at its top, 1 at its tip
        if (side > left * mix(TREE_MEAN_OUTLINE, 0.58 + 0.42 * branch, shape.x)) discard;
        shade = 0.55 + 0.75 * branch;
        snowy = 0.55 * smoothstep(0.45, 0.85, branch) * step(branch, 0.93) * (0.6 + 0.4 * left);
    } else {
        float across = (0.5 * place.x + 0.5) * shape.y, column = floor(across);
        float own = fract(0.618 * column + 7.0 * shape.z), aside = abs(2.0 * (across - column) - 1.0);
        float middle = abs(2.0 * (column + 0.5) / shape.y - 1.0);
        float level = min((1.0 - mix(abs(place.x), middle, 0.7)) * 1.515, 1.0);
        float above = level * mix(0.84, 0.74 + 0.26 * own, shape.x) - mix(0.12, 0.42 * aside, shape.x) - place.y;
        if (above < 0.0) discard;
        shade = 0.6 + 0.7 * own;
        snowy = TREE_MEAN_SNOW * (1.5 - min(4.0 * above, 1.0));
    }
    shade = mix(1.0, shade, shape.x), snowy = shape.w * mix(TREE_MEAN_SNOW, snowy, shape.x);
    colour = vec4(mix(dark.rgb * shade, bright.rgb, snowy), 0.0);  // alpha 0: edges_mark.frag leaves it out
}
