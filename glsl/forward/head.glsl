#version 430
// In place of what VTK begins its fragment shaders with: a version that has buffers, and the names that its
// templates use for those of others.
#define highp
#define mediump
#define lowp
#define texelFetchBuffer texelFetch
#define texture1D texture
#define texture2D texture
#define texture3D texture
#define varying in
