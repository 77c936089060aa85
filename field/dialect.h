// The C++ side of the dialect: GLM's vectors, scalar built-ins plain enough for the vectoriser, and lists.
//
// Included by generated kernels only, each compiled for another instruction set. Everything is static and always
// inlined: a function that the linker shared between them could run instructions the processor lacks.
#pragma once

#define GLM_FORCE_INLINE
#include <cmath>
#include <glm/glm.hpp>

#define FIELDWRIGHT_INLINE static inline __attribute__((always_inline, unused))

// Generated code opens its own namespace and puts this inside, so that scalars come from here and vectors follow.
#define FIELDWRIGHT_DIALECT_TYPES \
    using glm::vec2;              \
    using glm::vec3;              \
    using glm::vec4;              \
    using glm::mat2;              \
    using glm::mat3;

// Scalars, then the same built-ins component by component.
#define FIELDWRIGHT_DIALECT_FUNCTIONS_INCLUDED
