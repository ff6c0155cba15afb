// Updates the crossings of edges that are cut, or no longer are. One thread per edge.
layout(local_size_x = GROUP_ROW) in;

struct ChangedEdge {
    int edge;
    float crossing;
};

layout(std430, binding = SLOT_CHANGED_EDGES) readonly buffer ChangedEdges { ChangedEdge changed[]; };
layout(std430, binding = SLOT_CROSSINGS) writeonly buffer Crossings { float crossings[]; };

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i < changed.length()) crossings[changed[i].edge] = changed[i].crossing;
}
