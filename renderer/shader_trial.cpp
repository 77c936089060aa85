// Drivers compile in part at the first draw, so that belongs to it.
#include "renderer/shader_trial.h"

#include "renderer/gl_handles.h"
#include "renderer/headless_context.h"

namespace fieldwright::renderer {

std::string shader_log(const std::string& fragment_text)
{
    HeadlessContext context;
    try {
        Shader shader(fragment_text);
        FloatTarget target(1, 1, 3);
        VertexArray vertices;
        target.bind();
        glBindVertexArray(vertices.name());
        shader.use();
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glFinish();
    } catch (const ShaderRefused& refused) {
        return refused.log.empty() ? "the driver gives no reason" : refused.log;
    }
    return {};
}

}  // namespace fieldwright::renderer
