// Flow's mesh as lines: fronts stand out. An edge that only ends at a front is no piece of it.
in float front;
out vec4 colour;

void main() { colour = front > 0.995 ? vec4(0.86, 0.10, 0.02, 1.0) : vec4(0.01, 0.02, 0.05, 0.45); }
