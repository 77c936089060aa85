// Compiling, uploading and reading back with GL.
#include "renderer/gl_handles.h"

#include "graph/library.h"

#include <vector>

namespace fieldwright::renderer {
namespace {

template <typename Generate>
GLuint generated(Generate generate)
{
    GLuint name = 0;
    generate(1, &name);
    return name;
}

std::string first_line(const std::string& log)
{
    std::size_t start = log.find_first_not_of(" \t\r\n\0");
    if (start == std::string::npos) return "the driver gives no reason";
    return log.substr(start, log.find_first_of("\r\n\0", start) - start);
}

void attach(GLuint program, GLenum stage, const std::string& text)
{
    GLuint shader = glCreateShader(stage);
    const char* source = text.c_str();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint compiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    std::string log(4096, '\0');
    if (!compiled) glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    glAttachShader(program, shader);
    glDeleteShader(shader);
    if (!compiled) throw ShaderRefused(log.c_str());
}

}  // namespace

GLuint TextureKind::make()
{
    return generated([](GLsizei n, GLuint* name) { glGenTextures(n, name); });
}
GLuint BufferKind::make()
{
    return generated([](GLsizei n, GLuint* name) { glGenBuffers(n, name); });
}
GLuint FramebufferKind::make()
{
    return generated([](GLsizei n, GLuint* name) { glGenFramebuffers(n, name); });
}
GLuint VertexArrayKind::make()
{
    return generated([](GLsizei n, GLuint* name) { glGenVertexArrays(n, name); });
}

ShaderRefused::ShaderRefused(const std::string& driver_log)
    : graph::Failure(6, "the graphics driver refuses the shader of this scene: " + first_line(driver_log) +
                            "; check the node files it is made of"),
      log(driver_log)
{
}

Shader::Shader(const std::string& fragment_text)
{
    attach(program_.name(), GL_VERTEX_SHADER, graph::embedded_texts().at("gpu/triangle.glsl"));
    attach(program_.name(), GL_FRAGMENT_SHADER, fragment_text);
    glLinkProgram(program_.name());
    GLint linked = 0;
    glGetProgramiv(program_.name(), GL_LINK_STATUS, &linked);
    if (linked) return;
    std::string log(4096, '\0');
    glGetProgramInfoLog(program_.name(), static_cast<GLsizei>(log.size()), nullptr, log.data());
    throw ShaderRefused(log.c_str());
}

void FloatTexture::upload(const float* data, std::size_t count)
{
    GLint limit = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &limit);
    if (count > static_cast<std::size_t>(limit))
        throw graph::Failure(1, "the lists and pictures of this scene hold " + std::to_string(count) +
                                    " vectors, more than this GPU's limit of " + std::to_string(limit) +
                                    "; lower the detail of its pictures or choose --device cpu");
    glBindBuffer(GL_TEXTURE_BUFFER, buffer_.name());
    glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(count * 4 * sizeof(float)), data, GL_DYNAMIC_DRAW);
    glBindTexture(GL_TEXTURE_BUFFER, texture_.name());
    glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, buffer_.name());
}

void FloatTexture::bind(int unit) const
{
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_BUFFER, texture_.name());
}

FloatTarget::FloatTarget(int width, int height, int attachments)
    : width_(width), height_(height), textures_(static_cast<std::size_t>(attachments))
{
    GLint limit = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    std::string size = std::to_string(width) + "x" + std::to_string(height);
    if (width > limit || height > limit)
        throw graph::Failure(1, "a picture of " + size + " is larger than this GPU's limit of " +
                                    std::to_string(limit) + " pixels a side; choose a smaller --size or --device cpu");
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    std::vector<GLenum> buffers;
    for (const Texture& texture : textures_) {
        glBindTexture(GL_TEXTURE_2D, texture.name());
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        buffers.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(buffers.size()));
        glFramebufferTexture2D(GL_FRAMEBUFFER, buffers.back(), GL_TEXTURE_2D, texture.name(), 0);
    }
    glDrawBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw graph::Failure(
            1, "the GPU has no room for a picture of " + size + "; choose a smaller --size or --device cpu");
}

void FloatTarget::bind() const
{
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glViewport(0, 0, width_, height_);
}

void FloatTarget::read(int attachment, float* rgba) const { read(attachment, {0, 0, width_, height_}, rgba); }

void FloatTarget::read(int attachment, const Area& area, float* rgba) const
{
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(attachment));
    glReadPixels(area.x, area.y, area.width, area.height, GL_RGBA, GL_FLOAT, rgba);
}

}  // namespace fieldwright::renderer
