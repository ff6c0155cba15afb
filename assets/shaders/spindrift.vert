// Spindrift: a ribbon for each place of a ridge, along the wind and turned to the eye. It lengthens in gusts, which
// travel with the wind.
layout(location = 0) uniform vec4 wind;   // unit vector to where it blows; speed, m/s
layout(location = 1) uniform vec4 phase;  // how far the patterns have travelled, in their lengths: fine, coarse, gusts
layout(binding = SLOT_DETAIL) uniform sampler2DArray detail_texture;

layout(location = 0) in vec3 at;    // m
layout(location = 1) in vec3 look;  // strength, its own number, share of the sun

out vec2 place;             // along the ribbon 0 to 1, across it −1 to 1
out vec2 fine, coarse;      // in the detail texture
out float distance_m;       // along the view
flat out vec4 colour;       // its light; opacity
flat out vec2 level;        // of the detail texture

const float kFine = 44.0, kCoarse = 97.0, kGust = 430.0;  // m along the wind

void main() {
    bool end = gl_VertexID == 1 || gl_VertexID == 2 || gl_VertexID == 4;
    bool top = gl_VertexID == 2 || gl_VertexID == 4 || gl_VertexID == 5;
    place = vec2(end ? 1.0 : 0.0, top ? 1.0 : -1.0);

    // A gust comes over a whole stretch of a ridge; each place has its own share in it.
    vec2 aside = vec2(-wind.y, wind.x), flat_at = vec2(dot(at.xy, wind.xy), dot(at.xy, aside));
    float gust = textureLod(detail_texture, vec3(flat_at / kGust - vec2(phase.z, 0.0), DETAIL_SOFT), 3.0).z;
    gust = smoothstep(0.36, 0.66, gust + 0.35 * (look.y - 0.5));
    float strength = look.x * (0.15 + 0.85 * gust) * (0.55 + 0.6 * look.y);
    float length_m = (28.0 + 4.5 * wind.z) * (0.25 + 0.7 * strength + 0.7 * look.y * look.y), half_m = 4.5 + 7.0 * strength + 3.0 * fract(7.0 * look.y);

    vec3 along = normalize(vec3(wind.xy, 0.02));
    vec3 foot = at - 1.5 * along + vec3(0.0, 0.0, 0.15 * half_m);
    vec3 to_eye = normalize(frame.eye.xyz - foot);
    vec3 across = cross(to_eye, along);
    across *= (dot(across, frame.ray_up.xyz) < 0.0 ? -1.0 : 1.0) / max(length(across), 0.2);
    float half_here = half_m * (end ? 1.0 : 0.6);
    vec3 p = foot + along * (end ? length_m : 0.0) + across * (half_here * place.y);
    // It rises off the ridge: the lower rim stays beside it.
    p.z += end ? 0.4 * half_m : 0.0;

    // Neighbours share a pattern, so that they make one veil.
    float travelled = flat_at.x + place.x * length_m, beside = 0.6 * flat_at.y + place.y * half_here;
    fine = vec2(travelled / kFine - phase.x, beside / 7.0);
    coarse = vec2(travelled / kCoarse - phase.y, beside / 15.0 + 2.3 * look.y);

    distance_m = dot(p - frame.eye.xyz, frame.ray_forward.xyz);
    float middle_m = distance(foot, frame.eye.xyz);
    float pixel = middle_m * frame.material.y * float(textureSize(detail_texture, 0).x);
    level = max(log2(pixel / vec2(7.0, 15.0)), 0.0);

    // Fine snow passes light on forward: against the sun it shines.
    float sun = mix(0.3, 1.0, look.z), toward = max(dot(-to_eye, frame.sun.xyz), 0.0);
    vec3 light = frame.standing.rgb * (frame.lamp.rgb * (sun * (0.75 + 0.8 * toward * toward * toward)) + 0.8 * frame.above.rgb + 0.3 * frame.below.rgb);
    // Near the eye it parts, and so it does if it comes straight toward the eye.
    float opacity = min(1.1 * strength, 0.7) * smoothstep(15.0, 70.0, middle_m) * smoothstep(0.15, 0.5, length(cross(to_eye, along))) * mix(0.4, 1.0, look.z);
    colour = vec4(through_air(light, foot), opacity);
    gl_Position = frame.clip_from_world * vec4(p, 1.0);
}
