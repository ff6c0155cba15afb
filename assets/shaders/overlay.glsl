// Overlay: colours the ground by a legend (render/frame/marks.h). In good light these are the legend's own colours;
// elsewhere they are darker, so that the ground keeps its shape.
layout(binding = SLOT_MEASURE) uniform sampler2D measure;

// Transition from one legend colour to the next: a step one sample wide, or linear. 0 before, 1 after.
float into(int stop, float value, float per_sample) {
    float here = frame.stops[stop].w, before = stop == 0 ? 0.5 * here : frame.stops[stop - 1].w;
    float along = frame.overlay.z == 1 ? (value - here) / per_sample + 0.5 : (value - before) / max(here - before, 1e-6);
    return clamp(along, 0.0, 1.0);
}

vec3 overlaid(vec3 picture, Place p, mat2 pixel, vec3 light) {
    Smooth m = spline(measure, p.at.xy / frame.ground.x);
    float weight = max(m.value.y, 1e-6), value = m.value.x / weight;
    mat2 sample_in_cells = pixel / (frame.material.z * frame.ground.x);
    // The outline is that of the layer: midway between the last vertex inside and the first outside.
    float edge = max(length(vec2(m.along_x.y, m.along_y.y) * sample_in_cells), 1e-3);
    float there = clamp((weight - 0.5) / edge + 0.5, 0.0, 1.0);
    float per_sample = max(length(vec2(m.along_x.x, m.along_y.x) * sample_in_cells), 1e-3);
    vec3 of_legend = frame.stops[0].rgb;
    for (int i = 1; i < frame.overlay.y; ++i) of_legend = mix(of_legend, frame.stops[i].rgb, into(i, value, per_sample));
    return mix(picture, from_srgb(of_legend) * shade(light), there * into(0, value, per_sample));
}
