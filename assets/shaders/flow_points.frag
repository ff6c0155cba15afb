// Flow points: discs with a dark rim.
out vec4 colour;

void main() {
    float from_middle = 2.0 * length(gl_PointCoord - 0.5);
    if (from_middle > 1.0) discard;
    colour = vec4(from_middle > 0.6 ? vec3(0.02) : vec3(1.0, 0.75, 0.05), 1.0);
}
