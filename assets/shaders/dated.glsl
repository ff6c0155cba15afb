// For looks with a date: plants are drawn. undated.glsl is for the others, because shader code costs time even if its branch
// is not taken.
const bool kDated = true;
