// Marks: contours, a ring, an outline and that of an extent on the ground, in screen colours and with widths independent of distance.
vec3 overlaid(vec3 picture, Place p, mat2 pixel, vec3 light);  // overlay.glsl or overlay_none.glsl

layout(binding = SLOT_EXTENT) uniform sampler2D extent;

const float kEdge = 0.06;  // smallest sine of the viewing angle that is used

// Distance on the ground in plan, m, from a pixel to the next to the right (first column) and above (second).
// It uses the surface's tangent plane, so it is also right beside an outline, where neighbours show other
// things.
mat2 pixel_on_ground(Place p) {
    vec3 n = vec3(-p.slope, 1.0);
    float facing = min(dot(n, p.ray), -kEdge * length(n) * length(p.ray));
    float size = p.forward * frame.material.y * frame.material.z;
    vec3 right = size * normalize(frame.ray_right.xyz), up = size * normalize(frame.ray_up.xyz);
    return mat2(right.xy - p.ray.xy * (dot(n, right) / facing), up.xy - p.ray.xy * (dot(n, up) / facing));
}

// Share of a sample within `half_width` pixels of a line that is `away` pixels off, 0 to 1.
float line(float away, float half_width) {
    return clamp((half_width - abs(away)) * frame.material.z + 0.5, 0.0, 1.0);
}

// Contours fade where they would merge and on level ground.
vec3 with_contours(vec3 picture, Place p, mat2 pixel) {
    float height = p.at.z * frame.contours.x + frame.contours.y;  // lines
    float nearest = round(height);
    bool heavy = abs(mod(nearest + 0.5, 5.0) - 0.5) < 0.1;
    float per_pixel = max(length(p.slope * pixel) * frame.contours.x, 1e-5);
    float there = line((height - nearest) / per_pixel, heavy ? 0.9 : 0.5);
    float crowded = smoothstep(0.18, 0.4, heavy ? 0.2 * per_pixel : per_pixel);
    float level = smoothstep(0.03, 0.01, length(p.slope));
    const vec3 kInk = vec3(0.012, 0.009, 0.008);
    return mix(picture, kInk, there * (heavy ? 0.8 : 0.55) * (1.0 - crowded) * (1.0 - level));
}

// A line of two pixels between dark hairlines, a faint tint inside, a dot in the middle.
vec3 with_ring(vec3 picture, Place p, mat2 pixel) {
    vec2 away = p.at.xy - frame.ring.xy;
    float distance_m = length(away), outside_m = distance_m - frame.ring.z;
    float outside = outside_m / length(away / max(distance_m, 1e-6) * pixel + 1e-9);  // pixels
    float across = frame.ring.z / sqrt(abs(determinant(pixel)));                      // size of the ring, pixels
    // The ground under the dot is not level, so its distance is measured in screen pixels to keep the dot
    // round.
    float from_dot = length(inverse(pixel) * away);
    float dot_shown = smoothstep(6.0, 12.0, across);
    picture = mix(picture, frame.ring_colour.rgb, 0.04 * clamp(0.5 - outside * frame.material.z, 0.0, 1.0));
    picture *= 1.0 - 0.75 * max(line(outside, 2.1), dot_shown * line(from_dot, 3.9));
    return mix(picture, frame.ring_colour.rgb, max(line(outside, 1.0), dot_shown * line(from_dot, 2.7)));
}

// The outline of a rectangle, drawn as a ring is; its front is a heavier line.
vec3 with_outline(vec3 picture, Place p, mat2 pixel) {
    vec2 line_m = frame.outline.zw - frame.outline.xy, half_size = vec2(0.5 * length(line_m), abs(frame.outline_colour.w));
    vec2 along = line_m / max(length(line_m), 1e-6), across = vec2(-along.y, along.x);
    vec2 away = p.at.xy - 0.5 * (frame.outline.xy + frame.outline.zw);
    vec2 at = vec2(dot(away, along), dot(away, across)), beyond = abs(at) - half_size;
    // The direction in which the distance to the rectangle grows.
    bool before_end = beyond.x > beyond.y;
    vec2 grows = max(beyond.x, beyond.y) > 0.0 ? max(beyond, 0.0) : before_end ? vec2(1.0, 0.0) : vec2(0.0, 1.0);
    float outside_m = max(beyond.x, beyond.y) > 0.0 ? length(grows) : max(beyond.x, beyond.y);
    grows *= sign(at) / max(length(grows), 1e-6);
    float outside = outside_m / length((grows.x * along + grows.y * across) * pixel + 1e-9);  // pixels
    float heavy = frame.outline_colour.w < 0.0 && before_end && at.x > 0.0 ? 1.5 : 0.0;
    picture = mix(picture, frame.outline_colour.rgb, 0.15 * clamp(0.5 - outside * frame.material.z, 0.0, 1.0));
    picture *= 1.0 - 0.75 * line(outside, 2.1 + heavy);
    return mix(picture, frame.outline_colour.rgb, line(outside, 1.0 + heavy));
}

// A dashed line around an extent, between dark hairlines: midway between the last vertex inside and the first outside.
// Dashes follow the axis that the line runs along; each octave of the size of a pixel has a length of its own.
vec3 with_extent(vec3 picture, Place p, mat2 pixel) {
    const vec3 kGold = vec3(0.955, 0.577, 0.045);
    const float kDash = 10.0;  // least length of dash and gap together, pixels
    Smooth inside = spline(extent, p.at.xy / frame.ground.x);
    vec2 grows = vec2(inside.along_x.x, inside.along_y.x) / frame.ground.x;
    float away = (inside.value.x - 0.5) / max(length(grows * pixel), 1e-5);  // pixels
    float length_m = exp2(ceil(log2(kDash * sqrt(abs(determinant(pixel))))));
    float dash = step(fract((abs(grows.x) > abs(grows.y) ? p.at.y : p.at.x) / length_m), 0.6);
    picture *= 1.0 - 0.75 * dash * line(away, 2.1);
    return mix(picture, kGold, dash * line(away, 1.1));
}

vec3 marked(vec3 seen, Place p, vec3 light) {
    mat2 pixel = pixel_on_ground(p);
    vec3 picture = overlaid(shown(seen), p, pixel, light);
    if (frame.contours.x > 0.0) picture = with_contours(picture, p, pixel);
    if (frame.contours.z > 0.5) picture = with_extent(picture, p, pixel);
    if (frame.ring.w > 0.5) picture = with_ring(picture, p, pixel);
    if (frame.outline_colour.w != 0.0) picture = with_outline(picture, p, pixel);
    return light_shown_as(picture);
}
