// Tone: linear light to what a screen can show. Straight up to a knee, so colours stay true; above it highlights run softly
// into white.
layout(binding = SLOT_COLOUR) uniform sampler2D frame_colour;

out vec4 colour;

const float kKnee = 0.6;

vec3 shoulder(vec3 c) {
    vec3 t = 1.0 + max(c - kKnee, 0.0) / (4.0 * (1.0 - kKnee));
    t *= t;
    return min(c, kKnee) + (1.0 - kKnee) * (1.0 - 1.0 / (t * t));
}

void main() {
    vec3 c = shoulder(texelFetch(frame_colour, ivec2(gl_FragCoord.xy), 0).rgb);
    // Less than a step of 8 bits, fixed to the pixel: the sky shows no bands, and a frame drawn twice is the same. The picture
    // encodes itself; a step there is the longer in linear light the brighter the place.
    float grain = fract(52.9829189 * fract(dot(floor(gl_FragCoord.xy), vec2(0.06711056, 0.00583715)))) - 0.5;
    colour = vec4(c + (2.0 / 255.0) * grain * c, 1.0);
}
