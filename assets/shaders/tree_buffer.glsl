// The trees that are drawn.
layout(std430, binding = SLOT_TREES) readonly buffer Trees { Tree trees[]; };

Tree tree_at(int number) { return trees[number]; }
