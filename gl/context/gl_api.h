#pragma once
// The functions of OpenGL that are used here, and no others. Loaded at run time: nothing is linked.

#include <GL/glcorearb.h>

namespace refraster {

/// Of OpenGL 3.3 core.
#define REFRASTER_GL_FUNCTIONS(F)                                                                                      \
  F(ACTIVETEXTURE, ActiveTexture)                                                                                      \
  F(ATTACHSHADER, AttachShader)                                                                                        \
  F(BEGINQUERY, BeginQuery)                                                                                            \
  F(BINDATTRIBLOCATION, BindAttribLocation)                                                                            \
  F(BINDBUFFER, BindBuffer)                                                                                            \
  F(BINDBUFFERBASE, BindBufferBase)                                                                                    \
  F(BINDFRAMEBUFFER, BindFramebuffer)                                                                                  \
  F(BINDRENDERBUFFER, BindRenderbuffer)                                                                                \
  F(BINDSAMPLER, BindSampler)                                                                                          \
  F(BINDTEXTURE, BindTexture)                                                                                          \
  F(BINDVERTEXARRAY, BindVertexArray)                                                                                  \
  F(BLITFRAMEBUFFER, BlitFramebuffer)                                                                                  \
  F(BUFFERDATA, BufferData)                                                                                            \
  F(CHECKFRAMEBUFFERSTATUS, CheckFramebufferStatus)                                                                    \
  F(CLEAR, Clear)                                                                                                      \
  F(CLEARBUFFERFV, ClearBufferfv)                                                                                      \
  F(CLEARBUFFERIV, ClearBufferiv)                                                                                      \
  F(CLEARBUFFERUIV, ClearBufferuiv)                                                                                    \
  F(CLEARCOLOR, ClearColor)                                                                                            \
  F(CLEARDEPTH, ClearDepth)                                                                                            \
  F(COLORMASK, ColorMask)                                                                                              \
  F(COMPILESHADER, CompileShader)                                                                                      \
  F(CREATEPROGRAM, CreateProgram)                                                                                      \
  F(CREATESHADER, CreateShader)                                                                                        \
  F(CULLFACE, CullFace)                                                                                                \
  F(DELETEFRAMEBUFFERS, DeleteFramebuffers)                                                                            \
  F(DELETEQUERIES, DeleteQueries)                                                                                      \
  F(DELETERENDERBUFFERS, DeleteRenderbuffers)                                                                          \
  F(DEPTHFUNC, DepthFunc)                                                                                              \
  F(DISABLE, Disable)                                                                                                  \
  F(DRAWARRAYS, DrawArrays)                                                                                            \
  F(DRAWBUFFER, DrawBuffer)                                                                                            \
  F(DRAWELEMENTS, DrawElements)                                                                                        \
  F(ENABLE, Enable)                                                                                                    \
  F(ENABLEVERTEXATTRIBARRAY, EnableVertexAttribArray)                                                                  \
  F(ENDQUERY, EndQuery)                                                                                                \
  F(FINISH, Finish)                                                                                                    \
  F(FRAMEBUFFERRENDERBUFFER, FramebufferRenderbuffer)                                                                  \
  F(FRAMEBUFFERTEXTURE, FramebufferTexture)                                                                            \
  F(FRAMEBUFFERTEXTURELAYER, FramebufferTextureLayer)                                                                  \
  F(FRONTFACE, FrontFace)                                                                                              \
  F(GENBUFFERS, GenBuffers)                                                                                            \
  F(GENFRAMEBUFFERS, GenFramebuffers)                                                                                  \
  F(GENQUERIES, GenQueries)                                                                                            \
  F(GENRENDERBUFFERS, GenRenderbuffers)                                                                                \
  F(GENSAMPLERS, GenSamplers)                                                                                          \
  F(GENTEXTURES, GenTextures)                                                                                          \
  F(GENVERTEXARRAYS, GenVertexArrays)                                                                                  \
  F(GETACTIVEATTRIB, GetActiveAttrib)                                                                                  \
  F(GETACTIVEUNIFORM, GetActiveUniform)                                                                                \
  F(GETACTIVEUNIFORMBLOCKIV, GetActiveUniformBlockiv)                                                                  \
  F(GETACTIVEUNIFORMBLOCKNAME, GetActiveUniformBlockName)                                                              \
  F(GETACTIVEUNIFORMSIV, GetActiveUniformsiv)                                                                          \
  F(GETATTRIBLOCATION, GetAttribLocation)                                                                              \
  F(GETERROR, GetError)                                                                                                \
  F(GETINTEGERV, GetIntegerv)                                                                                          \
  F(GETMULTISAMPLEFV, GetMultisamplefv)                                                                                \
  F(GETPROGRAMINFOLOG, GetProgramInfoLog)                                                                              \
  F(GETPROGRAMIV, GetProgramiv)                                                                                        \
  F(GETQUERYOBJECTUIV, GetQueryObjectuiv)                                                                              \
  F(GETSHADERINFOLOG, GetShaderInfoLog)                                                                                \
  F(GETSHADERIV, GetShaderiv)                                                                                          \
  F(GETSTRING, GetString)                                                                                              \
  F(GETSTRINGI, GetStringi)                                                                                            \
  F(GETUNIFORMFV, GetUniformfv)                                                                                        \
  F(GETUNIFORMLOCATION, GetUniformLocation)                                                                            \
  F(LINKPROGRAM, LinkProgram)                                                                                          \
  F(PIXELSTOREI, PixelStorei)                                                                                          \
  F(READBUFFER, ReadBuffer)                                                                                            \
  F(READPIXELS, ReadPixels)                                                                                            \
  F(RENDERBUFFERSTORAGE, RenderbufferStorage)                                                                          \
  F(SAMPLERPARAMETERI, SamplerParameteri)                                                                              \
  F(SHADERSOURCE, ShaderSource)                                                                                        \
  F(TEXBUFFER, TexBuffer)                                                                                              \
  F(TEXIMAGE1D, TexImage1D)                                                                                            \
  F(TEXIMAGE2D, TexImage2D)                                                                                            \
  F(TEXIMAGE2DMULTISAMPLE, TexImage2DMultisample)                                                                      \
  F(TEXIMAGE3D, TexImage3D)                                                                                            \
  F(TEXIMAGE3DMULTISAMPLE, TexImage3DMultisample)                                                                      \
  F(TEXPARAMETERI, TexParameteri)                                                                                      \
  F(UNIFORM1F, Uniform1f)                                                                                              \
  F(UNIFORM1I, Uniform1i)                                                                                              \
  F(UNIFORM1IV, Uniform1iv)                                                                                            \
  F(UNIFORM2FV, Uniform2fv)                                                                                            \
  F(UNIFORM3FV, Uniform3fv)                                                                                            \
  F(UNIFORM4FV, Uniform4fv)                                                                                            \
  F(UNIFORMBLOCKBINDING, UniformBlockBinding)                                                                          \
  F(UNIFORMMATRIX3FV, UniformMatrix3fv)                                                                                \
  F(UNIFORMMATRIX4FV, UniformMatrix4fv)                                                                                \
  F(USEPROGRAM, UseProgram)                                                                                            \
  F(VALIDATEPROGRAM, ValidateProgram)                                                                                  \
  F(VERTEXATTRIB4F, VertexAttrib4f)                                                                                    \
  F(VERTEXATTRIBI4I, VertexAttribI4i)                                                                                  \
  F(VERTEXATTRIBI4UI, VertexAttribI4ui)                                                                                \
  F(VERTEXATTRIBPOINTER, VertexAttribPointer)                                                                          \
  F(VIEWPORT, Viewport)

/// Of later versions or of extensions: null where the driver has neither.
#define REFRASTER_GL_LATER_FUNCTIONS(F)                                                                                \
  F(GETINTERNALFORMATIV, GetInternalformativ)                                                                          \
  F(GETPROGRAMINTERFACEIV, GetProgramInterfaceiv)                                                                      \
  F(GETPROGRAMRESOURCENAME, GetProgramResourceName)                                                                    \
  F(GETPROGRAMRESOURCEIV, GetProgramResourceiv)                                                                        \
  F(GETPROGRAMSTAGEIV, GetProgramStageiv)                                                                              \
  F(UNIFORMSUBROUTINESUIV, UniformSubroutinesuiv)                                                                      \
  F(VERTEXATTRIBL4D, VertexAttribL4d)

/// gl.Clear(…) is glClear(…). For the context it was loaded from.
struct GlApi {
#define REFRASTER_GL_MEMBER(TYPE, name) PFNGL##TYPE##PROC name = nullptr;
  REFRASTER_GL_FUNCTIONS(REFRASTER_GL_MEMBER)
  REFRASTER_GL_LATER_FUNCTIONS(REFRASTER_GL_MEMBER)
#undef REFRASTER_GL_MEMBER
};

using GlFunction = void (*)();

/// Loads all of them for the current context; gives the name of the first of OpenGL 3.3 that is missing, or null.
const char* load(GlApi& gl, GlFunction (*get)(const char* name));

} // namespace refraster
