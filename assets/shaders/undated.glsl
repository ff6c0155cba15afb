// For looks without a date.
const bool kDated = false;
