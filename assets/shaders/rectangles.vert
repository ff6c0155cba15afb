// Rectangles of the target, at infinity: two triangles for each instance.
layout(location = 0) in vec4 corners;  // left, bottom, right, top, −1 to 1

void main() {
    bool right = gl_VertexID == 1 || gl_VertexID == 2 || gl_VertexID == 4;
    bool top = gl_VertexID == 2 || gl_VertexID == 4 || gl_VertexID == 5;
    gl_Position = vec4(right ? corners.z : corners.x, top ? corners.w : corners.y, 0.0, 1.0);
}
