// Lens: the light that a photo takes, still linear.
layout(binding = SLOT_COLOUR) uniform sampler2D frame_colour;
layout(location = 0) uniform float exposure;

out vec4 colour;

void main() {
    vec4 here = texelFetch(frame_colour, ivec2(gl_FragCoord.xy), 0);
    colour = vec4(exposure * here.rgb, here.a);
}
