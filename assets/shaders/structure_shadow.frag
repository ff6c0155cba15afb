// The shadow of a structure, or light from its windows: what is left of the light on the ground, as a factor.
in vec3 left;
out vec4 colour;

void main() { colour = vec4(left, 1.0); }
