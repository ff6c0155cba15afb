// Tone: maps linear light to screen colours.
layout(binding = SLOT_COLOUR) uniform sampler2D frame_colour;

out vec4 colour;

void main() {
    vec4 here = texelFetch(frame_colour, ivec2(gl_FragCoord.xy), 0);
    vec3 c = shown(here.rgb);
    // Dither of less than one 8-bit step, fixed to the pixel: the sky shows no bands, and a redrawn frame is
    // the same. The image format encodes sRGB, so a step in linear light grows with brightness.
    float grain = fract(52.9829189 * fract(dot(floor(gl_FragCoord.xy), vec2(0.06711056, 0.00583715)))) - 0.5;
    colour = vec4(c + (2.0 / 255.0) * grain * c, here.a);
}
