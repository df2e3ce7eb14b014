// Chapter 13: Reflection.

#include "raybook/ch13_reflection.hpp"

namespace ch13_reflection {

// What is along the surface stays, what is across it turns.
Vec3 reflect(const Vec3& incoming, const Vec3& normal) {
    const Vec3 across = dot(incoming, normal) * normal;
    const Vec3 along = incoming - across;
    return unit(along - across);
}

}
