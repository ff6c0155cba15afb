// The shadow of a structure: what it leaves of the light, as a factor.
flat in vec3 left;
out vec4 colour;

void main() { colour = vec4(left, 1.0); }
