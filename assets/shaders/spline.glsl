// Cubic B-spline through a field: four bilinear fetches instead of sixteen. It rounds corners along grid
// edges and preserves uniform slopes.
struct Smooth {
    vec4 value;
    vec4 along_x, along_y;  // change per cell
};

Smooth spline(sampler2D field, vec2 cell) {
    vec2 size = vec2(frame.size.xy);
    vec2 i = floor(cell), f = cell - i, e = 1.0 - f;
    vec2 w0 = e * e * e / 6.0, w1 = 2.0 / 3.0 - 0.5 * f * f * (2.0 - f), w3 = f * f * f / 6.0;
    vec2 g0 = w0 + w1, g1 = 1.0 - g0;
    vec2 a = i - 0.5 + w1 / g0, b = i + 1.5 + w3 / g1;
    vec2 apart = b - a;
    a /= size;
    b /= size;
    vec4 t00 = texture(field, a), t10 = texture(field, vec2(b.x, a.y));
    vec4 t01 = texture(field, vec2(a.x, b.y)), t11 = texture(field, b);
    return Smooth(mix(mix(t00, t10, g1.x), mix(t01, t11, g1.x), g1.y), mix(t10 - t00, t11 - t01, g1.y) / apart.x,
                  mix(t01 - t00, t11 - t10, g1.x) / apart.y);
}
