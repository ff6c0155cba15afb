// Cuts triangles beside edges that are cut, or no longer are, into pieces as in sim/front/remesh_reference.
// The first piece keeps the triangle's own slot among the indices, the others follow those of all triangles.
// One thread per triangle.
layout(local_size_x = GROUP_ROW) in;

layout(std430, binding = SLOT_CHANGED_TRIANGLES) readonly buffer ChangedTriangles { int changed[]; };
layout(std430, binding = SLOT_CUT_INDICES) writeonly buffer CutIndices { int indices[]; };
layout(std430, binding = SLOT_CUT_COUNT) buffer CutCount { uint count; };  // of indices

int triangle;
uint end;  // of the pieces, among the indices

void put(uint at, int p, int q, int r) {
    indices[at] = p;
    indices[at + 1] = q;
    indices[at + 2] = r;
}
void add_first(int p, int q, int r) {
    put(3 * triangle, p, q, r);
}
// Reserves space for the pieces after the first.
void make_room(uint pieces) {
    end = atomicAdd(count, 3 * pieces);
}
void add(int p, int q, int r) {
    put(end, p, q, r);
    end += 3;
}

int vertex(int corner) { return mesh_triangles[triangle].corner[corner]; }
int edge(int corner) { return mesh_triangles[triangle].edge[corner]; }

// On the edge from corner k to the next: the copy on the side of corner `side`.
int copy(int k, int side) {
    return first_on_edges() + 2 * edge(k) + (mesh_edges[edge(k)].y == vertex(side) ? 1 : 0);
}
int middle(int side) { return first_in_triangles() + 3 * triangle + side; }

float squared_distance(vec2 p, vec2 q) {
    precise vec2 way = q - p;
    precise float sum = way.x * way.x + way.y * way.y;
    return sum;
}

// One cut, from a to b. The second piece has no area, because the tear ends there.
void tear(int a) {
    int b = (a + 1) % 3, c = (a + 2) % 3;
    make_room(2);
    add_first(vertex(c), vertex(a), copy(a, a));
    add(vertex(c), copy(a, a), copy(a, b));
    add(vertex(c), copy(a, b), vertex(b));
}

// Two cuts: a is alone, and the rest is split by its shorter diagonal.
void part(int a) {
    int b = (a + 1) % 3, c = (a + 2) % 3;
    int d = copy(a, b), e = copy(c, c);
    make_room(2);
    add_first(vertex(a), copy(a, a), copy(c, a));
    if (squared_distance(crossing_of(edge(a)), mesh_positions[vertex(c)]) <=
        squared_distance(mesh_positions[vertex(b)], crossing_of(edge(c)))) {
        add(d, vertex(b), vertex(c));
        add(d, vertex(c), e);
    } else {
        add(d, vertex(b), e);
        add(vertex(b), vertex(c), e);
    }
}

// Three cuts: two pieces for each corner, around the middle.
void shatter() {
    make_room(5);
    add_first(vertex(0), copy(0, 0), middle(0));
    add(vertex(0), middle(0), copy(2, 0));
    for (int a = 1; a < 3; ++a) {
        add(vertex(a), copy(a, a), middle(a));
        add(vertex(a), middle(a), copy(a - 1, a));
    }
}

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= changed.length()) return;
    triangle = changed[i];
    bvec3 cut = bvec3(is_cut(edge(0)), is_cut(edge(1)), is_cut(edge(2)));
    switch (int(cut.x) + int(cut.y) + int(cut.z)) {
        case 0: add_first(vertex(0), vertex(1), vertex(2)); break;
        case 1: tear(cut.x ? 0 : cut.y ? 1 : 2); break;
        case 2: part(!cut.x ? 2 : !cut.y ? 0 : 1); break;
        case 3: shatter(); break;
    }
}
