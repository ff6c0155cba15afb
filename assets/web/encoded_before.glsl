// Before a fragment shader that writes linear light, so that encoded.frag can follow it.
#define main linear_main
