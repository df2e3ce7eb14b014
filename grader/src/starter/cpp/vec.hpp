// Vectors, colours, intervals and rays: what all chapters work with, and what they most need of the standard library.

#pragma once

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <math.h> // with <cmath> alone, `abs(0.5)` without `std::` may be that of whole numbers: 0
#include <stdexcept>
#include <string>

// A point or a vector of the plane.
struct Vec2 {
    double x = 0;
    double y = 0;
};

inline Vec2 operator+(const Vec2& a, const Vec2& b) { return {a.x + b.x, a.y + b.y}; }
inline Vec2 operator-(const Vec2& a, const Vec2& b) { return {a.x - b.x, a.y - b.y}; }
inline Vec2 operator*(double k, const Vec2& a) { return {k * a.x, k * a.y}; }
inline Vec2 operator*(const Vec2& a, double k) { return k * a; }
inline Vec2 operator/(const Vec2& a, double k) { return {a.x / k, a.y / k}; }

// A point or a vector of space; the unit is metres, or none for a direction.
struct Vec3 {
    double x = 0;
    double y = 0;
    double z = 0;

    // x, y or z by the number of the axis: 0, 1 or 2.
    double operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : axis == 2 ? z : throw no_axis(); }
    double& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : axis == 2 ? z : throw no_axis(); }

    static std::out_of_range no_axis() { return std::out_of_range("index out of range: the axes of a Vec3 are 0, 1 and 2"); }
};

inline Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3& operator+=(Vec3& a, const Vec3& b) { return a = a + b; }
inline Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
inline Vec3 operator*(double k, const Vec3& a) { return {k * a.x, k * a.y, k * a.z}; }
inline Vec3 operator*(const Vec3& a, double k) { return k * a; }
inline Vec3 operator/(const Vec3& a, double k) { return {a.x / k, a.y / k, a.z / k}; }

inline double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

inline Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline double length(const Vec3& a) { return std::sqrt(dot(a, a)); }

// The vector of length 1 in this direction; of 0 0 0 there is none.
inline Vec3 unit(const Vec3& a) { return a / length(a); }

// A colour: linear red, green and blue.
struct Rgb {
    double r = 0;
    double g = 0;
    double b = 0;
};

inline Rgb operator+(const Rgb& a, const Rgb& b) { return {a.r + b.r, a.g + b.g, a.b + b.b}; }
inline Rgb operator-(const Rgb& a, const Rgb& b) { return {a.r - b.r, a.g - b.g, a.b - b.b}; }
inline Rgb& operator+=(Rgb& a, const Rgb& b) { return a = a + b; }
inline Rgb operator*(const Rgb& a, const Rgb& b) { return {a.r * b.r, a.g * b.g, a.b * b.b}; }
inline Rgb operator*(double k, const Rgb& a) { return {k * a.r, k * a.g, k * a.b}; }
inline Rgb operator*(const Rgb& a, double k) { return k * a; }
inline Rgb operator/(const Rgb& a, double k) { return {a.r / k, a.g / k, a.b / k}; }

// How bright a colour looks: Y of the sRGB primaries.
inline double luminance(const Rgb& a) { return 0.2126 * a.r + 0.7152 * a.g + 0.0722 * a.b; }

// Distances along a ray, in metres.
struct Interval {
    double min = 0;
    double max = 0;
};

// A ray: where it starts, in metres, and where it goes, of length 1.
struct Ray {
    Vec3 origin{};
    Vec3 direction{};
};

// What is thrown by a function that is not written yet.
struct Todo {
    std::string name;
};

// Says that a function is not written yet; what it is given is not used.
template <class... Given> [[noreturn]] void todo(const char* name, const Given&...) {
    throw Todo{name};
}
