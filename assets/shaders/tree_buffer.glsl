#define TREE_FINEST 0  // level of the pictures

// The trees that are drawn.
layout(std430, binding = SLOT_TREES) readonly buffer Trees { Tree trees[]; };

Tree tree_at(int number) { return trees[number]; }
