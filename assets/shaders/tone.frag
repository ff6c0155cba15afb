// Tone: linear light to what a screen can show.
layout(binding = SLOT_COLOUR) uniform sampler2D frame_colour;

out vec4 colour;

void main() {
    vec3 c = shown(texelFetch(frame_colour, ivec2(gl_FragCoord.xy), 0).rgb);
    // Less than a step of 8 bits, fixed to the pixel: the sky shows no bands, and a frame drawn twice is the same. The picture
    // encodes itself; a step there is the longer in linear light the brighter the place.
    float grain = fract(52.9829189 * fract(dot(floor(gl_FragCoord.xy), vec2(0.06711056, 0.00583715)))) - 0.5;
    colour = vec4(c + (2.0 / 255.0) * grain * c, 1.0);
}
