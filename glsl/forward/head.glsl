#version 430
// Replaces the head of VTK's fragment shaders: selects a version that has storage buffers, and defines the names that
// VTK's templates use for those of other versions.
#define highp
#define mediump
#define lowp
#define texelFetchBuffer texelFetch
#define texture1D texture
#define texture2D texture
#define texture3D texture
#define varying in
