// A rope is black against whatever is behind it.
in vec3 air;
flat in float opaque;
out vec4 colour;

void main() { colour = vec4(air, opaque); }
