// Move-only owners of GL objects; the context that made them must be current when they die.
#pragma once

#include "graph/problem.h"
#include "renderer/frame.h"

#include <epoxy/gl.h>
#include <string>
#include <utility>
#include <vector>

namespace fieldwright::renderer {

// `Kind` makes and deletes one kind of object.
template <typename Kind>
class GlHandle {
public:
    GlHandle() : name_(Kind::make()) {}
    ~GlHandle() { release(); }
    GlHandle(GlHandle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    GlHandle& operator=(GlHandle&& other) noexcept
    {
        std::swap(name_, other.name_);
        return *this;
    }
    GLuint name() const { return name_; }

private:
    void release()
    {
        if (name_) Kind::free(name_);
    }
    GLuint name_;
};

struct TextureKind {
    static GLuint make();
    static void free(GLuint name) { glDeleteTextures(1, &name); }
};
struct BufferKind {
    static GLuint make();
    static void free(GLuint name) { glDeleteBuffers(1, &name); }
};
struct FramebufferKind {
    static GLuint make();
    static void free(GLuint name) { glDeleteFramebuffers(1, &name); }
};
struct VertexArrayKind {
    static GLuint make();
    static void free(GLuint name) { glDeleteVertexArrays(1, &name); }
};
struct ProgramKind {
    static GLuint make() { return glCreateProgram(); }
    static void free(GLuint name) { glDeleteProgram(name); }
};

using Texture = GlHandle<TextureKind>;
using Buffer = GlHandle<BufferKind>;
using Framebuffer = GlHandle<FramebufferKind>;
using VertexArray = GlHandle<VertexArrayKind>;

// The driver does not take a shader; its words in full are the log.
struct ShaderRefused : graph::Failure {
    explicit ShaderRefused(const std::string& log);
    std::string log;
};

// A linked program: the full-screen triangle and one fragment shader.
class Shader {
public:
    explicit Shader(const std::string& fragment_text);  // throws ShaderRefused, whose sentence has the log's first line

    void use() const { glUseProgram(program_.name()); }
    GLint uniform(const char* name) const { return glGetUniformLocation(program_.name(), name); }
    void set(const char* name, int value) const { glUniform1i(uniform(name), value); }
    void set(const char* name, float value) const { glUniform1f(uniform(name), value); }
    void set(const char* name, const glm::vec3& value) const { glUniform3f(uniform(name), value.x, value.y, value.z); }
    GLuint name() const { return program_.name(); }

private:
    GlHandle<ProgramKind> program_;
};

// RGBA float vectors that a shader reads by index (samplerBuffer).
class FloatTexture {
public:
    void upload(const float* data, std::size_t count);  // count: vec4s, at least one; graph::Failure{1}: too many
    void bind(int unit) const;

private:
    Buffer buffer_;
    Texture texture_;
};

// A framebuffer of RGBA32F attachments, at most the eight that GL 3.3 promises.
class FloatTarget {
public:
    FloatTarget(int width, int height, int attachments);  // throws graph::Failure{1} when the driver refuses the size
    void bind() const;
    void read(int attachment, float* rgba) const;                    // bottom-up rows
    void read(int attachment, const Area& area, float* rgba) const;  // its y counts from the bottom
    int width() const { return width_; }
    int height() const { return height_; }

private:
    int width_, height_;
    Framebuffer framebuffer_;
    std::vector<Texture> textures_;
};

}  // namespace fieldwright::renderer
